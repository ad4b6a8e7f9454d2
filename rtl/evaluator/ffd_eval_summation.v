// ffd_eval_summation: from blending weights to the vertex: products, control points, sums
//
// Stages 2 and 3 of the paper's fig. 1 for N = S * T * U combinations a step: weight products, the
// N points that it reads, a tree over the N terms (fig. 5), an accumulator over the steps. Every
// organization in product form ends in it.
//
// Formats, rounding: those of the number layer; order of addition: docs/numerics.md section 4.
// Pipeline:   weights | 2 MUL_LATENCY: products | FFD_TREE_LATENCY | FFD_ACCUMULATE_LATENCY: sum.
//             Points are asked for READ_LATENCY clocks ahead of the products. II 1.
// Freezes:    never.
// Parameters: N a power of two, 1 to 64; DISTANCE the clocks between steps of one vertex; the
//             others as in every organization.
// Model:      golden/include/hwffd/model/organization.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_summation #(
  parameter FORMAT       = 18,
  parameter N            = 1,
  parameter MUL_LATENCY  = 2,
  parameter ADD_LATENCY  = 1,
  parameter FMA_LATENCY  = 0,
  parameter READ_LATENCY = 2,
  parameter SOURCE_W     = 2,
  parameter DISTANCE     = 1
) (
  input  wire                                                 clk,
  input  wire                                                 rst,
  input  wire                                                 step_valid_i,
  input  wire                                                 step_first_i,
  input  wire                                                 step_last_i,
  input  wire [SOURCE_W-1:0]                                  step_source_i,
  input  wire [11:0]                                          step_cell_i,
  input  wire [5:0]                                           step_index_i,
  input  wire [`FFD_UNITS_S(N)*`FFD_WEIGHT_W(FORMAT)-1:0]     weights_s_i,
  input  wire [`FFD_UNITS_T(N)*`FFD_WEIGHT_W(FORMAT)-1:0]     weights_t_i,
  input  wire [`FFD_UNITS_U(N)*`FFD_WEIGHT_W(FORMAT)-1:0]     weights_u_i,
  output wire                                                 read_o,
  output wire                                                 read_last_o,
  output wire [SOURCE_W-1:0]                                  read_source_o,
  output wire [11:0]                                          read_cell_o,
  output wire [5:0]                                           read_index_o,
  input  wire [N*3*`FFD_POINT_W(FORMAT)-1:0]                  read_points_i,
  output wire                                                 result_valid_o,
  output wire [3*`FFD_SUM_W(FORMAT)-1:0]                      result_sum_o
);
  localparam WEIGHT_W   = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W    = `FFD_POINT_W(FORMAT);
  localparam SUM_W      = `FFD_SUM_W(FORMAT);
  localparam PRODUCT    = 2 * MUL_LATENCY;
  localparam READ_DELAY = PRODUCT - READ_LATENCY;
  localparam TREE       = `FFD_TREE_LATENCY(N, MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);
  localparam ACCUMULATE = `FFD_ACCUMULATE_LATENCY(N, ADD_LATENCY, FMA_LATENCY);
  localparam FUSED_SUM  = N == 1 && FMA_LATENCY > 0;

  generate
    if (READ_DELAY < 0) begin : gen_bad_read_latency
      ERROR_ffd_eval_summation_read_latency_is_too_long u_error ();
    end
  endgenerate

  wire [N*WEIGHT_W-1:0] weights;

  ffd_eval_weight_product #(
    .FORMAT     (FORMAT),
    .S          (`FFD_UNITS_S(N)),
    .T          (`FFD_UNITS_T(N)),
    .U          (`FFD_UNITS_U(N)),
    .MUL_LATENCY(MUL_LATENCY)
  ) u_product (
    .clk        (clk),
    .weights_s_i(weights_s_i),
    .weights_t_i(weights_t_i),
    .weights_u_i(weights_u_i),
    .weights_o  (weights)
  );

  wire read_valid;
  wire read_last;

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(READ_DELAY),
    .RESET  (1)
  ) u_read_valid (
    .clk(clk),
    .rst(rst),
    .d_i({step_valid_i, step_last_i}),
    .q_o({read_valid, read_last})
  );

  ffd_num_delay #(
    .WIDTH  (SOURCE_W + 18),
    .LATENCY(READ_DELAY)
  ) u_read_address (
    .clk(clk),
    .rst(rst),
    .d_i({step_source_i, step_cell_i, step_index_i}),
    .q_o({read_source_o, read_cell_o, read_index_o})
  );

  assign read_o      = read_valid;
  assign read_last_o = read_valid && read_last;

  wire sum_valid;
  wire sum_last;
  wire first_next;  // a clock ahead of the first sum

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(PRODUCT + TREE),
    .RESET  (1)
  ) u_sum_valid (
    .clk(clk),
    .rst(rst),
    .d_i({step_valid_i, step_valid_i && step_last_i}),
    .q_o({sum_valid, sum_last})
  );

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(PRODUCT + TREE - 1),
    .RESET  (1)
  ) u_first_next (
    .clk(clk),
    .rst(rst),
    .d_i(step_valid_i && step_first_i),
    .q_o(first_next)
  );

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(ACCUMULATE),
    .RESET  (1)
  ) u_result_valid (
    .clk(clk),
    .rst(rst),
    .d_i(sum_last),
    .q_o(result_valid_o)
  );

  genvar c;
  genvar i;
  generate
    for (c = 0; c < 3; c = c + 1) begin : gen_component
      wire [N*POINT_W-1:0] points;
      wire [SUM_W-1:0]     sum;

      for (i = 0; i < N; i = i + 1) begin : gen_point
        assign points[i*POINT_W +: POINT_W] = read_points_i[(3*i+c)*POINT_W +: POINT_W];
      end

      if (FUSED_SUM) begin : gen_no_tree
        assign sum = {SUM_W{1'b0}};
      end else begin : gen_tree
        ffd_eval_tree #(
          .FORMAT     (FORMAT),
          .N          (N),
          .MUL_LATENCY(MUL_LATENCY),
          .ADD_LATENCY(ADD_LATENCY),
          .FMA_LATENCY(FMA_LATENCY)
        ) u_tree (
          .clk      (clk),
          .weights_i(weights),
          .points_i (points),
          .sum_o    (sum)
        );
        `FFD_ASSERT_TAKES(u_tree, TREE)
      end

      if (N == 64) begin : gen_whole
        assign result_sum_o[c*SUM_W +: SUM_W] = sum;
      end else begin : gen_accumulate
        ffd_eval_accumulator #(
          .FORMAT     (FORMAT),
          .ADD_LATENCY(ADD_LATENCY),
          .FMA_LATENCY(FUSED_SUM ? FMA_LATENCY : 0),
          .DISTANCE   (DISTANCE)
        ) u_accumulator (
          .clk         (clk),
          .rst         (rst),
          .valid_i     (sum_valid),
          .clear_next_i(first_next),
          .term_i      (sum),
          .weight_i    (weights[WEIGHT_W-1:0]),
          .point_i     (points[POINT_W-1:0]),
          .sum_o       (result_sum_o[c*SUM_W +: SUM_W])
        );
        `FFD_ASSERT_TAKES(u_accumulator, ACCUMULATE)
      end
    end
    if (N == 64) begin : gen_unused
      wire unused_ok = &{1'b0, sum_valid, first_next, DISTANCE != 0};
    end
  endgenerate
endmodule

`default_nettype wire
