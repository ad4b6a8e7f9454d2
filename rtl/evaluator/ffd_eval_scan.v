// ffd_eval_scan: `affine` folded by four, a vertex a clock while only s changes
//
// Vertices that follow each other with the same t, u, cell and source are a run, such as those of a
// line of a regular grid. Along u and t they share everything: a run reads its 64 points once, 16 a
// clock, and leaves four points, which stay here; each vertex contracts these along s. A vertex
// that begins a run waits until the one before is four clocks old, and needs not wait for its end:
// what runs share is made for the next while the vertices of the present one pass. So a vertex a
// clock in runs of four and more, and from random cells in four clocks.
//
// Formats, rounding: those of ffd_eval_contraction; docs/numerics.md section 4. The bits are those
//             of every other folding.
// Schedule:   a vertex every clock, a run every four.
// Pipeline:   vertex | its run's steps: FFD_CHOICE_LATENCY, FFD_POLY_LATENCY: weights of u, points
//             | ffd_eval_contraction of two axes | narrowed, the four of the run | ffd_eval_affine.
// Freezes:    never. Results leave in the order of the vertices and are not held back.
// Parameters: those of ffd_org_affine, which checks them; N 16. EVALUATOR not iterative.
// Model:      golden/include/hwffd/model/org_affine.hpp.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_scan #(
  parameter FORMAT          = 17,
  parameter N               = 16,
  parameter PORTS           = 1,
  `include "ffd_org_parameters.vh"
) (
  `include "ffd_org_ports.vh"
);
  localparam FOLD         = 4;
  localparam STEP_LATENCY = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);
  localparam FILE_LATENCY = `FFD_FILE_LATENCY(SCHEDULE, EVALUATOR);
  localparam POLY_LATENCY = `FFD_POLY_LATENCY(EVALUATOR, FILE_LATENCY, STEP_LATENCY,
                                              CONVERT_LATENCY);
  localparam CONTRACT     = `FFD_CONTRACT_LATENCY(1, MUL_LATENCY, ADD_LATENCY, FMA_LATENCY,
                                                  CONVERT_LATENCY);
  localparam READ_DELAY   = `FFD_CHOICE_LATENCY(FOLD) + POLY_LATENCY - READ_LATENCY - ADD_LATENCY;
  // Clocks from a step to its point of s, and from the last of four on until all are held.
  localparam POINT_DELAY  = READ_DELAY + READ_LATENCY + 2 * CONTRACT;
  // Clocks from a vertex that goes to its points: five steps behind it a run's are held.
  localparam HELD_DELAY   = 5 + POINT_DELAY;
  localparam WEIGHT_W     = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W      = `FFD_POINT_W(FORMAT);
  localparam SUM_W        = `FFD_SUM_W(FORMAT);
  localparam PLACE_W      = `FFD_PLACE_W(SPANS);
  localparam SHARED_W     = 2 * WEIGHT_W + 12 + SOURCE_W + 2 * PLACE_W;
  localparam OWN_W        = WEIGHT_W + PLACE_W;

  generate
    if (READ_DELAY < 0) begin : gen_bad_read_latency
      ERROR_ffd_eval_scan_read_latency_is_too_long u_error ();
    end
  endgenerate

  // ---- the next vertex waits in a register, where it is known whether it begins a run

  wire [SHARED_W-1:0] offered = {s_vertex_coordinates[WEIGHT_W +: 2*WEIGHT_W], s_vertex_cell,
                                 s_vertex_source, s_vertex_bank[PLACE_W +: 2*PLACE_W]};
  reg                 held_q;
  reg                 begins_q;
  reg                 known_q;  // the vertex before, in what is shared
  reg  [SHARED_W-1:0] shared_q;
  reg  [OWN_W-1:0]    own_q;
  wire                may_begin;
  wire                go = held_q && (!begins_q || may_begin);

  assign s_vertex_ready = !held_q || go;

  always @(posedge clk) begin
    if (rst) begin
      held_q  <= 1'b0;
      known_q <= 1'b0;
    end else if (s_vertex_ready) begin
      held_q <= s_vertex_valid;
      if (s_vertex_valid) known_q <= 1'b1;
    end
  end
  always @(posedge clk) begin
    if (s_vertex_ready && s_vertex_valid) begin
      begins_q <= !known_q || s_vertex_changed || offered != shared_q;
      shared_q <= offered;
      own_q    <= {s_vertex_coordinates[0 +: WEIGHT_W], s_vertex_bank[0 +: PLACE_W]};
    end
  end

  // ---- four steps of a run: u, t, and the banks of s from the last to the first

  wire                  step_valid;
  wire                  step_first;
  wire                  step_last;
  wire [1:0]            step;
  wire [2*WEIGHT_W-1:0] coordinates;
  wire [11:0]           cell_index;
  wire [SOURCE_W-1:0]   source;
  wire [2*PLACE_W-1:0]  bank;

  ffd_eval_sequencer #(
    .PAYLOAD_W(SHARED_W),
    .STEPS    (FOLD),
    .CONTEXTS (1),
    .INTERVAL (1)
  ) u_sequencer (
    .clk           (clk),
    .rst           (rst),
    .s_vertex_valid(held_q && begins_q),
    .s_vertex_ready(may_begin),
    .s_vertex_data (shared_q),
    .step_valid_o  (step_valid),
    .step_first_o  (step_first),
    .step_last_o   (step_last),
    .step_o        (step),
    .payload_o     ({coordinates, cell_index, source, bank})
  );

  wire [3*4*WEIGHT_W-1:0] weights;

  ffd_eval_bank_weights #(
    .FOLD           (FOLD),
    .AFFINE         (1),
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
    .coordinates_i ({coordinates, {WEIGHT_W{1'b0}}}),
    .cell_i        (cell_index),
    .bank_i        ({bank, {PLACE_W{1'b0}}}),
    .weights_o     (weights)
  );

  wire                read_valid;
  wire                read_last;
  wire [1:0]          read_part;
  wire [SOURCE_W-1:0] read_source;
  wire [11:0]         read_cell;

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(READ_DELAY),
    .RESET  (1)
  ) u_read_valid (
    .clk(clk),
    .rst(rst),
    .d_i({step_valid, step_valid && step_last}),
    .q_o({read_valid, read_last})
  );

  ffd_num_delay #(
    .WIDTH  (2 + SOURCE_W + 12),
    .LATENCY(READ_DELAY)
  ) u_read (
    .clk(clk),
    .rst(rst),
    .d_i({~step, source, cell_index}),
    .q_o({read_part, read_source, read_cell})
  );

  wire               sum_valid;
  wire [3*SUM_W-1:0] sum;

  ffd_eval_contraction #(
    .FOLD           (FOLD),
    .AXES           (2),
    .AFFINE         (1),
    .FORMAT         (FORMAT),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (FMA_LATENCY),
    .CONVERT_LATENCY(CONVERT_LATENCY),
    .READ_LATENCY   (READ_LATENCY),
    .SOURCE_W       (SOURCE_W)
  ) u_contraction (
    .clk           (clk),
    .rst           (rst),
    .step_valid_i  (read_valid),
    .step_reads_i  (read_valid),
    .step_last_i   (read_last),
    .step_part_i   (read_part),
    .step_source_i (read_source),
    .step_cell_i   (read_cell),
    .weights_i     (weights),
    .slopes_i      (weights),
    .read_o        (read_o),
    .read_last_o   (read_last_o),
    .read_source_o (read_source_o),
    .read_cell_o   (read_cell_o),
    .read_index_o  (read_index_o),
    .read_points_i (read_points_i),
    .result_valid_o(sum_valid),
    .result_sums_o (sum)
  );

  // ---- the vertices of a run, along s

  wire held_new;  // the last of four points is here

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(POINT_DELAY)
  ) u_held_new (
    .clk(clk),
    .rst(1'b0),
    .d_i(step_last),
    .q_o(held_new)
  );

  wire [1:0]            own_residue = shared_q[2*PLACE_W+SOURCE_W +: 2];  // of the cell
  wire [OWN_W-1:0]      own;
  wire [1:0]            residue;
  wire [4*WEIGHT_W-1:0] own_weights;

  ffd_num_delay #(
    .WIDTH  (OWN_W + 2),
    .LATENCY(HELD_DELAY + ADD_LATENCY - POLY_LATENCY)
  ) u_own (
    .clk(clk),
    .rst(1'b0),
    .d_i({own_q, own_residue}),
    .q_o({own, residue})
  );

  ffd_eval_axis_weights #(
    .AFFINE         (1),
    .FORMAT         (FORMAT),
    .EVALUATOR      (EVALUATOR),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (FMA_LATENCY),
    .CONVERT_LATENCY(CONVERT_LATENCY),
    .SPANS          (SPANS)
  ) u_own_weights (
    .clk           (clk),
    .load_i        (load_i && load_axis_i == 2'd0),
    .load_axis_i   (load_axis_i),
    .load_address_i(load_address_i),
    .load_entry_i  (load_entry_i),
    .start_i       (1'b1),
    .axis_i        (2'd0),
    .coordinate_i  (own[PLACE_W +: WEIGHT_W]),
    .residue_i     (residue),
    .bank_i        (own[0 +: PLACE_W]),
    .weights_o     (own_weights)
  );

  genvar c;
  generate
    for (c = 0; c < 3; c = c + 1) begin : gen_component
      wire [POINT_W-1:0]   point;
      reg  [3*POINT_W-1:0] before_q;  // banks 1, 2, 3
      reg  [4*POINT_W-1:0] points_q;

      ffd_num_narrow #(
        .FORMAT (FORMAT),
        .LATENCY(CONVERT_LATENCY)
      ) u_narrow (
        .clk    (clk),
        .sum_i  (sum[c*SUM_W +: SUM_W]),
        .point_o(point)
      );

      always @(posedge clk) begin
        before_q <= {before_q[0 +: 2*POINT_W], point};
        if (held_new) points_q <= {before_q, point};
      end

      ffd_eval_affine #(
        .FORMAT     (FORMAT),
        .MUL_LATENCY(MUL_LATENCY),
        .ADD_LATENCY(ADD_LATENCY)
      ) u_affine (
        .clk      (clk),
        .weights_i(own_weights),
        .points_i (points_q),
        .sums_o   (result_sum_o[c*SUM_W +: SUM_W])
      );
    end
  endgenerate

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(HELD_DELAY + CONTRACT - CONVERT_LATENCY),
    .RESET  (1)
  ) u_valid (
    .clk(clk),
    .rst(rst),
    .d_i(go),
    .q_o(result_valid_o)
  );

  assign result_jacobian_o = {9 * SUM_W {1'b0}};
  assign forming_o         = 1'b0;
  wire unused_ok = &{1'b0, sum_valid, step_first};
endmodule

`default_nettype wire
