// ffd_eval_factored: one lane of ffd_org_factored, with its own polynomials
//
// With the Jacobian it has them twice, for the functions and for their derivatives, and four sums
// come of a pass. A vertex with a place of derivatives on one axis only has that sum in place of
// the position's, as where there is no Jacobian.
//
// Schedule:   a vertex every FOLD clocks.
// Pipeline:   step | FFD_CHOICE_LATENCY, FFD_POLY_LATENCY: weights of u, points |
//             ffd_eval_contraction.
// Freezes:    never. Results leave in the order of the vertices and are not held back.
// Parameters: those of ffd_org_factored, which checks them.
// Model:      golden/include/hwffd/model/org_factored.hpp.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_factored #(
  parameter FOLD            = 1,
  parameter AFFINE          = 0,
  parameter JACOBIAN        = 0,
  parameter FORMAT          = 18,
  parameter N               = 64,
  parameter PORTS           = 1,
  `include "ffd_org_parameters.vh"
) (
  `include "ffd_org_ports.vh"
);
  localparam WEIGHT_W     = `FFD_WEIGHT_W(FORMAT);
  localparam SUM_W        = `FFD_SUM_W(FORMAT);
  localparam PLACE_W      = `FFD_PLACE_W(SPANS);
  localparam KINDS        = JACOBIAN == 0 ? 1 : 2;
  localparam TURNS        = `FFD_FOLD_TURNS(FOLD);
  localparam PARTS        = `FFD_FOLD_PARTS(FOLD);
  localparam HALVES       = `FFD_READ_HALVES(FOLD, N);
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
    if (READ_DELAY < 0) begin : gen_bad_read_latency
      ERROR_ffd_eval_factored_read_latency_is_too_long u_error ();
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

  // The first three steps evaluate an axis each; a step reads points where a part of them begins.
  wire [2:0] count = {{(3 - STEP_W) {1'b0}}, step_count};
  wire [1:0] step  = count[2] ? 2'd3 : count[1:0];
  wire       reads = TURNS == 1 || count == 3'd0 || count == (HALVES != 0 ? 3'd1 : 3'd3);
  wire       later = TURNS == 1 || HALVES != 0 ? count[0] : count >= 3'd3;  // of two halves
  wire [1:0] part  = PARTS == 4 ? ~count[1:0] : {1'b0, (PARTS == 2 || HALVES != 0) && !later};

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

  wire [KINDS*3*4*WEIGHT_W-1:0] weights;

  genvar kind;
  genvar a;
  generate
    for (kind = 0; kind < KINDS; kind = kind + 1) begin : gen_kind
      wire [3*PLACE_W-1:0] place;
      for (a = 0; a < 3; a = a + 1) begin : gen_axis
        wire [PLACE_W-1:0] own = bank[PLACE_W*a +: PLACE_W];
        wire               derivative = JACOBIAN == 0 ? own[1] : kind == 1;
        assign place[PLACE_W*a +: 2] = {derivative, own[0]};
        if (PLACE_W > 2) begin : gen_span
          assign place[PLACE_W*a+2 +: PLACE_W-2] = own[2 +: PLACE_W-2];
        end
        wire unused_ok = &{1'b0, own};
      end

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
        .bank_i        (place),
        .weights_o     (weights[3*4*kind*WEIGHT_W +: 3*4*WEIGHT_W])
      );
    end
  endgenerate

  // The points of a step are asked for so that they come when the contraction wants them.
  wire                read_valid;
  wire                read_begins;
  wire                read_last;
  wire [1:0]          read_part;
  wire [SOURCE_W-1:0] read_source;
  wire [11:0]         read_cell;

  ffd_num_delay #(
    .WIDTH  (3),
    .LATENCY(READ_DELAY),
    .RESET  (1)
  ) u_read_valid (
    .clk(clk),
    .rst(rst),
    .d_i({step_valid, step_valid && reads, step_valid && step_last}),
    .q_o({read_valid, read_begins, read_last})
  );

  ffd_num_delay #(
    .WIDTH  (2 + SOURCE_W + 12),
    .LATENCY(READ_DELAY)
  ) u_read (
    .clk(clk),
    .rst(rst),
    .d_i({part, source, cell_index}),
    .q_o({read_part, read_source, read_cell})
  );

  wire [3*`FFD_RESULTS(JACOBIAN)*SUM_W-1:0] sums;

  ffd_eval_contraction #(
    .FOLD           (FOLD),
    .AFFINE         (AFFINE),
    .JACOBIAN       (JACOBIAN),
    .FORMAT         (FORMAT),
    .N              (N),
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
    .step_reads_i    (read_begins),
    .step_last_i     (read_last),
    .step_part_i     (read_part),
    .step_source_i   (read_source),
    .step_cell_i     (read_cell),
    .weights_i       (weights[0 +: 3*4*WEIGHT_W]),
    .slopes_i        (weights[(KINDS-1)*3*4*WEIGHT_W +: 3*4*WEIGHT_W]),
    .read_o          (read_o),
    .read_last_o     (read_last_o),
    .read_source_o   (read_source_o),
    .read_cell_o     (read_cell_o),
    .read_index_o    (read_index_o),
    .read_points_i   (read_points_i),
    .result_valid_o  (result_valid_o),
    .result_sums_o   (sums)
  );

  generate
    if (JACOBIAN != 0) begin : gen_jacobian
      // Of which axis alone the derivative is wanted, from the step to its sum.
      wire [2:0] derivative = {bank[2*PLACE_W+1], bank[PLACE_W+1], bank[1]};
      wire [2:0] only;

      ffd_num_delay #(
        .WIDTH  (3),
        .LATENCY(READ_DELAY + READ_LATENCY + 3 * CONTRACT - CONVERT_LATENCY + HALVES)
      ) u_only (
        .clk(clk),
        .rst(1'b0),
        .d_i(derivative & {3{derivative != 3'b111}}),
        .q_o(only)
      );

      wire [9*SUM_W-1:0] jacobian = sums[3*SUM_W +: 9*SUM_W];
      assign result_sum_o      = only[0] ? jacobian[0*SUM_W +: 3*SUM_W] :
                                 only[1] ? jacobian[3*SUM_W +: 3*SUM_W] :
                                 only[2] ? jacobian[6*SUM_W +: 3*SUM_W] : sums[0 +: 3*SUM_W];
      assign result_jacobian_o = jacobian;
    end else begin : gen_position
      assign result_sum_o      = sums;
      assign result_jacobian_o = {9 * SUM_W {1'b0}};
    end
  endgenerate

  wire unused_ok = &{1'b0, s_vertex_changed, s_vertex_second, step_first, later};

  assign result_second_o = {3 * SUM_W {1'b0}};
endmodule

`default_nettype wire
