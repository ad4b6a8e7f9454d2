// ffd_org_cg: the basic organization with a combination generator (paper, fig. 6, fig. 7, 4.4)
//
// SIZE polynomial evaluators fill three banks of four weights, 12 polynomials a vertex instead of
// 192; then the combinations are read from the banks, one a step, in the order of the counter.
//
// Schedule:   paper: 12/SIZE polynomials one after the other, then 64 combinations of one clock for
//             the generator, three for the multiplier and one for the accumulator: 72/SIZE + 320
//             clocks a vertex with one-clock units.
//             overlapped: the next vertex's weights are evaluated during the present one's
//             combinations: 64 clocks between vertices. The weights take less, with one
//             iterative evaluator 36.
// Pipeline:   polynomials | set of 12 weights | step | 1: generator | ffd_eval_summation.
// Freezes:    never; a vertex enters when a set of weights is free.
// Parameters: those of every organization (docs/architecture.md); N is 1; SIZE 1 or 3.
// Model:      golden/include/hwffd/model/org_cg.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_org_cg #(
  parameter SIZE            = 1,
  parameter FORMAT          = 18,
  parameter N               = 1,
  parameter PORTS           = 1,
  `include "ffd_org_parameters.vh"
) (
  `include "ffd_org_ports.vh"
);
  localparam WEIGHT_W     = `FFD_WEIGHT_W(FORMAT);
  localparam STEP_LATENCY = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);
  localparam FILE_LATENCY = `FFD_FILE_LATENCY(SCHEDULE, EVALUATOR);
  localparam POLY_LATENCY = `FFD_POLY_LATENCY(EVALUATOR, FILE_LATENCY, STEP_LATENCY,
                                              CONVERT_LATENCY);
  localparam TREE_LATENCY = `FFD_TREE_LATENCY(1, MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);
  localparam ACCUMULATE   = `FFD_ACCUMULATE_LATENCY(1, ADD_LATENCY, FMA_LATENCY);
  localparam GENERATOR    = 1;
  localparam PAPER        = SCHEDULE == `FFD_SCHEDULE_PAPER;
  localparam QUEUED       = 2;                           // the queue and the sequencer
  localparam AHEAD        = PAPER ? QUEUED : QUEUED - 1;  // or else one clock for the weight's bank
  localparam POLYNOMIALS  = 12 / SIZE;
  localparam FILL         = PAPER ? POLY_LATENCY : `FFD_POLY_INTERVAL(EVALUATOR);
  localparam INTERVAL     = PAPER ? GENERATOR + 2 * MUL_LATENCY + TREE_LATENCY + ACCUMULATE : 1;
  localparam CONTEXTS     = `FFD_CONTEXTS(ACCUMULATE, INTERVAL);
  localparam VERTEX       = PAPER ? POLYNOMIALS * FILL + 64 * INTERVAL : POLYNOMIALS * FILL;
  // Vertices in turn, one that waits for its turn and one that is filled.
  localparam SETS         = CONTEXTS + 2;
  localparam SET_W        = $clog2(SETS);
  localparam FILL_W       = $clog2(POLYNOMIALS);
  localparam PLACE_W      = `FFD_PLACE_W(SPANS);
  localparam SELECT_W     = SIZE == 3 ? `FFD_OWN_W(SPANS) : `FFD_SHARED_W(SPANS);

  generate
    if (SIZE != 1 && SIZE != 3) begin : gen_bad_size
      ERROR_ffd_org_cg_size_must_be_1_or_3 u_error ();
    end
    if (N != 1) begin : gen_bad_n
      ERROR_ffd_org_cg_n_must_be_1 u_error ();
    end
    if (SCHEDULE < 0 || SCHEDULE > 1) begin : gen_bad_schedule
      ERROR_ffd_org_cg_schedule_must_be_0_or_1 u_error ();
    end
  endgenerate

  // ---- sets of weights, given out and taken back in turn

  localparam             TOP_SET  = SETS - 1;
  localparam [SET_W-1:0] LAST_SET = TOP_SET[SET_W-1:0];
  localparam [SET_W:0]   ALL_SETS = SETS[SET_W:0];
  reg  [SET_W-1:0] set_q;
  reg  [SET_W:0]   used_q;
  wire             set_free = used_q != ALL_SETS;
  wire             set_done;
  wire             fill_ready;
  wire             enter    = s_vertex_valid && s_vertex_ready;

  assign s_vertex_ready = fill_ready && set_free;

  always @(posedge clk) begin
    if (rst) begin
      set_q  <= {SET_W{1'b0}};
      used_q <= {(SET_W + 1) {1'b0}};
    end else begin
      if (enter) set_q <= set_q == LAST_SET ? {SET_W{1'b0}} : set_q + 1'b1;
      used_q <= used_q + {{SET_W{1'b0}}, enter} - {{SET_W{1'b0}}, set_done};
    end
  end

  // ---- polynomials: evaluator e takes the e-th share of the 12, axis s first

  wire                  fill_valid;
  wire                  fill_first;
  wire                  fill_last;
  wire [FILL_W-1:0]     fill;
  wire [3*WEIGHT_W-1:0] fill_coordinates;
  wire [11:0]           fill_cell;
  wire [SOURCE_W-1:0]   fill_source;
  wire [3*PLACE_W-1:0]  fill_bank;
  wire [SET_W-1:0]      fill_set;

  ffd_eval_sequencer #(
    .PAYLOAD_W(3 * WEIGHT_W + 12 + SOURCE_W + 3 * PLACE_W + SET_W),
    .STEPS    (POLYNOMIALS),
    .CONTEXTS (1),
    .INTERVAL (FILL),
    .ALIGNED  (!PAPER),
    .START_GAP(VERTEX)
  ) u_fill (
    .clk           (clk),
    .rst           (rst),
    .s_vertex_valid(s_vertex_valid && set_free),
    .s_vertex_ready(fill_ready),
    .s_vertex_data ({s_vertex_coordinates, s_vertex_cell, s_vertex_source, s_vertex_bank, set_q}),
    .step_valid_o  (fill_valid),
    .step_first_o  (fill_first),
    .step_last_o   (fill_last),
    .step_o        (fill),
    .payload_o     ({fill_coordinates, fill_cell, fill_source, fill_bank, fill_set})
  );

  // The weights of one step, where they belong: {axis, function} of each evaluator. A vertex is
  // announced ahead of its last weights, so that its first combination is read in the very clock in
  // which they come; overlapped, in the next, which takes no way round the bank.
  wire                     ahead_valid;
  wire                     ahead_last;
  wire [SET_W-1:0]         ahead_set;
  wire [11:0]              ahead_cell;
  wire [SOURCE_W-1:0]      ahead_source;
  wire                     weight_valid;
  wire [SET_W-1:0]         weight_set;
  wire [SIZE*WEIGHT_W-1:0] weights;
  wire [SIZE*4-1:0]        weight_places;

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(POLY_LATENCY - AHEAD),
    .RESET  (1)
  ) u_ahead_valid (
    .clk(clk),
    .rst(rst),
    .d_i({fill_valid, fill_valid && fill_last}),
    .q_o({ahead_valid, ahead_last})
  );

  ffd_num_delay #(
    .WIDTH  (SET_W + 12 + SOURCE_W),
    .LATENCY(POLY_LATENCY - AHEAD)
  ) u_ahead (
    .clk(clk),
    .rst(rst),
    .d_i({fill_set, fill_cell, fill_source}),
    .q_o({ahead_set, ahead_cell, ahead_source})
  );

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(AHEAD),
    .RESET  (1)
  ) u_weight_valid (
    .clk(clk),
    .rst(rst),
    .d_i(ahead_valid),
    .q_o(weight_valid)
  );

  ffd_num_delay #(
    .WIDTH  (SET_W),
    .LATENCY(AHEAD)
  ) u_weight_set (
    .clk(clk),
    .rst(rst),
    .d_i(ahead_set),
    .q_o(weight_set)
  );

  genvar e;
  generate
    for (e = 0; e < SIZE; e = e + 1) begin : gen_evaluator
      localparam       FIRST_I = e * POLYNOMIALS;
      localparam [3:0] FIRST   = FIRST_I[3:0];
      wire [3:0]          place = FIRST + {{(4 - FILL_W) {1'b0}}, fill};
      wire [1:0]          axis  = place[3:2];
      wire [WEIGHT_W-1:0] coordinate = axis[1] ? fill_coordinates[2*WEIGHT_W +: WEIGHT_W] :
                                        axis[0] ? fill_coordinates[1*WEIGHT_W +: WEIGHT_W] :
                                                  fill_coordinates[0*WEIGHT_W +: WEIGHT_W];
      wire [PLACE_W-1:0]  bank       = axis[1] ? fill_bank[2*PLACE_W +: PLACE_W] :
                                       axis[0] ? fill_bank[1*PLACE_W +: PLACE_W] :
                                                 fill_bank[0*PLACE_W +: PLACE_W];

      wire                load;
      wire [SELECT_W-1:0] load_select;
      wire [SELECT_W-1:0] select;
      if (SIZE == 3) begin : gen_own_axis
        assign load        = load_i && load_axis_i == e;
        assign load_select = load_address_i;
        assign select      = {bank, place[1:0]};
      end else begin : gen_all_axes
        assign load        = load_i;
        ffd_eval_address #(
          .SPANS(SPANS)
        ) u_load_select (
          .axis_i   (load_axis_i),
          .place_i  (load_address_i),
          .address_o(load_select)
        );
        ffd_eval_address #(
          .SPANS(SPANS)
        ) u_select (
          .axis_i   (axis),
          .place_i  ({bank, place[1:0]}),
          .address_o(select)
        );
      end

      ffd_eval_poly #(
        .FORMAT         (FORMAT),
        .EVALUATOR      (EVALUATOR),
        .FILE_LATENCY   (FILE_LATENCY),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .ADDRESS_W      (SELECT_W)
      ) u_poly (
        .clk           (clk),
        .load_i        (load),
        .load_address_i(load_select),
        .load_entry_i  (load_entry_i),
        .start_i       (fill_valid),
        .coordinate_i  (coordinate),
        .address_i     (select),
        .weight_o      (weights[e*WEIGHT_W +: WEIGHT_W])
      );

      ffd_num_delay #(
        .WIDTH  (4),
        .LATENCY(POLY_LATENCY)
      ) u_place (
        .clk(clk),
        .rst(rst),
        .d_i(place),
        .q_o(weight_places[4*e +: 4])
      );
    end
  endgenerate

  // ---- a full set waits for its turn

  wire                filled_valid;
  wire                filled_ready;
  wire                filled_room;
  wire [SET_W-1:0]    filled_set;
  wire [11:0]         filled_cell;
  wire [SOURCE_W-1:0] filled_source;

  ffd_stream_fifo #(
    .WIDTH(SET_W + 12 + SOURCE_W),
    .DEPTH(1 << SET_W)
  ) u_filled (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(ahead_last),
    .s_word_ready(filled_room),
    .s_word_data ({ahead_set, ahead_cell, ahead_source}),
    .m_word_valid(filled_valid),
    .m_word_ready(filled_ready),
    .m_word_data ({filled_set, filled_cell, filled_source})
  );

  // ---- combinations

  wire                step_valid;
  wire                step_first;
  wire                step_last;
  wire [5:0]          step;
  wire [SET_W-1:0]    step_set;
  wire [11:0]         step_cell;
  wire [SOURCE_W-1:0] step_source;

  ffd_eval_sequencer #(
    .PAYLOAD_W(SET_W + 12 + SOURCE_W),
    .STEPS    (64),
    .CONTEXTS (CONTEXTS),
    .INTERVAL (INTERVAL),
    .ALIGNED  (!PAPER)
  ) u_steps (
    .clk           (clk),
    .rst           (rst),
    .s_vertex_valid(filled_valid),
    .s_vertex_ready(filled_ready),
    .s_vertex_data ({filled_set, filled_cell, filled_source}),
    .step_valid_o  (step_valid),
    .step_first_o  (step_first),
    .step_last_o   (step_last),
    .step_o        (step),
    .payload_o     ({step_set, step_cell, step_source})
  );

  assign set_done = step_valid && step_last;

  wire [3*WEIGHT_W-1:0] combination;

  ffd_eval_generator #(
    .WEIGHT_W(WEIGHT_W),
    .SIZE    (SIZE),
    .SETS    (SETS),
    .FORWARD (PAPER)
  ) u_generator (
    .clk            (clk),
    .weight_valid_i (weight_valid),
    .weight_set_i   (weight_set),
    .weight_places_i(weight_places),
    .weights_i      (weights),
    .step_set_i     (step_set),
    .step_cell_i    (step_cell),
    .step_i         (step),
    .combination_o  (combination)
  );

  wire                combined_valid;
  wire                combined_first;
  wire                combined_last;
  wire [SOURCE_W-1:0] combined_source;
  wire [11:0]         combined_cell;
  wire [5:0]          combined_step;

  ffd_num_delay #(
    .WIDTH  (3),
    .LATENCY(GENERATOR),
    .RESET  (1)
  ) u_combined_valid (
    .clk(clk),
    .rst(rst),
    .d_i({step_valid, step_first, step_last}),
    .q_o({combined_valid, combined_first, combined_last})
  );

  ffd_num_delay #(
    .WIDTH  (SOURCE_W + 18),
    .LATENCY(GENERATOR)
  ) u_combined (
    .clk(clk),
    .rst(rst),
    .d_i({step_source, step_cell, step}),
    .q_o({combined_source, combined_cell, combined_step})
  );

  ffd_eval_summation #(
    .FORMAT      (FORMAT),
    .N           (1),
    .MUL_LATENCY (MUL_LATENCY),
    .ADD_LATENCY (ADD_LATENCY),
    .FMA_LATENCY (FMA_LATENCY),
    .READ_LATENCY(READ_LATENCY),
    .SOURCE_W    (SOURCE_W),
    .DISTANCE    (CONTEXTS * INTERVAL)
  ) u_summation (
    .clk           (clk),
    .rst           (rst),
    .step_valid_i  (combined_valid),
    .step_first_i  (combined_first),
    .step_last_i   (combined_last),
    .step_source_i (combined_source),
    .step_cell_i   (combined_cell),
    .step_index_i  (combined_step),
    .weights_s_i   (combination[0*WEIGHT_W +: WEIGHT_W]),
    .weights_t_i   (combination[1*WEIGHT_W +: WEIGHT_W]),
    .weights_u_i   (combination[2*WEIGHT_W +: WEIGHT_W]),
    .read_o        (read_o),
    .read_last_o   (read_last_o),
    .read_source_o (read_source_o),
    .read_cell_o   (read_cell_o),
    .read_index_o  (read_index_o),
    .read_points_i (read_points_i),
    .result_valid_o(result_valid_o),
    .result_sum_o  (result_sum_o)
  );

  wire unused_ok = &{1'b0, s_vertex_changed, s_vertex_second, fill_first, filled_room};

  assign result_jacobian_o = {9 * `FFD_SUM_W(FORMAT) {1'b0}};
  assign result_second_o   = {3 * `FFD_SUM_W(FORMAT) {1'b0}};

  `FFD_ASSERT(a_set_is_filled_and_none_was_free,
              !ahead_last || filled_room)
endmodule

`default_nettype wire
