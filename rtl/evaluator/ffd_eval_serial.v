// ffd_eval_serial: `affine` in sequence: a multiplier a component, one for the nine polynomials
//
// 48 multiplications along u, 12 along t and 3 along s take 63 of the 64 clocks in which the points
// of a vertex are read one after the other, bank 3 of each axis first. Those along t and s take the
// clocks in which a base comes, and which is whose repeats every 16 clocks: one counter of four
// bits, the phase, serves all stages, each so many clocks later. A vertex starts in phase 0.
//
// Meanwhile the polynomials of the next vertex fill another set of weights
// (ffd_eval_serial_weights).
//
// Pipeline:   vertex | polynomials | START clocks: reads | READ_LATENCY: points |
//             ffd_eval_serial_component; along t GROUPS groups of four later, along s 32 clocks
//             more, the last 48 after the first. A vertex in 64 clocks.
// Freezes:    never. Results leave in the order of the vertices and are not held back.
// Parameters: those of ffd_org_affine, which checks SCHEDULE and N; ADD_LATENCY 1, MUL_LATENCY 1 to
//             3, together with CONVERT_LATENCY 2 to 11; READ_LATENCY to 14.
// Model:      golden/include/hwffd/model/org_affine.hpp.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_serial #(
  parameter FORMAT          = 17,
  parameter N               = 1,
  parameter PORTS           = 1,
  `include "ffd_org_parameters.vh"
) (
  `include "ffd_org_ports.vh"
);
  localparam WEIGHT_W     = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W      = `FFD_POINT_W(FORMAT);
  localparam SUM_W        = `FFD_SUM_W(FORMAT);
  localparam PLACE_W      = `FFD_PLACE_W(SPANS);
  localparam STEP_LATENCY = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);
  localparam FILE_LATENCY = `FFD_FILE_LATENCY(SCHEDULE, EVALUATOR);
  localparam POLY_LATENCY = `FFD_POLY_LATENCY(EVALUATOR, FILE_LATENCY, STEP_LATENCY,
                                              CONVERT_LATENCY);
  // The third weight of u is written 6 + POLY_LATENCY clocks after the first step and is wanted
  // with the fourth point; whole rounds of 16 clocks later.
  localparam EARLY        = POLY_LATENCY + 4 - READ_LATENCY;
  localparam START        = EARLY > 32 ? 48 : EARLY > 16 ? 32 : 16;
  // Clocks from a base of u to the point of t that its group makes.
  localparam T_LATENCY    = MUL_LATENCY + CONVERT_LATENCY + 5;
  localparam GROUPS       = (T_LATENCY + 3) / 4;

  generate
    if (ADD_LATENCY != 1) begin : gen_bad_add_latency
      ERROR_ffd_eval_serial_add_latency_must_be_1 u_error ();
    end
    if (MUL_LATENCY > 3 || MUL_LATENCY + CONVERT_LATENCY < 2) begin : gen_bad_mul_latency
      ERROR_ffd_eval_serial_mul_latency_must_be_1_to_3_not_1_without_conversion u_error ();
    end
    // A vertex stays for 64 clocks, and what a round of t makes waits for 16.
    if (EARLY > 48 || T_LATENCY > 16 || READ_LATENCY > 14) begin : gen_bad_latencies
      ERROR_ffd_eval_serial_latencies_are_too_long u_error ();
    end
  endgenerate

  // ---- a vertex begins in phase 0

  reg  [3:0]            phase_q;
  wire                  turn = phase_q == 4'd15;
  wire                  step_valid;
  wire                  step_first;
  wire                  step_last;
  wire [5:0]            step;
  wire [3*WEIGHT_W-1:0] coordinates;
  wire [11:0]           cell_index;
  wire [SOURCE_W-1:0]   source;
  wire [3*PLACE_W-1:0]  bank;
  wire                  idle;

  always @(posedge clk) begin
    if (rst) phase_q <= 4'd0;
    else phase_q <= phase_q + 1'b1;
  end

  ffd_eval_sequencer #(
    .PAYLOAD_W(3 * WEIGHT_W + 12 + SOURCE_W + 3 * PLACE_W),
    .STEPS    (64),
    .CONTEXTS (1),
    .INTERVAL (1)
  ) u_sequencer (
    .clk           (clk),
    .rst           (rst),
    .s_vertex_valid(s_vertex_valid && turn),
    .s_vertex_ready(idle),
    .s_vertex_data ({s_vertex_coordinates, s_vertex_cell, s_vertex_source, s_vertex_bank}),
    .step_valid_o  (step_valid),
    .step_first_o  (step_first),
    .step_last_o   (step_last),
    .step_o        (step),
    .payload_o     ({coordinates, cell_index, source, bank})
  );

  assign s_vertex_ready = idle && turn;

  // ---- reads: 64 from phase 0 on

  localparam          BEFORE     = START - 1;
  wire                start_read = step_valid && step == BEFORE[5:0];
  reg                 begins_q;
  reg                 reading_q;
  reg                 set_q;
  reg  [1:0]          read_l_q;
  reg  [2:0]          part_q;    // {u, t, s}: a derivative, whose weights sum to zero: no base
  reg  [11:0]         read_cell_q;
  reg  [SOURCE_W-1:0] read_source_q;
  wire                round_ends = phase_q == 4'd15;

  always @(posedge clk) begin
    begins_q <= start_read && !rst;
    if (rst) reading_q <= 1'b0;
    else if (start_read) reading_q <= 1'b1;
    else if (read_last_o) reading_q <= 1'b0;
    if (rst) set_q <= 1'b1;
    else if (start_read) set_q <= !set_q;
    if (start_read) begin
      part_q        <= {bank[2*PLACE_W+1], bank[PLACE_W+1], bank[1]};
      read_cell_q   <= cell_index;
      read_source_q <= source;
    end
    if (start_read) read_l_q <= 2'd0;
    else if (round_ends) read_l_q <= read_l_q + 1'b1;
  end

  assign read_o        = reading_q;
  assign read_last_o   = reading_q && round_ends && read_l_q == 2'd3;
  assign read_source_o = read_source_q;
  assign read_cell_o   = read_cell_q;
  assign read_index_o  = {read_l_q - 2'd1, phase_q[3:2] - 2'd1, phase_q[1:0] - 2'd1};

  // ---- the vertex as the axes come to it

  wire first_of_u;  // of a vertex: its first point is here
  wire before_t;    // its first point of t comes next
  wire first_of_s;

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(READ_LATENCY),
    .RESET  (1)
  ) u_first_of_u (
    .clk(clk),
    .rst(rst),
    .d_i(begins_q),
    .q_o(first_of_u)
  );

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(4 * GROUPS - 1),
    .RESET  (1)
  ) u_before_t (
    .clk(clk),
    .rst(rst),
    .d_i(first_of_u),
    .q_o(before_t)
  );

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(33),
    .RESET  (1)
  ) u_first_of_s (
    .clk(clk),
    .rst(rst),
    .d_i(before_t),
    .q_o(first_of_s)
  );

  reg        set_u_q;
  reg        set_t_q;
  reg        set_s_q;
  reg        part_u_q;
  reg        part_t_q;
  reg        part_s_q;
  reg        s_valid_q;
  reg  [1:0] s_l_q;  // of the last one

  // Phases of the stage of points, where t is GROUPS groups behind u.
  localparam       POINT_AT  = 16 - READ_LATENCY % 16;
  localparam       ADD_AT    = POINT_AT + 32 - MUL_LATENCY;
  localparam       KEEP_S_AT = 4 * (GROUPS + 3) + MUL_LATENCY + CONVERT_LATENCY + 2;
  localparam [1:0] BEHIND    = GROUPS[1:0];
  localparam [3:0] KEEP_S    = KEEP_S_AT[3:0];
  wire [3:0] point_next  = phase_q + POINT_AT[3:0] + 4'd1;
  reg  [3:0] point_phase_q;
  reg        base_q;
  reg        begin_t_q;
  wire [1:0] point_m     = point_phase_q[3:2] - BEHIND;  // of t
  // A clock before the sums, and a clock after them.
  wire [3:0] add_phase   = phase_q + ADD_AT[3:0];
  wire [1:0] add_m       = add_phase[3:2] - BEHIND;
  wire       add_upper   = add_phase[1:0] == 2'd0;
  wire       add_of_s    = add_m == 2'd0;
  wire       add_base    = add_upper ? (add_of_s ? s_l_q : add_m) == 2'd1
                                     : add_phase[1:0] == 2'd1;
  wire       add_nothing = add_upper ? (add_of_s ? part_s_q : part_t_q) : part_u_q;
  wire [3:0] keep_phase  = add_phase - 4'd2;

  always @(posedge clk) begin
    point_phase_q <= point_next;
    base_q        <= point_next[1:0] == 2'd0;
    begin_t_q     <= point_next == {BEHIND, 2'd0};
  end

  wire       s_valid = first_of_s || (s_valid_q && s_l_q != 2'd3);
  wire [1:0] s_l     = first_of_s ? 2'd0 : s_l_q + 2'd1;

  always @(posedge clk) begin
    if (first_of_u) begin
      set_u_q  <= set_q;
      part_u_q <= part_q[2];
    end
    if (before_t) begin
      set_t_q  <= set_q;
      part_t_q <= part_q[1];
    end
    if (first_of_s) begin
      set_s_q  <= set_q;
      part_s_q <= part_q[0];
    end
    if (rst) s_valid_q <= 1'b0;
    else if (begin_t_q) s_valid_q <= s_valid;
    if (begin_t_q) s_l_q <= s_l;
  end

  // ---- the weight of each clock

  wire [WEIGHT_W-1:0] used_weight;
  wire [4:0]          used = !base_q   ? {set_u_q, 2'd2, point_phase_q[1:0] - 2'd1}
                           : begin_t_q ? {set_s_q, 2'd0, s_l - 2'd1}
                                     : {set_t_q, 2'd1, point_m - 2'd1};

  ffd_eval_serial_weights #(
    .FORMAT         (FORMAT),
    .EVALUATOR      (EVALUATOR),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (FMA_LATENCY),
    .CONVERT_LATENCY(CONVERT_LATENCY),
    .SPANS          (SPANS)
  ) u_weights (
    .clk           (clk),
    .rst           (rst),
    .load_i        (load_i),
    .load_axis_i   (load_axis_i),
    .load_address_i(load_address_i),
    .load_entry_i  (load_entry_i),
    .begin_i       (s_vertex_valid && s_vertex_ready),
    .coordinates_i (coordinates),
    .cell_i        (cell_index),
    .bank_i        (bank),
    .read_i        (used),
    .weight_o      (used_weight)
  );

  // ---- three components

  wire [3*SUM_W-1:0] sums;

  genvar c;
  generate
    for (c = 0; c < 3; c = c + 1) begin : gen_component
      ffd_eval_serial_component #(
        .FORMAT         (FORMAT),
        .MUL_LATENCY    (MUL_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .DELAY          (4 * GROUPS - T_LATENCY)
      ) u_component (
        .clk          (clk),
        .point_i      (read_points_i[c*POINT_W +: POINT_W]),
        .weight_i     (used_weight),
        .base_i       (base_q),
        .of_s_i       (begin_t_q),
        .begin_t_i    (begin_t_q),
        .begin_s_i    (first_of_s),
        .keep_s_i     (point_phase_q == KEEP_S),
        .add_base_i   (add_base),
        .add_nothing_i(add_nothing),
        .add_half_i   (!add_upper || !add_of_s),
        .add_shadow_i   (add_upper && !add_base),
        .shadow_of_s_i  (add_of_s),
        .keep_i       (keep_phase[1:0] == 2'd0),
        .keep_of_s_i  (keep_phase[3:2] == BEHIND),
        .sum_o        (sums[c*SUM_W +: SUM_W])
      );
    end
  endgenerate

  // The last sum of a vertex, of s.
  wire sum_valid;
  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(MUL_LATENCY + 2),
    .RESET  (1)
  ) u_sum_valid (
    .clk(clk),
    .rst(rst),
    .d_i(begin_t_q && s_valid && s_l == 2'd3),
    .q_o(sum_valid)
  );

  assign result_valid_o    = sum_valid;
  assign result_sum_o      = sums;
  assign result_jacobian_o = {9 * `FFD_SUM_W(FORMAT) {1'b0}};
  assign result_second_o   = {3 * `FFD_SUM_W(FORMAT) {1'b0}};
  wire unused_ok = &{1'b0, s_vertex_changed, s_vertex_second, step_first, step_last};
endmodule

`default_nettype wire
