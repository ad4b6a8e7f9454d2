// ffd_num_mul: weight x weight -> weight
//
// Rounding:   fp32: to nearest even. Else: Q2.(W-2), half up, saturated and flagged outside
//             [-2, 2).
// Error:      half a unit in the last place.
// Pipeline:   LATENCY registers, II 1, never frozen. Fixed point: the last one holds the rounded
//             weight, the others surround the multiplier.
// Parameters: FORMAT as in ffd_num.vh, LATENCY >= 1.
// Model:      golden/include/hwffd/numerics (mul).  Test: tests/unit/fixed, tests/unit/float.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_mul #(
  parameter FORMAT  = 18,
  parameter LATENCY = 1
) (
  input  wire                              clk,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  a_i,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  b_i,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]  product_o
);
  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_mul_format_is_unknown u_error ();
    end
    if (LATENCY < 1) begin : gen_bad_latency
      ERROR_ffd_num_mul_latency_must_be_at_least_1 u_error ();
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
        .a_i     (a_i),
        .b_i     (b_i),
        .result_o(product_o)
      );
    end else begin : gen_fixed
      localparam W = `FFD_FIXED_W(FORMAT);
      wire signed [2*W-1:0] product;
      wire signed [W-1:0]   rounded;
      wire                  flag;
      wire                  saturated;

      ffd_fx_product #(
        .W      (W),
        .LATENCY(LATENCY - 1)
      ) u_product (
        .clk      (clk),
        .a_i      (a_i[W-1:0]),
        .b_i      (b_i[W-1:0]),
        .flags_i  (a_i[W] | b_i[W]),
        .product_o(product),
        .flags_o  (flag)
      );

      ffd_fx_round #(
        .IN_W (2 * W),
        .DROP (W - 2),
        .OUT_W(W)
      ) u_round (
        .value_i    (product),
        .addend_i   ({W{1'b0}}),
        .value_o    (rounded),
        .saturated_o(saturated)
      );

      ffd_num_delay #(
        .WIDTH  (W + 1),
        .LATENCY(1)
      ) u_result (
        .clk(clk),
        .rst(1'b0),
        .d_i({flag | saturated, rounded}),
        .q_o(product_o)
      );
    end
  endgenerate
endmodule

`default_nettype wire
