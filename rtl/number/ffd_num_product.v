// ffd_num_product: point x point -> sum
//
// Formats:    fp32: the product. fxW, block: twice the product, exact: one point's bits are read as
//             a weight. Block: NaN where either is no finite number.
// Rounding:   that of ffd_num_term.
// Pipeline:   LATENCY registers, II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh, LATENCY >= 1.
// Model:      golden/include/hwffd/numerics (product).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_product #(
  parameter FORMAT  = 18,
  parameter LATENCY = 1
) (
  input  wire                             clk,
  input  wire [`FFD_POINT_W(FORMAT)-1:0]  a_i,
  input  wire [`FFD_POINT_W(FORMAT)-1:0]  b_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]    product_o
);
  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_product_format_is_unknown u_error ();
    end
  endgenerate

  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  wire [`FFD_POINT_W(FORMAT)-1:0] other;

  generate
    if (`FFD_FORMAT_BLOCK(FORMAT)) begin : gen_block
      wire special = |a_i[WEIGHT_W +: 2] || |b_i[WEIGHT_W +: 2];
      assign other = {{2{special}}, b_i[WEIGHT_W-1:0]};
    end else begin : gen_plain
      assign other = b_i;
    end
  endgenerate

  ffd_num_term #(
    .FORMAT (FORMAT),
    .LATENCY(LATENCY)
  ) u_term (
    .clk     (clk),
    .weight_i(a_i[WEIGHT_W-1:0]),
    .point_i (other),
    .term_o  (product_o)
  );
endmodule

`default_nettype wire
