// ffd_num_offset_term: weight x offset -> sum
//
// A multiplication of W + 1 by W bits: fx17 is the widest format that has it in a block of 18 x 18.
//
// Formats:    fxW only: Q2.(W-2) x Q2.(W-1) -> Q9.(2W-3), exact.
// Pipeline:   LATENCY registers, II 1, never frozen.
// Parameters: FORMAT 8 to 32, LATENCY >= 1.
// Model:      none: org_affine.hpp sums the same another way.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_offset_term #(
  parameter FORMAT  = 17,
  parameter LATENCY = 1
) (
  input  wire                              clk,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  weight_i,
  input  wire [`FFD_OFFSET_W(FORMAT)-1:0]  offset_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]     term_o
);
  localparam W = `FFD_FIXED_W(FORMAT);

  generate
    if (`FFD_OFFSET_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_offset_term_needs_fixed_point u_error ();
    end
    if (LATENCY < 1) begin : gen_bad_latency
      ERROR_ffd_num_offset_term_latency_must_be_at_least_1 u_error ();
    end
  endgenerate

  wire signed [2*W+1:0] product;
  wire                  flag;

  ffd_fx_product #(
    .W      (W + 1),
    .LATENCY(LATENCY)
  ) u_product (
    .clk      (clk),
    .a_i      ({weight_i[W-1], weight_i[W-1:0]}),
    .b_i      (offset_i[W:0]),
    .flags_i  (weight_i[W] | offset_i[W+1]),
    .product_o(product),
    .flags_o  (flag)
  );

  assign term_o = {flag, {4{product[2*W+1]}}, product};
endmodule

`default_nettype wire
