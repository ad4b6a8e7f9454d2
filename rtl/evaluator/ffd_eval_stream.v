// ffd_eval_stream: an organization behind a stream of vertices and a stream of results
//
// Organizations run free and know no tags; this module lends them both. A vertex enters only when
// there is room for its result (credits), its `user` word waits in a queue of its own and meets the
// result at the output, and its exponent in another, which meets the sum: all keep their order.
//
// Vertices of column 1, 2, 3, in this order, are the columns of a Jacobian: their three results
// become one, det J, with the user word of the third. It takes longer than a result of column 0,
// waits in a queue of its own and leaves in its place in the order.
//
// Formats:    coordinates {u, t, s} as stream words, cell {k, j, i}, points as the organization
//             reads them, results {z, y, x} as stream words with {nan, saturated} of any component;
//             of a determinant {0, 0, det J}.
// Pipeline:   the organization's, CONVERT_LATENCY, and 3 clocks in the result queue; det J after
//             ffd_eval_determinant.
// Freezes:    s_vertex_ready is 0 while IN_FLIGHT vertices are inside; nothing inside ever stops.
// Parameters: IN_FLIGHT a power of two >= 4, more than the organization's pipeline holds at full
//             rate; the others are the organization's.
// Model:      golden/include/hwffd/model/evaluator.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_stream #(
  parameter ORG             = 0,
  parameter N               = 1,
  parameter FORMAT          = 18,
  parameter SCHEDULE        = `FFD_SCHEDULE_OVERLAPPED,
  parameter EVALUATOR       = `FFD_EVALUATOR_PIPELINED,
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 1,
  parameter READ_LATENCY    = 2,
  parameter SOURCE_W        = 2,
  parameter USER_W          = 16,
  parameter IN_FLIGHT       = 16
) (
  input  wire                                            clk,
  input  wire                                            rst,
  input  wire                                            load_i,
  input  wire [1:0]                                      load_axis_i,
  input  wire [3:0]                                      load_address_i,
  input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,
  input  wire                                            s_vertex_valid,
  output wire                                            s_vertex_ready,
  input  wire [95:0]                                     s_vertex_coordinates,
  input  wire [11:0]                                     s_vertex_cell,
  input  wire [SOURCE_W-1:0]                             s_vertex_source,
  input  wire [5:0]                                      s_vertex_bank,
  input  wire                                            s_vertex_changed,
  input  wire [1:0]                                      s_vertex_column,
  input  wire [`FFD_EXPONENT_W-1:0]                      s_vertex_exponent,
  input  wire [USER_W-1:0]                               s_vertex_user,
  output wire                                            read_o,
  output wire                                            read_last_o,
  output wire [SOURCE_W-1:0]                             read_source_o,
  output wire [11:0]                                     read_cell_o,
  output wire [5:0]                                      read_index_o,
  input  wire [N*3*`FFD_POINT_W(FORMAT)-1:0]             read_points_i,
  output wire                                            m_result_valid,
  input  wire                                            m_result_ready,
  output wire [95:0]                                     m_result_words,
  output wire [1:0]                                      m_result_flags,
  output wire                                            m_result_determinant,
  output wire [USER_W-1:0]                               m_result_user
);
  localparam SUM_W    = `FFD_SUM_W(FORMAT);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam ENTRY_W  = `FFD_ENTRY_W(WEIGHT_W);
  localparam COUNT_W  = $clog2(IN_FLIGHT) + 1;

  generate
    if (IN_FLIGHT < 4) begin : gen_bad_in_flight
      ERROR_ffd_eval_stream_in_flight_must_be_at_least_4 u_error ();
    end
  endgenerate

  localparam [1:0] LAST_COLUMN = 2'd3;

  // Credits: vertices inside, from their entry until their result has left; three leave with a
  // determinant.
  reg  [COUNT_W-1:0] inside_q;
  wire               room   = !inside_q[COUNT_W-1];
  wire               ready;
  wire               enter  = s_vertex_valid && s_vertex_ready;
  wire               leave  = m_result_valid && m_result_ready;

  // Their room is known a clock later.
  reg  [1:0]         left_q;
  wire [COUNT_W-1:0] entering = {{(COUNT_W - 1) {1'b0}}, enter};
  wire [COUNT_W-1:0] leaving  = {{(COUNT_W - 2) {1'b0}}, left_q};

  assign s_vertex_ready = ready && room;

  always @(posedge clk) begin
    if (rst) begin
      left_q   <= 2'd0;
      inside_q <= {COUNT_W{1'b0}};
    end else begin
      left_q   <= {leave && m_result_determinant, leave};
      inside_q <= inside_q + entering - leaving;
    end
  end

  // Coefficients arrive a clock later: no vertex can want them so soon.
  reg               load_q;
  reg [1:0]         load_axis_q;
  reg [3:0]         load_address_q;
  reg [ENTRY_W-1:0] load_entry_q;
  always @(posedge clk) begin
    load_q         <= load_i && !rst;
    load_axis_q    <= load_axis_i;
    load_address_q <= load_address_i;
    load_entry_q   <= load_entry_i;
  end

  wire [3*WEIGHT_W-1:0] coordinates;

  ffd_eval_coordinates #(
    .FORMAT(FORMAT)
  ) u_coordinates (
    .words_i      (s_vertex_coordinates),
    .coordinates_o(coordinates)
  );

  wire               sum_valid;
  wire [3*SUM_W-1:0] sum;

  ffd_org_select #(
    .ORG            (ORG),
    .N              (N),
    .FORMAT         (FORMAT),
    .SCHEDULE       (SCHEDULE),
    .EVALUATOR      (EVALUATOR),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (FMA_LATENCY),
    .CONVERT_LATENCY(CONVERT_LATENCY),
    .READ_LATENCY   (READ_LATENCY),
    .SOURCE_W       (SOURCE_W)
  ) u_org (
    .clk                 (clk),
    .rst                 (rst),
    .load_i              (load_q),
    .load_axis_i         (load_axis_q),
    .load_address_i      (load_address_q),
    .load_entry_i        (load_entry_q),
    .s_vertex_valid      (s_vertex_valid && room),
    .s_vertex_ready      (ready),
    .s_vertex_coordinates(coordinates),
    .s_vertex_cell       (s_vertex_cell),
    .s_vertex_source     (s_vertex_source),
    .s_vertex_bank       (s_vertex_bank),
    .s_vertex_changed    (s_vertex_changed),
    .read_o              (read_o),
    .read_last_o         (read_last_o),
    .read_source_o       (read_source_o),
    .read_cell_o         (read_cell_o),
    .read_index_o        (read_index_o),
    .read_points_i       (read_points_i),
    .result_valid_o      (sum_valid),
    .result_sum_o        (sum)
  );

  // Which column a sum is of, and the exponent of its points.
  localparam SIDE_W = 2 + `FFD_EXPONENT_W;
  wire [1:0]                 column;
  wire [`FFD_EXPONENT_W-1:0] exponent;
  wire                       sides_ready;
  wire                       side_valid;

  ffd_stream_queue #(
    .WIDTH(SIDE_W),
    .DEPTH(IN_FLIGHT)
  ) u_sides (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(enter),
    .s_word_ready(sides_ready),
    .s_word_data ({s_vertex_column, s_vertex_exponent}),
    .m_word_valid(side_valid),
    .m_word_ready(sum_valid),
    .m_word_data ({column, exponent})
  );

  wire        own_result = column == 2'd0;
  wire        word_valid;
  wire [95:0] words;
  wire [2:0]  saturated;
  wire [2:0]  nan;

  genvar c;
  generate
    for (c = 0; c < 3; c = c + 1) begin : gen_component
      ffd_num_out #(
        .FORMAT (FORMAT),
        .LATENCY(CONVERT_LATENCY)
      ) u_out (
        .clk        (clk),
        .sum_i      (sum[c*SUM_W +: SUM_W]),
        .exponent_i (exponent),
        .word_o     (words[32*c +: 32]),
        .saturated_o(saturated[c]),
        .nan_o      (nan[c])
      );
    end
  endgenerate

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(CONVERT_LATENCY),
    .RESET  (1)
  ) u_word_valid (
    .clk(clk),
    .rst(rst),
    .d_i(sum_valid && own_result),
    .q_o(word_valid)
  );

  wire        determinant_valid;
  wire [31:0] determinant;
  wire        determinant_saturated;
  wire        determinant_nan;

  ffd_eval_determinant #(
    .FORMAT         (FORMAT),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .CONVERT_LATENCY(CONVERT_LATENCY)
  ) u_determinant (
    .clk           (clk),
    .rst           (rst),
    .column_valid_i(sum_valid && !own_result),
    .column_last_i (column == LAST_COLUMN),
    .column_i      (sum),
    .exponent_i    (exponent),
    .word_valid_o  (determinant_valid),
    .word_o        (determinant),
    .saturated_o   (determinant_saturated),
    .nan_o         (determinant_nan)
  );

  // Credits keep the queues from overflowing, so their readies are not needed. A user word is there
  // whenever its result is; it says in which queue that is.
  wire        results_ready;
  wire        result_valid;
  wire [97:0] result;
  wire        determinants_ready;
  wire        waiting_valid;
  wire [33:0] waiting;
  wire        users_ready;
  wire        user_valid;
  wire        is_determinant;

  ffd_stream_queue #(
    .WIDTH(98),
    .DEPTH(IN_FLIGHT)
  ) u_results (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(word_valid),
    .s_word_ready(results_ready),
    .s_word_data ({|nan, |saturated, words}),
    .m_word_valid(result_valid),
    .m_word_ready(leave && !m_result_determinant),
    .m_word_data (result)
  );

  ffd_stream_queue #(
    .WIDTH(34),
    .DEPTH(IN_FLIGHT / 2)
  ) u_determinants (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(determinant_valid),
    .s_word_ready(determinants_ready),
    .s_word_data ({determinant_nan, determinant_saturated, determinant}),
    .m_word_valid(waiting_valid),
    .m_word_ready(leave && m_result_determinant),
    .m_word_data (waiting)
  );

  wire takes_user = s_vertex_column == 2'd0 || s_vertex_column == LAST_COLUMN;

  ffd_stream_queue #(
    .WIDTH(1 + USER_W),
    .DEPTH(IN_FLIGHT)
  ) u_users (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(enter && takes_user),
    .s_word_ready(users_ready),
    .s_word_data ({s_vertex_column == LAST_COLUMN, s_vertex_user}),
    .m_word_valid(user_valid),
    .m_word_ready(leave),
    .m_word_data ({is_determinant, m_result_user})
  );

  assign m_result_determinant = user_valid && is_determinant;
  assign m_result_valid       = m_result_determinant ? waiting_valid : result_valid;
  assign m_result_words       = m_result_determinant ? {64'd0, waiting[31:0]} : result[95:0];
  assign m_result_flags       = m_result_determinant ? waiting[33:32] : result[97:96];

  wire unused_ok = &{1'b0, sides_ready, side_valid, results_ready, determinants_ready,
                     users_ready};
endmodule

`default_nettype wire
