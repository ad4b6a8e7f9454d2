// ffd_scatter_weights: the cumulative weights of a vertex by bank, each axis when it is expanded
//
//   C_0 = w_0    C_1 = saturate(C_0 + w_1)    C_2 = saturate(C_1 + w_2)
//
// Three evaluators take the axes in turn, s first, and two adders make sums of what they give. s is
// expanded as its weights come, t DISTANCE clocks later, u DISTANCE clocks after t: ffd_eval_travel
// brings each axis its own for three clocks, those of the components of the vertex.
//
// Formats:    coordinates, weights Q2.(W-2). Sums saturate, flagged (ffd_num_cumulate).
// Pipeline:   step | FFD_SCATTER_WEIGHTS_LATENCY: weights of s, saturated_o of the axis of that
//             step | those of t, u later. A step a clock, those of a vertex one after the other;
//             II 3, never frozen.
// Bad input:  none: steps that are no vertex's give weights that nobody wants.
// Parameters: FORMAT 12 to 18, EVALUATOR not iterative, latencies >= 1, DISTANCE >= 1.
// Model:      golden/include/hwffd/model/scatter.hpp (cumulative_of).  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_scatter.vh"

module ffd_scatter_weights #(
  parameter FORMAT      = 17,
  parameter EVALUATOR   = `FFD_EVALUATOR_PIPELINED,
  parameter MUL_LATENCY = 4,
  parameter ADD_LATENCY = 1,
  parameter DISTANCE    = 6
) (
  input  wire                                            clk,
  input  wire                                            load_i,
  input  wire [1:0]                                      load_axis_i,
  input  wire [`FFD_OWN_W(1)-1:0]                        load_address_i,
  input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,
  input  wire [1:0]                                      step_i,         // 0 s, 1 t, 2 u
  input  wire [3*`FFD_WEIGHT_W(FORMAT)-1:0]              coordinates_i,  // {u, t, s}
  input  wire [5:0]                                      residues_i,     // of the cell, modulo 4
  input  wire [3*`FFD_PLACE_W(1)-1:0]                    bank_i,
  output wire [3*3*`FFD_WEIGHT_W(FORMAT)-1:0]            weights_o,      // of each {C_2, C_1, C_0}
  output wire [2:0]                                      whole_o,        // c_3 is the part, else 0
  output wire                                            saturated_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam PLACE_W  = `FFD_PLACE_W(1);
  localparam TOTAL    = `FFD_SCATTER_WEIGHTS_LATENCY(EVALUATOR, MUL_LATENCY, ADD_LATENCY);
  `FFD_TAKES(TOTAL)

  // ---- the weights of the banks

  wire [4*WEIGHT_W-1:0] evaluated;

  ffd_eval_axis_weights #(
    .SHARED         (1),
    .AFFINE         (1),
    .FORMAT         (FORMAT),
    .EVALUATOR      (EVALUATOR),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (0),
    .CONVERT_LATENCY(`FFD_SCATTER_CONVERT_LATENCY),
    .SPANS          (1)
  ) u_axis (
    .clk           (clk),
    .load_i        (load_i),
    .load_axis_i   (load_axis_i),
    .load_address_i(load_address_i),
    .load_entry_i  (load_entry_i),
    .start_i       (1'b1),
    .axis_i        (step_i),
    .coordinate_i  (step_i == 2'd0 ? coordinates_i[0*WEIGHT_W +: WEIGHT_W] :
                    step_i == 2'd1 ? coordinates_i[1*WEIGHT_W +: WEIGHT_W] :
                                     coordinates_i[2*WEIGHT_W +: WEIGHT_W]),
    .residue_i     (step_i == 2'd0 ? residues_i[1:0] :
                    step_i == 2'd1 ? residues_i[3:2] : residues_i[5:4]),
    .bank_i        (step_i == 2'd0 ? bank_i[0*PLACE_W +: PLACE_W] :
                    step_i == 2'd1 ? bank_i[1*PLACE_W +: PLACE_W] :
                                     bank_i[2*PLACE_W +: PLACE_W]),
    .weights_o     (evaluated)
  );

  // ---- their sums: that of banks 0 and 1, then of all three

  wire [WEIGHT_W-1:0] c_0;
  wire [WEIGHT_W-1:0] c_1;
  wire [WEIGHT_W-1:0] c_2;
  wire                whole;

  ffd_scatter_cumulative #(
    .FORMAT     (FORMAT),
    .ADD_LATENCY(ADD_LATENCY)
  ) u_cumulative (
    .clk      (clk),
    .weights_i(evaluated),
    .sums_o   ({c_2, c_1, c_0}),
    .whole_o  (whole)
  );

  // Whose flag is that of all three.
  assign saturated_o = c_2[WEIGHT_W-1];

  // ---- each axis when it is expanded

  wire [3*(1+3*WEIGHT_W)-1:0] travelled;
  ffd_eval_travel #(
    .WIDTH   (1 + 3 * WEIGHT_W),
    .LATENCY (TOTAL),
    .DISTANCE(DISTANCE)
  ) u_travel (
    .clk      (clk),
    .step_i   (step_i),
    .weights_i({whole, c_2, c_1, c_0}),
    .weights_o(travelled)
  );
  assign {whole_o[2], weights_o[6*WEIGHT_W +: 3*WEIGHT_W],
          whole_o[1], weights_o[3*WEIGHT_W +: 3*WEIGHT_W],
          whole_o[0], weights_o[0*WEIGHT_W +: 3*WEIGHT_W]} = travelled;
endmodule

`default_nettype wire
