// ffd_eval_determinant: det J of a vertex from the columns dq/ds, dq/dt, dq/du
//
//   det J = sum over c of s_c (t_c+1 u_c+2 - t_c+2 u_c+1), indices modulo 3
//
// Columns come one a clock at most, s, t, u, and are narrowed to points. With the third, three
// steps begin, a component c each: two products and their difference are a cofactor, narrowed, and
// a third product is its term. 9 multiplications on 3 multipliers: folded by three.
//
// Formats:    sums in, a stream word out. fp32: each operation rounds once, as numerics.md has
//             them. fxW: columns in [-1, 1), the word is det J / 4 (|det J| <= 4: numerics.md,
//             section 9); products and sums are exact, a cofactor is halved and rounded. Block:
//             the same, times 2^(3 exponent_i), in binary32.
// Pipeline:   the third column | FFD_NARROW_LATENCY | 1: the first step | MUL + ADD +
//             FFD_NARROW_LATENCY | MUL, the term | 1 + 2 ADD | FFD_OUT_LATENCY: the word. II 4
//             clocks a vertex, which is what a vertex of four evaluations takes at least.
// Freezes:    never.
// Parameters: FORMAT as in ffd_num.vh, latencies as in every organization.
// Model:      golden/include/hwffd/model/determinant.hpp.  Test: tests/unit/determinant.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"

