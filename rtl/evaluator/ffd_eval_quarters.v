// ffd_eval_quarters: P3 + w0 (P0 - P3) + w1 (P1 - P3) + w2 (P2 - P3), a point a clock, P3 first
//
// One multiplier in place of the three of ffd_eval_affine. The points come from bank 3, the base,
// down to bank 0; terms are added by pairs, which have no loop, so that any latency keeps the rate.
//
// Formats, rounding: those of ffd_eval_affine; sums are exact, so the bits are the same.
// Pipeline:   point | ADD_LATENCY: weights | MUL_LATENCY + 2 ADD_LATENCY: the sum, of a step of
//             bank 0 and the three before it. II 1, never frozen.
// Parameters: FORMAT 8 to 32, latencies >= 1. The fourth weight is what multiplies P3: 1 or 0.
// Not checked: that the banks come in this order, one a clock.
// Model:      golden/include/hwffd/model/org_affine.hpp.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"

module ffd_eval_quarters #(
  parameter FORMAT      = 17,
  parameter MUL_LATENCY = 1,
  parameter ADD_LATENCY = 1
) (
  input  wire                                clk,
  input  wire [1:0]                          bank_i,     // of the point
  input  wire [4*`FFD_WEIGHT_W(FORMAT)-1:0]  weights_i,
  input  wire [`FFD_POINT_W(FORMAT)-1:0]     point_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]       sum_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam OFFSET_W = `FFD_OFFSET_W(FORMAT);
  localparam SUM_W    = `FFD_SUM_W(FORMAT);
  `FFD_TAKES(MUL_LATENCY + 3 * ADD_LATENCY)

  // Bank 3 is the base of all: of itself it is the base term, and its offset is 0, whatever its
  // weight.
  reg  [POINT_W-1:0]  base_q;
  wire [POINT_W-1:0]  base = bank_i == 2'd3 ? point_i : base_q;
  wire [1:0]          bank;  // with the weights
  wire [WEIGHT_W-1:0] weight = bank[1] ? weights_i[2*WEIGHT_W +: WEIGHT_W] :
                               bank[0] ? weights_i[1*WEIGHT_W +: WEIGHT_W] :
                                         weights_i[0*WEIGHT_W +: WEIGHT_W];
  wire [OFFSET_W-1:0] offset;
  wire [POINT_W-1:0]  late_base;
  wire [SUM_W-1:0]    product;
  wire [SUM_W-1:0]    base_term;
  wire                of_base;  // with the terms
  wire [SUM_W-1:0]    term = of_base ? base_term : product;
  wire [SUM_W-1:0]    term_before;
  wire [SUM_W-1:0]    pair;
  wire [SUM_W-1:0]    pair_before;

  always @(posedge clk) base_q <= base;

  ffd_num_delay #(
    .WIDTH  (2 + POINT_W),
    .LATENCY(ADD_LATENCY)
  ) u_late_base (
    .clk(clk),
    .rst(1'b0),
    .d_i({bank_i, base}),
    .q_o({bank, late_base})
  );

  ffd_num_offset #(
    .FORMAT (FORMAT),
    .LATENCY(ADD_LATENCY)
  ) u_offset (
    .clk     (clk),
    .point_i (point_i),
    .base_i  (base),
    .offset_o(offset)
  );

  ffd_num_offset_term #(
    .FORMAT (FORMAT),
    .LATENCY(MUL_LATENCY)
  ) u_term (
    .clk     (clk),
    .weight_i(weight),
    .offset_i(offset),
    .term_o  (product)
  );

  ffd_num_base_term #(
    .FORMAT (FORMAT),
    .LATENCY(MUL_LATENCY)
  ) u_base_term (
    .clk     (clk),
    .weight_i(weights_i[3*WEIGHT_W +: WEIGHT_W]),
    .point_i (late_base),
    .term_o  (base_term)
  );

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(MUL_LATENCY)
  ) u_of_base (
    .clk(clk),
    .rst(1'b0),
    .d_i(bank == 2'd3),
    .q_o(of_base)
  );

  ffd_num_delay #(
    .WIDTH  (SUM_W),
    .LATENCY(1)
  ) u_term_before (
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
    .a_i  (term),
    .b_i  (term_before),
    .sum_o(pair)
  );

  ffd_num_delay #(
    .WIDTH  (SUM_W),
    .LATENCY(2)
  ) u_pair_before (
    .clk(clk),
    .rst(1'b0),
    .d_i(pair),
    .q_o(pair_before)
  );

  ffd_num_add #(
    .FORMAT (FORMAT),
    .LATENCY(ADD_LATENCY)
  ) u_sum (
    .clk  (clk),
    .a_i  (pair),
    .b_i  (pair_before),
    .sum_o(sum_o)
  );
endmodule

`default_nettype wire
