// ffd_fx_product: product_o = a_i * b_i, exact
//
// Formats:    signed W bits each, product signed 2W bits; flags_o is flags_i, as late as the
//             product.
// Pipeline:   LATENCY registers, II 1, never frozen. W <= 18 or LATENCY < 2: one multiplier, 1
//             behind it, from 4 on 2, the rest in front. Else four ffd_fx_block, each 1 behind its
//             product and from 3 on 1 in front; their sum 1, from 4 on 1 in it, the rest in front.
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
  localparam CUT     = W > BLOCK_W && LATENCY > 1 ? 1 : 0;
  localparam BLOCKS  = CUT == 0 ? 0 : LATENCY > 2 ? 2 : 1;     // registers around four blocks
  localparam BEHIND  = LATENCY > 3 ? 2 : LATENCY > 0 ? 1 : 0;  // behind the one, or in the sum
  localparam BEFORE  = LATENCY - BLOCKS - BEHIND;

  generate
    if (CUT == 0) begin : gen_whole
      ffd_fx_block #(
        .W     (W),
        .BEFORE(BEFORE),
        .BEHIND(BEHIND)
      ) u_block (
        .clk      (clk),
        .a_i      (a_i),
        .b_i      (b_i),
        .product_o(product_o)
      );
    end else begin : gen_halves
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

      // x = high 2^LOW_W + low, low not negative: products of HALF_W signed bits.
      localparam LOW_W  = (W - 1) / 2;
      localparam HALF_W = W - LOW_W;
      localparam PART_W = 2 * HALF_W;
      localparam ZERO_W = HALF_W - LOW_W;
      wire [2*HALF_W-1:0] a_halves = {a[W-1:LOW_W], {ZERO_W{1'b0}}, a[LOW_W-1:0]};
      wire [2*HALF_W-1:0] b_halves = {b[W-1:LOW_W], {ZERO_W{1'b0}}, b[LOW_W-1:0]};

      genvar i;
      genvar j;
      for (i = 0; i < 2; i = i + 1) begin : gen_a
        for (j = 0; j < 2; j = j + 1) begin : gen_b
          wire signed [PART_W-1:0] part;
          ffd_fx_block #(
            .W     (HALF_W),
            .BEFORE(BLOCKS - 1),
            .BEHIND(1)
          ) u_block (
            .clk      (clk),
            .a_i      (a_halves[i*HALF_W +: HALF_W]),
            .b_i      (b_halves[j*HALF_W +: HALF_W]),
            .product_o(part)
          );
        end
      end

      // The outer products do not overlap: low is not negative and below 2^(2 LOW_W).
      wire [PART_W-1:0] low      = gen_a[0].gen_b[0].part;
      wire [PART_W-1:0] low_high = gen_a[0].gen_b[1].part;
      wire [PART_W-1:0] high_low = gen_a[1].gen_b[0].part;
      wire [PART_W-1:0] high     = gen_a[1].gen_b[1].part;
      wire [PART_W:0]   crossed;
      wire [2*W-1:0]    outer;
      wire [2*W-1:0]    inner    = {{(2*W-PART_W-1-LOW_W) {crossed[PART_W]}}, crossed,
                                    {LOW_W{1'b0}}};

      ffd_num_delay #(
        .WIDTH  (PART_W + 1 + 2 * W),
        .LATENCY(BEHIND - 1)
      ) u_partial (
        .clk(clk),
        .rst(1'b0),
        .d_i({{low_high[PART_W-1], low_high} + {high_low[PART_W-1], high_low},
              high[2*W-2*LOW_W-1:0], low[2*LOW_W-1:0]}),
        .q_o({crossed, outer})
      );

      reg [2*W-1:0] sum_q;
      always @(posedge clk) sum_q <= outer + inner;
      assign product_o = sum_q;
      wire unused_ok = &{1'b0, low[PART_W-1:2*LOW_W]};
    end
  endgenerate

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
