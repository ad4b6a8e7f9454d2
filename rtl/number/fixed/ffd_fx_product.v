// ffd_fx_product: product_o = a_i * b_i, exact
//
// Formats:    signed W bits each, product signed 2W bits; flags_o is flags_i, as late as the
//             product.
// Pipeline:   LATENCY registers, II 1, never frozen: half before the multiplier (rounded down), the
//             rest behind it, so that two or more surround it as multiplier blocks want it.
// Parameters: W >= 2, FLAGS_W >= 1, LATENCY >= 0.
// Model:      golden/include/hwffd/numerics/fixed.hpp (operator *).  Test: tests/unit/fixed.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_fx_product #(
  parameter W       = 18,
  parameter FLAGS_W = 1,
  parameter LATENCY = 1
) (
  input  wire                  clk,
  input  wire signed [W-1:0]   a_i,
  input  wire signed [W-1:0]   b_i,
  input  wire [FLAGS_W-1:0]    flags_i,
  output wire signed [2*W-1:0] product_o,
  output wire [FLAGS_W-1:0]    flags_o
);
  generate
    if (W < 2) begin : gen_bad_width
      ERROR_ffd_fx_product_width_must_be_at_least_2 u_error ();
    end
  endgenerate

  localparam BEFORE = LATENCY / 2;

  wire signed [W-1:0]   a;
  wire signed [W-1:0]   b;
  wire signed [2*W-1:0] wide_a  = {{W{a[W-1]}}, a};
  wire signed [2*W-1:0] wide_b  = {{W{b[W-1]}}, b};
  wire signed [2*W-1:0] product = wide_a * wide_b;

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

  ffd_num_delay #(
    .WIDTH  (2 * W),
    .LATENCY(LATENCY - BEFORE)
  ) u_product (
    .clk(clk),
    .rst(1'b0),
    .d_i(product),
    .q_o(product_o)
  );

  ffd_num_delay #(
    .WIDTH  (FLAGS_W),
    .LATENCY(LATENCY)
  ) u_flags (
    .clk(clk),
    .rst(1'b0),
    .d_i(flags_i),
    .q_o(flags_o)
  );
endmodule

`default_nettype wire
