// ffd_num_term: weight x point -> sum
//
// Rounding:   fp32: to nearest even. fxW: none, the product Q3.(2W-3) is exact and fits the sum.
// Pipeline:   LATENCY registers, II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh, LATENCY >= 1.
// Model:      golden/include/hwffd/numerics (term).  Test: tests/unit/fixed, tests/unit/float.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_term #(
  parameter FORMAT  = 18,
  parameter LATENCY = 1
) (
  input  wire                              clk,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  weight_i,
  input  wire [`FFD_POINT_W(FORMAT)-1:0]   point_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]     term_o
);
  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_term_format_is_unknown u_error ();
    end
    if (LATENCY < 1) begin : gen_bad_latency
      ERROR_ffd_num_term_latency_must_be_at_least_1 u_error ();
    end
  endgenerate

  generate
    if (FORMAT == `FFD_FORMAT_FP32) begin : gen_float
      ffd_fp_mul #(
        .EXP_W  (8),
        .SIG_W  (24),
        .LATENCY(LATENCY)
      ) u_mul (
        .clk     (clk),
        .a_i     (weight_i),
        .b_i     (point_i),
        .result_o(term_o)
      );
    end else begin : gen_fixed
      wire signed [2*FORMAT-1:0] product;
      wire                       flag;

      ffd_fx_product #(
        .W      (FORMAT),
        .LATENCY(LATENCY)
      ) u_product (
        .clk      (clk),
        .a_i      (weight_i[FORMAT-1:0]),
        .b_i      (point_i[FORMAT-1:0]),
        .flag_i   (weight_i[FORMAT] | point_i[FORMAT]),
        .product_o(product),
        .flag_o   (flag)
      );

      assign term_o = {flag, {6{product[2*FORMAT-1]}}, product};
    end
  endgenerate
endmodule

`default_nettype wire
