// ffd_org_basic: q = sum of ((B_l(s) B_m(t)) B_n(u)) P over the 64 banks, one a turn (fig. 1, 4.1)
//
// Three polynomial evaluators, the four-input vector multiplier and the vector accumulator. The
// counter runs through the banks (l, m, n) of the global index modulo 4, n fastest; the local
// blending function of a bank is (bank - cell) mod 4, so that cells which share a face add in the
// same order (docs/numerics.md section 5).
//
// Schedule:   paper: a combination starts when the one before has finished: INTERVAL is the latency
//             of the whole pipe, 6 + 3 + 1 = 10 with one-clock units, 640 clocks a vertex.
//             overlapped: a combination a clock (iterative evaluator: every 6 clocks). Where the
//             accumulator is deeper than that, CONTEXTS vertices take turns.
// Pipeline:   step | POLY_LATENCY: weights | 3 MUL_LATENCY: term | ADD_LATENCY: sum. Points are
//             asked for READ_LATENCY clocks before the multiplier needs them.
// Freezes:    never. Results leave in the order of the vertices and are not held back: who offers a
//             vertex must have room for its result.
// Parameters: those of every organization (docs/architecture.md); N is 1.
// Model:      golden/include/hwffd/model/org_basic.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_org_basic #(
  parameter FORMAT          = 18,
  parameter N               = 1,
  parameter SCHEDULE        = `FFD_SCHEDULE_OVERLAPPED,
  parameter EVALUATOR       = `FFD_EVALUATOR_PIPELINED,
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter CONVERT_LATENCY = 1,
  parameter READ_LATENCY    = 2,
  parameter SOURCE_W        = 2
) (
  input  wire                                            clk,
  input  wire                                            rst,
  input  wire                                            load_i,
  input  wire [1:0]                                      load_axis_i,
  input  wire [2:0]                                      load_address_i,
  input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,
  input  wire                                            s_vertex_valid,
  output wire                                            s_vertex_ready,
  input  wire [3*`FFD_WEIGHT_W(FORMAT)-1:0]              s_vertex_coordinates,
  input  wire [11:0]                                     s_vertex_cell,
  input  wire [SOURCE_W-1:0]                             s_vertex_source,
  input  wire                                            s_vertex_bank,
  output wire                                            read_o,
  output wire                                            read_last_o,
  output wire [SOURCE_W-1:0]                             read_source_o,
  output wire [11:0]                                     read_cell_o,
  output wire [5:0]                                      read_index_o,
  input  wire [N*3*`FFD_POINT_W(FORMAT)-1:0]             read_points_i,
  output wire                                            result_valid_o,
  output wire [3*`FFD_SUM_W(FORMAT)-1:0]                 result_sum_o
);
  localparam WEIGHT_W     = `FFD_WEIGHT_W(FORMAT);
  localparam SUM_W        = `FFD_SUM_W(FORMAT);
  localparam STEP_LATENCY = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY);
  localparam POLY_LATENCY = `FFD_POLY_LATENCY(EVALUATOR, STEP_LATENCY, CONVERT_LATENCY);
  localparam TERM_LATENCY = POLY_LATENCY + 3 * MUL_LATENCY;
  localparam INTERVAL     = SCHEDULE == `FFD_SCHEDULE_PAPER ? TERM_LATENCY + ADD_LATENCY
                                                            : `FFD_POLY_INTERVAL(EVALUATOR);
  localparam CONTEXTS     = (ADD_LATENCY + INTERVAL - 1) / INTERVAL;
  localparam READ_DELAY   = POLY_LATENCY + 2 * MUL_LATENCY - READ_LATENCY;
  localparam PAYLOAD_W    = 3 * WEIGHT_W + 12 + SOURCE_W + 1;

  generate
    if (N != 1) begin : gen_bad_n
      ERROR_ffd_org_basic_n_must_be_1 u_error ();
    end
    if (SCHEDULE < 0 || SCHEDULE > 1) begin : gen_bad_schedule
      ERROR_ffd_org_basic_schedule_must_be_0_or_1 u_error ();
    end
    if (READ_DELAY < 0) begin : gen_bad_read_latency
      ERROR_ffd_org_basic_read_latency_is_too_long u_error ();
    end
  endgenerate

  wire                  step_valid;
  wire                  step_first;
  wire                  step_last;
  wire [5:0]            step;
  wire [3*WEIGHT_W-1:0] coordinates;
  wire [11:0]           cell_index;
  wire [SOURCE_W-1:0]   source;
  wire                  bank;

  ffd_eval_sequencer #(
    .PAYLOAD_W(PAYLOAD_W),
    .STEPS    (64),
    .CONTEXTS (CONTEXTS),
    .INTERVAL (INTERVAL)
  ) u_sequencer (
    .clk           (clk),
    .rst           (rst),
    .s_vertex_valid(s_vertex_valid),
    .s_vertex_ready(s_vertex_ready),
    .s_vertex_data ({s_vertex_coordinates, s_vertex_cell, s_vertex_source, s_vertex_bank}),
    .step_valid_o  (step_valid),
    .step_first_o  (step_first),
    .step_last_o   (step_last),
    .step_o        (step),
    .payload_o     ({coordinates, cell_index, source, bank})
  );

  // The three blending functions of this step's bank, axis s first.
  wire [3*WEIGHT_W-1:0] weights;

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      wire [1:0] blending = step[4-2*a +: 2] - cell_index[4*a +: 2];
      ffd_eval_poly #(
        .FORMAT         (FORMAT),
        .EVALUATOR      (EVALUATOR),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .ADDRESS_W      (3)
      ) u_poly (
        .clk           (clk),
        .load_i        (load_i && load_axis_i == a),
        .load_address_i(load_address_i),
        .load_entry_i  (load_entry_i),
        .start_i       (step_valid),
        .coordinate_i  (coordinates[a*WEIGHT_W +: WEIGHT_W]),
        .address_i     ({bank, blending}),
        .weight_o      (weights[a*WEIGHT_W +: WEIGHT_W])
      );
    end
  endgenerate

  // The control point of this step arrives with the product of its three weights.
  wire read_valid;
  wire read_last;

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
    .WIDTH  (SOURCE_W + 18),
    .LATENCY(READ_DELAY)
  ) u_read_address (
    .clk(clk),
    .rst(rst),
    .d_i({source, cell_index, step}),
    .q_o({read_source_o, read_cell_o, read_index_o})
  );

  assign read_o      = read_valid;
  assign read_last_o = read_valid && read_last;

  wire [3*SUM_W-1:0] term;

  ffd_eval_vector_multiplier #(
    .FORMAT     (FORMAT),
    .MUL_LATENCY(MUL_LATENCY)
  ) u_multiplier (
    .clk      (clk),
    .weights_i(weights),
    .point_i  (read_points_i),
    .term_o   (term)
  );

  wire term_valid;
  wire term_first;
  wire term_last;

  ffd_num_delay #(
    .WIDTH  (3),
    .LATENCY(TERM_LATENCY),
    .RESET  (1)
  ) u_term_valid (
    .clk(clk),
    .rst(rst),
    .d_i({step_valid, step_first, step_valid && step_last}),
    .q_o({term_valid, term_first, term_last})
  );

  ffd_eval_vector_accumulator #(
    .FORMAT     (FORMAT),
    .ADD_LATENCY(ADD_LATENCY),
    .DISTANCE   (CONTEXTS * INTERVAL)
  ) u_accumulator (
    .clk    (clk),
    .rst    (rst),
    .valid_i(term_valid),
    .clear_i(term_first),
    .term_i (term),
    .sum_o  (result_sum_o)
  );

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(ADD_LATENCY),
    .RESET  (1)
  ) u_result_valid (
    .clk(clk),
    .rst(rst),
    .d_i(term_last),
    .q_o(result_valid_o)
  );
endmodule

`default_nettype wire
