// ffd_fp_add: result_o = a_i + b_i, rounded to nearest, ties to even
//
// IEEE-754 format {sign, EXP_W, SIG_W - 1}: subnormals in and out, infinities; every NaN result is
// the canonical {0, all ones, 1, 0...}; a zero result is always +0 (also -0 + -0). Overflow gives
// infinity. Error at most half an ulp.
//
// Single path. The words are swapped on their whole magnitude, so the difference is never negative
// and a NaN or an infinity is always in the larger one. The smaller significand is aligned with
// two guard bits and a sticky bit: a sum with ones in the sticky bit loses at most one leading bit,
// so guard and sticky survive the normalising shift. That shift is limited by the exponent, where
// the result becomes subnormal.
//
// Pipeline:   free running, II 1, exactly LATENCY registers, spread over eight steps
//             (ffd_fp_stage): swap | unpack | align | add | count leading zeros | limit |
//             normalise | round. Never frozen, no reset.
// Unchecked:  nothing: every pair of words has a defined result. No exception flags.
// Parameters: EXP_W, SIG_W (width with the hidden bit) as guarded in ffd_fp_unpack;
//             LATENCY >= 1, guarded in ffd_fp_stage; OPEN as there.
// Model:      host arithmetic and exact integers.  Test: tests/unit/float/float_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_fp_add #(
  parameter EXP_W   = 8,
  parameter SIG_W   = 24,
  parameter LATENCY = 1,
  parameter OPEN    = 0
) (
  input  wire                   clk,
  input  wire [EXP_W+SIG_W-1:0] a_i,
  input  wire [EXP_W+SIG_W-1:0] b_i,
  output wire [EXP_W+SIG_W-1:0] result_o
);
  localparam STEPS   = 8;
  localparam W       = EXP_W + SIG_W;
  localparam FRAME_W = SIG_W + 4;          // carry, significand, two guard bits, sticky bit
  localparam ALIGN_W = $clog2(SIG_W + 3);  // all ones shifts SIG_W + 2 bits out completely
  localparam COUNT_W = $clog2(FRAME_W);

  localparam [EXP_W-1:0] LARGEST_FINITE = {{(EXP_W-1){1'b1}}, 1'b0};

  // Step 0: the larger magnitude first.
  wire         p0_swap    = a_i[W-2:0] < b_i[W-2:0];
  wire [W-1:0] p0_larger  = p0_swap ? b_i : a_i;
  wire [W-1:0] p0_smaller = p0_swap ? a_i : b_i;

  wire [W-1:0] p1_larger;
  wire [W-1:0] p1_smaller;

  ffd_fp_stage #(
    .WIDTH  (2 * W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (0)
  ) u_stage0 (
    .clk(clk),
    .d_i({p0_larger, p0_smaller}),
    .q_o({p1_larger, p1_smaller})
  );

  // Step 1: unpack; by how much the smaller significand is aligned to the larger exponent.
  wire             p1_sign;
  wire [EXP_W-1:0] p1_exponent;
  wire [SIG_W-1:0] p1_significand;
  wire             p1_infinite;
  wire             p1_larger_zero;
  wire             p1_larger_nan;
  wire             p1_smaller_sign;
  wire [EXP_W-1:0] p1_smaller_exponent;
  wire [SIG_W-1:0] p1_smaller_significand;
  wire             p1_smaller_zero;
  wire             p1_smaller_infinite;
  wire             p1_smaller_nan;

  ffd_fp_unpack #(
    .EXP_W(EXP_W),
    .SIG_W(SIG_W)
  ) u_larger (
    .word_i       (p1_larger),
    .sign_o       (p1_sign),
    .exponent_o   (p1_exponent),
    .significand_o(p1_significand),
    .zero_o       (p1_larger_zero),
    .infinite_o   (p1_infinite),
    .nan_o        (p1_larger_nan)
  );

  ffd_fp_unpack #(
    .EXP_W(EXP_W),
    .SIG_W(SIG_W)
  ) u_smaller (
    .word_i       (p1_smaller),
    .sign_o       (p1_smaller_sign),
    .exponent_o   (p1_smaller_exponent),
    .significand_o(p1_smaller_significand),
    .zero_o       (p1_smaller_zero),
    .infinite_o   (p1_smaller_infinite),
    .nan_o        (p1_smaller_nan)
  );

  wire               p1_subtract = p1_sign ^ p1_smaller_sign;
  wire               p1_nan      = p1_larger_nan | (p1_smaller_infinite & p1_subtract);
  wire [EXP_W-1:0]   p1_distance = p1_exponent - p1_smaller_exponent;
  wire               p1_far      = |(p1_distance >> ALIGN_W);
  wire [ALIGN_W-1:0] p1_amount   = p1_distance[ALIGN_W-1:0] | {ALIGN_W{p1_far}};

  wire               p2_sign;
  wire               p2_nan;
  wire               p2_infinite;
  wire               p2_subtract;
  wire [EXP_W-1:0]   p2_exponent;
  wire [ALIGN_W-1:0] p2_amount;
  wire [SIG_W-1:0]   p2_significand;
  wire [SIG_W-1:0]   p2_smaller_significand;

  ffd_fp_stage #(
    .WIDTH  (4 + EXP_W + ALIGN_W + 2 * SIG_W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (1)
  ) u_stage1 (
    .clk(clk),
    .d_i({p1_sign, p1_nan, p1_infinite, p1_subtract, p1_exponent, p1_amount, p1_significand,
          p1_smaller_significand}),
    .q_o({p2_sign, p2_nan, p2_infinite, p2_subtract, p2_exponent, p2_amount, p2_significand,
          p2_smaller_significand})
  );

  // Step 2: align.
  wire [SIG_W+1:0]   p2_aligned;
  wire               p2_sticky;

  ffd_fp_shift_right #(
    .WIDTH      (SIG_W + 2),
    .AMOUNT_W   (ALIGN_W),
    .LARGE_FIRST(1)
  ) u_align (
    .x_i     ({p2_smaller_significand, 2'b00}),
    .amount_i(p2_amount),
    .y_o     (p2_aligned),
    .sticky_o(p2_sticky)
  );

  wire               p3_sign;
  wire               p3_nan;
  wire               p3_infinite;
  wire               p3_subtract;
  wire [EXP_W-1:0]   p3_exponent;
  wire [SIG_W-1:0]   p3_augend;
  wire [FRAME_W-2:0] p3_addend;

  ffd_fp_stage #(
    .WIDTH  (4 + EXP_W + SIG_W + FRAME_W - 1),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (2)
  ) u_stage2 (
    .clk(clk),
    .d_i({p2_sign, p2_nan, p2_infinite, p2_subtract, p2_exponent, p2_significand,
          p2_aligned, p2_sticky}),
    .q_o({p3_sign, p3_nan, p3_infinite, p3_subtract, p3_exponent, p3_augend, p3_addend})
  );

  // Step 3: add or subtract; the bit below the frame turns into the carry of the complement.
  wire [FRAME_W:0]   p3_wide_sum = {1'b0, p3_augend, 3'b000, 1'b1}
                                 + {{1'b0, p3_addend} ^ {FRAME_W{p3_subtract}}, p3_subtract};
  wire [FRAME_W-1:0] p3_sum      = p3_wide_sum[FRAME_W:1];
  wire               p3_overflow = p3_sum[FRAME_W-1] & (p3_exponent == LARGEST_FINITE);

  wire               p4_sign;
  wire               p4_nan;
  wire               p4_infinite;
  wire [EXP_W-1:0]   p4_exponent;
  wire [FRAME_W-1:0] p4_sum;

  ffd_fp_stage #(
    .WIDTH  (3 + EXP_W + FRAME_W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (3)
  ) u_stage3 (
    .clk(clk),
    .d_i({p3_sign, p3_nan, p3_infinite | p3_overflow, p3_exponent, p3_sum}),
    .q_o({p4_sign, p4_nan, p4_infinite, p4_exponent, p4_sum})
  );

  // Step 4: leading zeros.
  wire [COUNT_W-1:0] p4_count;
  wire               p4_none;

  ffd_fp_lzc #(
    .WIDTH(FRAME_W)
  ) u_lzc (
    .x_i    (p4_sum),
    .count_o(p4_count),
    .none_o (p4_none)
  );

  wire               p5_sign;
  wire               p5_nan;
  wire               p5_infinite;
  wire [EXP_W-1:0]   p5_exponent;
  wire [FRAME_W-1:0] p5_sum;
  wire [COUNT_W-1:0] p5_count;
  wire               p5_none;

  ffd_fp_stage #(
    .WIDTH  (3 + EXP_W + FRAME_W + COUNT_W + 1),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (4)
  ) u_stage4 (
    .clk(clk),
    .d_i({p4_sign, p4_nan, p4_infinite, p4_exponent, p4_sum, p4_count, p4_none}),
    .q_o({p5_sign, p5_nan, p5_infinite, p5_exponent, p5_sum, p5_count, p5_none})
  );

  // Step 5: shift the leading one to the top, or as far as the exponent allows.
  wire [EXP_W:0]     p5_left    = {1'b0, p5_exponent} - {{(EXP_W+1-COUNT_W){1'b0}}, p5_count};
  wire               p5_limited = p5_left[EXP_W] | p5_none;
  wire [EXP_W-1:0]   p5_field   = p5_left[EXP_W-1:0] & {EXP_W{~p5_limited}};
  wire [COUNT_W-1:0] p5_amount  = p5_limited ? p5_exponent[COUNT_W-1:0] : p5_count;

  wire               p6_sign;
  wire               p6_nan;
  wire               p6_infinite;
  wire [EXP_W-1:0]   p6_field;
  wire [COUNT_W-1:0] p6_amount;
  wire [FRAME_W-1:0] p6_sum;

  ffd_fp_stage #(
    .WIDTH  (3 + EXP_W + COUNT_W + FRAME_W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (5)
  ) u_stage5 (
    .clk(clk),
    .d_i({p5_sign, p5_nan, p5_infinite, p5_field, p5_amount, p5_sum}),
    .q_o({p6_sign, p6_nan, p6_infinite, p6_field, p6_amount, p6_sum})
  );

  // Step 6: the shift.
  wire [FRAME_W-1:0] p6_normal;

  ffd_fp_shift_left #(
    .WIDTH   (FRAME_W),
    .AMOUNT_W(COUNT_W)
  ) u_normalise (
    .x_i     (p6_sum),
    .amount_i(p6_amount),
    .y_o     (p6_normal)
  );

  wire             p7_sign;
  wire             p7_nan;
  wire             p7_infinite;
  wire [EXP_W-1:0] p7_field;
  wire [SIG_W-1:0] p7_significand;
  wire             p7_guard;
  wire             p7_sticky;

  ffd_fp_stage #(
    .WIDTH  (3 + EXP_W + SIG_W + 2),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (6)
  ) u_stage6 (
    .clk(clk),
    .d_i({p6_sign, p6_nan, p6_infinite, p6_field, p6_normal[FRAME_W-1:3], |p6_normal[2:0]}),
    .q_o({p7_sign, p7_nan, p7_infinite, p7_field, p7_significand, p7_guard, p7_sticky})
  );

  // Step 7: round and pack.
  wire [W-1:0] p7_result;

  ffd_fp_round #(
    .EXP_W(EXP_W),
    .SIG_W(SIG_W)
  ) u_round (
    .sign_i       (p7_sign),
    .exponent_i   (p7_field),
    .significand_i(p7_significand),
    .guard_i      (p7_guard),
    .sticky_i     (p7_sticky),
    .infinite_i   (p7_infinite),
    .nan_i        (p7_nan),
    .result_o     (p7_result)
  );

  ffd_fp_stage #(
    .WIDTH  (W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (7),
    .OPEN   (OPEN)
  ) u_stage7 (
    .clk(clk),
    .d_i(p7_result),
    .q_o(result_o)
  );

  wire unused_ok = &{1'b0, p1_larger_zero, p1_smaller_zero, p1_smaller_nan, p3_wide_sum[0]};
endmodule

`default_nettype wire
