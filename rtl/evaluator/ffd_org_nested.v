// ffd_org_nested: q as a polynomial about the cell's centre, nested (beyond the paper)
//
// 63 multiply-adds a component, a vertex a clock within a cell; folded by three, a component a
// clock on a third of the units. The 64 coefficient vectors of a cell are formed here, from its
// control points and the coefficients, when its first vertex comes: one of another cell, source or
// bank than the vertex before, or with s_vertex_changed. It waits for them at the port; those
// before it go on. Seams are not watertight (docs/numerics.md section 5).
//
// Schedule:   overlapped only, FOLD clocks between vertices of a cell, 210 + 4 (READ_LATENCY +
//             FFD_CONTRACT_LATENCY) from one cell to the next; the paper has no such organization.
// Pipeline:   vertex | step | ffd_eval_trivariate.
// Freezes:    never. Results leave in the order of the vertices and are not held back: who offers a
//             vertex must have room for its result.
// Overwriting: the coefficients of a cell have been read before those of the next are written: that
//             begins 3 phases after the last vertex, and a guard keeps the pipeline shorter.
// Parameters: those of every organization (docs/architecture.md); N is 4, SCHEDULE overlapped,
//             EVALUATOR pipelined, though there are no polynomial evaluators; FOLD 1 or 3, with the
//             same bits.
// Model:      golden/include/hwffd/model/org_nested.hpp.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_org_nested #(
  parameter FOLD            = 1,
  parameter FORMAT          = 18,
  parameter N               = 4,
  parameter PORTS           = 1,
  `include "ffd_org_parameters.vh"
) (
  `include "ffd_org_ports.vh"
);
  localparam WEIGHT_W     = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W      = `FFD_POINT_W(FORMAT);
  localparam PLACES_W     = 3 * `FFD_PLACE_W(SPANS);
  localparam KEY_W        = 12 + SOURCE_W + PLACES_W;
  localparam STEP_W       = FOLD > 1 ? $clog2(FOLD) : 1;
  localparam STEP_LATENCY = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);
  // Clocks from a vertex's entry to its last use of a coefficient, and to the first overwritten.
  localparam LAST_USE     = FOLD + ADD_LATENCY + 9 * STEP_LATENCY;
  localparam FORMED       = 16 + 2 * 64;

  generate
    if (FOLD != 1 && FOLD != 3) begin : gen_bad_fold
      ERROR_ffd_org_nested_fold_must_be_1_or_3 u_error ();
    end
    if (N != 4) begin : gen_bad_n
      ERROR_ffd_org_nested_n_must_be_4 u_error ();
    end
    if (SCHEDULE != `FFD_SCHEDULE_OVERLAPPED) begin : gen_bad_schedule
      ERROR_ffd_org_nested_schedule_must_be_overlapped u_error ();
    end
    if (EVALUATOR != `FFD_EVALUATOR_PIPELINED) begin : gen_bad_evaluator
      ERROR_ffd_org_nested_evaluator_must_be_pipelined u_error ();
    end
    if (POINT_W != WEIGHT_W) begin : gen_bad_format
      ERROR_ffd_org_nested_points_and_weights_must_be_equally_wide u_error ();
    end
    if (LAST_USE > FORMED) begin : gen_bad_latency
      ERROR_ffd_org_nested_latencies_are_too_long u_error ();
    end
  endgenerate

  // ---- whose coefficients there are

  reg              formed_q;   // those of key_q, unless they have changed
  reg              fresh_q;    // of the vertex that waits, which has not yet entered
  reg              forming_q;
  reg  [KEY_W-1:0] key_q;
  wire [KEY_W-1:0] key   = {s_vertex_cell, s_vertex_source, s_vertex_bank};
  wire             fits  = fresh_q || (formed_q && !s_vertex_changed && key == key_q);
  wire             start = s_vertex_valid && !fits && !forming_q;
  wire             enter = s_vertex_valid && s_vertex_ready;
  wire             turn;
  wire             done;

  assign s_vertex_ready = turn && fits;
  assign forming_o      = forming_q;

  always @(posedge clk) begin
    if (rst || start) formed_q <= 1'b0;
    else if (done) formed_q <= 1'b1;
  end
  always @(posedge clk) begin
    if (rst || enter) fresh_q <= 1'b0;
    else if (done) fresh_q <= 1'b1;
  end
  always @(posedge clk) begin
    if (rst || done) forming_q <= 1'b0;
    else if (start) forming_q <= 1'b1;
  end
  always @(posedge clk) begin
    if (start) key_q <= key;
  end

  wire [11:0]         formed_cell;
  wire [SOURCE_W-1:0] formed_source;
  wire [PLACES_W-1:0] formed_bank;
  assign {formed_cell, formed_source, formed_bank} = key_q;

  // ---- forming

  wire                 write;
  wire [5:0]           write_index;
  wire [3*POINT_W-1:0] write_vector;
  wire [1:0]           write_halvings;

  ffd_eval_former #(
    .FORMAT         (FORMAT),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (FMA_LATENCY),
    .CONVERT_LATENCY(CONVERT_LATENCY),
    .READ_LATENCY   (READ_LATENCY),
    .SOURCE_W       (SOURCE_W),
    .SPANS          (SPANS)
  ) u_former (
    .clk             (clk),
    .rst             (rst),
    .load_i          (load_i),
    .load_axis_i     (load_axis_i),
    .load_address_i  (load_address_i),
    .load_entry_i    (load_entry_i),
    .start_i         (start),
    .cell_i          (formed_cell),
    .source_i        (formed_source),
    .bank_i          (formed_bank),
    .done_o          (done),
    .read_o          (read_o),
    .read_last_o     (read_last_o),
    .read_source_o   (read_source_o),
    .read_cell_o     (read_cell_o),
    .read_index_o    (read_index_o),
    .read_points_i   (read_points_i),
    .write_o         (write),
    .write_index_o   (write_index),
    .write_vector_o  (write_vector),
    .write_halvings_o(write_halvings)
  );

  // ---- vertices

  wire                  step_valid;
  wire                  step_first;
  wire                  step_last;
  wire [STEP_W-1:0]     step_count;
  wire [3*WEIGHT_W-1:0] coordinates;

  ffd_eval_sequencer #(
    .PAYLOAD_W(3 * WEIGHT_W),
    .STEPS    (FOLD),
    .CONTEXTS (1),
    .INTERVAL (1)
  ) u_sequencer (
    .clk           (clk),
    .rst           (rst),
    .s_vertex_valid(s_vertex_valid && fits),
    .s_vertex_ready(turn),
    .s_vertex_data (s_vertex_coordinates),
    .step_valid_o  (step_valid),
    .step_first_o  (step_first),
    .step_last_o   (step_last),
    .step_o        (step_count),
    .payload_o     (coordinates)
  );

  ffd_eval_trivariate #(
    .FOLD       (FOLD),
    .FORMAT     (FORMAT),
    .MUL_LATENCY(MUL_LATENCY),
    .ADD_LATENCY(ADD_LATENCY),
    .FMA_LATENCY(FMA_LATENCY)
  ) u_trivariate (
    .clk               (clk),
    .rst               (rst),
    .write_i           (write),
    .write_index_i     (write_index),
    .write_vector_i    (write_vector),
    .write_halvings_i  (write_halvings),
    .step_valid_i      (step_valid),
    .step_last_i       (step_last),
    .step_component_i  ({{(2 - STEP_W) {1'b0}}, step_count}),
    .step_coordinates_i(coordinates),
    .result_valid_o    (result_valid_o),
    .result_sum_o      (result_sum_o)
  );

  assign result_jacobian_o = {9 * `FFD_SUM_W(FORMAT) {1'b0}};
  assign result_second_o   = {3 * `FFD_SUM_W(FORMAT) {1'b0}};
  wire unused_ok = &{1'b0, s_vertex_second, step_first};
endmodule

`default_nettype wire
