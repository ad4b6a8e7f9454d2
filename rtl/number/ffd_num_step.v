// ffd_num_step: coefficient + coordinate x weight -> weight, one step of Horner's rule
//
// Rounding:   fp32: the product and the sum each to nearest even, or fused, once. Else: Q2.(W-2),
//             half up, once (the coefficient is on the grid); saturated outside [-2, 2).
// Pipeline:   FFD_STEP_LATENCY registers, II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh, MUL_LATENCY >= 1, ADD_LATENCY >= 1; FMA_LATENCY >= 1 fuses
//             (fp32 only), 0 does not.
// Model:      golden/include/hwffd/numerics (step).  Test: tests/unit/fixed, tests/unit/float.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_step #(
  parameter FORMAT      = 18,
  parameter MUL_LATENCY = 1,
  parameter ADD_LATENCY = 1,
  parameter FMA_LATENCY = 0
) (
  input  wire                              clk,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  coefficient_i,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  coordinate_i,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  weight_i,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]  weight_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);

  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_step_format_is_unknown u_error ();
    end
    if (MUL_LATENCY < 1 || ADD_LATENCY < 1) begin : gen_bad_latency
      ERROR_ffd_num_step_latencies_must_be_at_least_1 u_error ();
    end
    if (`FFD_FMA_BAD(FORMAT, FMA_LATENCY)) begin : gen_bad_fma
      ERROR_ffd_num_step_fused_needs_fp32 u_error ();
    end
  endgenerate

  // The coefficient meets the product.
  wire [WEIGHT_W-1:0] coefficient;
  ffd_num_delay #(
    .WIDTH  (WEIGHT_W),
    .LATENCY(FMA_LATENCY > 0 ? 0 : MUL_LATENCY)
  ) u_coefficient (
    .clk(clk),
    .rst(1'b0),
    .d_i(coefficient_i),
    .q_o(coefficient)
  );

  generate
    if (FMA_LATENCY > 0) begin : gen_fused
      ffd_fp_fma #(
        .EXP_W  (8),
        .SIG_W  (24),
        .LATENCY(FMA_LATENCY)
      ) u_fma (
        .clk     (clk),
        .a_i     (coordinate_i),
        .b_i     (weight_i),
        .c_i     (coefficient),
        .result_o(weight_o)
      );
    end else if (FORMAT == `FFD_FORMAT_FP32) begin : gen_float
      wire [WEIGHT_W-1:0] product;

      ffd_fp_mul #(
        .EXP_W  (8),
        .SIG_W  (24),
        .LATENCY(MUL_LATENCY)
      ) u_mul (
        .clk     (clk),
        .a_i     (coordinate_i),
        .b_i     (weight_i),
        .result_o(product)
      );

      ffd_fp_add #(
        .EXP_W  (8),
        .SIG_W  (24),
        .LATENCY(ADD_LATENCY)
      ) u_add (
        .clk     (clk),
        .a_i     (product),
        .b_i     (coefficient),
        .result_o(weight_o)
      );
    end else begin : gen_fixed
      localparam W = `FFD_FIXED_W(FORMAT);
      wire signed [2*W-1:0] product;
      wire signed [W-1:0]   rounded;
      wire                  flag;
      wire                  saturated;

      ffd_fx_product #(
        .W      (W),
        .LATENCY(MUL_LATENCY)
      ) u_product (
        .clk      (clk),
        .a_i      (coordinate_i[W-1:0]),
        .b_i      (weight_i[W-1:0]),
        .flags_i  (coordinate_i[W] | weight_i[W]),
        .product_o(product),
        .flags_o  (flag)
      );

      ffd_fx_round #(
        .IN_W (2 * W),
        .DROP (W - 2),
        .OUT_W(W)
      ) u_round (
        .value_i    (product),
        .addend_i   (coefficient[W-1:0]),
        .value_o    (rounded),
        .saturated_o(saturated)
      );

      ffd_num_delay #(
        .WIDTH  (WEIGHT_W),
        .LATENCY(ADD_LATENCY)
      ) u_result (
        .clk(clk),
        .rst(1'b0),
        .d_i({flag | coefficient[W] | saturated, rounded}),
        .q_o(weight_o)
      );
    end
  endgenerate
endmodule

`default_nettype wire
