// ffd_num_share: weight x part -> part, what of a part is for the banks up to one
//
// Parts have no flag of their own: whoever expands one gathers what saturated. The flag of the
// weight is not looked at.
//
// Formats:    fxW only: Q2.(W-2) x Q2.(W-1) -> Q2.(W-1). fx17 is the widest format that has the
//             product in a block of 18 x 18.
// Rounding:   half up; saturated outside [-2, 2), which saturated_o says.
// Error:      half a unit of a part.
// Pipeline:   MUL_LATENCY: product | ADD_LATENCY: rounded. II 1, never frozen.
// Parameters: FORMAT 12 to 18, latencies >= 1.
// Model:      golden/include/hwffd/numerics/fixed.hpp (share).  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_share #(
  parameter FORMAT      = 17,
  parameter MUL_LATENCY = 1,
  parameter ADD_LATENCY = 1
) (
  input  wire                              clk,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  weight_i,
  input  wire [`FFD_PART_W(FORMAT)-1:0]    part_i,
  output wire [`FFD_PART_W(FORMAT)-1:0]    share_o,
  output wire                              saturated_o
);
  localparam W      = `FFD_FIXED_W(FORMAT);
  localparam PART_W = `FFD_PART_W(FORMAT);

  generate
    if (`FFD_PART_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_share_format_must_be_fixed_point_of_12_to_18_bits u_error ();
    end
    if (MUL_LATENCY < 1 || ADD_LATENCY < 1) begin : gen_bad_latency
      ERROR_ffd_num_share_latencies_must_be_at_least_1 u_error ();
    end
  endgenerate

  wire signed [2*PART_W-1:0] product;
  wire                       none;

  ffd_fx_product #(
    .W      (PART_W),
    .LATENCY(MUL_LATENCY)
  ) u_product (
    .clk      (clk),
    .a_i      ({weight_i[W-1], weight_i[W-1:0]}),
    .b_i      (part_i),
    .flags_i  (1'b0),
    .product_o(product),
    .flags_o  (none)
  );

  ffd_fx_narrow #(
    .IN_W   (2 * PART_W),
    .DROP   (W - 2),
    .OUT_W  (PART_W),
    .LATENCY(ADD_LATENCY)
  ) u_share (
    .clk    (clk),
    .value_i(product),
    .flags_i(none),
    .value_o(share_o),
    .flags_o(saturated_o)
  );

  wire unused_ok = &{1'b0, weight_i[W]};
endmodule

`default_nettype wire
