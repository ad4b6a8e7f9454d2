// ffd_bfp_normalise: a sum in units of its block becomes a binary32 word
//
//   word = (value x 2^(exponent - (2W - 3))) rounded to binary32
//
// Six steps: magnitude; its leading zeros; the leading one brought to the top four bits, which
// gives the exponent field; it goes to the top, and how far is the field below 1; significand and
// field become those of a subnormal; all is rounded.
//
// Formats:    sum_i {minus, plus, saturated, Q9.(2W-3)}; exponent_i signed. plus alone is an
//             infinity, minus alone one below 0, both a NaN (0x7FC00000), whatever the value.
// Rounding:   to nearest even, once (ffd_fp_round). Overflow gives infinity; a zero is +0.
// Pipeline:   LATENCY registers spread over the six steps, II 1, never frozen.
// Parameters: 8 <= W <= 40, LATENCY >= 0.
// Model:      golden/include/hwffd/numerics/block.hpp (out).  Test: tests/unit/fixed.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_bfp_normalise #(
  parameter W       = 35,
  parameter LATENCY = 3
) (
  input  wire                        clk,
  input  wire [2*W+8:0]              sum_i,
  input  wire [`FFD_EXPONENT_W-1:0]  exponent_i,
  output wire [31:0]                 word_o,
  output wire                        saturated_o,
  output wire                        nan_o
);
  localparam VALUE_W = 2 * W + 6;
  localparam COUNT_W = $clog2(VALUE_W);
  localparam FIELD_W = `FFD_EXPONENT_W + 2;
  localparam HEAD_W  = 26;  // significand, guard, sticky
  localparam NEAR_W  = HEAD_W + 3;
  localparam CLASS_W = 4;   // {minus, plus, saturated, sign}

  localparam [FIELD_W-1:0] TOP      = 135;  // field of a leading one at the top, less exponent_i
  localparam [FIELD_W-1:0] LARGEST  = 254;
  localparam [FIELD_W-1:0] ONE      = 1;
  localparam [FIELD_W-1:0] FARTHEST = HEAD_W;

  // Registers behind each step; the last has one before any other.
  localparam FIRST  = LATENCY / 6;
  localparam SECOND = LATENCY / 3 - LATENCY / 6;
  localparam THIRD  = LATENCY / 2 - LATENCY / 3;
  localparam FOURTH = (2 * LATENCY) / 3 - LATENCY / 2;
  localparam FIFTH  = (5 * LATENCY) / 6 - (2 * LATENCY) / 3;
  localparam SIXTH  = LATENCY - (5 * LATENCY) / 6;

  generate
    if (W < 8 || W > 40) begin : gen_bad_width
      ERROR_ffd_bfp_normalise_width_must_be_8_to_40 u_error ();
    end
  endgenerate

  // ---- magnitude and leading zeros

  wire               sign      = sum_i[VALUE_W-1];
  wire [VALUE_W-1:0] value     = sum_i[VALUE_W-1:0];
  wire [VALUE_W-1:0] magnitude = sign ? -value : value;

  wire [VALUE_W-1:0]         p0_magnitude;
  wire [`FFD_EXPONENT_W-1:0] p0_exponent;
  wire [CLASS_W-1:0]         p0_class;

  ffd_num_delay #(
    .WIDTH  (VALUE_W + `FFD_EXPONENT_W + CLASS_W),
    .LATENCY(FIRST)
  ) u_magnitude (
    .clk(clk),
    .rst(1'b0),
    .d_i({magnitude, exponent_i, sum_i[VALUE_W +: 3], sign}),
    .q_o({p0_magnitude, p0_exponent, p0_class})
  );

  wire [COUNT_W-1:0] zeros;
  wire               none;

  ffd_fp_lzc #(
    .WIDTH(VALUE_W)
  ) u_zeros (
    .x_i    (p0_magnitude),
    .count_o(zeros),
    .none_o (none)
  );

  wire [VALUE_W-1:0]         p1_magnitude;
  wire [COUNT_W-1:0]         p1_zeros;
  wire                       p1_none;
  wire [`FFD_EXPONENT_W-1:0] p1_exponent;
  wire [CLASS_W-1:0]         p1_class;

  ffd_num_delay #(
    .WIDTH  (VALUE_W + COUNT_W + 1 + `FFD_EXPONENT_W + CLASS_W),
    .LATENCY(SECOND)
  ) u_counted (
    .clk(clk),
    .rst(1'b0),
    .d_i({p0_magnitude, zeros, none, p0_exponent, p0_class}),
    .q_o({p1_magnitude, p1_zeros, p1_none, p1_exponent, p1_class})
  );

  // ---- the leading one near the top, where the exponent field is exponent_i + 135

  wire [VALUE_W-1:0] coarse;
  ffd_fp_shift_left #(
    .WIDTH   (VALUE_W),
    .AMOUNT_W(COUNT_W)
  ) u_coarse (
    .x_i     (p1_magnitude),
    .amount_i({p1_zeros[COUNT_W-1:2], 2'd0}),
    .y_o     (coarse)
  );

  // The exponent field as if it had no ends: -462 to 646.
  wire [FIELD_W-1:0] field = TOP + {{2{p1_exponent[`FFD_EXPONENT_W-1]}}, p1_exponent} -
                             {{(FIELD_W - COUNT_W) {1'b0}}, p1_zeros};
  wire [NEAR_W-1:0]  near;
  generate
    if (VALUE_W > NEAR_W) begin : gen_wide
      assign near = {coarse[VALUE_W-1 -: NEAR_W-1], |coarse[VALUE_W-NEAR_W:0]};
    end else begin : gen_narrow
      assign near = {coarse, {(NEAR_W - VALUE_W) {1'b0}}};
    end
  endgenerate

  wire [NEAR_W-1:0]  p2_near;
  wire [1:0]         p2_zeros;
  wire [FIELD_W-1:0] p2_field;
  wire               p2_none;
  wire [CLASS_W-1:0] p2_class;

  ffd_num_delay #(
    .WIDTH  (NEAR_W + 2 + FIELD_W + 1 + CLASS_W),
    .LATENCY(THIRD)
  ) u_near (
    .clk(clk),
    .rst(1'b0),
    .d_i({near, p1_zeros[1:0], field, p1_none, p1_class}),
    .q_o({p2_near, p2_zeros, p2_field, p2_none, p2_class})
  );

  // ---- at the top; subnormals, infinities, rounding

  wire [NEAR_W-1:0]  top     = p2_near << p2_zeros;
  wire [HEAD_W-1:0]  p2_head = {top[NEAR_W-1 -: HEAD_W-1], |top[NEAR_W-HEAD_W:0]};
  wire               below   = p2_field[FIELD_W-1] || p2_field == {FIELD_W{1'b0}};
  wire [FIELD_W-1:0] down    = ONE - p2_field;
  wire [4:0]         amount  = !below ? 5'd0 : down > FARTHEST ? FARTHEST[4:0] : down[4:0];

  wire [HEAD_W-1:0]  p3_head;
  wire [FIELD_W-1:0] p3_field;
  wire [4:0]         p3_amount;
  wire               p3_below;
  wire               p3_none;
  wire [CLASS_W-1:0] p3_class;

  ffd_num_delay #(
    .WIDTH  (HEAD_W + FIELD_W + 5 + 2 + CLASS_W),
    .LATENCY(FOURTH)
  ) u_amount (
    .clk(clk),
    .rst(1'b0),
    .d_i({p2_head, p2_field, amount, below, p2_none, p2_class}),
    .q_o({p3_head, p3_field, p3_amount, p3_below, p3_none, p3_class})
  );

  wire [HEAD_W-1:0] shifted;
  wire              sticky;

  ffd_fp_shift_right #(
    .WIDTH   (HEAD_W),
    .AMOUNT_W(5)
  ) u_subnormal (
    .x_i     (p3_head),
    .amount_i(p3_amount),
    .y_o     (shifted),
    .sticky_o(sticky)
  );

  wire        plus     = p3_class[2];
  wire        minus    = p3_class[3];
  wire        huge     = !p3_below && p3_field > LARGEST && !p3_none;
  wire        infinite = plus || minus || huge;
  wire        nan      = plus && minus;

  wire [FIELD_W-1:0] biased = p3_below || p3_none ? {FIELD_W{1'b0}} : p3_field - ONE;

  wire              p4_sign;
  wire [7:0]        p4_exponent;
  wire [HEAD_W-1:0] p4_significand;
  wire              p4_sticky;
  wire              p4_infinite;
  wire              p4_nan;
  wire              p4_saturated;

  ffd_num_delay #(
    .WIDTH  (1 + 8 + HEAD_W + 4),
    .LATENCY(FIFTH)
  ) u_shifted (
    .clk(clk),
    .rst(1'b0),
    .d_i({plus || minus ? minus : p3_class[0], biased[7:0], shifted, sticky, infinite, nan,
          p3_class[1]}),
    .q_o({p4_sign, p4_exponent, p4_significand, p4_sticky, p4_infinite, p4_nan, p4_saturated})
  );

  wire [31:0] word;

  ffd_fp_round #(
    .EXP_W(8),
    .SIG_W(24)
  ) u_round (
    .sign_i       (p4_sign),
    .exponent_i   (p4_exponent),
    .significand_i(p4_significand[HEAD_W-1:2]),
    .guard_i      (p4_significand[1]),
    .sticky_i     (p4_significand[0] || p4_sticky),
    .infinite_i   (p4_infinite),
    .nan_i        (p4_nan),
    .result_o     (word)
  );

  ffd_num_delay #(
    .WIDTH  (34),
    .LATENCY(SIXTH)
  ) u_word (
    .clk(clk),
    .rst(1'b0),
    .d_i({p4_nan, p4_saturated, word}),
    .q_o({nan_o, saturated_o, word_o})
  );

  wire unused_ok = &{1'b0, biased[FIELD_W-1:8]};
endmodule

`default_nettype wire
