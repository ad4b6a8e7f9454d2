// ffd_eval_bank_weights: the 12 weights of a vertex by bank, each axis when it is contracted
//
// Bank b of an axis has the weight of the local function (b - cell) mod 4: a rotation of four
// weights, made where the evaluators are addressed, so that no point is ever moved. u is contracted
// first, t DISTANCE clocks later, s DISTANCE clocks after t, and each axis has its weights then.
//
// FOLD 1, 2:  12 evaluators; t and s are evaluated that much later.
// FOLD 3 on:  4 evaluators; the first three steps of a vertex evaluate u, t, s. The four weights
//             travel on beside the contraction, and each axis holds its own for the steps of the
//             vertex. step_i is 3 in other steps.
//
// AFFINE 1:   bank 3 has no evaluator. Its weight is what the others leave, and in its place stands
//             what they leave it of: 1, of a derivative 0.
//
// Pipeline:   step 0 | FFD_CHOICE_LATENCY | FFD_POLY_LATENCY: weights of u, for FOLD clocks;
//             those of t and s later. A step a clock, those of a vertex one after the other; never
//             frozen.
// Parameters: FOLD 1, 2, 3, 4 or 6; AFFINE 0, or 1 in fixed point; EVALUATOR not iterative; DISTANCE
//             >= 1; the others as in every organization.
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
  localparam EVALUATED    = AFFINE == 0 ? 4 : 3;  // of the banks
  localparam PLACE_W      = `FFD_PLACE_W(SPANS);
  localparam ADDRESS_W    = SETS == 3 ? `FFD_OWN_W(SPANS) : `FFD_SHARED_W(SPANS);

  generate
    if (`FFD_FOLD_BAD(FOLD)) begin : gen_bad_fold
      ERROR_ffd_eval_bank_weights_fold_must_be_1_2_3_4_or_6 u_error ();
    end
    if (EVALUATOR == `FFD_EVALUATOR_ITERATIVE) begin : gen_bad_evaluator
      ERROR_ffd_eval_bank_weights_evaluator_must_not_be_iterative u_error ();
    end
  endgenerate

  wire [SETS*4*WEIGHT_W-1:0] evaluated;

  genvar set;
  genvar b;
  generate
    for (set = 0; set < SETS; set = set + 1) begin : gen_set
      wire [WEIGHT_W-1:0]  coordinate;
      wire [WEIGHT_W-1:0]  chosen_coordinate;
      wire [1:0]           residue;  // of the cell, modulo 4
      wire [PLACE_W-1:0]   bank;
      wire                 load;
      wire [ADDRESS_W-1:0] load_address;

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
        assign load         = load_i && load_axis_i == set;
        assign load_address = load_address_i;
      end else begin : gen_all_axes
        assign coordinate   = step_i == 2'd0 ? coordinates_i[2*WEIGHT_W +: WEIGHT_W] :
                              step_i == 2'd1 ? coordinates_i[1*WEIGHT_W +: WEIGHT_W] :
                                               coordinates_i[0*WEIGHT_W +: WEIGHT_W];
        assign residue      = step_i == 2'd0 ? cell_i[9:8] : step_i == 2'd1 ? cell_i[5:4] :
                                               cell_i[1:0];
        assign bank         = step_i == 2'd0 ? bank_i[2*PLACE_W +: PLACE_W] :
                              step_i == 2'd1 ? bank_i[1*PLACE_W +: PLACE_W] :
                                               bank_i[0*PLACE_W +: PLACE_W];
        assign load         = load_i;
        ffd_eval_address #(
          .SPANS(SPANS)
        ) u_load_address (
          .axis_i   (load_axis_i),
          .place_i  (load_address_i),
          .address_o(load_address)
        );
      end

      ffd_num_delay #(
        .WIDTH  (WEIGHT_W),
        .LATENCY(CHOICE)
      ) u_coordinate (
        .clk(clk),
        .rst(1'b0),
        .d_i(coordinate),
        .q_o(chosen_coordinate)
      );

      if (EVALUATOR == `FFD_EVALUATOR_POWERS) begin : gen_powers
        wire [2:0]            chosen;
        wire [4*WEIGHT_W-1:0] of_bank;

        ffd_num_delay #(
          .WIDTH  (3),
          .LATENCY(CHOICE)
        ) u_chosen (
          .clk(clk),
          .rst(1'b0),
          .d_i({bank[1], residue}),
          .q_o(chosen)
        );

        ffd_eval_powers #(
          .FORMAT         (FORMAT),
          .MUL_LATENCY    (MUL_LATENCY),
          .ADD_LATENCY    (ADD_LATENCY),
          .CONVERT_LATENCY(CONVERT_LATENCY)
        ) u_powers (
          .clk         (clk),
          .coordinate_i(chosen_coordinate),
          .residue_i   (chosen[1:0]),
          .derivative_i(chosen[2]),
          .weights_o   (of_bank)
        );

        assign evaluated[4*set*WEIGHT_W +: EVALUATED*WEIGHT_W] = of_bank[EVALUATED*WEIGHT_W-1:0];
        wire unused_ok = &{1'b0, of_bank, bank, step_valid_i, load, load_address, load_entry_i};
      end

      for (b = 0; b < (EVALUATOR == `FFD_EVALUATOR_POWERS ? 0 : EVALUATED); b = b + 1)
      begin : gen_bank
        localparam [1:0] BANK = b;
        wire [1:0]           blending = BANK - residue;
        wire [ADDRESS_W-1:0] address;
        wire                 start;
        wire [ADDRESS_W-1:0] chosen_address;

        if (SETS == 3) begin : gen_own_file
          assign address = {bank, blending};
        end else begin : gen_three_files
          ffd_eval_address #(
            .SPANS(SPANS)
          ) u_file_address (
            .axis_i   (2'd2 - step_i),
            .place_i  ({bank, blending}),
            .address_o(address)
          );
        end

        ffd_num_delay #(
          .WIDTH  (1 + ADDRESS_W),
          .LATENCY(CHOICE)
        ) u_address (
          .clk(clk),
          .rst(1'b0),
          .d_i({step_valid_i, address}),
          .q_o({start, chosen_address})
        );

        ffd_eval_poly #(
          .FORMAT         (FORMAT),
          .EVALUATOR      (EVALUATOR),
          .FILE_LATENCY   (FILE_LATENCY),
          .MUL_LATENCY    (MUL_LATENCY),
          .ADD_LATENCY    (ADD_LATENCY),
          .FMA_LATENCY    (FMA_LATENCY),
          .CONVERT_LATENCY(CONVERT_LATENCY),
          .ADDRESS_W      (ADDRESS_W)
        ) u_poly (
          .clk           (clk),
          .load_i        (load),
          .load_address_i(load_address),
          .load_entry_i  (load_entry_i),
          .start_i       (start),
          .coordinate_i  (chosen_coordinate),
          .address_i     (chosen_address),
          .weight_o      (evaluated[(4*set+b)*WEIGHT_W +: WEIGHT_W])
        );
      end

      if (AFFINE != 0) begin : gen_rest
        // binom(0, 0) is 1 and binom(0, 1) is 0.
        wire derivative;
        ffd_num_delay #(
          .WIDTH  (1),
          .LATENCY(CHOICE + POLY_LATENCY)
        ) u_derivative (
          .clk(clk),
          .rst(1'b0),
          .d_i(bank[1]),
          .q_o(derivative)
        );
        ffd_num_binomial #(
          .FORMAT(FORMAT),
          .POWER (0)
        ) u_rest (
          .power_i ({1'b0, derivative}),
          .weight_o(evaluated[(4*set+3)*WEIGHT_W +: WEIGHT_W])
        );
      end
    end
  endgenerate

  // Folded, the weights of an axis come a clock after those of the axis before and are wanted
  // DISTANCE clocks after them.
  genvar stage;
  generate
    if (SETS == 3) begin : gen_ready
      assign weights_o = evaluated;
      wire unused_ok = &{1'b0, step_i, cell_i};
    end else begin : gen_travel
      for (stage = 0; stage < 3; stage = stage + 1) begin : gen_stage
        localparam [1:0] OWN_STEP = stage;
        wire [1:0]            step;
        wire [4*WEIGHT_W-1:0] weights;
        wire                  own = step == OWN_STEP;
        reg  [4*WEIGHT_W-1:0] held_q;

        if (stage == 0) begin : gen_first
          assign weights = evaluated;
          ffd_num_delay #(
            .WIDTH  (2),
            .LATENCY(CHOICE + POLY_LATENCY)
          ) u_step (
            .clk(clk),
            .rst(1'b0),
            .d_i(step_i),
            .q_o(step)
          );
        end else begin : gen_next
          ffd_num_delay #(
            .WIDTH  (2 + 4 * WEIGHT_W),
            .LATENCY(DISTANCE - 1)
          ) u_weights (
            .clk(clk),
            .rst(1'b0),
            .d_i({gen_stage[stage-1].step, gen_stage[stage-1].weights}),
            .q_o({step, weights})
          );
        end

        always @(posedge clk) begin
          if (own) held_q <= weights;
        end
        assign weights_o[4*(2-stage)*WEIGHT_W +: 4*WEIGHT_W] = own ? weights : held_q;
      end
      wire unused_ok = &{1'b0, cell_i};
    end
  endgenerate
endmodule

`default_nettype wire
