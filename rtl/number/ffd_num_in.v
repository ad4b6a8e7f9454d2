// ffd_num_in: a word of the stream becomes a coordinate, a coefficient or a point
//
// One converter serves all three roles, which may change from clock to clock.
//
// Formats:    fp32: the word is the number. fxW, by role_i (docs/interface.md section 3):
//               coordinate   unsigned Q1.31, 0x80000000 = 1.0  ->  Q2.(W-2)
//               coefficient  Q2.30 (already times 2^-shift)    ->  Q2.(W-2)
//               point        Q1.31                             ->  Q1.(W-1)
//             Block: coordinates and points are binary32, aligned to 1 and to 2^exponent_i, the
//             exponent of the block; coefficients as in fxW. Weights are in the low bits of
//             number_o, and the bits above them are 0.
// Range:      nan_o and outside_o are what ffd_num_range says of the word, whatever its role. A
//             coordinate that is no number in [0, 1] becomes the nearer end, of a NaN the one that
//             its sign says, and is flagged; with clamp_i it is not flagged, and with one_i as well
//             it is 1, whatever the word. In fp32 only clamp_i and one_i change a coordinate.
//             clear_i makes any number 0 and clears its flags.
// Rounding:   half up; a word that rounds past the largest value saturates and is flagged.
// Pipeline:   LATENCY registers, II 1, never frozen. Of two in fixed point the first is in front
//             of the carry chain; in block formats they are those of ffd_bfp_align.
// Parameters: FORMAT as in ffd_num.vh, LATENCY >= 0 (the core's is FFD_IN_LATENCY).
// Model:      golden/include/hwffd/numerics (coordinate, coefficient, point, range).
// Test:       tests/unit/entry, tests/unit/fixed.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_in #(
  parameter FORMAT  = 18,
  parameter LATENCY = 0
) (
  input  wire                             clk,
  input  wire [1:0]                       role_i,
  input  wire                             clear_i,
  input  wire                             clamp_i,
  input  wire                             one_i,
  input  wire [31:0]                      word_i,
  input  wire [`FFD_EXPONENT_W-1:0]       exponent_i,
  output wire [`FFD_POINT_W(FORMAT)-1:0]  number_o,
  output wire                             nan_o,
  output wire                             outside_o
);
  localparam W      = `FFD_FIXED_W(FORMAT);
  localparam FLOAT  = FORMAT == `FFD_FORMAT_FP32 || `FFD_FORMAT_BLOCK(FORMAT);
  localparam FRONT  = LATENCY / 2;  // registers in front of the carry chain, and behind it
  localparam BEHIND = LATENCY - FRONT;

  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_in_format_is_unknown u_error ();
    end
    if (LATENCY < 0) begin : gen_bad_latency
      ERROR_ffd_num_in_latency_must_not_be_negative u_error ();
    end
  endgenerate

  // ---- range: what is taken as an end is 0, to which `one` adds 1

  wire        coordinate = role_i == `FFD_ROLE_COORDINATE;
  wire        nan;
  wire        outside;
  wire [31:0] clamped;
  ffd_num_range #(
    .FORMAT(FORMAT)
  ) u_range (
    .word_i   (word_i),
    .nan_o    (nan),
    .outside_o(outside),
    .clamped_o(clamped)
  );

  wire asked   = coordinate && clamp_i && one_i;
  wire off     = coordinate && (nan || outside) && (FORMAT != `FFD_FORMAT_FP32 || clamp_i);
  wire upper   = FLOAT != 0 ? !word_i[31] : !word_i[30];  // the nearer end is 1
  wire at_end  = asked || off;
  wire one     = !clear_i && (asked || (off && upper));
  wire flagged = !clear_i && off && !clamp_i;

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(LATENCY)
  ) u_range_delay (
    .clk(clk),
    .rst(1'b0),
    .d_i({nan, outside}),
    .q_o({nan_o, outside_o})
  );

  generate
    if (FORMAT == `FFD_FORMAT_FP32) begin : gen_float
      wire zero = clear_i || at_end;
      ffd_num_delay #(
        .WIDTH  (32),
        .LATENCY(LATENCY)
      ) u_number (
        .clk(clk),
        .rst(1'b0),
        .d_i((word_i & ~{32{zero}}) | (`FFD_ONE_WORD(FORMAT) & {32{one}})),
        .q_o(number_o)
      );
      wire unused_ok = &{1'b0, flagged};
    end else if (`FFD_FORMAT_BLOCK(FORMAT)) begin : gen_block
      ffd_bfp_align #(
        .W      (W),
        .LATENCY(LATENCY)
      ) u_align (
        .clk         (clk),
        .fixed_i     (role_i == `FFD_ROLE_COEFFICIENT),
        .coordinate_i(coordinate),
        .clear_i     (clear_i),
        .end_i       (at_end),
        .one_i       (one),
        .flagged_i   (flagged),
        .word_i      (word_i),
        .exponent_i  (exponent_i),
        .value_o     (number_o[W-1:0]),
        .saturated_o (number_o[W]),
        .plus_o      (number_o[W+1]),
        .minus_o     (number_o[W+2])
      );
    end else begin : gen_fixed
      // Nothing that rounds past the largest value is rounded up, so that nothing overflows.
      wire         zero  = clear_i || at_end;
      wire [32:0]  word  = coordinate ? {1'b0, word_i} : {word_i, 1'b0};
      wire         full;
      wire         up    = word[32-W] && !full && !zero;
      wire [W-1:0] floor = word[32:33-W] & ~{W{zero}};
      if (W < 32) begin : gen_full
        assign full = !coordinate && !word_i[31] && &word_i[30:31-W];
      end else begin : gen_exact
        assign full = 1'b0;
      end

      wire         p1_up;
      wire         p1_flag;
      wire [W-1:0] p1_floor;
      ffd_num_delay #(
        .WIDTH  (W + 2),
        .LATENCY(FRONT)
      ) u_ingress (
        .clk(clk),
        .rst(1'b0),
        .d_i({flagged | (full && !clear_i), up, floor[W-1], floor[W-2] | one, floor[W-3:0]}),
        .q_o({p1_flag, p1_up, p1_floor})
      );
      ffd_num_delay #(
        .WIDTH  (W + 1),
        .LATENCY(BEHIND)
      ) u_behind (
        .clk(clk),
        .rst(1'b0),
        .d_i({p1_flag, p1_floor + {{(W - 1) {1'b0}}, p1_up}}),
        .q_o(number_o)
      );
    end
  endgenerate

  wire unused_ok = &{1'b0, clk, exponent_i, clamped};
endmodule

`default_nettype wire
