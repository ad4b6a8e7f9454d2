// ffd_eval_affine: sum = P3 + w0 (P0 - P3) + w1 (P1 - P3) + w2 (P2 - P3), one component
//
// Weights that sum to one need three multiplications for four points, and sum to one whatever the
// rounding of these three. Of a derivative, whose weights sum to zero, P3 itself is left out.
// Several sums, each with weights of its own, share the differences.
//
// Formats, rounding: those of ffd_num_offset and the terms of it: exact, so the bits are those of
//             four terms with the weight 1 - w0 - w1 - w2, or - w0 - w1 - w2.
// Pipeline:   points | ADD_LATENCY: weights | MUL_LATENCY + 2 ADD_LATENCY: sum. II 1, never frozen.
// Parameters: FORMAT 8 to 32, latencies >= 1, SUMS >= 1. The fourth weight is what multiplies P3:
//             1 or 0.
// Not checked: that it is one of these.
// Model:      golden/include/hwffd/model/org_affine.hpp.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"

module ffd_eval_affine #(
  parameter FORMAT      = 17,
  parameter SUMS        = 1,
  parameter MUL_LATENCY = 1,
  parameter ADD_LATENCY = 1
) (
  input  wire                                    clk,
  input  wire [SUMS*4*`FFD_WEIGHT_W(FORMAT)-1:0] weights_i,
  input  wire [4*`FFD_POINT_W(FORMAT)-1:0]       points_i,
  output wire [SUMS*`FFD_SUM_W(FORMAT)-1:0]      sums_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam OFFSET_W = `FFD_OFFSET_W(FORMAT);
  localparam SUM_W    = `FFD_SUM_W(FORMAT);
  `FFD_TAKES(MUL_LATENCY + 3 * ADD_LATENCY)

  wire [3*OFFSET_W-1:0] offsets;
  wire [POINT_W-1:0]    base;

  genvar b;
  generate
    for (b = 0; b < 3; b = b + 1) begin : gen_bank
      ffd_num_offset #(
        .FORMAT (FORMAT),
        .LATENCY(ADD_LATENCY)
      ) u_offset (
        .clk     (clk),
        .point_i (points_i[b*POINT_W +: POINT_W]),
        .base_i  (points_i[3*POINT_W +: POINT_W]),
        .offset_o(offsets[b*OFFSET_W +: OFFSET_W])
      );
    end
  endgenerate

  ffd_num_delay #(
    .WIDTH  (POINT_W),
    .LATENCY(ADD_LATENCY)
  ) u_base (
    .clk(clk),
    .rst(1'b0),
    .d_i(points_i[3*POINT_W +: POINT_W]),
    .q_o(base)
  );

  genvar n;
  genvar i;
  generate
    for (n = 0; n < SUMS; n = n + 1) begin : gen_sum
      wire [4*WEIGHT_W-1:0] weights = weights_i[n*4*WEIGHT_W +: 4*WEIGHT_W];
      wire [4*SUM_W-1:0]    terms;
      wire [2*SUM_W-1:0]    pairs;

      for (i = 0; i < 3; i = i + 1) begin : gen_term
        ffd_num_offset_term #(
          .FORMAT (FORMAT),
          .LATENCY(MUL_LATENCY)
        ) u_term (
          .clk     (clk),
          .weight_i(weights[i*WEIGHT_W +: WEIGHT_W]),
          .offset_i(offsets[i*OFFSET_W +: OFFSET_W]),
          .term_o  (terms[i*SUM_W +: SUM_W])
        );
      end

      ffd_num_base_term #(
        .FORMAT (FORMAT),
        .LATENCY(MUL_LATENCY)
      ) u_base_term (
        .clk     (clk),
        .weight_i(weights[3*WEIGHT_W +: WEIGHT_W]),
        .point_i (base),
        .term_o  (terms[3*SUM_W +: SUM_W])
      );

      for (i = 0; i < 2; i = i + 1) begin : gen_pair
        ffd_num_add #(
          .FORMAT (FORMAT),
          .LATENCY(ADD_LATENCY)
        ) u_add (
          .clk  (clk),
          .a_i  (terms[(2*i+0)*SUM_W +: SUM_W]),
          .b_i  (terms[(2*i+1)*SUM_W +: SUM_W]),
          .sum_o(pairs[i*SUM_W +: SUM_W])
        );
      end

      ffd_num_add #(
        .FORMAT (FORMAT),
        .LATENCY(ADD_LATENCY)
      ) u_add (
        .clk  (clk),
        .a_i  (pairs[0*SUM_W +: SUM_W]),
        .b_i  (pairs[1*SUM_W +: SUM_W]),
        .sum_o(sums_o[n*SUM_W +: SUM_W])
      );
    end
  endgenerate
endmodule

`default_nettype wire
