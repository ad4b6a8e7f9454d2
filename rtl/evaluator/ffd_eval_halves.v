// ffd_eval_halves: a sum of four terms in two steps, the second two before the first two
//
// The points of banks 2 and 3 come in one step, those of 0 and 1 TURNS clocks later. The pairs are
// those of ffd_eval_tree and ffd_eval_affine, so the bits are too.
//
// Formats, rounding: as there.
// Pipeline:   points of a step | affine: ADD_LATENCY, weights | MUL_LATENCY + ADD_LATENCY: the pair
//             | ADD_LATENCY: the sum, of a step with low_i and the one TURNS before. II 1, never
//             frozen.
// Parameters: TURNS >= 1; AFFINE 0 or 1; the others as there.
// Model:      golden/include/hwffd/model/org_factored.hpp, org_affine.hpp.  Test: tests/evaluator.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_halves #(
  parameter TURNS       = 1,
  parameter AFFINE      = 0,
  parameter FORMAT      = 18,
  parameter MUL_LATENCY = 1,
  parameter ADD_LATENCY = 1,
  parameter FMA_LATENCY = 0
) (
  input  wire                                clk,
  input  wire                                low_i,      // with its points: of banks 0 and 1
  input  wire [4*`FFD_WEIGHT_W(FORMAT)-1:0]  weights_i,
  input  wire [2*`FFD_POINT_W(FORMAT)-1:0]   points_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]       sum_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam OFFSET_W = `FFD_OFFSET_W(FORMAT);
  localparam SUM_W    = `FFD_SUM_W(FORMAT);
  `FFD_TAKES(AFFINE != 0 ? MUL_LATENCY + 3 * ADD_LATENCY : MUL_LATENCY + ADD_LATENCY
             + (FMA_LATENCY > 0 ? FMA_LATENCY : ADD_LATENCY))

  wire low;  // with the weights

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(`FFD_OFFSET_LATENCY(AFFINE, ADD_LATENCY))
  ) u_low (
    .clk(clk),
    .rst(1'b0),
    .d_i(low_i),
    .q_o(low)
  );

  wire [2*WEIGHT_W-1:0] weights = low ? weights_i[0 +: 2*WEIGHT_W]
                                      : weights_i[2*WEIGHT_W +: 2*WEIGHT_W];
  wire [SUM_W-1:0]      pair;
  wire [SUM_W-1:0]      pair_before;

  generate
    if (AFFINE == 0) begin : gen_tree
      ffd_eval_tree #(
        .FORMAT     (FORMAT),
        .N          (2),
        .MUL_LATENCY(MUL_LATENCY),
        .ADD_LATENCY(ADD_LATENCY),
        .FMA_LATENCY(FMA_LATENCY)
      ) u_tree (
        .clk      (clk),
        .weights_i(weights),
        .points_i (points_i),
        .sum_o    (pair)
      );
    end else begin : gen_affine
      // Bank 3 is the base of all: of itself it is the base term, and its offset is 0.
      wire [POINT_W-1:0]   odd = points_i[POINT_W +: POINT_W];
      wire [POINT_W-1:0]   odd_before;
      wire [POINT_W-1:0]   base = low_i ? odd_before : odd;
      wire [POINT_W-1:0]   late_base;
      wire [2*SUM_W-1:0]   terms;
      wire [SUM_W-1:0]     base_term;
      wire                 sum_low;

      ffd_num_delay #(
        .WIDTH  (POINT_W),
        .LATENCY(TURNS)
      ) u_odd_before (
        .clk(clk),
        .rst(1'b0),
        .d_i(odd),
        .q_o(odd_before)
      );

      genvar b;
      for (b = 0; b < 2; b = b + 1) begin : gen_bank
        wire [OFFSET_W-1:0] offset;
        ffd_num_offset #(
          .FORMAT (FORMAT),
          .LATENCY(ADD_LATENCY)
        ) u_offset (
          .clk     (clk),
          .point_i (points_i[b*POINT_W +: POINT_W]),
          .base_i  (base),
          .offset_o(offset)
        );
        ffd_num_offset_term #(
          .FORMAT (FORMAT),
          .LATENCY(MUL_LATENCY)
        ) u_term (
          .clk     (clk),
          .weight_i(weights[b*WEIGHT_W +: WEIGHT_W]),
          .offset_i(offset),
          .term_o  (terms[b*SUM_W +: SUM_W])
        );
      end

      ffd_num_delay #(
        .WIDTH  (POINT_W),
        .LATENCY(ADD_LATENCY)
      ) u_late_base (
        .clk(clk),
        .rst(1'b0),
        .d_i(base),
        .q_o(late_base)
      );

      ffd_num_base_term #(
        .FORMAT (FORMAT),
        .LATENCY(MUL_LATENCY)
      ) u_base_term (
        .clk     (clk),
        .weight_i(weights[WEIGHT_W +: WEIGHT_W]),
        .point_i (late_base),
        .term_o  (base_term)
      );

      ffd_num_delay #(
        .WIDTH  (1),
        .LATENCY(MUL_LATENCY)
      ) u_sum_low (
        .clk(clk),
        .rst(1'b0),
        .d_i(low),
        .q_o(sum_low)
      );

      ffd_num_add #(
        .FORMAT (FORMAT),
        .LATENCY(ADD_LATENCY)
      ) u_pair (
        .clk  (clk),
        .a_i  (terms[0 +: SUM_W]),
        .b_i  (sum_low ? terms[SUM_W +: SUM_W] : base_term),
        .sum_o(pair)
      );
    end
  endgenerate

  ffd_num_delay #(
    .WIDTH  (SUM_W),
    .LATENCY(TURNS)
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
