// ffd_num_less: part - part -> part, of one bank what it has more than those below it
//
// Formats:    fxW only: Q2.(W-1) - Q2.(W-1) -> Q2.(W-1), without a flag as in ffd_num_share. Or of
//             wide parts, in the same units, as many bits as PART_W says.
// Rounding:   none; saturated outside what PART_W bits hold, which saturated_o says, or saturated_i
//             beside it.
// Pipeline:   LATENCY registers, from 2 on one between difference and saturation. II 1, never
//             frozen.
// Parameters: FORMAT 12 to 18, LATENCY >= 1, PART_W >= 2.
// Model:      golden/include/hwffd/numerics/fixed.hpp (less).  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_less #(
  parameter FORMAT  = 17,
  parameter LATENCY = 1,
  parameter PART_W  = `FFD_PART_W(FORMAT)
) (
  input  wire              clk,
  input  wire [PART_W-1:0] a_i,
  input  wire [PART_W-1:0] b_i,
  input  wire              saturated_i,
  output wire [PART_W-1:0] part_o,
  output wire              saturated_o
);
  generate
    if (`FFD_PART_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_less_format_must_be_fixed_point_of_12_to_18_bits u_error ();
    end
    if (LATENCY < 1) begin : gen_bad_latency
      ERROR_ffd_num_less_latency_must_be_at_least_1 u_error ();
    end
  endgenerate

  wire signed [PART_W:0] less = {a_i[PART_W-1], a_i} - {b_i[PART_W-1], b_i};

  ffd_fx_narrow #(
    .IN_W   (PART_W + 1),
    .DROP   (0),
    .OUT_W  (PART_W),
    .LATENCY(LATENCY)
  ) u_part (
    .clk    (clk),
    .value_i(less),
    .flags_i(saturated_i),
    .value_o(part_o),
    .flags_o(saturated_o)
  );
endmodule

`default_nettype wire
