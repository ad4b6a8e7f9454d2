// ffd_fp_fma: result_o = a_i * b_i + c_i with one rounding, to nearest, ties to even
//
// IEEE-754 format {sign, EXP_W, SIG_W - 1}: subnormals in and out, infinities; every NaN result is
// the canonical {0, all ones, 1, 0...}, infinity * 0 + NaN too; a zero result is always +0.
// Overflow gives infinity. Error at most half an ulp, also of subnormal results.
//
// With p = SIG_W, the frame has 3p + 5 bits and the 2p-bit product stands still in it:
//
//   p + 2 zeros | product, 2p bits | 2 guard bits | sticky bit       and c slides under it:
//   c, p bits, at distance 0 from the top, shifted right by distance.
//
// * distance < 0: c begins beyond the top of the frame. It is put at the top, and the product,
//   which is then too high, is below the two bits under c: it is but a sticky bit. The same place
//   serves a product of zero, which is below everything.
// * c shifted out below: c is then less than half of the product, whose leading one is at bit p - 1
//   of it or above (one factor subnormal at most). The difference leads at bit p - 2 or above, and
//   its significand, guard and sticky bit are inside the frame; one bit less below would be wrong.
// * a sum never carries out of the frame, and a negative one is a multiple of 8.
//
// A negative difference is complemented without the one that its negative needs; the rounding adds
// it: bits under the guard bit that are all ones pass it on, others stay a sticky one.
//
// Pipeline:   free running, II 1, exactly LATENCY registers, spread over seven steps
//             (ffd_fp_stage): multiply | align | add | count leading zeros | limit | normalise |
//             round. Never frozen, no reset.
// Unchecked:  nothing: all words have a defined result. No exception flags.
// Parameters: EXP_W, SIG_W (width with the hidden bit) as guarded in ffd_fp_unpack;
//             LATENCY >= 1, guarded in ffd_fp_stage; OPEN as there.
// Model:      host arithmetic and exact integers.  Test: tests/unit/float/float_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_fp_fma #(
  parameter EXP_W   = 8,
  parameter SIG_W   = 24,
  parameter LATENCY = 1,
  parameter OPEN    = 0
) (
  input  wire                   clk,
  input  wire [EXP_W+SIG_W-1:0] a_i,
  input  wire [EXP_W+SIG_W-1:0] b_i,
  input  wire [EXP_W+SIG_W-1:0] c_i,
  output wire [EXP_W+SIG_W-1:0] result_o
);
  localparam STEPS     = 7;
  localparam W         = EXP_W + SIG_W;
  localparam PRODUCT_W = 2 * SIG_W;
  localparam FRAME_W   = 3 * SIG_W + 5;        // see above
  localparam ALIGN_W   = $clog2(FRAME_W + 1);  // all ones shifts FRAME_W - 1 bits out
  localparam COUNT_W   = $clog2(FRAME_W);
  localparam BASE_W    = EXP_W + 3;  // signed: two exponents and RISE, below 2^(EXP_W+2)

  // Exponent of the top of the frame, less one (the hidden bit adds it, see ffd_fp_round), when
  // the product places it: exponent a + exponent b + RISE.
  localparam BIAS                = (1 << (EXP_W - 1)) - 1;
  localparam integer RISE        = SIG_W + 2 - BIAS;
  localparam [BASE_W-1:0] OFFSET = RISE[BASE_W-1:0];

  // Step 0: multiply, place the frame, classify.
  wire             p0_a_sign;
  wire [EXP_W-1:0] p0_a_exponent;
  wire [SIG_W-1:0] p0_a_significand;
  wire             p0_a_zero;
  wire             p0_a_infinite;
  wire             p0_a_nan;
  wire             p0_b_sign;
  wire [EXP_W-1:0] p0_b_exponent;
  wire [SIG_W-1:0] p0_b_significand;
  wire             p0_b_zero;
  wire             p0_b_infinite;
  wire             p0_b_nan;
  wire             p0_c_sign;
  wire [EXP_W-1:0] p0_c_exponent;
  wire [SIG_W-1:0] p0_c_significand;
  wire             p0_c_zero;
  wire             p0_c_infinite;
  wire             p0_c_nan;

  ffd_fp_unpack #(
    .EXP_W(EXP_W),
    .SIG_W(SIG_W)
  ) u_a (
    .word_i       (a_i),
    .sign_o       (p0_a_sign),
    .exponent_o   (p0_a_exponent),
    .significand_o(p0_a_significand),
    .zero_o       (p0_a_zero),
    .infinite_o   (p0_a_infinite),
    .nan_o        (p0_a_nan)
  );

  ffd_fp_unpack #(
    .EXP_W(EXP_W),
    .SIG_W(SIG_W)
  ) u_b (
    .word_i       (b_i),
    .sign_o       (p0_b_sign),
    .exponent_o   (p0_b_exponent),
    .significand_o(p0_b_significand),
    .zero_o       (p0_b_zero),
    .infinite_o   (p0_b_infinite),
    .nan_o        (p0_b_nan)
  );

  ffd_fp_unpack #(
    .EXP_W(EXP_W),
    .SIG_W(SIG_W)
  ) u_c (
    .word_i       (c_i),
    .sign_o       (p0_c_sign),
    .exponent_o   (p0_c_exponent),
    .significand_o(p0_c_significand),
    .zero_o       (p0_c_zero),
    .infinite_o   (p0_c_infinite),
    .nan_o        (p0_c_nan)
  );

  wire p0_ab_sign   = p0_a_sign ^ p0_b_sign;
  wire p0_subtract  = p0_ab_sign ^ p0_c_sign;
  wire p0_ab_zero   = p0_a_zero | p0_b_zero;
  wire p0_ab_inf    = p0_a_infinite | p0_b_infinite;
  wire p0_infinite  = p0_ab_inf | p0_c_infinite;
  wire p0_nan       = p0_a_nan | p0_b_nan | p0_c_nan | (p0_ab_inf & p0_ab_zero)
                    | (p0_ab_inf & p0_c_infinite & p0_subtract);
  wire p0_sign      = p0_c_infinite ? p0_c_sign : p0_ab_sign;

  wire [PRODUCT_W-1:0] p0_product = {{SIG_W{1'b0}}, p0_a_significand}
                                  * {{SIG_W{1'b0}}, p0_b_significand};

  // The frame begins where the product wants it or where c begins, whichever is higher.
  wire [BASE_W-1:0]  p0_ab_base  = {3'b000, p0_a_exponent} + {3'b000, p0_b_exponent} + OFFSET;
  wire [BASE_W-1:0]  p0_c_base   = {3'b000, p0_c_exponent} - {{(BASE_W-1){1'b0}}, 1'b1};
  wire [BASE_W-1:0]  p0_distance = p0_ab_base - p0_c_base;
  wire               p0_c_leads  = p0_distance[BASE_W-1] | p0_ab_zero;
  wire [BASE_W-1:0]  p0_base     = p0_c_leads ? p0_c_base : p0_ab_base;
  wire               p0_far      = |(p0_distance >> ALIGN_W);
  wire [ALIGN_W-1:0] p0_amount   = (p0_distance[ALIGN_W-1:0] | {ALIGN_W{p0_far}})
                                 & {ALIGN_W{~p0_c_leads}};

  wire                 p1_sign;
  wire                 p1_nan;
  wire                 p1_infinite;
  wire                 p1_subtract;
  wire [BASE_W-2:0]    p1_base;
  wire [ALIGN_W-1:0]   p1_amount;
  wire [SIG_W-1:0]     p1_c;
  wire [PRODUCT_W-1:0] p1_product;

  ffd_fp_stage #(
    .WIDTH  (4 + BASE_W - 1 + ALIGN_W + SIG_W + PRODUCT_W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (0)
  ) u_stage0 (
    .clk(clk),
    .d_i({p0_sign, p0_nan, p0_infinite, p0_subtract, p0_base[BASE_W-2:0], p0_amount,
          p0_c_significand, p0_product}),
    .q_o({p1_sign, p1_nan, p1_infinite, p1_subtract, p1_base, p1_amount, p1_c, p1_product})
  );

  // Step 1: slide c to its place.
  wire [FRAME_W-2:0] p1_aligned;
  wire               p1_sticky;

  ffd_fp_shift_right #(
    .WIDTH      (FRAME_W - 1),
    .AMOUNT_W   (ALIGN_W),
    .LARGE_FIRST(0)
  ) u_align (
    .x_i     ({p1_c, {(FRAME_W-1-SIG_W){1'b0}}}),
    .amount_i(p1_amount),
    .y_o     (p1_aligned),
    .sticky_o(p1_sticky)
  );

  wire                 p2_sign;
  wire                 p2_nan;
  wire                 p2_infinite;
  wire                 p2_subtract;
  wire [BASE_W-2:0]    p2_base;
  wire [FRAME_W-1:0]   p2_c;
  wire [PRODUCT_W-1:0] p2_product;

  ffd_fp_stage #(
    .WIDTH  (4 + BASE_W - 1 + FRAME_W + PRODUCT_W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (1)
  ) u_stage1 (
    .clk(clk),
    .d_i({p1_sign, p1_nan, p1_infinite, p1_subtract, p1_base, p1_aligned, p1_sticky, p1_product}),
    .q_o({p2_sign, p2_nan, p2_infinite, p2_subtract, p2_base, p2_c, p2_product})
  );

  // Step 2: product + c or product - c; the bit below the frame turns into the carry of the
  // complement, the bit above it is the sign.
  wire [FRAME_W+1:0] p2_wide_sum = {1'b0, {(SIG_W+2){1'b0}}, p2_product, 3'b000, 1'b1}
                                 + {{1'b0, p2_c} ^ {(FRAME_W+1){p2_subtract}}, p2_subtract};
  wire [FRAME_W-1:0] p2_sum      = p2_wide_sum[FRAME_W:1];
  wire               p2_negative = p2_wide_sum[FRAME_W+1];

  wire               p3_sign;
  wire               p3_nan;
  wire               p3_infinite;
  wire [BASE_W-2:0]  p3_base;
  wire               p3_negative;
  wire [FRAME_W-1:0] p3_sum;

  ffd_fp_stage #(
    .WIDTH  (3 + BASE_W - 1 + 1 + FRAME_W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (2)
  ) u_stage2 (
    .clk(clk),
    .d_i({p2_sign ^ (p2_negative & ~p2_infinite), p2_nan, p2_infinite, p2_base,
          p2_negative, p2_sum}),
    .q_o({p3_sign, p3_nan, p3_infinite, p3_base, p3_negative, p3_sum})
  );

  // Step 3: leading zeros of the complemented sum.
  wire [COUNT_W-1:0] p3_count;
  wire               p3_none;

  ffd_fp_lzc #(
    .WIDTH(FRAME_W)
  ) u_lzc (
    .x_i    (p3_sum ^ {FRAME_W{p3_negative}}),
    .count_o(p3_count),
    .none_o (p3_none)
  );

  wire               p4_sign;
  wire               p4_nan;
  wire               p4_infinite;
  wire [BASE_W-2:0]  p4_base;
  wire               p4_negative;
  wire [FRAME_W-1:0] p4_sum;
  wire               p4_none;
  wire [COUNT_W-1:0] p4_count;

  ffd_fp_stage #(
    .WIDTH  (3 + BASE_W - 1 + 1 + FRAME_W + 1 + COUNT_W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (3)
  ) u_stage3 (
    .clk(clk),
    .d_i({p3_sign, p3_nan, p3_infinite, p3_base, p3_negative, p3_sum, p3_none, p3_count}),
    .q_o({p4_sign, p4_nan, p4_infinite, p4_base, p4_negative, p4_sum, p4_none, p4_count})
  );

  // Step 4: shift the leading one to the top, or as far as the exponent allows.
  wire [BASE_W-1:0]  p4_left     = {1'b0, p4_base} - {{(BASE_W-COUNT_W){1'b0}}, p4_count};
  wire               p4_limited  = p4_left[BASE_W-1] | p4_none;
  wire               p4_overflow = ~p4_limited
                                 & ((|p4_left[BASE_W-2:EXP_W]) | (&p4_left[EXP_W-1:1]));
  wire [EXP_W-1:0]   p4_field    = p4_left[EXP_W-1:0] & {EXP_W{~p4_limited}};
  wire [COUNT_W-1:0] p4_amount   = p4_limited ? p4_base[COUNT_W-1:0] : p4_count;

  wire               p5_sign;
  wire               p5_nan;
  wire               p5_infinite;
  wire [EXP_W-1:0]   p5_field;
  wire [COUNT_W-1:0] p5_amount;
  wire               p5_negative;
  wire [FRAME_W-1:0] p5_sum;

  ffd_fp_stage #(
    .WIDTH  (3 + EXP_W + COUNT_W + 1 + FRAME_W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (4)
  ) u_stage4 (
    .clk(clk),
    .d_i({p4_sign, p4_nan, p4_infinite | p4_overflow, p4_field, p4_amount, p4_negative, p4_sum}),
    .q_o({p5_sign, p5_nan, p5_infinite, p5_field, p5_amount, p5_negative, p5_sum})
  );

  // Step 5: the shift, then the complement. Under the guard bit, ones that are all complemented
  // zeros let the missing one through to it: 0 and rest become 1 and nothing, 1 and rest become a
  // carry into the significand, which {guard, sticky} = 3 is sure to give.
  wire [FRAME_W-1:0] p5_shifted;

  ffd_fp_shift_left #(
    .WIDTH   (FRAME_W),
    .AMOUNT_W(COUNT_W)
  ) u_normalise (
    .x_i     (p5_sum),
    .amount_i(p5_amount),
    .y_o     (p5_shifted)
  );

  localparam REST_W = FRAME_W - SIG_W - 1;  // below significand and guard bit

  wire [SIG_W-1:0] p5_significand = p5_shifted[FRAME_W-1 -: SIG_W] ^ {SIG_W{p5_negative}};
  wire             p5_bit         = p5_shifted[REST_W] ^ p5_negative;
  wire             p5_rest        = |p5_shifted[REST_W-1:0];
  wire             p5_guard       = p5_bit | (p5_negative & ~p5_rest);
  wire             p5_sticky      = p5_rest | (p5_negative & p5_bit);

  wire             p6_sign;
  wire             p6_nan;
  wire             p6_infinite;
  wire [EXP_W-1:0] p6_field;
  wire [SIG_W-1:0] p6_significand;
  wire             p6_guard;
  wire             p6_sticky;

  ffd_fp_stage #(
    .WIDTH  (3 + EXP_W + SIG_W + 2),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (5)
  ) u_stage5 (
    .clk(clk),
    .d_i({p5_sign, p5_nan, p5_infinite, p5_field, p5_significand, p5_guard, p5_sticky}),
    .q_o({p6_sign, p6_nan, p6_infinite, p6_field, p6_significand, p6_guard, p6_sticky})
  );

  // Step 6: round and pack.
  wire [W-1:0] p6_result;

  ffd_fp_round #(
    .EXP_W(EXP_W),
    .SIG_W(SIG_W)
  ) u_round (
    .sign_i       (p6_sign),
    .exponent_i   (p6_field),
    .significand_i(p6_significand),
    .guard_i      (p6_guard),
    .sticky_i     (p6_sticky),
    .infinite_i   (p6_infinite),
    .nan_i        (p6_nan),
    .result_o     (p6_result)
  );

  ffd_fp_stage #(
    .WIDTH  (W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (6),
    .OPEN   (OPEN)
  ) u_stage6 (
    .clk(clk),
    .d_i(p6_result),
    .q_o(result_o)
  );

  wire unused_ok = &{1'b0, p0_c_zero, p0_base[BASE_W-1], p2_wide_sum[0]};
endmodule

`default_nettype wire
