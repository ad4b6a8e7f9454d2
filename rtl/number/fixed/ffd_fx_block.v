// ffd_fx_block: product_o = a_i * b_i in one block multiplier, between registers of its own
//
// A module by itself, so that a target may have one of its own, whose registers are those of the
// block: synth/ecp5/ffd_fx_block.v.
//
// Formats:    signed W bits each, product signed 2W bits, exact.
// Pipeline:   BEFORE registers | multiplier, BEHIND registers; II 1, never frozen.
// Parameters: W >= 2 (one block up to 18), BEFORE >= 0, BEHIND >= 0.
// Model:      golden/include/hwffd/numerics/fixed.hpp (operator *).  Test: tests/unit/fixed.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_fx_block #(
  parameter W      = 18,
  parameter BEFORE = 0,
  parameter BEHIND = 1
) (
  input  wire                  clk,
  input  wire signed [W-1:0]   a_i,
  input  wire signed [W-1:0]   b_i,
  output wire signed [2*W-1:0] product_o
);
  generate
    if (W < 2) begin : gen_bad_width
      ERROR_ffd_fx_block_width_must_be_at_least_2 u_error ();
    end
  endgenerate

  wire signed [W-1:0] a;
  wire signed [W-1:0] b;

  ffd_num_delay #(
    .WIDTH  (W),
    .LATENCY(BEFORE)
  ) u_a (
    .clk(clk),
    .rst(1'b0),
    .d_i(a_i),
    .q_o(a)
  );

  ffd_num_delay #(
    .WIDTH  (W),
    .LATENCY(BEFORE)
  ) u_b (
    .clk(clk),
    .rst(1'b0),
    .d_i(b_i),
    .q_o(b)
  );

  wire signed [2*W-1:0] wide_a = {{W{a[W-1]}}, a};
  wire signed [2*W-1:0] wide_b = {{W{b[W-1]}}, b};

  ffd_num_delay #(
    .WIDTH  (2 * W),
    .LATENCY(BEHIND)
  ) u_product (
    .clk(clk),
    .rst(1'b0),
    .d_i(wide_a * wide_b),
    .q_o(product_o)
  );
endmodule

`default_nettype wire
