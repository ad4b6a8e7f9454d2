// ffd_eval_point_product: point x point -> sum
//
// Formats:    fp32: the product. fxW: twice the product, exact (ffd_num_factor).
// Rounding:   that of ffd_num_term.
// Pipeline:   LATENCY registers, II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh, LATENCY >= 1.
// Model:      golden/include/hwffd/model/determinant.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_eval_point_product #(
  parameter FORMAT  = 18,
  parameter LATENCY = 1
) (
  input  wire                              clk,
  input  wire [`FFD_POINT_W(FORMAT)-1:0]   a_i,
  input  wire [`FFD_POINT_W(FORMAT)-1:0]   b_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]     product_o
);
  wire [`FFD_WEIGHT_W(FORMAT)-1:0] a;

  ffd_num_factor #(
    .FORMAT(FORMAT)
  ) u_factor (
    .point_i (a_i),
    .weight_o(a)
  );

  ffd_num_term #(
    .FORMAT (FORMAT),
    .LATENCY(LATENCY)
  ) u_term (
    .clk     (clk),
    .weight_i(a),
    .point_i (b_i),
    .term_o  (product_o)
  );
endmodule

`default_nettype wire
