// ffd_org_tree: q = sum of ((B_l(s) B_m(t)) B_n(u)) P over the 64 banks, N a step (fig. 1, fig. 5)
//
// One module for three organizations of the paper: N units and a tree accumulator (4.3), `parallel`
// with 64 units (4.2), and `basic` with one unit (4.1). Units of a step share the polynomial
// evaluators of equal blending functions: 3, 4, 6, 7, 9, 10, 12 for N = 1 to 64, where the paper
// draws three for each unit.
//
// The counter runs through the banks (l, m, n) of the global index modulo 4, n fastest; the local
// blending function of a bank is (bank - cell) mod 4, so that cells which share a face add in the
// same order (docs/numerics.md section 5).
//
// Schedule:   paper: a step starts when the one before has finished its polynomials, products and
//             tree; the accumulation is hidden under the next step, or with SERIAL (`basic`)
//             waited for. With one-clock units (9 + log2 N) * 64/N clocks a vertex, `basic` 640.
//             overlapped: a step a clock (iterative evaluator: every 3 clocks). Where the
//             accumulator is deeper than that, CONTEXTS vertices take turns.
// Pipeline:   step | FFD_POLY_LATENCY: weights | ffd_eval_summation.
// Freezes:    never. Results leave in the order of the vertices and are not held back: who offers a
//             vertex must have room for its result.
// Parameters: those of every organization (docs/architecture.md); N a power of two, 1 to 64;
//             SERIAL 0 or 1.
// Model:      golden/include/hwffd/model/org_tree.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_org_tree #(
  parameter SERIAL          = 0,
  parameter FORMAT          = 18,
  parameter N               = 8,
  parameter PORTS           = 1,
  `include "ffd_org_parameters.vh"
) (
  `include "ffd_org_ports.vh"
);
  localparam WEIGHT_W     = `FFD_WEIGHT_W(FORMAT);
  localparam UNITS_S      = `FFD_UNITS_S(N);
  localparam UNITS_T      = `FFD_UNITS_T(N);
  localparam UNITS_U      = `FFD_UNITS_U(N);
  localparam STEPS        = 64 / N;
  localparam STEP_W       = STEPS > 1 ? $clog2(STEPS) : 1;
  localparam STEP_LATENCY = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);
  localparam FILE_LATENCY = `FFD_FILE_LATENCY(SCHEDULE, EVALUATOR);
  localparam POLY_LATENCY = `FFD_POLY_LATENCY(EVALUATOR, FILE_LATENCY, STEP_LATENCY,
                                              CONVERT_LATENCY);
  localparam TREE_LATENCY = `FFD_TREE_LATENCY(N, MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);
  localparam ACCUMULATE   = `FFD_ACCUMULATE_LATENCY(N, ADD_LATENCY, FMA_LATENCY);
  // A single fused unit multiplies in its accumulator, which cannot hide then.
  localparam WAITS        = SERIAL != 0 || TREE_LATENCY == 0;
  localparam PASS         = POLY_LATENCY + 2 * MUL_LATENCY + TREE_LATENCY
                          + (WAITS ? ACCUMULATE : 0);
  localparam PAPER        = SCHEDULE == `FFD_SCHEDULE_PAPER;
  localparam INTERVAL     = PAPER ? PASS : `FFD_POLY_INTERVAL(EVALUATOR);
  localparam CONTEXTS     = `FFD_CONTEXTS(ACCUMULATE, INTERVAL);
  localparam PLACE_W      = `FFD_PLACE_W(SPANS);
  localparam PAYLOAD_W    = 3 * WEIGHT_W + 12 + SOURCE_W + 3 * PLACE_W;

  generate
    if (N < 1 || N > 64 || (N & (N - 1)) != 0) begin : gen_bad_n
      ERROR_ffd_org_tree_n_must_be_a_power_of_two_to_64 u_error ();
    end
    if (SCHEDULE < 0 || SCHEDULE > 1) begin : gen_bad_schedule
      ERROR_ffd_org_tree_schedule_must_be_0_or_1 u_error ();
    end
  endgenerate

  wire                  step_valid;
  wire                  step_first;
  wire                  step_last;
  wire [STEP_W-1:0]     step;
  wire [3*WEIGHT_W-1:0] coordinates;
  wire [11:0]           cell_index;
  wire [SOURCE_W-1:0]   source;
  wire [3*PLACE_W-1:0]  bank;

  ffd_eval_sequencer #(
    .PAYLOAD_W(PAYLOAD_W),
    .STEPS    (STEPS),
    .CONTEXTS (CONTEXTS),
    .INTERVAL (INTERVAL),
    .ALIGNED  (!PAPER)
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

  // The first of this step's banks; unit e of an axis takes the e-th from there.
  wire [6+STEP_W-1:0] shifted = {6'd0, step} << $clog2(N);
  wire [5:0]          index   = shifted[5:0];
  wire                unused_ok = &{1'b0, s_vertex_changed, s_vertex_second,
                                    shifted[6+STEP_W-1:6]};

  wire [UNITS_S*WEIGHT_W-1:0] weights_s;
  wire [UNITS_T*WEIGHT_W-1:0] weights_t;
  wire [UNITS_U*WEIGHT_W-1:0] weights_u;

  genvar a;
  genvar e;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      localparam UNITS = a == 0 ? UNITS_S : a == 1 ? UNITS_T : UNITS_U;
      wire [UNITS*WEIGHT_W-1:0] weights;
      for (e = 0; e < UNITS; e = e + 1) begin : gen_unit
        localparam [1:0] UNIT = e;
        wire [1:0] blending = index[4-2*a +: 2] + UNIT - cell_index[4*a +: 2];
        ffd_eval_poly #(
          .FORMAT         (FORMAT),
          .EVALUATOR      (EVALUATOR),
          .FILE_LATENCY   (FILE_LATENCY),
          .MUL_LATENCY    (MUL_LATENCY),
          .ADD_LATENCY    (ADD_LATENCY),
          .FMA_LATENCY    (FMA_LATENCY),
          .CONVERT_LATENCY(CONVERT_LATENCY),
          .ADDRESS_W      (PLACE_W + 2)
        ) u_poly (
          .clk           (clk),
          .load_i        (load_i && load_axis_i == a),
          .load_address_i(load_address_i),
          .load_entry_i  (load_entry_i),
          .start_i       (step_valid),
          .coordinate_i  (coordinates[a*WEIGHT_W +: WEIGHT_W]),
          .address_i     ({bank[PLACE_W*a +: PLACE_W], blending}),
          .weight_o      (weights[e*WEIGHT_W +: WEIGHT_W])
        );
      end
    end
  endgenerate

  assign weights_s = gen_axis[0].weights;
  assign weights_t = gen_axis[1].weights;
  assign weights_u = gen_axis[2].weights;

  // The step goes beside its polynomials.
  wire                weighted_valid;
  wire                weighted_first;
  wire                weighted_last;
  wire [SOURCE_W-1:0] weighted_source;
  wire [11:0]         weighted_cell;
  wire [5:0]          weighted_index;

  ffd_num_delay #(
    .WIDTH  (3),
    .LATENCY(POLY_LATENCY),
    .RESET  (1)
  ) u_weighted_valid (
    .clk(clk),
    .rst(rst),
    .d_i({step_valid, step_first, step_last}),
    .q_o({weighted_valid, weighted_first, weighted_last})
  );

  ffd_num_delay #(
    .WIDTH  (SOURCE_W + 18),
    .LATENCY(POLY_LATENCY)
  ) u_weighted (
    .clk(clk),
    .rst(rst),
    .d_i({source, cell_index, index}),
    .q_o({weighted_source, weighted_cell, weighted_index})
  );

  ffd_eval_summation #(
    .FORMAT      (FORMAT),
    .N           (N),
    .MUL_LATENCY (MUL_LATENCY),
    .ADD_LATENCY (ADD_LATENCY),
    .FMA_LATENCY (FMA_LATENCY),
    .READ_LATENCY(READ_LATENCY),
    .SOURCE_W    (SOURCE_W),
    .DISTANCE    (CONTEXTS * INTERVAL)
  ) u_summation (
    .clk           (clk),
    .rst           (rst),
    .step_valid_i  (weighted_valid),
    .step_first_i  (weighted_first),
    .step_last_i   (weighted_last),
    .step_source_i (weighted_source),
    .step_cell_i   (weighted_cell),
    .step_index_i  (weighted_index),
    .weights_s_i   (weights_s),
    .weights_t_i   (weights_t),
    .weights_u_i   (weights_u),
    .read_o        (read_o),
    .read_last_o   (read_last_o),
    .read_source_o (read_source_o),
    .read_cell_o   (read_cell_o),
    .read_index_o  (read_index_o),
    .read_points_i (read_points_i),
    .result_valid_o(result_valid_o),
    .result_sum_o  (result_sum_o)
  );

  assign result_jacobian_o = {9 * `FFD_SUM_W(FORMAT) {1'b0}};
  assign result_second_o   = {3 * `FFD_SUM_W(FORMAT) {1'b0}};
endmodule

`default_nettype wire
