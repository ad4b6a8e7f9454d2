// ffd_num_negate: -sum
//
// Formats:    fp32: the sign turned round, of a NaN too; ffd_num_add makes +0 and the canonical NaN
//             of what comes of it. fxW, block: exact; a saturated number stays flagged, infinities
//             change sign.
// Overflow:   fxW, block: none, sums lie within [-128, 128] of Q9.
// Pipeline:   combinational.
// Parameters: FORMAT as in ffd_num.vh.
// Model:      golden/include/hwffd/numerics (negate).  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_negate #(
  parameter FORMAT = 18
) (
  input  wire [`FFD_SUM_W(FORMAT)-1:0]  sum_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]  negative_o
);
  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_negate_format_is_unknown u_error ();
    end
  endgenerate

  generate
    if (FORMAT == `FFD_FORMAT_FP32) begin : gen_float
      assign negative_o = {!sum_i[31], sum_i[30:0]};
    end else begin : gen_fixed
      localparam VALUE_W = 2 * `FFD_FIXED_W(FORMAT) + 6;
      assign negative_o[VALUE_W:0] = {sum_i[VALUE_W], {VALUE_W{1'b0}} - sum_i[VALUE_W-1:0]};
      if (`FFD_FORMAT_BLOCK(FORMAT)) begin : gen_class
        assign negative_o[VALUE_W+1 +: 2] = {sum_i[VALUE_W+1], sum_i[VALUE_W+2]};
      end
    end
  endgenerate
endmodule

`default_nettype wire
