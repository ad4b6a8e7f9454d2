// model_summation: in the place of the summation: it shows the combination that it is given,
// {cell, source, step, weights of u, t, s}, in the clock in which it is given
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_eval_summation #(
  parameter FORMAT       = 8,
  parameter N            = 1,
  parameter MUL_LATENCY  = 2,
  parameter ADD_LATENCY  = 1,
  parameter FMA_LATENCY  = 0,
  parameter READ_LATENCY = 2,
  parameter SOURCE_W     = 1,
  parameter DISTANCE     = 1
) (
  input  wire        clk,
  input  wire        rst,
  input  wire        step_valid_i,
  input  wire        step_first_i,
  input  wire        step_last_i,
  input  wire        step_source_i,
  input  wire [11:0] step_cell_i,
  input  wire [5:0]  step_index_i,
  input  wire [8:0]  weights_s_i,
  input  wire [8:0]  weights_t_i,
  input  wire [8:0]  weights_u_i,
  output wire        read_o,
  output wire        read_last_o,
  output wire        read_source_o,
  output wire [11:0] read_cell_o,
  output wire [5:0]  read_index_o,
  input  wire [26:0] read_points_i,
  output wire        result_valid_o,
  output wire [68:0] result_sum_o
);
  assign result_valid_o = step_valid_i;
  assign result_sum_o   = {23'd0, step_cell_i, step_source_i, step_index_i,
                           weights_u_i, weights_t_i, weights_s_i};
  assign {read_o, read_last_o, read_source_o, read_cell_o, read_index_o} = 21'd0;
endmodule

`default_nettype wire
