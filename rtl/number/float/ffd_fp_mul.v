// ffd_fp_mul: result_o = a_i * b_i, rounded to nearest, ties to even
//
// IEEE-754 format {sign, EXP_W, SIG_W - 1}: subnormals in and out, infinities; every NaN result is
// the canonical {0, all ones, 1, 0...}; a zero result is always +0, an underflow to zero too.
// Overflow gives infinity. Error at most half an ulp, also of subnormal results.
//
// Nothing is normalised before the multiplication. With p = SIG_W the product has 2p bits, and its
// leading one is at bit p - 1 or above unless it is zero or both factors are subnormal; position
// counts from there. One right shift then serves both ends: by position for a normal result, by
// depth, which does not depend on the product, for a subnormal one, whichever is more:
//
//   depth = p + BIAS - (exponent a + exponent b),   exponent of the result = position - depth.
//
// Two subnormal factors have depth > p, more than any position: their position is never used.
//
// Pipeline:   free running, II 1, exactly LATENCY registers, spread over seven steps
//             (ffd_fp_stage): unpack | multiply halves | add them | find leading one | limit |
//             shift | round. Registers around the products are those of ffd_fx_block. Never
//             frozen, no reset.
// Unchecked:  nothing: every pair of words has a defined result. No exception flags.
// Parameters: EXP_W, SIG_W (width with the hidden bit) as guarded in ffd_fp_unpack;
//             LATENCY >= 1, guarded in ffd_fp_stage.
// Model:      host arithmetic and exact integers.  Test: tests/unit/float/float_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_fp_mul #(
  parameter EXP_W   = 8,
  parameter SIG_W   = 24,
  parameter LATENCY = 1
) (
  input  wire                   clk,
  input  wire [EXP_W+SIG_W-1:0] a_i,
  input  wire [EXP_W+SIG_W-1:0] b_i,
  output wire [EXP_W+SIG_W-1:0] result_o
);
  localparam STEPS      = 7;
  localparam W          = EXP_W + SIG_W;
  localparam PRODUCT_W  = 2 * SIG_W;
  localparam POSITION_W = $clog2(SIG_W + 1);      // of a leading one among the upper SIG_W + 1 bits
  localparam UPPER_W    = 1 << POSITION_W;        // these bits, padded in front; <= PRODUCT_W
  localparam AMOUNT_W   = $clog2(2 * SIG_W + 2);  // all ones shifts 2 * SIG_W + 1 bits out
  localparam DEPTH_W    = EXP_W + 2;  // signed: SIG_W + BIAS < 2^(EXP_W+1), sum <= 2^(EXP_W+1)

  localparam BIAS                 = (1 << (EXP_W - 1)) - 1;
  localparam [DEPTH_W-1:0] ORIGIN = SIG_W[DEPTH_W-1:0] + BIAS[DEPTH_W-1:0];

  // Step 0: unpack, classify.
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

  wire p0_sign     = p0_a_sign ^ p0_b_sign;
  wire p0_infinite = p0_a_infinite | p0_b_infinite;
  wire p0_nan      = p0_a_nan | p0_b_nan | (p0_infinite & (p0_a_zero | p0_b_zero));

  wire             p1_sign;
  wire             p1_nan;
  wire             p1_infinite;
  wire [EXP_W-1:0] p1_a_exponent;
  wire [EXP_W-1:0] p1_b_exponent;

  ffd_fp_stage #(
    .WIDTH  (3 + 2 * EXP_W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (0)
  ) u_stage0 (
    .clk(clk),
    .d_i({p0_sign, p0_nan, p0_infinite, p0_a_exponent, p0_b_exponent}),
    .q_o({p1_sign, p1_nan, p1_infinite, p1_a_exponent, p1_b_exponent})
  );

  // Step 1: add the exponents; the products of halves, each in a multiplier block. The registers
  // behind steps 0 and 1 are theirs too.
  localparam LOW_W  = SIG_W / 2;
  localparam HIGH_W = SIG_W - LOW_W;
  localparam PART_W = 2 * HIGH_W;
  localparam HALF_W = HIGH_W + 1;  // with a sign, which is 0
  localparam ZERO_W = HALF_W - LOW_W;
  localparam BEFORE = `FFD_FP_REGISTERS(LATENCY, STEPS, 0);
  localparam BEHIND = `FFD_FP_REGISTERS(LATENCY, STEPS, 1);

  wire [2*HALF_W-1:0] p0_a_halves = {1'b0, p0_a_significand[SIG_W-1:LOW_W],
                                     {ZERO_W{1'b0}}, p0_a_significand[LOW_W-1:0]};
  wire [2*HALF_W-1:0] p0_b_halves = {1'b0, p0_b_significand[SIG_W-1:LOW_W],
                                     {ZERO_W{1'b0}}, p0_b_significand[LOW_W-1:0]};

  genvar i;
  genvar j;
  generate
    for (i = 0; i < 2; i = i + 1) begin : gen_a
      for (j = 0; j < 2; j = j + 1) begin : gen_b
        wire [2*HALF_W-1:0] product;
        wire [PART_W-1:0]   part = product[PART_W-1:0];
        ffd_fx_block #(
          .W     (HALF_W),
          .BEFORE(BEFORE),
          .BEHIND(BEHIND)
        ) u_block (
          .clk      (clk),
          .a_i      (p0_a_halves[i*HALF_W +: HALF_W]),
          .b_i      (p0_b_halves[j*HALF_W +: HALF_W]),
          .product_o(product)
        );
        wire unused_ok = &{1'b0, product[2*HALF_W-1:PART_W]};
      end
    end
  endgenerate

  wire [DEPTH_W-1:0] p1_depth = ORIGIN - ({2'b00, p1_a_exponent} + {2'b00, p1_b_exponent});

  wire               p2_sign;
  wire               p2_nan;
  wire               p2_infinite;
  wire [DEPTH_W-1:0] p2_depth;
  wire [PART_W-1:0]  p2_high  = gen_a[1].gen_b[1].part;
  wire [PART_W-1:0]  p2_cross = gen_a[1].gen_b[0].part;
  wire [PART_W-1:0]  p2_other = gen_a[0].gen_b[1].part;
  wire [PART_W-1:0]  p2_low   = gen_a[0].gen_b[0].part;

  ffd_fp_stage #(
    .WIDTH  (3 + DEPTH_W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (1)
  ) u_stage1 (
    .clk(clk),
    .d_i({p1_sign, p1_nan, p1_infinite, p1_depth}),
    .q_o({p2_sign, p2_nan, p2_infinite, p2_depth})
  );

  // Step 2: their sum. The outer two do not overlap.
  wire [PART_W:0]      p2_crossed = {1'b0, p2_cross} + {1'b0, p2_other};
  wire [PRODUCT_W:0]   p2_inner   = {{(PRODUCT_W-PART_W){1'b0}}, p2_crossed} << LOW_W;
  wire [PRODUCT_W-1:0] p2_product = {p2_high, p2_low[2*LOW_W-1:0]} + p2_inner[PRODUCT_W-1:0];

  wire                 p3_sign;
  wire                 p3_nan;
  wire                 p3_infinite;
  wire [DEPTH_W-1:0]   p3_depth;
  wire [PRODUCT_W-1:0] p3_product;

  ffd_fp_stage #(
    .WIDTH  (3 + DEPTH_W + PRODUCT_W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (2)
  ) u_stage2 (
    .clk(clk),
    .d_i({p2_sign, p2_nan, p2_infinite, p2_depth, p2_product}),
    .q_o({p3_sign, p3_nan, p3_infinite, p3_depth, p3_product})
  );

  // Step 3: the leading one. Padded in front to a power of two, position = ~(leading zeros).
  wire [PRODUCT_W-1:0]  p3_upper = p3_product >> (SIG_W - 1);
  wire [POSITION_W-1:0] p3_count;
  wire                  p3_none;

  ffd_fp_lzc #(
    .WIDTH(UPPER_W)
  ) u_lzc (
    .x_i    (p3_upper[UPPER_W-1:0]),
    .count_o(p3_count),
    .none_o (p3_none)
  );

  wire                  p4_sign;
  wire                  p4_nan;
  wire                  p4_infinite;
  wire [DEPTH_W-1:0]    p4_depth;
  wire [PRODUCT_W-1:0]  p4_product;
  wire                  p4_none;
  wire [POSITION_W-1:0] p4_position;

  ffd_fp_stage #(
    .WIDTH  (3 + DEPTH_W + PRODUCT_W + 1 + POSITION_W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (3)
  ) u_stage3 (
    .clk(clk),
    .d_i({p3_sign, p3_nan, p3_infinite, p3_depth, p3_product, p3_none, ~p3_count}),
    .q_o({p4_sign, p4_nan, p4_infinite, p4_depth, p4_product, p4_none, p4_position})
  );

  // Step 4: normal or subnormal, exponent and shift. One sign bit more than depth has.
  wire [DEPTH_W:0]    p4_left     = {{(DEPTH_W+1-POSITION_W){1'b0}}, p4_position}
                                  - {p4_depth[DEPTH_W-1], p4_depth};
  wire                p4_limited  = p4_left[DEPTH_W] | p4_none;
  wire                p4_overflow = ~p4_limited
                                  & ((|p4_left[DEPTH_W-1:EXP_W]) | (&p4_left[EXP_W-1:1]));
  wire [EXP_W-1:0]    p4_field    = p4_left[EXP_W-1:0] & {EXP_W{~p4_limited}};
  wire                p4_far      = |(p4_depth >> AMOUNT_W);
  wire [AMOUNT_W-1:0] p4_amount   = p4_limited ? p4_depth[AMOUNT_W-1:0] | {AMOUNT_W{p4_far}}
                                  : {{(AMOUNT_W-POSITION_W){1'b0}}, p4_position};

  wire                 p5_sign;
  wire                 p5_nan;
  wire                 p5_infinite;
  wire [EXP_W-1:0]     p5_field;
  wire [AMOUNT_W-1:0]  p5_amount;
  wire [PRODUCT_W-1:0] p5_product;

  ffd_fp_stage #(
    .WIDTH  (3 + EXP_W + AMOUNT_W + PRODUCT_W),
    .LATENCY(LATENCY),
    .STEPS  (STEPS),
    .STEP   (4)
  ) u_stage4 (
    .clk(clk),
    .d_i({p4_sign, p4_nan, p4_infinite | p4_overflow, p4_field, p4_amount, p4_product}),
    .q_o({p5_sign, p5_nan, p5_infinite, p5_field, p5_amount, p5_product})
  );

  // Step 5: the shift; significand and guard bit end up lowest, zeros above them.
  wire [PRODUCT_W:0] p5_normal;
  wire               p5_sticky;

  ffd_fp_shift_right #(
    .WIDTH      (PRODUCT_W + 1),
    .AMOUNT_W   (AMOUNT_W),
    .LARGE_FIRST(1)
  ) u_normalise (
    .x_i     ({p5_product, 1'b0}),
    .amount_i(p5_amount),
    .y_o     (p5_normal),
    .sticky_o(p5_sticky)
  );

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
    .d_i({p5_sign, p5_nan, p5_infinite, p5_field, p5_normal[SIG_W:0], p5_sticky}),
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
    .STEP   (6)
  ) u_stage6 (
    .clk(clk),
    .d_i(p6_result),
    .q_o(result_o)
  );

  wire unused_ok = &{1'b0, p2_low, p2_inner[PRODUCT_W], p3_upper, p5_normal[PRODUCT_W:SIG_W+1]};
endmodule

`default_nettype wire