module ffd_eval_determinant #(
  parameter FORMAT          = 18,
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter CONVERT_LATENCY = 1
) (
  input  wire                              clk,
  input  wire                              rst,
  input  wire                              column_valid_i,
  input  wire                              column_last_i,
  input  wire [3*`FFD_SUM_W(FORMAT)-1:0]   column_i,
  input  wire [`FFD_EXPONENT_W-1:0]        exponent_i,
  output wire                              word_valid_o,
  output wire [31:0]                       word_o,
  output wire                              saturated_o,
  output wire                              nan_o
);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam SUM_W    = `FFD_SUM_W(FORMAT);
  localparam NARROW   = `FFD_NARROW_LATENCY(FORMAT, CONVERT_LATENCY);
  localparam OUT      = `FFD_OUT_LATENCY(FORMAT, CONVERT_LATENCY);
  localparam COFACTOR = MUL_LATENCY + ADD_LATENCY + NARROW;
  `FFD_TAKES(NARROW + 1 + COFACTOR + MUL_LATENCY + 1 + 2 * ADD_LATENCY + OUT)

  // ---- columns as points, kept until the third is there

  wire                 valid;
  wire                 last;
  wire [3*POINT_W-1:0] column;

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(NARROW),
    .RESET  (1)
  ) u_valid (
    .clk(clk),
    .rst(rst),
    .d_i({column_valid_i, column_valid_i && column_last_i}),
    .q_o({valid, last})
  );

  genvar c;
  generate
    for (c = 0; c < 3; c = c + 1) begin : gen_component
      ffd_num_narrow #(
        .FORMAT (FORMAT),
        .LATENCY(NARROW)
      ) u_narrow (
        .clk    (clk),
        .sum_i  (column_i[c*SUM_W +: SUM_W]),
        .point_o(column[c*POINT_W +: POINT_W])
      );
    end
  endgenerate

  reg [3*POINT_W-1:0] before_q;
  reg [3*POINT_W-1:0] first_q;
  always @(posedge clk) begin
    if (valid) begin
      before_q <= column;
      first_q  <= before_q;
    end
  end

  // ---- three steps: the components of each column turn, so that a step finds its own in the
  //      same place

  localparam [1:0] LAST_STEP = 2'd2;
  reg                  busy_q;
  reg  [1:0]           step_q;
  reg  [3*POINT_W-1:0] s_q;
  reg  [3*POINT_W-1:0] t_q;
  reg  [3*POINT_W-1:0] u_q;

  always @(posedge clk) begin
    if (rst) busy_q <= 1'b0;
    else if (last) busy_q <= 1'b1;
    else if (step_q == LAST_STEP) busy_q <= 1'b0;
  end
  always @(posedge clk) begin
    if (last) begin
      step_q <= 2'd0;
      s_q    <= first_q;
      t_q    <= before_q;
      u_q    <= column;
    end else begin
      step_q <= step_q + 2'd1;
      s_q    <= {s_q[POINT_W-1:0], s_q[3*POINT_W-1:POINT_W]};
      t_q    <= {t_q[POINT_W-1:0], t_q[3*POINT_W-1:POINT_W]};
      u_q    <= {u_q[POINT_W-1:0], u_q[3*POINT_W-1:POINT_W]};
    end
  end

  // ---- a cofactor

  wire [POINT_W-1:0] t1 = t_q[1*POINT_W +: POINT_W];
  wire [POINT_W-1:0] t2 = t_q[2*POINT_W +: POINT_W];
  wire [POINT_W-1:0] u1 = u_q[1*POINT_W +: POINT_W];
  wire [POINT_W-1:0] u2 = u_q[2*POINT_W +: POINT_W];
  wire [SUM_W-1:0]   product;
  wire [SUM_W-1:0]   other;
  wire [SUM_W-1:0]   minus_other;
  wire [SUM_W-1:0]   difference;
  wire [POINT_W-1:0] cofactor;

  ffd_num_product #(
    .FORMAT (FORMAT),
    .LATENCY(MUL_LATENCY)
  ) u_product (
    .clk      (clk),
    .a_i      (t1),
    .b_i      (u2),
    .product_o(product)
  );

  ffd_num_product #(
    .FORMAT (FORMAT),
    .LATENCY(MUL_LATENCY)
  ) u_other (
    .clk      (clk),
    .a_i      (t2),
    .b_i      (u1),
    .product_o(other)
  );

  ffd_num_negate #(
    .FORMAT(FORMAT)
  ) u_negate (
    .sum_i     (other),
    .negative_o(minus_other)
  );

  ffd_num_add #(
    .FORMAT (FORMAT),
    .LATENCY(ADD_LATENCY)
  ) u_difference (
    .clk  (clk),
    .a_i  (product),
    .b_i  (minus_other),
    .sum_o(difference)
  );

  // In fixed point the products are doubled: a quarter of their difference is half a cofactor.
  ffd_num_narrow #(
    .FORMAT (FORMAT),
    .SHIFT  (2),
    .LATENCY(NARROW)
  ) u_cofactor (
    .clk    (clk),
    .sum_i  (difference),
    .point_o(cofactor)
  );

  // ---- its term, and the sum of three that come one after the other: (0 + 1) + 2

  wire [POINT_W-1:0] s0;
  wire [SUM_W-1:0]   term;
  wire [SUM_W-1:0]   term_before;
  wire [SUM_W-1:0]   term_third;
  wire [SUM_W-1:0]   pair;
  wire [SUM_W-1:0]   sum;

  ffd_num_delay #(
    .WIDTH  (POINT_W),
    .LATENCY(COFACTOR)
  ) u_s (
    .clk(clk),
    .rst(1'b0),
    .d_i(s_q[POINT_W-1:0]),
    .q_o(s0)
  );

  ffd_num_product #(
    .FORMAT (FORMAT),
    .LATENCY(MUL_LATENCY)
  ) u_term (
    .clk      (clk),
    .a_i      (s0),
    .b_i      (cofactor),
    .product_o(term)
  );

  ffd_num_delay #(
    .WIDTH  (SUM_W),
    .LATENCY(1)
  ) u_before (
    .clk(clk),
    .rst(1'b0),
    .d_i(term),
    .q_o(term_before)
  );

  ffd_num_add #(
    .FORMAT (FORMAT),
    .LATENCY(ADD_LATENCY)
  ) u_pair (
    .clk  (clk),
    .a_i  (term_before),
    .b_i  (term),
    .sum_o(pair)
  );

  // The third term comes a clock after the second, whose sum takes ADD_LATENCY.
  ffd_num_delay #(
    .WIDTH  (SUM_W),
    .LATENCY(ADD_LATENCY - 1)
  ) u_third (
    .clk(clk),
    .rst(1'b0),
    .d_i(term),
    .q_o(term_third)
  );

  ffd_num_add #(
    .FORMAT (FORMAT),
    .LATENCY(ADD_LATENCY)
  ) u_sum (
    .clk  (clk),
    .a_i  (pair),
    .b_i  (term_third),
    .sum_o(sum)
  );

  // The exponent of the vertex's points, with its word.
  wire [`FFD_EXPONENT_W-1:0] exponent;

  ffd_num_delay #(
    .WIDTH  (`FFD_EXPONENT_W),
    .LATENCY(NARROW + 3 + COFACTOR + MUL_LATENCY + 2 * ADD_LATENCY - 1)
  ) u_exponent (
    .clk(clk),
    .rst(1'b0),
    .d_i(exponent_i),
    .q_o(exponent)
  );

  ffd_num_out #(
    .FORMAT (FORMAT),
    .SHIFT  (2),
    .POWER  (3),
    .LATENCY(OUT)
  ) u_out (
    .clk        (clk),
    .sum_i      (sum),
    .exponent_i (exponent),
    .word_o     (word_o),
    .saturated_o(saturated_o),
    .nan_o      (nan_o)
  );

  // From the last step: its term, that term's place in the sum, the word.
  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(COFACTOR + MUL_LATENCY + 2 * ADD_LATENCY - 1 + OUT),
    .RESET  (1)
  ) u_word_valid (
    .clk(clk),
    .rst(rst),
    .d_i(busy_q && step_q == LAST_STEP),
    .q_o(word_valid_o)
  );
endmodule

`default_nettype wire
