// ffd_num_bspline: a coefficient of the uniform cubic B-spline or of its derivative, wired in
//
// The watertight form of docs/numerics.md section 5, with one sixth, A, rounded once: in binary32
// 2796203 * 2^-24, in fixed point the nearest multiple of the weight's unit, or of 2^-30, which is
// that of a coefficient's word, where the weight has more bits. The derivative is that of the true
// B-spline, exact; in fixed point it is halved (section 9). Both have the shift 0.
//
// Formats:    a weight, never flagged.
// Pipeline:   combinational.
// Parameters: FORMAT as in ffd_num.vh, POWER 0 to 3: of x.
// Model:      golden/include/hwffd/stream/blending.hpp (watertight_bspline).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_bspline #(
  parameter FORMAT = 18,
  parameter POWER  = 0
) (
  input  wire                              derivative_i,
  input  wire [1:0]                        function_i,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]  coefficient_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);

  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_bspline_format_is_unknown u_error ();
    end
    if (POWER < 0 || POWER > 3) begin : gen_bad_power
      ERROR_ffd_num_bspline_power_must_be_0_to_3 u_error ();
    end
  endgenerate

  // The format's words for the numbers that occur.
  wire [WEIGHT_W-1:0] zero = {WEIGHT_W{1'b0}};
  wire [WEIGHT_W-1:0] sixth;              // A
  wire [WEIGHT_W-1:0] minus_sixth;        // -A
  wire [WEIGHT_W-1:0] three_sixths;       // 3 A, not quite 1/2
  wire [WEIGHT_W-1:0] minus_three_sixths; // -3 A
  wire [WEIGHT_W-1:0] rest;               // 1 - 2 A
  wire [WEIGHT_W-1:0] half;               // 1/2
  wire [WEIGHT_W-1:0] minus_half;         // -1/2
  wire [WEIGHT_W-1:0] minus_one;          // -1
  // Of the derivative, in fixed point halved.
  wire [WEIGHT_W-1:0] d_half;             // 1/2
  wire [WEIGHT_W-1:0] d_minus_half;       // -1/2
  wire [WEIGHT_W-1:0] d_one;              // 1
  wire [WEIGHT_W-1:0] d_minus_two;        // -2
  wire [WEIGHT_W-1:0] d_three_halves;     // 3/2
  wire [WEIGHT_W-1:0] d_minus_three_halves;

  generate
    if (FORMAT == `FFD_FORMAT_FP32) begin : gen_float
      assign sixth                = 32'h3E2A_AAAC;
      assign minus_sixth          = 32'hBE2A_AAAC;
      assign three_sixths         = 32'h3F00_0001;
      assign minus_three_sixths   = 32'hBF00_0001;
      assign rest                 = 32'h3F2A_AAAA;
      assign half                 = 32'h3F00_0000;
      assign minus_half           = 32'hBF00_0000;
      assign minus_one            = 32'hBF80_0000;
      assign d_half               = half;
      assign d_minus_half         = minus_half;
      assign d_one                = 32'h3F80_0000;
      assign d_minus_two          = 32'hC000_0000;
      assign d_three_halves       = 32'h3FC0_0000;
      assign d_minus_three_halves = 32'hBFC0_0000;
    end else begin : gen_fixed
      localparam W        = `FFD_FIXED_W(FORMAT);
      localparam FRACTION = W < 32 ? W - 2 : 30;
      localparam PAD      = W - 2 - FRACTION;
      localparam SIXTH    = ((1 << FRACTION) + 3) / 6;
      localparam THREE_OF = 3 * SIXTH;
      localparam REST_OF  = (1 << FRACTION) - 2 * SIXTH;
      localparam [W-1:0] UNIT    = 1 << PAD;
      localparam [W-1:0] A       = SIXTH * UNIT;
      localparam [W-1:0] ONE     = (1 << FRACTION) * UNIT;
      localparam [W-1:0] HALF    = (1 << (FRACTION - 1)) * UNIT;
      localparam [W-1:0] QUARTER = (1 << (FRACTION - 2)) * UNIT;
      localparam [W-1:0] THREE   = THREE_OF * UNIT;
      localparam [W-1:0] REST    = REST_OF * UNIT;
      localparam [W-1:0] NONE    = 0;
      assign sixth                = {1'b0, A};
      assign minus_sixth          = {1'b0, NONE - A};
      assign three_sixths         = {1'b0, THREE};
      assign minus_three_sixths   = {1'b0, NONE - THREE};
      assign rest                 = {1'b0, REST};
      assign half                 = {1'b0, HALF};
      assign minus_half           = {1'b0, NONE - HALF};
      assign minus_one            = {1'b0, NONE - ONE};
      assign d_half               = {1'b0, QUARTER};
      assign d_minus_half         = {1'b0, NONE - QUARTER};
      assign d_one                = half;
      assign d_minus_two          = minus_one;
      assign d_three_halves       = {1'b0, HALF + QUARTER};
      assign d_minus_three_halves = {1'b0, NONE - HALF - QUARTER};
    end
  endgenerate

  wire [WEIGHT_W-1:0] b0 = POWER == 0 ? sixth : POWER == 1 ? minus_half :
                           POWER == 2 ? half : minus_sixth;
  wire [WEIGHT_W-1:0] b1 = POWER == 0 ? rest : POWER == 1 ? zero :
                           POWER == 2 ? minus_one : three_sixths;
  wire [WEIGHT_W-1:0] b2 = POWER == 0 ? sixth : POWER == 3 ? minus_three_sixths : half;
  wire [WEIGHT_W-1:0] b3 = POWER == 3 ? sixth : zero;

  wire [WEIGHT_W-1:0] d0 = POWER == 1 ? d_one : POWER == 3 ? zero : d_minus_half;
  wire [WEIGHT_W-1:0] d1 = POWER == 1 ? d_minus_two : POWER == 2 ? d_three_halves : zero;
  wire [WEIGHT_W-1:0] d2 = POWER == 0 ? d_half : POWER == 1 ? d_one :
                           POWER == 2 ? d_minus_three_halves : zero;
  wire [WEIGHT_W-1:0] d3 = POWER == 2 ? d_half : zero;

  wire [WEIGHT_W-1:0] b = function_i[1] ? (function_i[0] ? b3 : b2) : (function_i[0] ? b1 : b0);
  wire [WEIGHT_W-1:0] d = function_i[1] ? (function_i[0] ? d3 : d2) : (function_i[0] ? d1 : d0);
  assign coefficient_o = derivative_i ? d : b;
endmodule

`default_nettype wire
