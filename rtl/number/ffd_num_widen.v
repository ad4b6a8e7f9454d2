// ffd_num_widen: point x 2^shift -> sum, the value of a nested form whose coefficients were halved
//
// Formats:    fp32: a wire, the shift is ignored. Else: Q1.(W-1) -> Q9.(2W-3), exact.
// Pipeline:   combinational.
// Parameters: FORMAT as in ffd_num.vh.
// Model:      golden/include/hwffd/numerics (widen).  Test: tests/unit/fixed.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_widen #(
  parameter FORMAT = 18
) (
  input  wire [`FFD_POINT_W(FORMAT)-1:0]  point_i,
  input  wire [1:0]                       shift_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]    sum_o
);
  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_widen_format_is_unknown u_error ();
    end
  endgenerate

  generate
    if (FORMAT == `FFD_FORMAT_FP32) begin : gen_float
      assign sum_o = point_i;
      wire unused_ok = &{1'b0, shift_i};
    end else begin : gen_fixed
      localparam W       = `FFD_FIXED_W(FORMAT);
      localparam VALUE_W = 2 * W + 6;
      wire signed [VALUE_W-1:0] value = {{8{point_i[W-1]}}, point_i[W-1:0],
                                         {(W - 2) {1'b0}}};
      assign sum_o[VALUE_W:0] = {point_i[W], value <<< shift_i};
      if (`FFD_FORMAT_BLOCK(FORMAT)) begin : gen_class
        assign sum_o[VALUE_W+1 +: 2] = point_i[W+1 +: 2];
      end
    end
  endgenerate
endmodule

`default_nettype wire
