// ffd_stream_decoder: framed beats become coefficients, control points and vertices
//
// Coefficients and lattices are loaded into the bank and the buffer that are not in use, which come
// into use with the last beat. The header waits until no vertex inside reads them: vertices before
// it see the old, after it the new. The points of an interleaved vertex go into a free slot.
//
// All four words of a beat pass one row of converters. What belongs to it goes with it, and is then
// written, or offered as a vertex.
//
// Bad input:  banks and buffers cut short never come into use. Each event is a pulse of event_o
//             (FFD_EVENT_*) with the packet's number since reset and the beat's in it.
// Formats:    frame as FFD_FRAME_*; numbers_o weights or points, one a word of the beat; source
//             {resident, slot or buffer}; changed: points or coefficients were loaded since the
//             vertex before; user as FFD_USER_*. Vertices have their points' exponent.
// Pipeline:   FFD_IN_LATENCY to numbers_o and the writes; a vertex is offered 3 clocks behind those
//             of its last beat. II 1 resident, 49 interleaved.
// Freezes:    never: it takes what comes. A beat that may have to wait comes when go_o was 1: its
//             bank or buffer is free, there is a slot, and room for the end of a vertex: WAITING
//             are converted or wait for the evaluator. A vertex that starts where slot_free_o is 1,
//             or ends where rooms_o is, may come in the next clock.
// Parameters: FORMAT as in ffd_num.vh, FEATURES as in ffd_stream.vh, SLOTS >= 2, WAITING a power of
//             two >= 2, EVERY_CLOCK as in ffd_stream_vertex, SPANS in ffd_stream_functions.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module ffd_stream_decoder #(
  parameter FORMAT      = 18,
  parameter FEATURES    = `FFD_FEATURES,
  parameter SLOTS       = 3,
  parameter SLOT_W      = $clog2(SLOTS),
  parameter WAITING     = 16,
  parameter EVERY_CLOCK = 1,
  parameter SPANS       = 1
) (
  input  wire                                 clk,
  input  wire                                 rst,
  input  wire                                 beat_valid_i,
  input  wire [127:0]                         beat_data_i,
  input  wire                                 beat_last_i,
  input  wire [`FFD_FRAME_W-1:0]              beat_frame_i,
  output wire                                 go_o,
  output wire [4*`FFD_POINT_W(FORMAT)-1:0]    numbers_o,
  output wire                                 load_o,
  output wire [1:0]                           load_axis_o,
  output wire [`FFD_OWN_W(SPANS)-1:0]         load_address_o,
  output wire [1:0]                           load_shift_o,
  output wire                                 lattice_write_o,
  output wire                                 lattice_buffer_o,
  output wire [11:0]                          lattice_at_o,
  output wire                                 slot_write_o,
  output wire [SLOT_W-1:0]                    slot_o,
  output wire [11:0]                          slot_cell_o,
  output wire [3:0]                           slot_group_o,
  output wire [1:0]                           slot_phase_o,
  output wire                                 m_vertex_valid,
  input  wire                                 m_vertex_ready,
  output wire [3*`FFD_WEIGHT_W(FORMAT)-1:0]   m_vertex_coordinates,
  output wire [11:0]                          m_vertex_cell,
  output wire [SLOT_W:0]                      m_vertex_source,
  output wire [`FFD_PLACES_W(SPANS)-1:0]      m_vertex_bank,
  output wire                                 m_vertex_changed,
  output wire [1:0]                           m_vertex_results,
  output wire [`FFD_EXPONENT_W-1:0]           m_vertex_exponent,
  output wire [`FFD_USER_W-1:0]               m_vertex_user,
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
  localparam LATENCY   = `FFD_IN_LATENCY(FORMAT);
  localparam EXPONENT_W = `FFD_EXPONENT_W;
  localparam [1:0] MODE_CLAMP = 2'd0;
  localparam [1:0] MODE_PASS  = 2'd1;

  wire        take     = beat_valid_i;
  wire        header   = beat_frame_i[`FFD_FRAME_HEADER];
  wire        function_beat = beat_frame_i[`FFD_FRAME_FUNCTION];
  wire        point    = beat_frame_i[`FFD_FRAME_POINT];
  wire        vertex   = beat_frame_i[`FFD_FRAME_VERTEX];
  wire        points   = beat_frame_i[`FFD_FRAME_POINTS];
  wire        top      = beat_frame_i[`FFD_FRAME_TOP];
  wire        finish   = beat_frame_i[`FFD_FRAME_FINISH];
  wire [11:0] index    = beat_frame_i[`FFD_FRAME_INDEX];

  // ---- what the header says

  reg                   resident_q;
  reg  [1:0]            mode_q;
  reg  [1:0]            results_q;
  reg  [11:0]           new_last_cell_q;
  reg  [EXPONENT_W-1:0] exponent_q;
  always @(posedge clk) begin
    if (take && header) begin
      resident_q         <= beat_data_i[0];  // opcode 3, not 4
      mode_q             <= beat_data_i[65:64];
      results_q          <= beat_data_i[73:72];
      new_last_cell_q    <= {beat_data_i[83:80] - 4'd4, beat_data_i[75:72] - 4'd4,
                             beat_data_i[67:64] - 4'd4};
      exponent_q         <= beat_data_i[96 +: EXPONENT_W]
                          & {EXPONENT_W{`FFD_FORMAT_BLOCK(FORMAT)}};
    end
  end

  // ---- what is in use

  wire                  bank;
  wire                  coefficients_loaded;
  wire                  derivatives_loaded;
  reg                   buffer_q;
  reg                   lattice_loaded_q;
  reg  [11:0]           last_cell_q;
  reg  [EXPONENT_W-1:0] lattice_exponent_q;
  wire                  new_bank;
  wire                  new_buffer = take && point && top;

  always @(posedge clk) begin
    if (rst) begin
      buffer_q         <= 1'b0;
      lattice_loaded_q <= 1'b0;
    end else if (new_buffer) begin
      buffer_q         <= !buffer_q;
      lattice_loaded_q <= 1'b1;
    end
  end
  always @(posedge clk) begin
    if (new_buffer) begin
      last_cell_q        <= new_last_cell_q;
      lattice_exponent_q <= exponent_q;
    end
  end

  // ---- when a beat may come

  wire bank_busy;
  wire functions_busy;
  wire buffer_busy;
  wire slot_free;
  wire room;
  assign go_o = !(beat_frame_i[`FFD_FRAME_BANK] && (bank_busy || functions_busy))
             && !(beat_frame_i[`FFD_FRAME_BUFFER] && buffer_busy)
             && !(vertex && !resident_q && !slot_free)
             && !(finish && !room);

  assign slot_free_o = slot_free;
  wire [SLOT_W-1:0] slot;
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
    .buffer_i       (buffer_q),
    .inside_i       (any_inside),
    .bank_busy_o    (bank_busy),
    .buffer_busy_o  (buffer_busy)
  );

  generate
    if (`FFD_FEATURE_INTERLEAVED(FEATURES) != 0) begin : gen_slots
      ffd_stream_slots #(
        .SLOTS(SLOTS)
      ) u_slots (
        .clk    (clk),
        .rst    (rst),
        .claim_i(take && vertex && !resident_q),
        .next_i (take && finish && !resident_q),
        .free_i (slot_free_i),
        .slot_o (slot),
        .free_o (slot_free)
      );
    end else begin : gen_no_slots
      assign slot      = {SLOT_W{1'b0}};
      assign slot_free = 1'b1;
      wire unused_ok = &{1'b0, slot_free_i};
    end
  endgenerate

  // ---- numbers

  wire       clamp   = mode_q == MODE_CLAMP;
  wire [1:0] role    = function_beat ? `FFD_ROLE_COEFFICIENT
                     : vertex        ? `FFD_ROLE_COORDINATE : `FFD_ROLE_POINT;
  wire [1:0] degree;
  wire       bounded = resident_q && lattice_loaded_q;
  wire [2:0] beyond;
  wire [3:0] nan;
  wire [3:0] outside;
  wire [11:0] cell_index;

  genvar w;
  generate
    for (w = 0; w < 4; w = w + 1) begin : gen_word
      localparam [3:0] ABOVE = (1 << w) - 1;  // the degrees that this power is above
      wire at_end;
      if (w < 3) begin : gen_axis
        wire [3:0] asked = beat_data_i[112+4*w +: 4];
        wire [3:0] last  = last_cell_q[4*w +: 4];
        assign beyond[w] = bounded && asked > last;
        assign cell_index[4*w +: 4] = beyond[w] ? last : asked;
        assign at_end = beyond[w];
      end else begin : gen_no_axis
        assign at_end = 1'b0;
      end
      ffd_num_in #(
        .FORMAT (FORMAT),
        .LATENCY(LATENCY)
      ) u_in (
        .clk       (clk),
        .role_i    (role),
        .clear_i   (function_beat && ABOVE[degree]),
        .clamp_i   (clamp),
        .one_i     (at_end),
        .word_i    (beat_data_i[32*w +: 32]),
        .exponent_i(exponent_q),
        .number_o  (numbers_o[w*POINT_W +: POINT_W]),
        .nan_o     (nan[w]),
        .outside_o (outside[w])
      );
    end
  endgenerate

  // ---- what goes with them

  wire       taken;
  wire       taken_last;
  wire [4:0] framing;  // span, size, long, short, unknown
  wire       vertex_there;
  wire       finish_there;
  wire       finish_top;
  wire       finish_final;

  // Whether bank, buffer or slot may hold other numbers than for the vertex before.
  reg changed_q;
  always @(posedge clk) begin
    if (rst || (take && (function_beat || point))) changed_q <= 1'b1;
    else if (take && vertex) changed_q <= 1'b0;
  end

  ffd_num_delay #(
    .WIDTH  (11),
    .LATENCY(LATENCY),
    .RESET  (1)
  ) u_taken (
    .clk(clk),
    .rst(rst),
    .d_i({take, take && function_beat, take && point, take && points, take && vertex,
          take && finish, {5{take}} & {beat_frame_i[`FFD_FRAME_SPAN], beat_frame_i[`FFD_FRAME_SIZE],
          beat_frame_i[`FFD_FRAME_LONG], beat_frame_i[`FFD_FRAME_SHORT],
          beat_frame_i[`FFD_FRAME_UNKNOWN]}}),
    .q_o({taken, load_o, lattice_write_o, slot_write_o, vertex_there, finish_there, framing})
  );

  ffd_num_delay #(
    .WIDTH  (3 + 12 + 1),
    .LATENCY(LATENCY)
  ) u_place (
    .clk(clk),
    .rst(1'b0),
    .d_i({beat_last_i, points && top, beat_frame_i[`FFD_FRAME_FINAL], index, !buffer_q}),
    .q_o({taken_last, finish_top, finish_final, lattice_at_o[3:0], lattice_at_o[7:4],
          lattice_at_o[11:8], lattice_buffer_o})
  );

  // Digits of a lattice are k, j, i from the lowest on: the delay has turned them round.
  assign slot_group_o = lattice_at_o[7:4];
  assign slot_phase_o = lattice_at_o[9:8];

  wire [11:0]                     known_cell;
  wire [`FFD_PLACES_W(SPANS)-1:0] places;
  ffd_stream_functions #(
    .SPANS  (SPANS),
    .LATENCY(LATENCY)
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
    .place_there_i (lattice_at_o),
    .load_axis_o   (load_axis_o),
    .load_address_o(load_address_o),
    .load_shift_o  (load_shift_o),
    .cell_valid_i  (vertex_there),
    .cell_i        (known_cell),
    .places_o      (places)
  );

  // ---- vertices

  wire              position     = results_q == `FFD_RESULTS_POSITION;
  wire              no_functions = !coefficients_loaded || (!position && !derivatives_loaded);
  wire              no_lattice   = resident_q && !lattice_loaded_q;
  wire [SLOT_W-1:0] at_buffer    = {{(SLOT_W - 1) {1'b0}}, buffer_q};
  wire              nan_event;
  wire              outside_event;
  wire              beyond_event;
  wire              functions_event;
  wire              lattice_event;

  ffd_stream_vertex #(
    .FORMAT     (FORMAT),
    .SOURCE_W   (SLOT_W + 1),
    .LATENCY    (LATENCY),
    .WAITING    (WAITING),
    .EVERY_CLOCK(EVERY_CLOCK),
    .SPANS      (SPANS)
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
    .tag_i               (beat_data_i[111:96]),
    .source_i            ({resident_q, resident_q ? at_buffer : slot}),
    .bank_i              (bank),
    .places_i            (places),
    .changed_i           (changed_q || !resident_q),
    .results_i           (results_q),
    .exponent_i          (resident_q ? lattice_exponent_q : exponent_q),
    .vertex_there_i      (vertex_there),
    .finish_there_i      (finish_there),
    .top_i               (finish_top),
    .final_i             (finish_final),
    .numbers_i           (numbers_o[3*POINT_W-1:0]),
    .nan_i               (|nan[2:0]),
    .outside_i           (|outside[2:0]),
    .known_cell_o        (known_cell),
    .held_cell_o         (slot_cell_o),
    .held_slot_o         (slot_o),
    .room_o              (room),
    .rooms_o             (rooms_o),
    .waiting_o           (waiting),
    .m_vertex_valid      (m_vertex_valid),
    .m_vertex_ready      (m_vertex_ready),
    .m_vertex_coordinates(m_vertex_coordinates),
    .m_vertex_cell       (m_vertex_cell),
    .m_vertex_source     (m_vertex_source),
    .m_vertex_bank       (m_vertex_bank),
    .m_vertex_changed    (m_vertex_changed),
    .m_vertex_results    (m_vertex_results),
    .m_vertex_exponent   (m_vertex_exponent),
    .m_vertex_user       (m_vertex_user),
    .nan_o               (nan_event),
    .outside_o           (outside_event),
    .beyond_o            (beyond_event),
    .no_functions_o      (functions_event),
    .no_lattice_o        (lattice_event)
  );

  // ---- events

  // In the order of their bits; saturated is the result's.
  assign event_o = {2'd0, framing[4], 1'd0, 1'b0, outside_event, nan_event, beyond_event, framing[3],
                    lattice_event, functions_event, framing[2:0]};

  ffd_stream_place u_event_place (
    .clk     (clk),
    .rst     (rst),
    .take_i  (taken),
    .last_i  (taken_last),
    .packet_o(event_packet_o),
    .beat_o  (event_beat_o)
  );

  reg [LATENCY:0] moving_q;  // what has been taken is known behind the converters
  always @(posedge clk) moving_q <= rst ? {(LATENCY + 1) {1'b0}} : {moving_q[LATENCY-1:0], take};

  assign idle_o = !any_inside && moving_q == {(LATENCY + 1) {1'b0}};

  wire unused_ok = &{1'b0, nan[3], outside[3]};
endmodule

`default_nettype wire
