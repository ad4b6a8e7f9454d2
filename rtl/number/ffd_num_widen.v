// ffd_num_widen: point -> sum
//
// Formats:    fxW only: Q1.(W-1) -> Q9.(2W-3), exact.
// Pipeline:   combinational.
// Parameters: FORMAT 8 to 32.
// Model:      none: its users' sums are the model's.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_widen #(
  parameter FORMAT = 18
) (
  input  wire [`FFD_POINT_W(FORMAT)-1:0]  point_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]    sum_o
);
  localparam W = `FFD_FIXED_W(FORMAT);

  generate
    if (`FFD_OFFSET_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_widen_needs_fixed_point u_error ();
    end
  endgenerate

  assign sum_o = {point_i[W], {8{point_i[W-1]}}, point_i[W-1:0], {(W - 2) {1'b0}}};
endmodule

`default_nettype wire
