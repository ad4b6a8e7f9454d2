// ffd_num_offset: point - base -> offset, from one control point to another
//
// Formats:    fxW only: Q1.(W-1) - Q1.(W-1) -> Q2.(W-1), a bit more than a point, exact.
// Pipeline:   LATENCY registers, II 1, never frozen.
// Parameters: FORMAT 8 to 32, LATENCY >= 1.
// Model:      none: org_affine.hpp sums the same another way.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_offset #(
  parameter FORMAT  = 17,
  parameter LATENCY = 1
) (
  input  wire                              clk,
  input  wire [`FFD_POINT_W(FORMAT)-1:0]   point_i,
  input  wire [`FFD_POINT_W(FORMAT)-1:0]   base_i,
  output wire [`FFD_OFFSET_W(FORMAT)-1:0]  offset_o
);
  localparam W = `FFD_FIXED_W(FORMAT);

  generate
    if (`FFD_OFFSET_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_offset_needs_fixed_point u_error ();
    end
    if (LATENCY < 1) begin : gen_bad_latency
      ERROR_ffd_num_offset_latency_must_be_at_least_1 u_error ();
    end
  endgenerate

  wire [W:0] offset = {point_i[W-1], point_i[W-1:0]} - {base_i[W-1], base_i[W-1:0]};

  ffd_num_delay #(
    .WIDTH  (`FFD_OFFSET_W(FORMAT)),
    .LATENCY(LATENCY)
  ) u_offset (
    .clk(clk),
    .rst(1'b0),
    .d_i({point_i[W] | base_i[W], offset}),
    .q_o(offset_o)
  );
endmodule

`default_nettype wire
