// ffd_num_base_term: weight x point -> sum, of a weight that is 1 or 0
//
// Formats:    fxW only: Q1.(W-1) -> Q9.(2W-3), exact, without a multiplier.
// Pipeline:   LATENCY registers, II 1, never frozen.
// Parameters: FORMAT 8 to 32, LATENCY >= 1.
// Not checked: that the weight is 1 or 0: any other is taken for 1 if its bit of 1 is set.
// Model:      none: org_affine.hpp sums the same another way.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_base_term #(
  parameter FORMAT  = 17,
  parameter LATENCY = 1
) (
  input  wire                              clk,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  weight_i,
  input  wire [`FFD_POINT_W(FORMAT)-1:0]   point_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]     term_o
);
  localparam W       = `FFD_FIXED_W(FORMAT);
  localparam POINT_W = `FFD_POINT_W(FORMAT);

  generate
    if (`FFD_OFFSET_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_base_term_needs_fixed_point u_error ();
    end
    if (LATENCY < 1) begin : gen_bad_latency
      ERROR_ffd_num_base_term_latency_must_be_at_least_1 u_error ();
    end
  endgenerate

  wire               one = weight_i[W-2];
  wire [POINT_W-1:0] taken;

  ffd_num_delay #(
    .WIDTH  (POINT_W),
    .LATENCY(LATENCY)
  ) u_taken (
    .clk(clk),
    .rst(1'b0),
    .d_i(one ? point_i : {POINT_W{1'b0}}),
    .q_o(taken)
  );

  ffd_num_widen #(
    .FORMAT(FORMAT)
  ) u_widen (
    .point_i(taken),
    .sum_o  (term_o)
  );

  wire unused_ok = &{1'b0, weight_i};
endmodule

`default_nettype wire
