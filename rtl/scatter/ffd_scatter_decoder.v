// ffd_scatter_decoder: beats become coefficients, vertices with gradients, begins and collects
//
// Coefficients are loaded into the bank that no vertex inside reads; vertices before them see the
// old, vertices after them the new. Words of a function, of a vertex and of a gradient pass one row
// of converters, in turn; vertices of a grid, which are made here, have converters of their own.
// With ROWS one is made in the clock of its gradient, of which one is taken in each clock.
//
// Bad input:  a vertex outside is brought inside or adds nothing, by the mode of its packet; it
//             adds nothing without functions. Each event is a pulse of event_o (FFD_EVENT_*) with
//             the packet's number since reset and the beat's in it. With BESIDE 1 an evaluator is
//             on the same stream, which tells of coefficients and of all that is unknown here.
// Formats:    as in ffd_scatter_vertex and ffd_scatter_pages; entry {shift, c3, c2, c1, c0}.
// Pipeline:   a vertex is offered 5 clocks behind the beat of its gradient, with WAITING above 16
//             in 6; II 2, of a grid with ROWS 1. Events FFD_IN_LATENCY behind the clock in which
//             their beat goes on.
// Freezes:    s_beat_ready is 0 while two beats wait: a header for what ffd_scatter_pages says, the
//             last axis of a grid for its check, 20 clocks, a gradient for room.
// Cuts:       s_beat_ready leaves a register (ffd_scatter_entry), outputs follow registers through
//             gates, none an input of its stream.
// Parameters: FORMAT, PAGES as in ffd_scatter_pages; EVALUATOR pipelined or powers; AXIS 4 to 32;
//             WAITING as in ffd_scatter_vertex; INSIDE >= the most vertices, or rows, inside;
//             BESIDE, ROWS 0, 1.
// Model:      golden/include/hwffd/model/scatter_stream.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module ffd_scatter_decoder #(
  parameter FORMAT    = 17,
  parameter EVALUATOR = `FFD_EVALUATOR_PIPELINED,
  parameter AXIS      = 16,
  parameter PAGES     = 2,
  parameter WAITING   = 16,
  parameter INSIDE    = 80,
  parameter BESIDE    = 0,
  parameter ROWS      = 0,
  parameter PAGE_W    = `FFD_PAGE_NUMBER_W(PAGES),
  parameter PLACE_W   = 3 * `FFD_AXIS_W(AXIS)
) (
  input  wire                               clk,
  input  wire                               rst,
  input  wire                               s_beat_valid,
  output wire                               s_beat_ready,
  input  wire [127:0]                       s_beat_data,
  input  wire                               s_beat_last,
  output wire                               load_o,
  output wire [1:0]                         load_axis_o,
  output wire [`FFD_OWN_W(1)-1:0]           load_address_o,
  output wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0] load_entry_o,
  output wire                               m_vertex_valid,
  input  wire                               m_vertex_ready,
  output wire [3*`FFD_WEIGHT_W(FORMAT)-1:0] m_vertex_coordinates,
  output wire [PLACE_W-1:0]                 m_vertex_cell,
  output wire [3*`FFD_PLACE_W(1)-1:0]       m_vertex_bank,
  output wire [1:0]                         m_vertex_along,
  output wire [PAGE_W-1:0]                  m_vertex_page,
  output wire [3*`FFD_POINT_W(FORMAT)-1:0]  m_vertex_gradient,
  output wire                               m_vertex_saturated,
  output wire                               m_vertex_last,  // of its row
  input  wire                               added_i,
  input  wire [PAGE_W-1:0]                  added_page_i,
  input  wire                               added_saturated_i,
  input  wire                               left_i,
  input  wire                               layer_saturated_i,
  input  wire [PAGE_W-1:0]                  layer_page_i,
  output wire                               begin_o,
  output wire [PAGE_W-1:0]                  begin_page_o,
  input  wire                               sweeping_i,
  output wire                               m_collect_valid,
  input  wire                               m_collect_ready,
  output wire [PAGE_W-1:0]                  m_collect_page,
  output wire [1:0]                         m_collect_shift,
  output wire [PLACE_W-1:0]                 m_collect_tops,
  output wire [15:0]                        collect_tag_o,
  output wire [1:0]                         collect_flags_o,
  output wire [1:0]                         collect_status_o,
  input  wire                               collected_i,
  output wire [`FFD_EVENTS-1:0]             event_o,
  output wire [31:0]                        event_packet_o,
  output wire [31:0]                        event_beat_o,
  output wire [1:0]                         wait_o,   // {for room, for what is inside}
  output wire                               idle_o
);
  generate
    if (EVALUATOR != `FFD_EVALUATOR_PIPELINED && EVALUATOR != `FFD_EVALUATOR_POWERS)
    begin : gen_bad_evaluator
      ERROR_ffd_scatter_decoder_evaluator_must_be_pipelined_or_powers u_error ();
    end
    if (BESIDE != 0 && BESIDE != 1) begin : gen_bad_beside
      ERROR_ffd_scatter_decoder_beside_must_be_0_or_1 u_error ();
    end
    if (ROWS != 0 && ROWS != 1) begin : gen_bad_rows
      ERROR_ffd_scatter_decoder_rows_must_be_0_or_1 u_error ();
    end
  endgenerate

  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam AXIS_W   = `FFD_AXIS_W(AXIS);
  localparam LATENCY  = `FFD_IN_LATENCY(FORMAT);

  wire         there;
  wire         take;
  wire [127:0] data;
  wire         last;
  ffd_scatter_entry #(
    .WIDTH(129)
  ) u_entry (
    .clk         (clk),
    .rst         (rst),
    .s_beat_valid(s_beat_valid),
    .s_beat_ready(s_beat_ready),
    .s_beat_data ({s_beat_last, s_beat_data}),
    .m_beat_valid(there),
    .m_beat_ready(take),
    .m_beat_data ({last, data})
  );

  // ---- what each is

  wire [`FFD_PACKET_W-1:0] packet;
  ffd_stream_opcode #(
    .FEATURES(0),
    .SCATTER (1)
  ) u_opcode (
    .opcode_i(data[7:0]),
    .packet_o(packet)
  );

  wire               between;
  wire               header;
  wire               go;
  wire [3:0]         verdict;
  wire               coefficients;
  wire               collect;
  wire               grid;
  wire               none;
  wire               function_beat;
  wire               function_top;
  wire [11:0]        index;
  wire [2:0]         axes;
  wire               check;
  wire               checked;
  wire               bad;
  wire               last_made;
  wire               vertex;
  wire               functions;
  wire               vertices;
  wire               made;
  wire               room;
  wire               finish;
  wire               full;
  wire               is_short;
  wire               is_long;
  wire               is_bad;
  ffd_scatter_framer #(
    .ROWS(ROWS)
  ) u_framer (
    .clk             (clk),
    .rst             (rst),
    .beat_valid_i    (there),
    .beat_last_i     (last),
    .count_i         (data[63:32]),
    .twice_i         (data[95]),
    .take_o          (take),
    .idle_o          (between),
    .header_o        (header),
    .go_i            (go),
    .header_refused_i(verdict != 4'd0),
    .coefficients_i  (coefficients),
    .collect_i       (collect),
    .grid_i          (grid),
    .none_i          (none),
    .function_o      (function_beat),
    .top_o           (function_top),
    .index_o         (index),
    .axis_o          (axes),
    .check_o         (check),
    .grid_checked_i  (checked),
    .grid_bad_i      (bad),
    .grid_last_i     (last_made),
    .vertex_o        (vertex),
    .functions_o     (functions),
    .vertices_o      (vertices),
    .made_o          (made),
    .room_i          (room),
    .finish_o        (finish),
    .full_o          (full),
    .short_o         (is_short),
    .long_o          (is_long),
    .grid_o          (is_bad)
  );

  // With ROWS the vertex of a grid is in the clock of its gradient. A row ends with its last
  // vertex or with its packet; others are rows by themselves. Who is inside is known a clock later.
  wire adds;
  wire made_last;
  wire walk     = ROWS != 0 && made;
  wire row_last = !walk || made_last || last;
  reg  come_q;
  always @(posedge clk) come_q <= finish && adds && row_last && !rst;

  // ---- pages, and who is inside

  wire               header_waits;
  wire [1:0]         along;
  wire               clamp;
  wire [PAGE_W-1:0]  page;
  wire [PLACE_W-1:0] last_cell;
  wire               any_inside;
  wire               bank_inside;
  wire               collect_inside;
  wire               change;
  wire               mark;
  wire               overflowed;
  wire               collecting;
  ffd_scatter_pages #(
    .FORMAT(FORMAT),
    .PAGES (PAGES),
    .AXIS  (AXIS)
  ) u_pages (
    .clk              (clk),
    .rst              (rst),
    .held_i           (header),
    .data_i           (data),
    .packet_i         (packet),
    .go_o             (go),
    .waits_o          (header_waits),
    .verdict_o        (verdict),
    .coefficients_o   (coefficients),
    .collect_o        (collect),
    .grid_o           (grid),
    .none_o           (none),
    .along_o          (along),
    .clamp_o          (clamp),
    .page_o           (page),
    .last_cell_o      (last_cell),
    .inside_i         (any_inside),
    .bank_inside_i    (bank_inside),
    .collect_inside_i (collect_inside),
    .added_i          (added_i),
    .added_page_i     (added_page_i),
    .added_saturated_i(added_saturated_i),
    .layer_saturated_i(layer_saturated_i),
    .layer_page_i     (layer_page_i),
    .overflowed_o     (overflowed),
    .begin_o          (begin_o),
    .begin_page_o     (begin_page_o),
    .sweeping_i       (sweeping_i),
    .mark_o           (mark),
    .m_collect_valid  (m_collect_valid),
    .m_collect_ready  (m_collect_ready),
    .m_collect_page   (m_collect_page),
    .m_collect_shift  (m_collect_shift),
    .m_collect_tops   (m_collect_tops),
    .collect_tag_o    (collect_tag_o),
    .collect_flags_o  (collect_flags_o),
    .collect_status_o (collect_status_o),
    .collected_i      (collected_i),
    .collecting_o     (collecting)
  );

  ffd_scatter_inside #(
    .MOST(INSIDE)
  ) u_inside (
    .clk      (clk),
    .rst      (rst),
    .come_i   (come_q),
    .leave_i  (left_i),
    .bank_i   (change),
    .collect_i(mark),
    .any_o    (any_inside),
    .bank_o   (bank_inside),
    .collect_o(collect_inside)
  );

  // ---- functions

  reg  [`FFD_FRAME_W-1:0] frame;
  always @* begin
    frame                      = {`FFD_FRAME_W{1'b0}};
    frame[`FFD_FRAME_INDEX]    = index;
    frame[`FFD_FRAME_TOP]      = function_top;
    frame[`FFD_FRAME_HEADER]   = header;
    frame[`FFD_FRAME_FUNCTION] = function_beat;
    frame[`FFD_FRAME_PACKET]   = packet;
  end

  wire [1:0]           degree;
  wire                 bank;
  wire                 loaded;
  wire                 derivatives_loaded;
  wire                 functions_busy;
  wire                 sum_fault;
  wire [11:0]          index_there;
  wire [1:0]           load_shift;
  wire [`FFD_PLACES_W(1)-1:0] places;
  ffd_num_delay #(
    .WIDTH  (12),
    .LATENCY(LATENCY)
  ) u_index (
    .clk(clk),
    .rst(1'b0),
    .d_i(index),
    .q_o(index_there)
  );
  ffd_stream_functions #(
    .SPANS  (1),
    .LATENCY(LATENCY),
    .AXIS   (AXIS),
    .SUMS   (EVALUATOR != `FFD_EVALUATOR_POWERS && BESIDE == 0 ? 1 : 0)
  ) u_functions (
    .clk           (clk),
    .rst           (rst),
    .take_i        (go || function_beat),
    .data_i        (data),
    .frame_i       (frame),
    .degree_o      (degree),
    .change_o      (change),
    .busy_o        (functions_busy),
    .bank_o        (bank),
    .loaded_o      (loaded),
    .derivatives_o (derivatives_loaded),
    .sum_fault_o   (sum_fault),
    .place_there_i (index_there),
    .load_axis_o   (load_axis_o),
    .load_address_o(load_address_o),
    .load_shift_o  (load_shift),
    .cell_i        ({PLACE_W{1'b0}}),
    .origin_i      (21'd0),
    .cell_there_i  (1'b0),
    .places_o      (places)
  );

  // ---- vertices of a grid

  wire [17:0] grid_cells;
  wire [74:0] grid_coordinates;
  wire        grid_pair;
  wire [24:0] grid_second;
  ffd_stream_grid #(
    .AXIS(AXIS)
  ) u_grid (
    .clk          (clk),
    .rst          (rst),
    .data_i       (data),
    .header_i     (header),
    .axis_i       (axes),
    .check_i      (check),
    .loaded_i     (1'b1),
    .large_i      (1'b0),
    .last_cell_i  (last_cell),
    .next_i       (made),
    .pairs_i      (1'b0),
    .checked_o    (checked),
    .bad_o        (bad),
    .last_o       (last_made),
    .row_last_o   (made_last),
    .cells_o      (grid_cells),
    .coordinates_o(grid_coordinates),
    .pair_o       (grid_pair),
    .second_o     (grid_second)
  );
  wire unused_grid = &{1'b0, grid_pair, grid_second};

  // ---- where a vertex is

  wire [95:0]        made_words;
  wire [PLACE_W-1:0] cell_made;
  wire [PLACE_W-1:0] cell_sent;  // brought inside
  wire [2:0]         beyond;
  wire [2:0]         outside;
  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      wire              nan;
      wire [31:0]       clamped;
      wire [4:0]        index_sent = {AXIS_W > 4 && data[124+a], data[112+4*a +: 4]};
      wire [5:0]        index_made = grid_cells[6*a +: 6];
      wire [AXIS_W-1:0] index_last = last_cell[AXIS_W*a +: AXIS_W];
      ffd_num_coordinate #(
        .FORMAT(FORMAT)
      ) u_word (
        .coordinate_i(grid_coordinates[25*a +: 25]),
        .word_o      (made_words[32*a +: 32])
      );
      ffd_num_range #(
        .FORMAT(FORMAT)
      ) u_range (
        .word_i   (data[32*a +: 32]),
        .nan_o    (nan),
        .outside_o(outside[a]),
        .clamped_o(clamped)
      );
      assign cell_made[AXIS_W*a +: AXIS_W] = index_made[AXIS_W-1:0];
      assign beyond[a]                     = index_sent[AXIS_W-1:0] > index_last;
      assign cell_sent[AXIS_W*a +: AXIS_W] = beyond[a] ? index_last : index_sent[AXIS_W-1:0];
      wire unused_ok = &{1'b0, nan, clamped, index_sent, index_made};
    end
  endgenerate

  reg  [PLACE_W-1:0] cell_q;
  reg                beyond_q;
  reg                outside_q;
  always @(posedge clk) begin
    if (vertex) begin
      cell_q    <= made ? cell_made : cell_sent;
      beyond_q  <= !made && |beyond;
      outside_q <= !made && |outside;
    end
  end
  wire no_functions = !loaded || (along != 2'd0 && !derivatives_loaded);
  wire strays       = !walk && (beyond_q || outside_q);
  assign adds = !no_functions && (clamp || !strays);

  // ---- numbers

  wire [4*POINT_W-1:0] numbers;
  wire                 any_nan;
  wire                 any_outside;
  ffd_stream_numbers #(
    .FORMAT (FORMAT),
    .LATENCY(LATENCY)
  ) u_numbers (
    .clk       (clk),
    .function_i(functions),
    .vertex_i  (vertices),
    .degree_i  (degree),
    .clamp_i   (1'b1),
    .beyond_i  (beyond),
    .data_i    (data),
    .exponent_i(`FFD_EXPONENT_W'd0),
    .numbers_o (numbers),
    .nan_o     (any_nan),
    .outside_o (any_outside)
  );

  wire [3*WEIGHT_W-1:0] made_numbers;
  wire [4*POINT_W-1:0]  coordinates;
  wire                  none_nan;
  wire                  none_outside;
  ffd_stream_numbers #(
    .FORMAT (FORMAT),
    .LATENCY(LATENCY)
  ) u_made_numbers (
    .clk       (clk),
    .function_i(1'b0),
    .vertex_i  (1'b1),
    .degree_i  (2'd0),
    .clamp_i   (1'b1),
    .beyond_i  (3'd0),
    .data_i    ({32'd0, made_words}),
    .exponent_i(`FFD_EXPONENT_W'd0),
    .numbers_o (coordinates),
    .nan_o     (none_nan),
    .outside_o (none_outside)
  );
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_number
      assign made_numbers[a*WEIGHT_W +: WEIGHT_W] = coordinates[a*POINT_W +: WEIGHT_W];
    end
  endgenerate

  assign load_entry_o[4*WEIGHT_W +: 2] = load_shift;
  genvar w;
  generate
    for (w = 0; w < 4; w = w + 1) begin : gen_power
      assign load_entry_o[w*WEIGHT_W +: WEIGHT_W] = numbers[w*POINT_W +: WEIGHT_W];
    end
  endgenerate

  ffd_scatter_vertex #(
    .FORMAT (FORMAT),
    .AXIS   (AXIS),
    .PAGE_W (PAGE_W),
    .LATENCY(LATENCY),
    .WAITING(WAITING)
  ) u_vertex (
    .clk                 (clk),
    .rst                 (rst),
    .vertex_i            (vertex),
    .finish_i            (finish && adds),
    .made_i              (made),
    .last_i              (row_last),
    .cell_i              (walk ? cell_made : cell_q),
    .page_i              (page),
    .along_i             (along),
    .bank_i              (bank),
    .numbers_i           (numbers[3*POINT_W-1:0]),
    .made_numbers_i      (made_numbers),
    .room_o              (room),
    .m_vertex_valid      (m_vertex_valid),
    .m_vertex_ready      (m_vertex_ready),
    .m_vertex_coordinates(m_vertex_coordinates),
    .m_vertex_cell       (m_vertex_cell),
    .m_vertex_bank       (m_vertex_bank),
    .m_vertex_along      (m_vertex_along),
    .m_vertex_page       (m_vertex_page),
    .m_vertex_gradient   (m_vertex_gradient),
    .m_vertex_saturated  (m_vertex_saturated),
    .m_vertex_last       (m_vertex_last)
  );

  // ---- events and their place, LATENCY behind their beat

  wire                   own = packet[`FFD_PACKET_GRADIENTS] || packet[`FFD_PACKET_COLLECT];
  reg  [`FFD_EVENTS-1:0] raised;
  wire [`FFD_EVENTS-1:0] told;
  reg  [`FFD_EVENTS-1:0] others;
  wire                   taken;
  wire                   taken_last;
  always @* begin
    raised = {`FFD_EVENTS{1'b0}};
    if (go) begin
      raised[`FFD_EVENT_UNKNOWN_OPCODE]                 = verdict[0] && !(BESIDE != 0 && !own);
      raised[`FFD_EVENT_NO_LATTICE]                     = verdict[1];
      raised[`FFD_EVENT_LATTICE_SIZE]                   = verdict[2];
      raised[`FFD_STREAM_EVENT(`FFD_EVENT_PAGE_POINTS)] = verdict[3];
    end
    raised[`FFD_EVENT_PACKET_SHORT]                  = is_short && !(BESIDE != 0 && coefficients);
    raised[`FFD_EVENT_PACKET_LONG]                   = is_long && !(BESIDE != 0 && coefficients);
    raised[`FFD_EVENT_NO_COEFFICIENTS]               = finish && no_functions;
    raised[`FFD_EVENT_CELL_OUTSIDE]                  = finish && beyond_q && !walk;
    raised[`FFD_EVENT_COORDINATE_OUTSIDE]            = finish && outside_q && !walk;
    raised[`FFD_STREAM_EVENT(`FFD_EVENT_GRID_COUNT)] = is_bad;
  end
  ffd_num_delay #(
    .WIDTH  (`FFD_EVENTS + 3),
    .LATENCY(LATENCY),
    .RESET  (1)
  ) u_told (
    .clk(clk),
    .rst(rst),
    .d_i({function_beat, take, take && last, raised}),
    .q_o({load_o, taken, taken_last, told})
  );
  always @* begin
    others                                                = {`FFD_EVENTS{1'b0}};
    others[`FFD_STREAM_EVENT(`FFD_EVENT_FUNCTIONS_SUM)]   = sum_fault;
    others[`FFD_STREAM_EVENT(`FFD_EVENT_PAGE_OVERFLOWED)] = overflowed;
  end
  assign event_o = told | others;

  ffd_stream_place u_place (
    .clk     (clk),
    .rst     (rst),
    .take_i  (taken),
    .last_i  (taken_last),
    .packet_o(event_packet_o),
    .beat_o  (event_beat_o)
  );

  // What has been taken is known behind the converters.
  reg  [LATENCY:0] moving_q;
  always @(posedge clk) begin
    moving_q <= rst ? {(LATENCY + 1) {1'b0}} : {moving_q[LATENCY-1:0], take};
  end
  wire moving = moving_q != {(LATENCY + 1) {1'b0}};

  assign wait_o = {full, header_waits};
  assign idle_o = !there && between && !moving && !any_inside && !collecting
               && !overflowed;

  wire unused_ok = &{1'b0, functions_busy, places, any_nan, any_outside, numbers, coordinates,
                     none_nan, none_outside};
endmodule

`default_nettype wire
