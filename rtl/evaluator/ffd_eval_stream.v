// ffd_eval_stream: an organization behind a stream of vertices and a stream of results
//
// Organizations run free and know no tags; this module lends them both. A vertex enters only when
// there is room for its result (credits); its `user` word waits in a queue until its result is
// there. Column and exponent wait in another, for the sum. All keep their order.
//
// With DETERMINANT vertices of column 1, 2, 3, in this order, are the columns of a Jacobian: their
// three results become one, det J, with the user word of the third. It takes longer than a result
// of column 0, waits in a queue of its own and leaves in its place in the order.
//
// Where the organization gives the Jacobian in one pass, a vertex comes once, whatever it wants:
// det J with column 3, and with column 2 without the position; three derivatives with places of
// derivatives on all axes and column 0. Its
// results leave one after the other with one user word, as ffd_eval_order has them, with RESULTS 2
// two of four at once, or with RESULTS 4 all at once.
//
// With PAIRS a second vertex may come with each one (ffd_org_ports.vh), and its result leaves with
// the other's: both are one vertex for all counts here.
//
// Formats:    coordinates {u, t, s} as weights, cell {k, j, i}, points as the organization reads
//             them, results {z, y, x} as stream words with {folded, nan, saturated}; of a
//             determinant {any, any, det J}, folded where that is not positive. Of a second
//             vertex {nan, saturated, words}.
// Pipeline:   the organization's, ffd_eval_words', and 3 clocks in the result queue; det J after
//             ffd_eval_determinant. Where a vertex enters in every other clock at most, it is
//             offered to the organization a clock after it came: what is in front and what is
//             behind meet in a register.
// Freezes:    s_vertex_ready is 0 while IN_FLIGHT vertices are inside; nothing inside ever stops.
// Parameters: IN_FLIGHT a power of two >= 4, more than the organization's pipeline holds at full
//             rate; RESULTS 1, or with the Jacobian 2, without DETERMINANT 4; DETERMINANT 0 or 1;
//             SPANS 1 to 128, above 1 only in the overlapped schedule and not with EVALUATOR 3;
//             PAIRS 0, or 1 where FFD_ORG_PAIRS; the others are the organization's.
// Model:      golden/include/hwffd/model/evaluator.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_stream #(
  `include "ffd_row_parameters.vh"
  parameter READ_LATENCY    = 2,
  parameter SOURCE_W        = 2,
  parameter USER_W          = 16,
  parameter IN_FLIGHT       = 16,
  parameter RESULTS         = 1,
  parameter DETERMINANT     = 1,
  parameter SPANS           = 1,
  parameter PAIRS           = 0
) (
  input  wire                                            clk,
  input  wire                                            rst,
  input  wire                                            load_i,
  input  wire [1:0]                                      load_axis_i,
  input  wire [`FFD_OWN_W(SPANS)-1:0]                    load_address_i,
  input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,
  input  wire                                            s_vertex_valid,
  output wire                                            s_vertex_ready,
  input  wire [3*`FFD_WEIGHT_W(FORMAT)-1:0]              s_vertex_coordinates,
  input  wire [11:0]                                     s_vertex_cell,
  input  wire [SOURCE_W-1:0]                             s_vertex_source,
  input  wire [3*`FFD_PLACE_W(SPANS)-1:0]                s_vertex_bank,
  input  wire                                            s_vertex_changed,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]                s_vertex_second,
  input  wire [1:0]                                      s_vertex_column,
  input  wire [`FFD_EXPONENT_W-1:0]                      s_vertex_exponent,
  input  wire [USER_W-1:0]                               s_vertex_user,
  output wire [`FFD_ORG_PORTS(ORG)-1:0]                  read_o,
  output wire [`FFD_ORG_PORTS(ORG)-1:0]                  read_last_o,
  output wire [`FFD_ORG_PORTS(ORG)*SOURCE_W-1:0]         read_source_o,
  output wire [`FFD_ORG_PORTS(ORG)*12-1:0]               read_cell_o,
  output wire [`FFD_ORG_PORTS(ORG)*6-1:0]                read_index_o,
  input  wire [`FFD_ORG_PORTS(ORG)*N*3*`FFD_POINT_W(FORMAT)-1:0] read_points_i,
  output wire                                            evaluating_o,  // any vertex
  output wire                                            m_result_valid,
  input  wire                                            m_result_ready,
  output wire [RESULTS*96-1:0]                           m_result_words,
  output wire [RESULTS*3-1:0]                            m_result_flags,
  output wire                                            m_result_determinant,
  output wire                                            m_result_two,
  output wire                                            m_result_last,
  output wire [USER_W-1:0]                               m_result_user,
  output wire [97:0]                                     m_result_second
);
  localparam SUM_W    = `FFD_SUM_W(FORMAT);
  localparam COUNT_W  = $clog2(IN_FLIGHT) + 1;
  localparam JACOBIAN = `FFD_ORG_JACOBIAN(ORG);
  localparam SUMS     = `FFD_RESULTS(JACOBIAN);
  localparam PLACE_W  = `FFD_PLACE_W(SPANS);

  generate
    if (IN_FLIGHT < 4) begin : gen_bad_in_flight
      ERROR_ffd_eval_stream_in_flight_must_be_at_least_4 u_error ();
    end
  endgenerate

  // A table of spans is read into a register, which the paper's schedule has no clock for, and it
  // holds what a wired-in B-spline does not look at.
  generate
    if (SPANS < 1 || SPANS > 128) begin : gen_bad_spans
      ERROR_ffd_eval_stream_spans_must_be_1_to_128 u_error ();
    end
    if (SPANS > 1 && SCHEDULE != `FFD_SCHEDULE_OVERLAPPED) begin : gen_bad_schedule
      ERROR_ffd_eval_stream_spans_want_the_overlapped_schedule u_error ();
    end
    if (SPANS > 1 && EVALUATOR == `FFD_EVALUATOR_POWERS) begin : gen_bad_evaluator
      ERROR_ffd_eval_stream_spans_want_functions_that_are_loaded u_error ();
    end
  endgenerate

  localparam [1:0] LAST_COLUMN = 2'd3;
  localparam       OWN_COLUMNS = DETERMINANT != 0 && SUMS == 1;  // each a pass of its own

  // Credits: vertices inside, from their entry until their result has left; three leave with the
  // determinant of three. Who came and who left is counted a clock later: one more may come
  // meanwhile, which FIRST leaves room for.
  localparam [COUNT_W-1:0] FIRST = 1;
  reg  [COUNT_W-1:0] inside_q;
  reg                entered_q;
  reg                left_q;
  reg                left_three_q;
  reg  [1:0]         left_more;
  wire               room   = !inside_q[COUNT_W-1];
  wire               offer;
  wire               ready;
  wire               enter  = s_vertex_valid && s_vertex_ready;
  wire               leave  = m_result_valid && m_result_ready && m_result_last;

  assign evaluating_o = inside_q != FIRST || entered_q;

  generate
    // One of two steps may take in vertices in successive clocks: its barrel is filled at once.
    if (`FFD_RESULT_INTERVAL(ORG, N) > 2) begin : gen_offer
      reg offer_q;
      always @(posedge clk) offer_q <= !rst && s_vertex_valid && room && !enter;
      assign offer          = offer_q;
      assign s_vertex_ready = ready && offer_q;
    end else begin : gen_at_once
      assign offer          = s_vertex_valid && room;
      assign s_vertex_ready = ready && room;
    end
  endgenerate

  always @* begin
    left_more = 2'd0;
    if (left_three_q) left_more = entered_q ? 2'd2 : 2'd3;
  end
  always @(posedge clk) begin
    if (rst) begin
      entered_q    <= 1'b0;
      left_q       <= 1'b0;
      left_three_q <= 1'b0;
      inside_q     <= FIRST;
    end else begin
      entered_q    <= enter;
      left_q       <= leave && !(OWN_COLUMNS && m_result_determinant);
      left_three_q <= leave && OWN_COLUMNS && m_result_determinant;
      if (left_more != 2'd0) inside_q <= inside_q - {{(COUNT_W - 2) {1'b0}}, left_more};
      else if (entered_q && !left_q) inside_q <= inside_q + 1'b1;
      else if (left_q && !entered_q) inside_q <= inside_q - 1'b1;
    end
  end

  wire               sum_valid;
  wire [3*SUM_W-1:0] sum;
  wire [9*SUM_W-1:0] jacobian;
  wire [3*SUM_W-1:0] second;

  ffd_org_select #(
    `include "ffd_row_arguments.vh"
    .READ_LATENCY   (READ_LATENCY),
    .SOURCE_W       (SOURCE_W),
    .SPANS          (SPANS)
  ) u_org (
    .clk                 (clk),
    .rst                 (rst),
    .load_i              (load_i),
    .load_axis_i         (load_axis_i),
    .load_address_i      (load_address_i),
    .load_entry_i        (load_entry_i),
    .s_vertex_valid      (offer),
    .s_vertex_ready      (ready),
    .s_vertex_coordinates(s_vertex_coordinates),
    .s_vertex_cell       (s_vertex_cell),
    .s_vertex_source     (s_vertex_source),
    .s_vertex_bank       (s_vertex_bank),
    .s_vertex_changed    (s_vertex_changed),
    .s_vertex_second     (s_vertex_second),
    .read_o              (read_o),
    .read_last_o         (read_last_o),
    .read_source_o       (read_source_o),
    .read_cell_o         (read_cell_o),
    .read_index_o        (read_index_o),
    .read_points_i       (read_points_i),
    .result_valid_o      (sum_valid),
    .result_sum_o        (sum),
    .result_jacobian_o   (jacobian),
    .result_second_o     (second)
  );

  // Which column a sum is of, and the exponent of its points: where there is such a thing.
  localparam BLOCK  = `FFD_FORMAT_BLOCK(FORMAT);
  localparam SIDE_W = 2 + (BLOCK ? `FFD_EXPONENT_W : 0);
  wire [1:0]                 column;
  wire [`FFD_EXPONENT_W-1:0] exponent;

  generate
    if (DETERMINANT != 0 || BLOCK) begin : gen_sides
      // A clock later: no sum comes so soon.
      wire              sides_ready;
      wire              side_valid;
      wire [SIDE_W-1:0] side;
      reg  [SIDE_W-1:0] side_q;
      if (BLOCK) begin : gen_exponents
        always @(posedge clk) side_q <= {s_vertex_exponent, s_vertex_column};
        assign exponent = side[2 +: `FFD_EXPONENT_W];
      end else begin : gen_columns
        always @(posedge clk) side_q <= s_vertex_column;
        assign exponent = `FFD_EXPONENT_W'd0;
        wire unused_exponent = &{1'b0, s_vertex_exponent};
      end
      assign column = side[1:0];
      ffd_stream_queue #(
        .WIDTH(SIDE_W),
        .DEPTH(IN_FLIGHT)
      ) u_sides (
        .clk         (clk),
        .rst         (rst),
        .s_word_valid(entered_q),
        .s_word_ready(sides_ready),
        .s_word_data (side_q),
        .m_word_valid(side_valid),
        .m_word_ready(sum_valid),
        .m_word_data (side)
      );
      wire unused_ok = &{1'b0, sides_ready, side_valid};
      `FFD_ASSERT(a_vertex_comes_and_the_queue_is_full, !entered_q || sides_ready)
      `FFD_ASSERT(a_sum_comes_of_a_vertex_that_did_not, !sum_valid || side_valid)
    end else begin : gen_no_sides
      assign column   = 2'd0;
      assign exponent = `FFD_EXPONENT_W'd0;
      wire unused_ok = &{1'b0, s_vertex_exponent};
    end
  endgenerate

  wire               own_result = column == 2'd0 || SUMS != 1;
  wire [12*SUM_W-1:0] sums      = {jacobian, sum};
  wire [SUMS-1:0]    word_valid;
  wire [SUMS*96-1:0] words;
  wire [SUMS-1:0]    saturated;
  wire [SUMS-1:0]    nan;

  genvar r;
  generate
    for (r = 0; r < SUMS; r = r + 1) begin : gen_words
      ffd_eval_words #(
        .FORMAT         (FORMAT),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .SERIAL         (`FFD_RESULT_INTERVAL(ORG, N) >= 3 || JACOBIAN != 0)
      ) u_words (
        .clk         (clk),
        .rst         (rst),
        .sum_valid_i (sum_valid && own_result),
        .sum_i       (sums[3*r*SUM_W +: 3*SUM_W]),
        .exponent_i  (exponent),
        .word_valid_o(word_valid[r]),
        .words_o     (words[96*r +: 96]),
        .saturated_o (saturated[r]),
        .nan_o       (nan[r])
      );
    end
  endgenerate

  wire [97:0] second_words;
  generate
    if (PAIRS != 0) begin : gen_second
      wire second_valid;  // that of the first
      ffd_eval_words #(
        .FORMAT         (FORMAT),
        .CONVERT_LATENCY(CONVERT_LATENCY)
      ) u_words (
        .clk         (clk),
        .rst         (rst),
        .sum_valid_i (1'b0),
        .sum_i       (second),
        .exponent_i  (exponent),
        .word_valid_o(second_valid),
        .words_o     (second_words[95:0]),
        .saturated_o (second_words[96]),
        .nan_o       (second_words[97])
      );
      wire unused_second = &{1'b0, second_valid};
    end else begin : gen_no_second
      assign second_words = 98'd0;
      wire unused_second = &{1'b0, second};
    end
  endgenerate

  // What is wanted of a vertex, and its user word, go on a clock later: nothing is done so soon.
  wire             last_column = SUMS == 1 ? s_vertex_column == LAST_COLUMN : s_vertex_column[1];
  reg              takes_q;
  reg              determinant_q;
  reg              alone_q;
  reg              four_q;
  reg [USER_W-1:0] user_q;
  always @(posedge clk) begin
    takes_q       <= enter && (s_vertex_column == 2'd0 || last_column) && !rst;
    determinant_q <= last_column;
    alone_q       <= SUMS != 1 && last_column && !s_vertex_column[0];
    four_q        <= s_vertex_bank[1] && s_vertex_bank[PLACE_W+1] && s_vertex_bank[2*PLACE_W+1];
    user_q        <= s_vertex_user;
  end

  localparam LATE = `FFD_DETERMINANT_LATENCY(FORMAT, MUL_LATENCY, ADD_LATENCY, CONVERT_LATENCY);
  wire        determinant_valid;
  wire [31:0] determinant;
  wire [2:0]  determinant_flags;
  generate
    if (DETERMINANT != 0) begin : gen_determinant
      wire                       determinant_saturated;
      wire                       determinant_nan;
      wire                       column_valid;
      wire                       column_last;
      wire [3*SUM_W-1:0]         column_sum;
      wire [`FFD_EXPONENT_W-1:0] column_exponent;
      // The words of both kinds of format have their sign in front, and only one for zero.
      wire folded = determinant[31] || determinant == 32'd0;
      assign determinant_flags = {folded, determinant_nan, determinant_saturated};

      if (SUMS == 1) begin : gen_own_columns
        assign column_valid    = sum_valid && !own_result;
        assign column_last     = column == LAST_COLUMN;
        assign column_sum      = sum;
        assign column_exponent = exponent;
      end else begin : gen_three_columns
        ffd_eval_columns #(
          .WIDTH     (3 * SUM_W),
          .EXPONENT_W(`FFD_EXPONENT_W)
        ) u_columns (
          .clk           (clk),
          .rst           (rst),
          .valid_i       (sum_valid && column[1]),
          .columns_i     (jacobian),
          .exponent_i    (exponent),
          .column_valid_o(column_valid),
          .column_last_o (column_last),
          .column_o      (column_sum),
          .exponent_o    (column_exponent)
        );
      end

      ffd_eval_determinant #(
        .FORMAT         (FORMAT),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY)
      ) u_determinant (
        .clk           (clk),
        .rst           (rst),
        .column_valid_i(column_valid),
        .column_last_i (column_last),
        .column_i      (column_sum),
        .exponent_i    (column_exponent),
        .word_valid_o  (determinant_valid),
        .word_o        (determinant),
        .saturated_o   (determinant_saturated),
        .nan_o         (determinant_nan)
      );
      `FFD_ASSERT_TAKES(u_determinant, LATE)
    end else begin : gen_no_determinant
      assign determinant_valid = 1'b0;
      assign determinant       = 32'd0;
      assign determinant_flags = 3'd0;
      wire unused_ok = &{1'b0, own_result};
    end
  endgenerate

  // Where the next sum comes later than the determinant, both go into one queue as they come.
  localparam LATEST = LATE + (FMA_LATENCY > ADD_LATENCY ? FMA_LATENCY : ADD_LATENCY);

  ffd_eval_order #(
    .SUMS       (SUMS),
    .RESULTS    (RESULTS),
    .USER_W     (USER_W),
    .DEPTH      (IN_FLIGHT),
    .DETERMINANT(DETERMINANT),
    .APART      (DETERMINANT != 0 && `FFD_RESULT_INTERVAL(ORG, N) <= LATEST),
    .PAIRS      (PAIRS)
  ) u_order (
    .clk                 (clk),
    .rst                 (rst),
    .take_i              (takes_q),
    .take_determinant_i  (determinant_q),
    .take_alone_i        (alone_q),
    .take_four_i         (four_q),
    .take_user_i         (user_q),
    .word_valid_i        (word_valid[0]),
    .words_i             (words),
    .saturated_i         (saturated),
    .nan_i               (nan),
    .second_i            (second_words),
    .determinant_valid_i (determinant_valid),
    .determinant_i       (determinant),
    .determinant_flags_i (determinant_flags),
    .m_result_valid      (m_result_valid),
    .m_result_ready      (m_result_ready),
    .m_result_words      (m_result_words),
    .m_result_flags      (m_result_flags),
    .m_result_determinant(m_result_determinant),
    .m_result_two        (m_result_two),
    .m_result_last       (m_result_last),
    .m_result_user       (m_result_user),
    .m_result_second     (m_result_second)
  );

  wire unused_ok = &{1'b0, word_valid, sums};

  `FFD_ASSERT(more_vertices_have_left_than_came_or_more_are_inside_than_may_be,
              inside_q >= FIRST && inside_q <= IN_FLIGHT[COUNT_W-1:0] + FIRST)
endmodule

`default_nettype wire
