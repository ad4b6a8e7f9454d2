// ffd_bfp_align: a binary32 word becomes fixed point in units of its block
//
//   value = floor(word x 2^(W - 1 - exponent) + 1/2), so that 2^exponent is 1 in Q1.(W-1)
//
// The significand stands at the top, as large as any value that fits can have it, and is shifted to
// the right by 150 + exponent - (exponent field); a shift to the left of there is an overflow.
//
// Formats:    exponent_i signed; value_o signed W bits. An infinity has plus_o or minus_o by its
//             sign, a NaN both; their value is 0 and not saturated.
// Rounding:   half up, once (ffd_fx_round, which sees two bits below the unit: half and sticky).
// Overflow:   outside [-2^exponent, 2^exponent) saturated and flagged.
// Pipeline:   combinational.
// Parameters: 8 <= W <= 40: the aligned word and its bits below have W + 25 <= 65 bits.
// Model:      golden/include/hwffd/numerics/block.hpp (point, coordinate).  Test: tests/unit/fixed.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_bfp_align #(
  parameter W = 35
) (
  input  wire [31:0]                 word_i,
  input  wire [`FFD_EXPONENT_W-1:0]  exponent_i,
  output wire signed [W-1:0]         value_o,
  output wire                        saturated_o,
  output wire                        plus_o,
  output wire                        minus_o
);
  localparam ALIGNED_W = 24 + W + 1;  // the significand W - 1 bits up, two bits below the unit
  localparam SHIFT_W   = $clog2(ALIGNED_W + 1);
  localparam REACH_W   = `FFD_EXPONENT_W + 2;
  localparam [REACH_W-1:0] MOST = ALIGNED_W[REACH_W-1:0];
  localparam [REACH_W-1:0] BIAS = 150;

  generate
    if (W < 8 || W > 40) begin : gen_bad_width
      ERROR_ffd_bfp_align_width_must_be_8_to_40 u_error ();
    end
  endgenerate

  wire        sign;
  wire [7:0]  field;
  wire [23:0] significand;
  wire        zero;
  wire        infinite;
  wire        nan;

  ffd_fp_unpack #(
    .EXP_W(8),
    .SIG_W(24)
  ) u_unpack (
    .word_i       (word_i),
    .sign_o       (sign),
    .exponent_o   (field),
    .significand_o(significand),
    .zero_o       (zero),
    .infinite_o   (infinite),
    .nan_o        (nan)
  );

  // 150 + exponent - field: -617 to 660.
  wire [REACH_W-1:0] shift = BIAS + {{2{exponent_i[`FFD_EXPONENT_W-1]}}, exponent_i} -
                             {{(REACH_W - 8) {1'b0}}, field};
  wire               left  = shift[REACH_W-1];
  wire               far   = shift > MOST;

  wire [ALIGNED_W-1:0] shifted;
  wire                 sticky;
  ffd_fp_shift_right #(
    .WIDTH   (ALIGNED_W),
    .AMOUNT_W(SHIFT_W)
  ) u_shift (
    .x_i     ({significand, {(W + 1) {1'b0}}}),
    .amount_i(far ? MOST[SHIFT_W-1:0] : shift[SHIFT_W-1:0]),
    .y_o     (shifted),
    .sticky_o(sticky)
  );

  // Beyond the shifter all ones are larger than any value that fits.
  wire                      finite    = !infinite && !nan;
  wire                      nonzero   = finite && !zero;
  wire [ALIGNED_W-1:0]      magnitude = (shifted | {ALIGNED_W{left}}) & {ALIGNED_W{nonzero}};
  wire signed [ALIGNED_W:0] positive  = {1'b0, magnitude[ALIGNED_W-1:1],
                                         magnitude[0] | (sticky && nonzero)};

  ffd_fx_round #(
    .IN_W (ALIGNED_W + 1),
    .DROP (2),
    .OUT_W(W)
  ) u_round (
    .value_i    (sign ? -positive : positive),
    .addend_i   ({W{1'b0}}),
    .value_o    (value_o),
    .saturated_o(saturated_o)
  );

  assign plus_o  = nan || (infinite && !sign);
  assign minus_o = nan || (infinite && sign);
endmodule

`default_nettype wire
