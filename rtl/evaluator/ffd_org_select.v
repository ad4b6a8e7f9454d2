// ffd_org_select: the organization numbered ORG
//
// ORG is 0 basic (N 1), 1 cg1 (N 1), 2 cg2 (N 1), 3 cg3 (N 1), 4 tree, 5 parallel (N 64), 6
// factored (N 64), 7 factored/3 (N 64), 8 nested (N 4), 9 nested/3 (N 4).
// Made from rtl/organizations.csv by scripts/configurations.py; changes here are lost.
//
// Ports, pipeline, parameters: those of every organization (docs/architecture.md).
// Model:      golden/include/hwffd/model/evaluator.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_org_select #(
  parameter ORG             = 0,
  parameter FORMAT          = 18,
  parameter N               = 1,
  parameter SCHEDULE        = `FFD_SCHEDULE_OVERLAPPED,
  parameter EVALUATOR       = `FFD_EVALUATOR_PIPELINED,
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 1,
  parameter READ_LATENCY    = 2,
  parameter SOURCE_W        = 2
) (
  input  wire                                            clk,
  input  wire                                            rst,
  input  wire                                            load_i,
  input  wire [1:0]                                      load_axis_i,
  input  wire [3:0]                                      load_address_i,
  input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,
  input  wire                                            s_vertex_valid,
  output wire                                            s_vertex_ready,
  input  wire [3*`FFD_WEIGHT_W(FORMAT)-1:0]              s_vertex_coordinates,
  input  wire [11:0]                                     s_vertex_cell,
  input  wire [SOURCE_W-1:0]                             s_vertex_source,
  input  wire [5:0]                                      s_vertex_bank,
  input  wire                                            s_vertex_changed,
  output wire                                            read_o,
  output wire                                            read_last_o,
  output wire [SOURCE_W-1:0]                             read_source_o,
  output wire [11:0]                                     read_cell_o,
  output wire [5:0]                                      read_index_o,
  input  wire [N*3*`FFD_POINT_W(FORMAT)-1:0]             read_points_i,
  output wire                                            result_valid_o,
  output wire [3*`FFD_SUM_W(FORMAT)-1:0]                 result_sum_o
);
  generate
    if (ORG == 0 && N != 1 ||
        ORG == 1 && N != 1 ||
        ORG == 2 && N != 1 ||
        ORG == 3 && N != 1 ||
        ORG == 5 && N != 64 ||
        ORG == 6 && N != 64 ||
        ORG == 7 && N != 64 ||
        ORG == 8 && N != 4 ||
        ORG == 9 && N != 4) begin : gen_bad_n
      ERROR_ffd_org_select_n_is_not_that_of_the_organization u_error ();
    end
    if (ORG == 0) begin : gen_basic
      ffd_org_tree #(
        .SERIAL(1),
        .FORMAT         (FORMAT),
        .N              (N),
        .SCHEDULE       (SCHEDULE),
        .EVALUATOR      (EVALUATOR),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .READ_LATENCY   (READ_LATENCY),
        .SOURCE_W       (SOURCE_W)
      ) u_org (
        .clk                 (clk),
        .rst                 (rst),
        .load_i              (load_i),
        .load_axis_i         (load_axis_i),
        .load_address_i      (load_address_i),
        .load_entry_i        (load_entry_i),
        .s_vertex_valid      (s_vertex_valid),
        .s_vertex_ready      (s_vertex_ready),
        .s_vertex_coordinates(s_vertex_coordinates),
        .s_vertex_cell       (s_vertex_cell),
        .s_vertex_source     (s_vertex_source),
        .s_vertex_bank       (s_vertex_bank),
        .s_vertex_changed    (s_vertex_changed),
        .read_o              (read_o),
        .read_last_o         (read_last_o),
        .read_source_o       (read_source_o),
        .read_cell_o         (read_cell_o),
        .read_index_o        (read_index_o),
        .read_points_i       (read_points_i),
        .result_valid_o      (result_valid_o),
        .result_sum_o        (result_sum_o)
      );
    end else if (ORG == 1) begin : gen_cg1
      ffd_org_cg #(
        .SIZE(1),
        .FORMAT         (FORMAT),
        .N              (N),
        .SCHEDULE       (SCHEDULE),
        .EVALUATOR      (EVALUATOR),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .READ_LATENCY   (READ_LATENCY),
        .SOURCE_W       (SOURCE_W)
      ) u_org (
        .clk                 (clk),
        .rst                 (rst),
        .load_i              (load_i),
        .load_axis_i         (load_axis_i),
        .load_address_i      (load_address_i),
        .load_entry_i        (load_entry_i),
        .s_vertex_valid      (s_vertex_valid),
        .s_vertex_ready      (s_vertex_ready),
        .s_vertex_coordinates(s_vertex_coordinates),
        .s_vertex_cell       (s_vertex_cell),
        .s_vertex_source     (s_vertex_source),
        .s_vertex_bank       (s_vertex_bank),
        .s_vertex_changed    (s_vertex_changed),
        .read_o              (read_o),
        .read_last_o         (read_last_o),
        .read_source_o       (read_source_o),
        .read_cell_o         (read_cell_o),
        .read_index_o        (read_index_o),
        .read_points_i       (read_points_i),
        .result_valid_o      (result_valid_o),
        .result_sum_o        (result_sum_o)
      );
    end else if (ORG == 2) begin : gen_cg2
      ffd_org_cg #(
        .SIZE(2),
        .FORMAT         (FORMAT),
        .N              (N),
        .SCHEDULE       (SCHEDULE),
        .EVALUATOR      (EVALUATOR),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .READ_LATENCY   (READ_LATENCY),
        .SOURCE_W       (SOURCE_W)
      ) u_org (
        .clk                 (clk),
        .rst                 (rst),
        .load_i              (load_i),
        .load_axis_i         (load_axis_i),
        .load_address_i      (load_address_i),
        .load_entry_i        (load_entry_i),
        .s_vertex_valid      (s_vertex_valid),
        .s_vertex_ready      (s_vertex_ready),
        .s_vertex_coordinates(s_vertex_coordinates),
        .s_vertex_cell       (s_vertex_cell),
        .s_vertex_source     (s_vertex_source),
        .s_vertex_bank       (s_vertex_bank),
        .s_vertex_changed    (s_vertex_changed),
        .read_o              (read_o),
        .read_last_o         (read_last_o),
        .read_source_o       (read_source_o),
        .read_cell_o         (read_cell_o),
        .read_index_o        (read_index_o),
        .read_points_i       (read_points_i),
        .result_valid_o      (result_valid_o),
        .result_sum_o        (result_sum_o)
      );
    end else if (ORG == 3) begin : gen_cg3
      ffd_org_cg #(
        .SIZE(3),
        .FORMAT         (FORMAT),
        .N              (N),
        .SCHEDULE       (SCHEDULE),
        .EVALUATOR      (EVALUATOR),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .READ_LATENCY   (READ_LATENCY),
        .SOURCE_W       (SOURCE_W)
      ) u_org (
        .clk                 (clk),
        .rst                 (rst),
        .load_i              (load_i),
        .load_axis_i         (load_axis_i),
        .load_address_i      (load_address_i),
        .load_entry_i        (load_entry_i),
        .s_vertex_valid      (s_vertex_valid),
        .s_vertex_ready      (s_vertex_ready),
        .s_vertex_coordinates(s_vertex_coordinates),
        .s_vertex_cell       (s_vertex_cell),
        .s_vertex_source     (s_vertex_source),
        .s_vertex_bank       (s_vertex_bank),
        .s_vertex_changed    (s_vertex_changed),
        .read_o              (read_o),
        .read_last_o         (read_last_o),
        .read_source_o       (read_source_o),
        .read_cell_o         (read_cell_o),
        .read_index_o        (read_index_o),
        .read_points_i       (read_points_i),
        .result_valid_o      (result_valid_o),
        .result_sum_o        (result_sum_o)
      );
    end else if (ORG == 4) begin : gen_tree
      ffd_org_tree #(
        .FORMAT         (FORMAT),
        .N              (N),
        .SCHEDULE       (SCHEDULE),
        .EVALUATOR      (EVALUATOR),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .READ_LATENCY   (READ_LATENCY),
        .SOURCE_W       (SOURCE_W)
      ) u_org (
        .clk                 (clk),
        .rst                 (rst),
        .load_i              (load_i),
        .load_axis_i         (load_axis_i),
        .load_address_i      (load_address_i),
        .load_entry_i        (load_entry_i),
        .s_vertex_valid      (s_vertex_valid),
        .s_vertex_ready      (s_vertex_ready),
        .s_vertex_coordinates(s_vertex_coordinates),
        .s_vertex_cell       (s_vertex_cell),
        .s_vertex_source     (s_vertex_source),
        .s_vertex_bank       (s_vertex_bank),
        .s_vertex_changed    (s_vertex_changed),
        .read_o              (read_o),
        .read_last_o         (read_last_o),
        .read_source_o       (read_source_o),
        .read_cell_o         (read_cell_o),
        .read_index_o        (read_index_o),
        .read_points_i       (read_points_i),
        .result_valid_o      (result_valid_o),
        .result_sum_o        (result_sum_o)
      );
    end else if (ORG == 5) begin : gen_parallel
      ffd_org_tree #(
        .FORMAT         (FORMAT),
        .N              (N),
        .SCHEDULE       (SCHEDULE),
        .EVALUATOR      (EVALUATOR),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .READ_LATENCY   (READ_LATENCY),
        .SOURCE_W       (SOURCE_W)
      ) u_org (
        .clk                 (clk),
        .rst                 (rst),
        .load_i              (load_i),
        .load_axis_i         (load_axis_i),
        .load_address_i      (load_address_i),
        .load_entry_i        (load_entry_i),
        .s_vertex_valid      (s_vertex_valid),
        .s_vertex_ready      (s_vertex_ready),
        .s_vertex_coordinates(s_vertex_coordinates),
        .s_vertex_cell       (s_vertex_cell),
        .s_vertex_source     (s_vertex_source),
        .s_vertex_bank       (s_vertex_bank),
        .s_vertex_changed    (s_vertex_changed),
        .read_o              (read_o),
        .read_last_o         (read_last_o),
        .read_source_o       (read_source_o),
        .read_cell_o         (read_cell_o),
        .read_index_o        (read_index_o),
        .read_points_i       (read_points_i),
        .result_valid_o      (result_valid_o),
        .result_sum_o        (result_sum_o)
      );
    end else if (ORG == 6) begin : gen_factored
      ffd_org_factored #(
        .FORMAT         (FORMAT),
        .N              (N),
        .SCHEDULE       (SCHEDULE),
        .EVALUATOR      (EVALUATOR),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .READ_LATENCY   (READ_LATENCY),
        .SOURCE_W       (SOURCE_W)
      ) u_org (
        .clk                 (clk),
        .rst                 (rst),
        .load_i              (load_i),
        .load_axis_i         (load_axis_i),
        .load_address_i      (load_address_i),
        .load_entry_i        (load_entry_i),
        .s_vertex_valid      (s_vertex_valid),
        .s_vertex_ready      (s_vertex_ready),
        .s_vertex_coordinates(s_vertex_coordinates),
        .s_vertex_cell       (s_vertex_cell),
        .s_vertex_source     (s_vertex_source),
        .s_vertex_bank       (s_vertex_bank),
        .s_vertex_changed    (s_vertex_changed),
        .read_o              (read_o),
        .read_last_o         (read_last_o),
        .read_source_o       (read_source_o),
        .read_cell_o         (read_cell_o),
        .read_index_o        (read_index_o),
        .read_points_i       (read_points_i),
        .result_valid_o      (result_valid_o),
        .result_sum_o        (result_sum_o)
      );
    end else if (ORG == 7) begin : gen_factored_by_3
      ffd_org_factored #(
        .FOLD(3),
        .FORMAT         (FORMAT),
        .N              (N),
        .SCHEDULE       (SCHEDULE),
        .EVALUATOR      (EVALUATOR),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .READ_LATENCY   (READ_LATENCY),
        .SOURCE_W       (SOURCE_W)
      ) u_org (
        .clk                 (clk),
        .rst                 (rst),
        .load_i              (load_i),
        .load_axis_i         (load_axis_i),
        .load_address_i      (load_address_i),
        .load_entry_i        (load_entry_i),
        .s_vertex_valid      (s_vertex_valid),
        .s_vertex_ready      (s_vertex_ready),
        .s_vertex_coordinates(s_vertex_coordinates),
        .s_vertex_cell       (s_vertex_cell),
        .s_vertex_source     (s_vertex_source),
        .s_vertex_bank       (s_vertex_bank),
        .s_vertex_changed    (s_vertex_changed),
        .read_o              (read_o),
        .read_last_o         (read_last_o),
        .read_source_o       (read_source_o),
        .read_cell_o         (read_cell_o),
        .read_index_o        (read_index_o),
        .read_points_i       (read_points_i),
        .result_valid_o      (result_valid_o),
        .result_sum_o        (result_sum_o)
      );
    end else if (ORG == 8) begin : gen_nested
      ffd_org_nested #(
        .FORMAT         (FORMAT),
        .N              (N),
        .SCHEDULE       (SCHEDULE),
        .EVALUATOR      (EVALUATOR),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .READ_LATENCY   (READ_LATENCY),
        .SOURCE_W       (SOURCE_W)
      ) u_org (
        .clk                 (clk),
        .rst                 (rst),
        .load_i              (load_i),
        .load_axis_i         (load_axis_i),
        .load_address_i      (load_address_i),
        .load_entry_i        (load_entry_i),
        .s_vertex_valid      (s_vertex_valid),
        .s_vertex_ready      (s_vertex_ready),
        .s_vertex_coordinates(s_vertex_coordinates),
        .s_vertex_cell       (s_vertex_cell),
        .s_vertex_source     (s_vertex_source),
        .s_vertex_bank       (s_vertex_bank),
        .s_vertex_changed    (s_vertex_changed),
        .read_o              (read_o),
        .read_last_o         (read_last_o),
        .read_source_o       (read_source_o),
        .read_cell_o         (read_cell_o),
        .read_index_o        (read_index_o),
        .read_points_i       (read_points_i),
        .result_valid_o      (result_valid_o),
        .result_sum_o        (result_sum_o)
      );
    end else if (ORG == 9) begin : gen_nested_by_3
      ffd_org_nested #(
        .FOLD(3),
        .FORMAT         (FORMAT),
        .N              (N),
        .SCHEDULE       (SCHEDULE),
        .EVALUATOR      (EVALUATOR),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .READ_LATENCY   (READ_LATENCY),
        .SOURCE_W       (SOURCE_W)
      ) u_org (
        .clk                 (clk),
        .rst                 (rst),
        .load_i              (load_i),
        .load_axis_i         (load_axis_i),
        .load_address_i      (load_address_i),
        .load_entry_i        (load_entry_i),
        .s_vertex_valid      (s_vertex_valid),
        .s_vertex_ready      (s_vertex_ready),
        .s_vertex_coordinates(s_vertex_coordinates),
        .s_vertex_cell       (s_vertex_cell),
        .s_vertex_source     (s_vertex_source),
        .s_vertex_bank       (s_vertex_bank),
        .s_vertex_changed    (s_vertex_changed),
        .read_o              (read_o),
        .read_last_o         (read_last_o),
        .read_source_o       (read_source_o),
        .read_cell_o         (read_cell_o),
        .read_index_o        (read_index_o),
        .read_points_i       (read_points_i),
        .result_valid_o      (result_valid_o),
        .result_sum_o        (result_sum_o)
      );
    end else begin : gen_bad_org
      ERROR_ffd_org_select_org_is_unknown u_error ();
    end
  endgenerate
endmodule

`default_nettype wire
