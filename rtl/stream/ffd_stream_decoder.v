// ffd_stream_decoder: framed beats become coefficients, control points and vertices
//
// Coefficients and lattices are loaded into the bank and the buffer or page that no vertex inside
// reads; their header waits for that. Vertices before it see the old, after it the new. The points
// of an interleaved vertex go into a free slot. All words of a beat pass one row of converters, and
// what belongs to it goes beside them.
//
// With PAIRS a beat may bring the coordinate s of a second vertex, which passes the converter of
// the word that has no number, and goes with the first one from there on.
//
// Bad input:  banks and buffers cut short never come into use. Each event is a pulse of event_o
//             (FFD_EVENT_*) with the packet's number since reset and the beat's in it.
// Formats:    frame as FFD_FRAME_*; numbers_o weights or points, one a word of the beat; source
//             as in ffd_stream.vh; changed: points or coefficients were loaded since the vertex
//             before; user as FFD_USER_*. Vertices have their points' exponent.
// Pipeline:   FFD_IN_LATENCY to numbers_o and the writes; a vertex is offered 3 clocks behind those
//             of its last beat. II 1 resident, 49 interleaved.
// Freezes:    never: it takes what comes. A beat that may have to wait comes when go_o was 1: its
//             bank or page is free, there is a slot, and room for a vertex's end: WAITING. One
//             that starts where slot_free_o is 1, or ends where rooms_o is, may follow at once.
// Parameters: FORMAT as in ffd_num.vh, FEATURES as in ffd_stream.vh, SLOTS >= 2, WAITING a power of
//             two >= 2; PAGES, AXIS as in ffd_stream_pages; INSIDE >= the most vertices inside;
//             EVERY_CLOCK and PAIRS as in ffd_stream_vertex, SPANS and SUMS in
//             ffd_stream_functions.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module ffd_stream_decoder #(
  parameter FORMAT      = 18,
  parameter FEATURES    = `FFD_FEATURES_USUAL,
  parameter SLOTS       = 3,
  parameter SLOT_W      = $clog2(SLOTS),
  parameter WAITING     = 16,
  parameter EVERY_CLOCK = 1,
  parameter PAGES       = 2,
  parameter AXIS        = 16,
  parameter INSIDE      = 152,
  parameter SPANS       = 1,
  parameter SUMS        = 0,
  parameter PAIRS       = 0,
  parameter PAGE_W      = `FFD_PAGE_NUMBER_W(PAGES),
  parameter PLACE_W     = 3 * `FFD_AXIS_W(AXIS),
  parameter SOURCE_W    = `FFD_SOURCE_W(SLOTS, PAGES, AXIS, FEATURES)
) (
  input  wire                                 clk,
  input  wire                                 rst,
  input  wire                                 beat_valid_i,
  input  wire [127:0]                         beat_data_i,
  input  wire                                 beat_last_i,
  input  wire [32:0]                          beat_second_i, // {it is there, word s}
  input  wire [`FFD_FRAME_W-1:0]              beat_frame_i,
  input  wire                                 beat_held_i,   // it waits for go_o
  output wire                                 go_o,
  output wire [1:0]                           wait_o,        // {for room, for readers}
  output wire                                 refuse_o,
  output wire                                 place_valid_o,
  output wire [PLACE_W-1:0]                   place_o,
  output wire [PLACE_W-1:0]                   tops_o,
  output wire [4*`FFD_POINT_W(FORMAT)-1:0]    numbers_o,
  output wire                                 load_o,
  output wire [1:0]                           load_axis_o,
  output wire [`FFD_OWN_W(SPANS)-1:0]         load_address_o,
  output wire [1:0]                           load_shift_o,
  output wire                                 lattice_write_o,
  output wire [PAGE_W-1:0]                    lattice_buffer_o,
  output wire [PLACE_W-1:0]                   lattice_at_o,
  output wire                                 lattice_fourth_o,
  output wire                                 slot_write_o,
  output wire [SLOT_W-1:0]                    slot_o,
  output wire [11:0]                          slot_cell_o,
  output wire [3:0]                           slot_group_o,
  output wire [1:0]                           slot_phase_o,
  output wire                                 m_vertex_valid,
  input  wire                                 m_vertex_ready,
  output wire [3*`FFD_WEIGHT_W(FORMAT)-1:0]   m_vertex_coordinates,
  output wire [`FFD_WEIGHT_W(FORMAT):0]       m_vertex_second,   // {it is there, s}
  output wire [11:0]                          m_vertex_cell,
  output wire [SOURCE_W-1:0]                  m_vertex_source,
  output wire [`FFD_PLACES_W(SPANS)-1:0]      m_vertex_bank,
  output wire                                 m_vertex_changed,
  output wire [1:0]                           m_vertex_results,
  output wire [`FFD_EXPONENT_W-1:0]           m_vertex_exponent,
  output wire [`FFD_USER_W-1:0]               m_vertex_user,
  output wire                                 lattice_loaded_o,  // that of the last header
  output wire [PLACE_W-1:0]                   last_cell_o,       // {k, j, i}
  output wire                                 pairs_o,           // of vertices that are evaluated
  output wire                                 slot_free_o,
  output wire                                 rooms_o,
  input  wire                                 slot_free_i,
  input  wire                                 evaluating_i,  // vertices
  input  wire                                 retire_i,
  input  wire [2:0]                           retire_user_i,
  output wire [`FFD_EVENTS-1:0]               event_o,
  output wire [31:0]                          event_packet_o,
  output wire [31:0]                          event_beat_o,
  output wire                                 idle_o
);
  localparam POINT_W   = `FFD_POINT_W(FORMAT);
  localparam WEIGHT_W  = `FFD_WEIGHT_W(FORMAT);
  localparam LATENCY   = `FFD_IN_LATENCY(FORMAT);
  localparam EXPONENT_W = `FFD_EXPONENT_W;
  localparam [1:0] MODE_CLAMP = 2'd0;
  localparam [1:0] MODE_PASS  = 2'd1;

  wire        take     = beat_valid_i;
  wire        header   = beat_frame_i[`FFD_FRAME_HEADER];
  wire        function_beat = beat_frame_i[`FFD_FRAME_FUNCTION];
  wire        point    = beat_frame_i[`FFD_FRAME_POINT];
  wire        vertex   = beat_frame_i[`FFD_FRAME_VERTEX];
  wire        top      = beat_frame_i[`FFD_FRAME_TOP];
  wire        finish   = beat_frame_i[`FFD_FRAME_FINISH];
  wire        of_page  = beat_frame_i[`FFD_FRAME_PAGE];
  wire [`FFD_PACKET_W-1:0] packet = beat_frame_i[`FFD_FRAME_PACKET];

  // ---- what the header says

  reg                   resident_q;
  reg  [1:0]            mode_q;
  reg  [1:0]            results_q;
  reg                   half_q;
  reg  [EXPONENT_W-1:0] exponent_q;
  always @(posedge clk) begin
    if (take && header) begin
      resident_q <= packet[`FFD_PACKET_VERTICES] || packet[`FFD_PACKET_PAGE_VERTICES];
      mode_q     <= beat_data_i[65:64];
      results_q  <= beat_data_i[73:72];
      half_q     <= `FFD_FEATURE_HALVES(FEATURES) != 0 && packet[`FFD_PACKET_PAGE_VERTICES]
                 && beat_data_i[22];
      exponent_q <= beat_data_i[96 +: EXPONENT_W] & {EXPONENT_W{`FFD_FORMAT_BLOCK(FORMAT)}};
    end
  end

  // ---- what is in use

  wire                  bank;
  wire                  coefficients_loaded;
  wire                  derivatives_loaded;
  wire                  new_bank;
  wire [PAGE_W-1:0]     new_page;   // that points go to
  wire                  lattice_loaded;
  wire [EXPONENT_W-1:0] lattice_exponent;
  wire                  fourth;
  wire                  new_buffer = take && point && top;

  wire [SLOT_W-1:0]      slot;
  wire                   page_go;
  wire                   page_waits;
  wire [`FFD_PAGE_W-1:0] page_verdict;
  wire                   page_empty;
  wire [2:0]             beyond;
  wire [11:0]            cell_index;
  wire [PLACE_W-1:0]     whole_cell;
  wire [20:0]            origin;
  wire [15:0]            tag;
  wire [SOURCE_W-1:0]    source;
  ffd_stream_resident #(
    .FORMAT  (FORMAT),
    .FEATURES(FEATURES),
    .SLOTS   (SLOTS),
    .PAGES   (PAGES),
    .AXIS    (AXIS),
    .INSIDE  (INSIDE),
    .SPANS   (SPANS)
  ) u_resident (
    .clk          (clk),
    .rst          (rst),
    .take_i       (take),
    .held_i       (beat_held_i),
    .data_i       (beat_data_i),
    .frame_i      (beat_frame_i),
    .exponent_i   (exponent_q),
    .resident_i   (resident_q),
    .slot_i       (slot),
    .leave_i      (retire_i),
    .go_o         (page_go),
    .waits_o      (page_waits),
    .refuse_o     (refuse_o),
    .place_valid_o(place_valid_o),
    .place_o      (place_o),
    .tops_o       (tops_o),
    .verdict_o    (page_verdict),
    .empty_o      (page_empty),
    .new_page_o   (new_page),
    .loaded_o     (lattice_loaded),
    .last_cell_o  (last_cell_o),
    .exponent_o   (lattice_exponent),
    .fourth_o     (fourth),
    .beyond_o     (beyond),
    .cell_o       (cell_index),
    .whole_cell_o (whole_cell),
    .origin_o     (origin),
    .tag_o        (tag),
    .source_o     (source)
  );

  // ---- when a beat may come

  wire bank_busy, functions_busy, buffer_busy;
  wire slot_free;
  wire room;
  wire read_on = (beat_frame_i[`FFD_FRAME_BANK] && (bank_busy || functions_busy))
              || (beat_frame_i[`FFD_FRAME_BUFFER] && buffer_busy);
  wire full    = (vertex && !resident_q && !slot_free) || (finish && !room);
  assign go_o   = !read_on && !(of_page && !page_go) && !full;
  assign wait_o = {full, read_on || (of_page && page_waits)} & {2{beat_held_i}};

  assign slot_free_o      = slot_free;
  assign lattice_loaded_o = lattice_loaded;
  assign pairs_o          = coefficients_loaded;
  wire              waiting;
  wire              any_inside = waiting || evaluating_i;
  ffd_stream_readers u_readers (
    .clk            (clk),
    .rst            (rst),
    .leave_i        (retire_i),
    .leave_bank_i   (retire_user_i[`FFD_RETIRE_BANK]),
    .leave_buffer_i (retire_user_i[`FFD_RETIRE_BUFFER]),
    .leave_lattice_i(retire_user_i[`FFD_RETIRE_RESIDENT]),
    .new_bank_i     (new_bank),
    .new_buffer_i   (new_buffer),
    .bank_i         (bank),
    .buffer_i       (!new_page[0]),
    .inside_i       (any_inside),
    .bank_busy_o    (bank_busy),
    .buffer_busy_o  (buffer_busy)
  );

  ffd_stream_slots #(
    .FEATURES(FEATURES),
    .SLOTS   (SLOTS)
  ) u_slots (
    .clk    (clk),
    .rst    (rst),
    .claim_i(take && vertex && !resident_q),
    .next_i (take && finish && !resident_q),
    .free_i (slot_free_i),
    .slot_o (slot),
    .free_o (slot_free)
  );

  // ---- numbers

  wire        pair  = PAIRS != 0 && vertex && beat_second_i[32];
  wire [31:0] word3 = pair ? beat_second_i[31:0] : beat_data_i[127:96];
  wire       clamp = mode_q == MODE_CLAMP;
  wire [1:0] degree;
  wire       nan;
  wire       outside;
  ffd_stream_numbers #(
    .FORMAT (FORMAT),
    .LATENCY(LATENCY)
  ) u_numbers (
    .clk       (clk),
    .function_i(function_beat),
    .vertex_i  (vertex),
    .degree_i  (degree),
    .clamp_i   (clamp),
    .beyond_i  (beyond),
    .data_i    ({word3, beat_data_i[95:0]}),
    .exponent_i(exponent_q),
    .numbers_o (numbers_o),
    .nan_o     (nan),
    .outside_o (outside)
  );

  // ---- what goes with them

  wire [11:0]                place;
  wire                       vertex_there;
  wire                       finish_there;
  wire                       finish_top;
  wire                       finish_final;
  wire [`FFD_EVENTS-1:0]     framing;
  wire [`FFD_EVENTS-1:0]     of_vertex;
  wire                       moving;

  // Whether bank, page or slot may hold other numbers than for the vertex before.
  reg changed_q;
  always @(posedge clk) begin
    if (rst || (take && (function_beat || point))) changed_q <= 1'b1;
    else if (take && vertex) changed_q <= 1'b0;
  end

  ffd_stream_sideband #(
    .LATENCY(LATENCY),
    .AXIS   (AXIS),
    .PAGE_W (PAGE_W),
    .PAIRS  (PAIRS)
  ) u_sideband (
    .clk             (clk),
    .rst             (rst),
    .take_i          (take),
    .last_i          (beat_last_i),
    .frame_i         (beat_frame_i),
    .verdict_i       (page_verdict),
    .empty_i         (page_empty),
    .page_i          (new_page),
    .fourth_i        (fourth),
    .pair_i          (pair),
    .load_o          (load_o),
    .place_o         (place),
    .lattice_write_o (lattice_write_o),
    .lattice_page_o  (lattice_buffer_o),
    .lattice_at_o    (lattice_at_o),
    .lattice_fourth_o(lattice_fourth_o),
    .slot_write_o    (slot_write_o),
    .slot_group_o    (slot_group_o),
    .slot_phase_o    (slot_phase_o),
    .vertex_o        (vertex_there),
    .finish_o        (finish_there),
    .top_o           (finish_top),
    .final_o         (finish_final),
    .moving_o        (moving),
    .event_o         (framing),
    .event_packet_o  (event_packet_o),
    .event_beat_o    (event_beat_o)
  );

  wire [`FFD_PLACES_W(SPANS)-1:0] places;
  wire                            sum_fault;
  ffd_stream_functions #(
    .SPANS  (SPANS),
    .LATENCY(LATENCY),
    .AXIS   (AXIS),
    .SUMS   (SUMS)
  ) u_functions (
    .clk           (clk),
    .rst           (rst),
    .take_i        (take),
    .data_i        (beat_data_i),
    .frame_i       (beat_frame_i),
    .degree_o      (degree),
    .change_o      (new_bank),
    .busy_o        (functions_busy),
    .bank_o        (bank),
    .loaded_o      (coefficients_loaded),
    .derivatives_o (derivatives_loaded),
    .sum_fault_o   (sum_fault),
    .place_there_i (place),
    .load_axis_o   (load_axis_o),
    .load_address_o(load_address_o),
    .load_shift_o  (load_shift_o),
    .cell_i        (whole_cell),
    .origin_i      (origin),
    .cell_there_i  (vertex_there),
    .places_o      (places)
  );

  // ---- vertices

  wire              position     = results_q == `FFD_RESULTS_POSITION;
  wire              no_functions = !coefficients_loaded || (!position && !derivatives_loaded);
  wire              no_lattice   = resident_q && !lattice_loaded;

  ffd_stream_vertex #(
    .FORMAT     (FORMAT),
    .SOURCE_W   (SOURCE_W),
    .SLOT_W     (SLOT_W),
    .LATENCY    (LATENCY),
    .WAITING    (WAITING),
    .EVERY_CLOCK(EVERY_CLOCK),
    .SPANS      (SPANS),
    .PAIRS      (PAIRS)
  ) u_vertex (
    .clk                 (clk),
    .rst                 (rst),
    .finish_i            (take && finish),
    .cell_i              (cell_index),
    .beyond_i            (|beyond),
    .clamp_i             (clamp),
    .refuse_i            (!clamp && mode_q != MODE_PASS),
    .no_functions_i      (no_functions),
    .no_lattice_i        (no_lattice),
    .refused_i           (beat_frame_i[`FFD_FRAME_REFUSED]),
    .tag_i               (tag),
    .source_i            (source),
    .bank_i              (bank),
    .places_i            (places),
    .changed_i           (changed_q || !resident_q),
    .results_i           (results_q),
    .half_i              (half_q),
    .exponent_i          (resident_q ? lattice_exponent : exponent_q),
    .pair_i              (pair),
    .vertex_there_i      (vertex_there),
    .finish_there_i      (finish_there),
    .top_i               (finish_top),
    .final_i             (finish_final),
    .numbers_i           (numbers_o[3*POINT_W-1:0]),
    .second_i            (numbers_o[3*POINT_W +: WEIGHT_W]),
    .nan_i               (nan),
    .outside_i           (outside),
    .held_cell_o         (slot_cell_o),
    .held_slot_o         (slot_o),
    .room_o              (room),
    .rooms_o             (rooms_o),
    .waiting_o           (waiting),
    .m_vertex_valid      (m_vertex_valid),
    .m_vertex_ready      (m_vertex_ready),
    .m_vertex_coordinates(m_vertex_coordinates),
    .m_vertex_second     (m_vertex_second),
    .m_vertex_cell       (m_vertex_cell),
    .m_vertex_source     (m_vertex_source),
    .m_vertex_bank       (m_vertex_bank),
    .m_vertex_changed    (m_vertex_changed),
    .m_vertex_results    (m_vertex_results),
    .m_vertex_exponent   (m_vertex_exponent),
    .m_vertex_user       (m_vertex_user),
    .event_o             (of_vertex)
  );

  wire [`FFD_EVENTS-1:0] of_functions = {{(`FFD_EVENTS - 1) {1'b0}}, sum_fault}
                                      << `FFD_STREAM_EVENT(`FFD_EVENT_FUNCTIONS_SUM);
  assign event_o = framing | of_vertex | of_functions;
  assign idle_o  = !any_inside && !moving;

  wire unused_ok = &{1'b0, packet, beat_second_i};
endmodule

`default_nettype wire
