// ffd_fx_product: product_o = a_i * b_i, exact
//
// Formats:    signed W bits each, product signed 2W bits; flags_o is flags_i, as late as the
//             product.
// Pipeline:   LATENCY registers, II 1, never frozen; two or more surround the multiplier, as blocks
//             want it, any more stand in front of it. A word wider than a block's 18 bits is cut in
//             two, and from LATENCY 3 on one register is between the four products and their sum.
// Parameters: 2 <= W <= 35, FLAGS_W >= 1, LATENCY >= 0.
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
    if (W < 2 || W > 35) begin : gen_bad_width
      ERROR_ffd_fx_product_width_must_be_2_to_35 u_error ();
    end
  endgenerate

  localparam BLOCK_W = 18;
  localparam MIDDLE  = W > BLOCK_W && LATENCY > 2 ? 1 : 0;
  localparam AFTER   = LATENCY > 0 ? 1 : 0;
  localparam BEFORE  = LATENCY - MIDDLE - AFTER;

  wire signed [W-1:0]   a;
  wire signed [W-1:0]   b;
  wire signed [2*W-1:0] product;

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

  generate
    if (MIDDLE == 0) begin : gen_whole
      wire signed [2*W-1:0] wide_a = {{W{a[W-1]}}, a};
      wire signed [2*W-1:0] wide_b = {{W{b[W-1]}}, b};
      assign product = wide_a * wide_b;
    end else begin : gen_halves
      // x = high 2^LOW_W + low, low not negative: products of HALF_W signed bits.
      localparam LOW_W  = (W - 1) / 2;
      localparam HALF_W = W - LOW_W;
      localparam PART_W = 2 * HALF_W;
      localparam ZERO_W = HALF_W - LOW_W;
      wire signed [PART_W-1:0] a_high = {{HALF_W{a[W-1]}}, a[W-1:LOW_W]};
      wire signed [PART_W-1:0] b_high = {{HALF_W{b[W-1]}}, b[W-1:LOW_W]};
      wire signed [PART_W-1:0] a_low  = {{(HALF_W + ZERO_W) {1'b0}}, a[LOW_W-1:0]};
      wire signed [PART_W-1:0] b_low  = {{(HALF_W + ZERO_W) {1'b0}}, b[LOW_W-1:0]};
      reg  signed [PART_W-1:0] high_q;
      reg  signed [PART_W-1:0] cross_q;
      reg  signed [PART_W-1:0] other_q;
      reg  signed [PART_W-1:0] low_q;
      always @(posedge clk) begin
        high_q  <= a_high * b_high;
        cross_q <= a_high * b_low;
        other_q <= a_low * b_high;
        low_q   <= a_low * b_low;
      end

      // The outer products do not overlap: low is not negative and below 2^(2 LOW_W).
      wire signed [PART_W:0]  crossed = {cross_q[PART_W-1], cross_q} + {other_q[PART_W-1], other_q};
      wire        [2*W-1:0]   outer   = {high_q[2*W-2*LOW_W-1:0], low_q[2*LOW_W-1:0]};
      wire        [2*W-1:0]   inner   = {{(2*W-PART_W-1-LOW_W) {crossed[PART_W]}}, crossed,
                                         {LOW_W{1'b0}}};
      assign product = outer + inner;
      wire unused_ok = &{1'b0, low_q[PART_W-1:2*LOW_W]};
    end
  endgenerate

  ffd_num_delay #(
    .WIDTH  (2 * W),
    .LATENCY(AFTER)
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
