// ffd_num_cumulate: weight + weight -> weight, the cumulative weight of one bank more
//
// Formats:    fxW only: Q2.(W-2) + Q2.(W-2) -> Q2.(W-2). Rounding: none. Saturated and flagged
//             outside [-2, 2).
// Pipeline:   LATENCY registers, II 1, never frozen.
// Parameters: FORMAT 12 to 18, LATENCY >= 0.
// Model:      golden/include/hwffd/numerics/fixed.hpp (cumulate).  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_cumulate #(
  parameter FORMAT  = 17,
  parameter LATENCY = 1
) (
  input  wire                              clk,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  a_i,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  b_i,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]  weight_o
);
  localparam W = `FFD_FIXED_W(FORMAT);

  generate
    if (`FFD_PART_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_cumulate_format_must_be_fixed_point_of_12_to_18_bits u_error ();
    end
  endgenerate

  wire signed [W:0] sum = {a_i[W-1], a_i[W-1:0]} + {b_i[W-1], b_i[W-1:0]};

  ffd_fx_narrow #(
    .IN_W   (W + 1),
    .DROP   (0),
    .OUT_W  (W),
    .LATENCY(LATENCY)
  ) u_weight (
    .clk    (clk),
    .value_i(sum),
    .flags_i(a_i[W] | b_i[W]),
    .value_o(weight_o[W-1:0]),
    .flags_o(weight_o[W])
  );
endmodule

`default_nettype wire
