// ffd_num_term: weight x point -> sum
//
// Rounding:   fp32: to nearest even. Else: none, the product Q3.(2W-3) is exact and fits the sum.
// Infinities: block: times a weight below 0 of the other sign, times 0 a NaN.
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
      localparam W       = `FFD_FIXED_W(FORMAT);
      localparam FLAGS_W = `FFD_FLAGS_W(FORMAT);
      wire signed [2*W-1:0]     product;
      wire        [FLAGS_W-1:0] flags;
      wire        [FLAGS_W-1:0] late_flags;

      assign flags[0] = weight_i[W] | point_i[W];
      if (`FFD_FORMAT_BLOCK(FORMAT)) begin : gen_class
        wire plus     = point_i[W+1];
        wire minus    = point_i[W+2];
        wire negative = weight_i[W-1];
        wire zero     = weight_i[W-1:0] == {W{1'b0}};
        assign flags[1] = negative || zero ? minus || (zero && plus) : plus;
        assign flags[2] = negative || zero ? plus || (zero && minus) : minus;
      end

      ffd_fx_product #(
        .W      (W),
        .FLAGS_W(FLAGS_W),
        .LATENCY(LATENCY)
      ) u_product (
        .clk      (clk),
        .a_i      (weight_i[W-1:0]),
        .b_i      (point_i[W-1:0]),
        .flags_i  (flags),
        .product_o(product),
        .flags_o  (late_flags)
      );

      assign term_o = {late_flags, {6{product[2*W-1]}}, product};
    end
  endgenerate
endmodule

`default_nettype wire
