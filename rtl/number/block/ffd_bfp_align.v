// ffd_bfp_align: a binary32 word becomes fixed point in units of its block
//
//   value = floor(word x 2^(W - 1 - exponent) + 1/2), so that 2^exponent is 1 in Q1.(W-1)
//
// The significand is shifted to the left by (exponent field) - exponent - 87 in a window of 64 bits
// whose highest W are the value: what lies below them rounds, what leaves the window overflows. A
// fixed-point word (fixed_i) is the upper half of the window as it stands.
//
// Formats:    exponent_i signed, of coordinate_i it is 1; value_o signed W bits. Infinities and NaN
//             have value 0, not saturated; an infinity has plus_o or minus_o by its sign and a NaN
//             both, but with coordinate_i neither. With end_i the value is 0, and with one_i as
//             well 2^(W-2), flagged if flagged_i; clear_i, without these two, clears value and
//             flags.
// Rounding:   half up, once (ffd_fx_round): of a magnitude below 0 a tie is rounded down.
// Overflow:   outside [-2^exponent, 2^exponent) saturated and flagged.
// Pipeline:   LATENCY registers, II 1, never frozen; of four: distance | shift by 15 | by 48,
//             sign | round.
// Parameters: 8 <= W <= 40, LATENCY >= 0.
// Model:      golden/include/hwffd/numerics/block.hpp (point, coordinate).
// Test:       tests/unit/entry, tests/unit/fixed.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_bfp_align #(
  parameter W       = 35,
  parameter LATENCY = 0
) (
  input  wire                        clk,
  input  wire                        fixed_i,
  input  wire                        coordinate_i,
  input  wire                        clear_i,
  input  wire                        end_i,
  input  wire                        one_i,
  input  wire                        flagged_i,
  input  wire [31:0]                 word_i,
  input  wire [`FFD_EXPONENT_W-1:0]  exponent_i,
  output wire signed [W-1:0]         value_o,
  output wire                        saturated_o,
  output wire                        plus_o,
  output wire                        minus_o
);
  localparam DISTANCE_W = `FFD_EXPONENT_W + 1;  // of -598 to 680
  localparam BELOW      = 64 - W;               // bits of the window below the value
  localparam FLAGS_W    = 3;

  generate
    if (W < 8 || W > 40) begin : gen_bad_width
      ERROR_ffd_bfp_align_width_must_be_8_to_40 u_error ();
    end
    if (LATENCY < 0) begin : gen_bad_latency
      ERROR_ffd_bfp_align_latency_must_not_be_negative u_error ();
    end
  endgenerate

  // ---- 1: parts, and the distance to shift

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

  localparam [DISTANCE_W-1:0] BIAS = 87;
  wire [DISTANCE_W-1:0] exponent = {exponent_i[`FFD_EXPONENT_W-1], exponent_i};
  wire [DISTANCE_W-1:0] origin   = coordinate_i ? BIAS + 1'b1 : exponent + BIAS;
  wire [DISTANCE_W-1:0] distance = {{(DISTANCE_W - 8) {1'b0}}, field} - origin;
  wire                  special  = infinite || nan;
  wire                  none     = clear_i || (special && !fixed_i);
  wire                  named    = special && !fixed_i && !coordinate_i && !clear_i;

  wire [FLAGS_W-1:0]    flags1;
  wire [DISTANCE_W-1:0] distance1;
  wire                  fixed1;
  wire                  none1;
  wire                  end1;
  wire                  one1;
  wire                  zero1;
  wire                  sign1;
  wire [31:0]           x1;
  ffd_num_delay #(
    .WIDTH  (FLAGS_W + DISTANCE_W + 6 + 32),
    .LATENCY(LATENCY / 4)
  ) u_decoded (
    .clk(clk),
    .rst(1'b0),
    .d_i({flagged_i, named && (nan || !sign), named && (nan || sign), distance, fixed_i, none,
          end_i, one_i, zero, sign, word_i[31:25], word_i[24] && fixed_i,
          fixed_i ? word_i[23] : significand[23], word_i[22:0]}),
    .q_o({flags1, distance1, fixed1, none1, end1, one1, zero1, sign1, x1})
  );

  // ---- 2: 1 + 2 + 4 + 8 of the distance

  // A distance below 0 leaves nothing, not even the half of a unit. Above the significand, which
  // comes from bit 23 to bit 38, there is only a fixed-point word, which stays.
  wire         gone   = none1 || end1 || (distance1[DISTANCE_W-1] && !fixed1);
  wire [5:0]   amount = fixed1 ? 6'd32 : distance1[5:0];
  wire         beyond = !gone && !fixed1 && !zero1 && |distance1[DISTANCE_W-2:6];
  wire [31:25] high   = x1[31:25] & {7{fixed1 && !gone}};
  wire [24:0]  by1    = (amount[0] ? {x1[23:0], 1'b0} : x1[24:0]) & ~{25{gone}};
  wire [26:0]  by2    = amount[1] ? {by1, 2'b0} : {high[26:25], by1};
  wire [30:0]  by4    = amount[2] ? {by2, 4'b0} : {high[30:27], by2};
  wire [38:0]  by8    = amount[3] ? {by4, 8'b0} : {7'b0, high[31], by4};

  wire [FLAGS_W-1:0] flags2;
  wire               one2;
  wire               beyond2;
  wire               negate2;
  wire               sign2;
  wire [1:0]         amount2;
  wire [38:0]        x2;
  ffd_num_delay #(
    .WIDTH  (FLAGS_W + 4 + 2 + 39),
    .LATENCY((2 * LATENCY) / 4 - LATENCY / 4)
  ) u_near (
    .clk(clk),
    .rst(1'b0),
    .d_i({flags1, one1, beyond, sign1 && !fixed1 && !gone, sign1 && !gone, amount[5:4], by8}),
    .q_o({flags2, one2, beyond2, negate2, sign2, amount2, x2})
  );

  // ---- 3: the rest of it, and the complement of what is below 0

  wire [54:0]  by16  = amount2[0] ? {x2, 16'b0} : {16'b0, x2};
  wire [86:0]  by32  = amount2[1] ? {by16, 32'b0} : {32'b0, by16};
  wire         half  = by32[BELOW-1];
  wire         rest  = |by32[BELOW-2:BELOW-24];  // all there can be below a half
  wire         over  = beyond2 || |by32[86:64];
  wire [W-1:0] value = (by32[63:BELOW] | {1'b0, one2, {(W - 2) {1'b0}}}) ^ {W{negate2}};

  wire [FLAGS_W-1:0] flags3;
  wire               over3;
  wire               sign3;
  wire               up3;
  wire [W-1:0]       value3;
  ffd_num_delay #(
    .WIDTH  (FLAGS_W + 3 + W),
    .LATENCY((3 * LATENCY) / 4 - (2 * LATENCY) / 4)
  ) u_far (
    .clk(clk),
    .rst(1'b0),
    .d_i({flags2, over, sign2, negate2 ? !(half && rest) : half, value}),
    .q_o({flags3, over3, sign3, up3, value3})
  );

  // ---- 4: round; two signs that differ saturate

  wire signed [W-1:0] rounded;
  wire                saturated;
  ffd_fx_round #(
    .IN_W (W + 3),
    .DROP (1),
    .OUT_W(W)
  ) u_round (
    .value_i    ({sign3, sign3 ^ over3, value3, up3}),
    .addend_i   ({W{1'b0}}),
    .value_o    (rounded),
    .saturated_o(saturated)
  );

  ffd_num_delay #(
    .WIDTH  (3 + W),
    .LATENCY(LATENCY - (3 * LATENCY) / 4)
  ) u_value (
    .clk(clk),
    .rst(1'b0),
    .d_i({flags3[0], flags3[1], flags3[2] | saturated, rounded}),
    .q_o({minus_o, plus_o, saturated_o, value_o})
  );

  wire unused_ok = &{1'b0, significand[22:0], by32};
endmodule

`default_nettype wire
