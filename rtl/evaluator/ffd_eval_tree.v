// ffd_eval_tree: sum = weight_0 P_0 + ... + weight_{N-1} P_{N-1}, one component
//
// The terms and a tree of adders over adjacent pairs (paper, fig. 5). Fused, the odd term of each
// pair is added to the even one as it is multiplied.
//
// Formats, rounding: those of ffd_num_term, ffd_num_add, ffd_num_mac.
// Pipeline:   FFD_TREE_LATENCY registers, II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh; N a power of two, 1 to 64 (fused: 2 to 64); latencies >= 1;
//             FMA_LATENCY >= 1 fuses, 0 does not.
// Model:      golden/include/hwffd/model/organization.hpp (tree_sum).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"

module ffd_eval_tree #(
  parameter FORMAT      = 18,
  parameter N           = 4,
  parameter MUL_LATENCY = 1,
  parameter ADD_LATENCY = 1,
  parameter FMA_LATENCY = 0
) (
  input  wire                                clk,
  input  wire [N*`FFD_WEIGHT_W(FORMAT)-1:0]  weights_i,
  input  wire [N*`FFD_POINT_W(FORMAT)-1:0]   points_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]       sum_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam SUM_W    = `FFD_SUM_W(FORMAT);
  localparam LEVELS   = $clog2(N + 1) - 1;  // rounded down, so that a bad N meets its guard only
  localparam FUSED    = FMA_LATENCY > 0;
  `FFD_TAKES(FUSED ? MUL_LATENCY + FMA_LATENCY + (LEVELS - 1) * ADD_LATENCY
                   : MUL_LATENCY + LEVELS * ADD_LATENCY)

  generate
    if ((1 << LEVELS) != N || N > 64 || (FUSED && N == 1)) begin : gen_bad_n
      ERROR_ffd_eval_tree_n_must_be_a_power_of_two u_error ();
    end
  endgenerate

  // Level 0 is the terms; fused, it is the even ones only, and level 1 adds the odd ones to them.
  genvar level;
  genvar i;
  generate
    for (level = 0; level <= LEVELS; level = level + 1) begin : gen_rank
      for (i = 0; i < (N >> level); i = i + 1) begin : gen_sum
        wire [SUM_W-1:0] sum;
        if (level == 0) begin : gen_term
          if (FUSED && i % 2 == 1) begin : gen_later
            assign sum = {SUM_W{1'b0}};
            wire unused_ok = &{1'b0, sum};
          end else begin : gen_now
            ffd_num_term #(
              .FORMAT (FORMAT),
              .LATENCY(MUL_LATENCY)
            ) u_term (
              .clk     (clk),
              .weight_i(weights_i[i*WEIGHT_W +: WEIGHT_W]),
              .point_i (points_i[i*POINT_W +: POINT_W]),
              .term_o  (sum)
            );
          end
        end else if (FUSED && level == 1) begin : gen_fused
          wire [WEIGHT_W-1:0] weight;
          wire [POINT_W-1:0]  point;
          ffd_num_delay #(
            .WIDTH  (WEIGHT_W + POINT_W),
            .LATENCY(MUL_LATENCY)
          ) u_odd (
            .clk(clk),
            .rst(1'b0),
            .d_i({weights_i[(2*i+1)*WEIGHT_W +: WEIGHT_W], points_i[(2*i+1)*POINT_W +: POINT_W]}),
            .q_o({weight, point})
          );
          ffd_num_mac #(
            .FORMAT (FORMAT),
            .LATENCY(FMA_LATENCY)
          ) u_mac (
            .clk     (clk),
            .weight_i(weight),
            .point_i (point),
            .sum_i   (gen_rank[level-1].gen_sum[2*i].sum),
            .sum_o   (sum)
          );
        end else begin : gen_add
          ffd_num_add #(
            .FORMAT (FORMAT),
            .LATENCY(ADD_LATENCY)
          ) u_add (
            .clk  (clk),
            .a_i  (gen_rank[level-1].gen_sum[2*i].sum),
            .b_i  (gen_rank[level-1].gen_sum[2*i+1].sum),
            .sum_o(sum)
          );
        end
      end
    end
  endgenerate

  assign sum_o = gen_rank[LEVELS].gen_sum[0].sum;
endmodule

`default_nettype wire
