// ffd_eval_bank_weights: the 12 weights of a vertex by bank, each axis when it is contracted
//
// u is contracted first, t DISTANCE clocks later, s DISTANCE clocks after t, and each axis has its
// weights then (ffd_eval_axis_weights): a rotation of weights, so that no point is ever moved.
//
// FOLD 1, 2:  12 evaluators; t and s are evaluated that much later.
// FOLD 3 on:  4 evaluators; the first three steps of a vertex evaluate u, t, s, whose weights
//             travel beside the contraction (ffd_eval_travel). step_i is 3 in other steps.
//
// Pipeline:   step 0 | FFD_CHOICE_LATENCY | FFD_POLY_LATENCY: weights of u, for FOLD clocks;
//             those of t and s later. A step a clock, those of a vertex one after the other; never
//             frozen.
// Parameters: FOLD 1, 2, 3, 4 or 6; AFFINE 0, or 1 in fixed point; DISTANCE >= 1; the
//             others as in every organization.
// Model:      golden/include/hwffd/model/organization.hpp (weights_of).  Test: tests/evaluator.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_bank_weights #(
  parameter FOLD            = 1,
  parameter AFFINE          = 0,
  parameter FORMAT          = 18,
  parameter EVALUATOR       = `FFD_EVALUATOR_PIPELINED,
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 1,
  parameter DISTANCE        = 5,
  parameter SPANS           = 1
) (
  input  wire                                            clk,
  input  wire                                            load_i,
  input  wire [1:0]                                      load_axis_i,
  input  wire [`FFD_OWN_W(SPANS)-1:0]                    load_address_i,
  input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,
  input  wire                                            step_valid_i,
  input  wire [1:0]                                      step_i,
  input  wire [3*`FFD_WEIGHT_W(FORMAT)-1:0]              coordinates_i,
  input  wire [11:0]                                     cell_i,
  input  wire [3*`FFD_PLACE_W(SPANS)-1:0]                bank_i,
  output wire [3*4*`FFD_WEIGHT_W(FORMAT)-1:0]            weights_o
);
  localparam WEIGHT_W     = `FFD_WEIGHT_W(FORMAT);
  localparam STEP_LATENCY = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);
  localparam FILE_LATENCY = `FFD_FILE_LATENCY(`FFD_SCHEDULE_OVERLAPPED, EVALUATOR);
  localparam CHOICE       = `FFD_CHOICE_LATENCY(FOLD);
  localparam POLY_LATENCY = `FFD_POLY_LATENCY(EVALUATOR, FILE_LATENCY, STEP_LATENCY,
                                              CONVERT_LATENCY);
  // Sets of four evaluators: one an axis, or one for all of them, which then has three files.
  localparam SETS         = `FFD_FOLD_SETS(FOLD);
  localparam PLACE_W      = `FFD_PLACE_W(SPANS);

  generate
    if (`FFD_FOLD_BAD(FOLD)) begin : gen_bad_fold
      ERROR_ffd_eval_bank_weights_fold_must_be_1_2_3_4_or_6 u_error ();
    end
  endgenerate

  wire [SETS*4*WEIGHT_W-1:0] evaluated;

  genvar set;
  generate
    for (set = 0; set < SETS; set = set + 1) begin : gen_set
      wire [WEIGHT_W-1:0] coordinate;
      wire [1:0]          residue;  // of the cell, modulo 4
      wire [PLACE_W-1:0]  bank;
      wire [1:0]          axis;
      wire                load;

      if (SETS == 3) begin : gen_own_axis
        ffd_num_delay #(
          .WIDTH  (WEIGHT_W + 2 + PLACE_W),
          .LATENCY((2 - set) * DISTANCE)
        ) u_later (
          .clk(clk),
          .rst(1'b0),
          .d_i({coordinates_i[set*WEIGHT_W +: WEIGHT_W], cell_i[4*set +: 2],
                 bank_i[PLACE_W*set +: PLACE_W]}),
          .q_o({coordinate, residue, bank})
        );
        assign axis = set;
        assign load = load_i && load_axis_i == set;
      end else begin : gen_all_axes
        assign coordinate = step_i == 2'd0 ? coordinates_i[2*WEIGHT_W +: WEIGHT_W] :
                            step_i == 2'd1 ? coordinates_i[1*WEIGHT_W +: WEIGHT_W] :
                                             coordinates_i[0*WEIGHT_W +: WEIGHT_W];
        assign residue    = step_i == 2'd0 ? cell_i[9:8] : step_i == 2'd1 ? cell_i[5:4] :
                                             cell_i[1:0];
        assign bank       = step_i == 2'd0 ? bank_i[2*PLACE_W +: PLACE_W] :
                            step_i == 2'd1 ? bank_i[1*PLACE_W +: PLACE_W] :
                                             bank_i[0*PLACE_W +: PLACE_W];
        assign axis = 2'd2 - step_i;
        assign load = load_i;
      end

      ffd_eval_axis_weights #(
        .SHARED         (SETS == 1 ? 1 : 0),
        .AFFINE         (AFFINE),
        .FORMAT         (FORMAT),
        .EVALUATOR      (EVALUATOR),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .SPANS          (SPANS)
      ) u_axis (
        .clk           (clk),
        .load_i        (load),
        .load_axis_i   (load_axis_i),
        .load_address_i(load_address_i),
        .load_entry_i  (load_entry_i),
        .start_i       (step_valid_i),
        .axis_i        (axis),
        .coordinate_i  (coordinate),
        .residue_i     (residue),
        .bank_i        (bank),
        .weights_o     (evaluated[4*set*WEIGHT_W +: 4*WEIGHT_W])
      );
    end
  endgenerate

  generate
    if (SETS == 3) begin : gen_ready
      assign weights_o = evaluated;
      wire unused_ok = &{1'b0, step_i, cell_i};
    end else begin : gen_travel
      wire [4*WEIGHT_W-1:0] of_s;
      wire [4*WEIGHT_W-1:0] of_t;
      wire [4*WEIGHT_W-1:0] of_u;
      ffd_eval_travel #(
        .WIDTH   (4 * WEIGHT_W),
        .LATENCY (CHOICE + POLY_LATENCY),
        .DISTANCE(DISTANCE)
      ) u_travel (
        .clk      (clk),
        .step_i   (step_i),
        .weights_i(evaluated),
        .weights_o({of_s, of_t, of_u})
      );
      assign weights_o = {of_u, of_t, of_s};
      wire unused_ok = &{1'b0, cell_i};
    end
  endgenerate
endmodule

`default_nettype wire
