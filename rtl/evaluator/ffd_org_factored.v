// ffd_org_factored: q by contracting one axis at a time, 64 -> 16 -> 4 -> 1 (beyond the paper)
//
// The 64 points of a cell are read at once, one from each bank, and the four weights of each axis
// are rotated into the order of the banks: 12 polynomials and 84 multiplications a component, and
// a vertex a clock from any cell. Folded by three, one component a clock on a third of it.
//
// Schedule:   overlapped only, FOLD clocks between vertices; the paper has no such organization.
// Pipeline:   step | FFD_CHOICE_LATENCY, FFD_POLY_LATENCY: weights of u, points |
//             ffd_eval_contraction.
// Freezes:    never. Results leave in the order of the vertices and are not held back: who offers a
//             vertex must have room for its result.
// Parameters: those of every organization (docs/architecture.md); N is 64, SCHEDULE overlapped,
//             EVALUATOR not iterative; FOLD 1 or 3, with the same bits; AFFINE 1: ffd_org_affine.
// Model:      golden/include/hwffd/model/org_factored.hpp.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_org_factored #(
  parameter FOLD            = 1,
  parameter AFFINE          = 0,
  parameter FORMAT          = 18,
  parameter N               = 64,
  `include "ffd_org_parameters.vh"
) (
  `include "ffd_org_ports.vh"
);
  localparam WEIGHT_W     = `FFD_WEIGHT_W(FORMAT);
  localparam PLACE_W      = `FFD_PLACE_W(SPANS);
  localparam STEP_W       = FOLD > 1 ? $clog2(FOLD) : 1;
  localparam STEP_LATENCY = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);
  localparam FILE_LATENCY = `FFD_FILE_LATENCY(SCHEDULE, EVALUATOR);
  localparam POLY_LATENCY = `FFD_POLY_LATENCY(EVALUATOR, FILE_LATENCY, STEP_LATENCY,
                                              CONVERT_LATENCY);
  localparam CONTRACT     = `FFD_CONTRACT_LATENCY(AFFINE, MUL_LATENCY, ADD_LATENCY, FMA_LATENCY,
                                                  CONVERT_LATENCY);
  localparam READ_DELAY   = `FFD_CHOICE_LATENCY(FOLD) + POLY_LATENCY - READ_LATENCY
                          - `FFD_OFFSET_LATENCY(AFFINE, ADD_LATENCY);

  generate
    if (FOLD != 1 && FOLD != 3) begin : gen_bad_fold
      ERROR_ffd_org_factored_fold_must_be_1_or_3 u_error ();
    end
    if (N != 64) begin : gen_bad_n
      ERROR_ffd_org_factored_n_must_be_64 u_error ();
    end
    if (SCHEDULE != `FFD_SCHEDULE_OVERLAPPED) begin : gen_bad_schedule
      ERROR_ffd_org_factored_schedule_must_be_overlapped u_error ();
    end
    if (READ_DELAY < 0) begin : gen_bad_read_latency
      ERROR_ffd_org_factored_read_latency_is_too_long u_error ();
    end
  endgenerate

  wire                  step_valid;
  wire                  step_first;
  wire                  step_last;
  wire [STEP_W-1:0]     step_count;
  wire [3*WEIGHT_W-1:0] coordinates;
  wire [11:0]           cell_index;
  wire [SOURCE_W-1:0]   source;
  wire [3*PLACE_W-1:0]  bank;
  wire [1:0]            step = {{(2 - STEP_W) {1'b0}}, step_count};

  ffd_eval_sequencer #(
    .PAYLOAD_W(3 * WEIGHT_W + 12 + SOURCE_W + 3 * PLACE_W),
    .STEPS    (FOLD),
    .CONTEXTS (1),
    .INTERVAL (1)
  ) u_sequencer (
    .clk           (clk),
    .rst           (rst),
    .s_vertex_valid(s_vertex_valid),
    .s_vertex_ready(s_vertex_ready),
    .s_vertex_data ({s_vertex_coordinates, s_vertex_cell, s_vertex_source, s_vertex_bank}),
    .step_valid_o  (step_valid),
    .step_first_o  (step_first),
    .step_last_o   (step_last),
    .step_o        (step_count),
    .payload_o     ({coordinates, cell_index, source, bank})
  );

  wire [3*4*WEIGHT_W-1:0] weights;

  ffd_eval_bank_weights #(
    .FOLD           (FOLD),
    .AFFINE         (AFFINE),
    .FORMAT         (FORMAT),
    .EVALUATOR      (EVALUATOR),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (FMA_LATENCY),
    .CONVERT_LATENCY(CONVERT_LATENCY),
    .DISTANCE       (CONTRACT),
    .SPANS          (SPANS)
  ) u_weights (
    .clk           (clk),
    .load_i        (load_i),
    .load_axis_i   (load_axis_i),
    .load_address_i(load_address_i),
    .load_entry_i  (load_entry_i),
    .step_valid_i  (step_valid),
    .step_i        (step),
    .coordinates_i (coordinates),
    .cell_i        (cell_index),
    .bank_i        (bank),
    .weights_o     (weights)
  );

  // The points of a step are asked for so that they come when the contraction wants them.
  wire                read_valid;
  wire                read_last;
  wire [1:0]          read_component;
  wire [SOURCE_W-1:0] read_source;
  wire [11:0]         read_cell;

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(READ_DELAY),
    .RESET  (1)
  ) u_read_valid (
    .clk(clk),
    .rst(rst),
    .d_i({step_valid, step_last}),
    .q_o({read_valid, read_last})
  );

  ffd_num_delay #(
    .WIDTH  (2 + SOURCE_W + 12),
    .LATENCY(READ_DELAY)
  ) u_read (
    .clk(clk),
    .rst(rst),
    .d_i({step, source, cell_index}),
    .q_o({read_component, read_source, read_cell})
  );

  ffd_eval_contraction #(
    .FOLD           (FOLD),
    .AFFINE         (AFFINE),
    .FORMAT         (FORMAT),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (FMA_LATENCY),
    .CONVERT_LATENCY(CONVERT_LATENCY),
    .READ_LATENCY   (READ_LATENCY),
    .SOURCE_W       (SOURCE_W)
  ) u_contraction (
    .clk             (clk),
    .rst             (rst),
    .step_valid_i    (read_valid),
    .step_last_i     (read_last),
    .step_component_i(read_component),
    .step_source_i   (read_source),
    .step_cell_i     (read_cell),
    .weights_i       (weights),
    .read_o          (read_o),
    .read_last_o     (read_last_o),
    .read_source_o   (read_source_o),
    .read_cell_o     (read_cell_o),
    .read_points_i   (read_points_i),
    .result_valid_o  (result_valid_o),
    .result_sum_o    (result_sum_o)
  );

  assign read_index_o = 6'd0;
  wire unused_ok = &{1'b0, s_vertex_changed, step_first};

  assign forming_o = 1'b0;
endmodule

`default_nettype wire
