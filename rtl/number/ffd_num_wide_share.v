// ffd_num_wide_share: weight x sum of parts -> wide part, what of it is for the banks up to one
//
// As ffd_num_share, of 35 bits: high and low half each times the weight, and both products added.
// The lower 17 bits of the low one pass by that adder. The flag of the weight is not looked at.
//
// Formats:    fxW only: Q2.(W-2) x 35 bits in units of 2^-(W-1) -> the same. The low half has 17
//             bits, not negative, so that each product is one of 18 x 18 bits.
// Rounding:   half up; saturated to [-2^34, 2^34 - 1], which saturated_o says.
// Overflow:   none inside: the product of 18 and 35 bits has 53, of which 36 are above the low 17.
// Error:      half a unit.
// Pipeline:   MUL_LATENCY: products | ADD_LATENCY: their sum | 2 ADD_LATENCY: rounded, saturated.
//             II 1, never frozen.
// Parameters: FORMAT 12 to 18, latencies >= 1.
// Model:      golden/include/hwffd/numerics/fixed.hpp (wide_share).  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"

module ffd_num_wide_share #(
  parameter FORMAT      = 17,
  parameter MUL_LATENCY = 1,
  parameter ADD_LATENCY = 1
) (
  input  wire                             clk,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0] weight_i,
  input  wire [`FFD_WIDE_W-1:0]           part_i,
  output wire [`FFD_WIDE_W-1:0]           share_o,
  output wire                             saturated_o
);
  localparam W         = `FFD_FIXED_W(FORMAT);
  localparam WIDE_W    = `FFD_WIDE_W;
  localparam BLOCK_W   = 18;
  localparam LOW_W     = BLOCK_W - 1;
  localparam HIGH_W    = WIDE_W - LOW_W;  // BLOCK_W
  localparam PRODUCT_W = BLOCK_W + WIDE_W;
  localparam UPPER_W   = PRODUCT_W - LOW_W;
  `FFD_TAKES(MUL_LATENCY + 3 * ADD_LATENCY)

  generate
    if (`FFD_PART_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_wide_share_format_must_be_fixed_point_of_12_to_18_bits u_error ();
    end
    if (MUL_LATENCY < 1 || ADD_LATENCY < 1) begin : gen_bad_latency
      ERROR_ffd_num_wide_share_latencies_must_be_at_least_1 u_error ();
    end
  endgenerate

  wire signed [BLOCK_W-1:0]   weight;
  wire signed [2*BLOCK_W-1:0] high;
  wire signed [2*BLOCK_W-1:0] low;
  wire                        none_high;
  wire                        none_low;

  generate
    if (W < BLOCK_W) begin : gen_extended
      assign weight = {{(BLOCK_W - W) {weight_i[W-1]}}, weight_i[W-1:0]};
    end else begin : gen_fits
      assign weight = weight_i[W-1:0];
    end
  endgenerate

  ffd_fx_product #(
    .W      (BLOCK_W),
    .LATENCY(MUL_LATENCY)
  ) u_high (
    .clk      (clk),
    .a_i      (weight),
    .b_i      (part_i[WIDE_W-1 -: HIGH_W]),
    .flags_i  (1'b0),
    .product_o(high),
    .flags_o  (none_high)
  );

  ffd_fx_product #(
    .W      (BLOCK_W),
    .LATENCY(MUL_LATENCY)
  ) u_low (
    .clk      (clk),
    .a_i      (weight),
    .b_i      ({1'b0, part_i[LOW_W-1:0]}),
    .flags_i  (1'b0),
    .product_o(low),
    .flags_o  (none_low)
  );

  wire [UPPER_W-1:0]          upper = high + {{LOW_W{low[2*BLOCK_W-1]}}, low[2*BLOCK_W-1:LOW_W]};
  wire signed [PRODUCT_W-1:0] product;

  ffd_num_delay #(
    .WIDTH  (PRODUCT_W),
    .LATENCY(ADD_LATENCY)
  ) u_product (
    .clk(clk),
    .rst(1'b0),
    .d_i({upper, low[LOW_W-1:0]}),
    .q_o(product)
  );

  ffd_fx_narrow #(
    .IN_W   (PRODUCT_W),
    .DROP   (W - 2),
    .OUT_W  (WIDE_W),
    .LATENCY(2 * ADD_LATENCY)
  ) u_share (
    .clk    (clk),
    .value_i(product),
    .flags_i(1'b0),
    .value_o(share_o),
    .flags_o(saturated_o)
  );

  wire unused_ok = &{1'b0, weight_i[W], none_high, none_low};
endmodule

`default_nettype wire
