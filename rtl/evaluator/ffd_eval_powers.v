// ffd_eval_powers: the four weights of an axis by bank, the uniform cubic B-spline wired in
//
// From the powers s^2 and s^3: two multiplications for all four weights of an axis. What is loaded
// is ignored, and the bits are not those of the loaded B-spline: weights sum to one exactly, those
// of a derivative to zero.
//
// Formats, rounding: those of ffd_num_powers.
// Pipeline:   ffd_num_powers | CONVERT_LATENCY: FFD_POLY_LATENCY in all, without a file. II 1,
//             never frozen.
// Parameters: those of ffd_num_powers; CONVERT_LATENCY >= 0.
// Model:      golden/include/hwffd/model/org_powers.hpp.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_powers #(
  parameter FORMAT          = 17,
  parameter MUL_LATENCY     = 1,
  parameter ADD_LATENCY     = 1,
  parameter CONVERT_LATENCY = 0
) (
  input  wire                                clk,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]    coordinate_i,
  input  wire [1:0]                          residue_i,  // of the cell, modulo 4
  input  wire                                derivative_i,
  output wire [4*`FFD_WEIGHT_W(FORMAT)-1:0]  weights_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam STEP     = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, 0);
  localparam TOTAL    = `FFD_POLY_LATENCY(`FFD_EVALUATOR_POWERS, 0, STEP, CONVERT_LATENCY);
  `FFD_TAKES(TOTAL)

  wire [4*WEIGHT_W-1:0] of_function;
  wire [4*WEIGHT_W-1:0] of_bank;
  wire [1:0]            residue;

  ffd_num_powers #(
    .FORMAT     (FORMAT),
    .MUL_LATENCY(MUL_LATENCY),
    .ADD_LATENCY(ADD_LATENCY)
  ) u_powers (
    .clk         (clk),
    .coordinate_i(coordinate_i),
    .derivative_i(derivative_i),
    .weights_o   (of_function)
  );

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(TOTAL - CONVERT_LATENCY)
  ) u_residue (
    .clk(clk),
    .rst(1'b0),
    .d_i(residue_i),
    .q_o(residue)
  );

  // Bank b has the function (b - residue) mod 4: turned by one, then by two. (An index that is
  // computed would be given a multiplier.)
  wire [4*WEIGHT_W-1:0] turned = residue[0] ? {of_function[0 +: 3*WEIGHT_W],
                                               of_function[3*WEIGHT_W +: WEIGHT_W]} : of_function;
  assign of_bank = residue[1] ? {turned[0 +: 2*WEIGHT_W], turned[2*WEIGHT_W +: 2*WEIGHT_W]}
                              : turned;

  ffd_num_delay #(
    .WIDTH  (4 * WEIGHT_W),
    .LATENCY(CONVERT_LATENCY)
  ) u_weights (
    .clk(clk),
    .rst(1'b0),
    .d_i(of_bank),
    .q_o(weights_o)
  );
endmodule

`default_nettype wire
