// ffd_num_factor: point -> weight, so that two points can be multiplied
//
// Formats:    fp32: the number. fxW: its double, exact: the same bits read as Q2.(W-2).
// Pipeline:   combinational.
// Parameters: FORMAT as in ffd_num.vh.
// Model:      golden/include/hwffd/numerics (factor).  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_factor #(
  parameter FORMAT = 18
) (
  input  wire [`FFD_POINT_W(FORMAT)-1:0]   point_i,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]  weight_o
);
  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_factor_format_is_unknown u_error ();
    end
  endgenerate

  assign weight_o = point_i;
endmodule

`default_nettype wire
