// ffd_stream_decoder: packets become coefficients, control points and vertices
//
// A packet is a header beat and its payload, ended by tlast (docs/interface.md section 2):
//   1 coefficients   12 beats, one a blending function, or 24 with their derivatives
//   2 lattice        a beat a control point
//   3 vertices       count beats, one a vertex of the resident lattice
//   4 interleaved    count vertices of 49 beats: the vertex, then its 64 points into a free slot
// Coefficients and lattices are loaded into the bank and the buffer that are not in use, which come
// into use with the last beat. The header waits until no vertex inside reads them: vertices before
// it see the old, after it the new.
//
// Bad input:  an unknown opcode or kind of results, bad dimensions, and beats after a packet's end
//             are dropped up to tlast. A tlast inside a vertex ends it: it goes on marked
//             truncated. Banks and buffers cut short never come into use. Each event is a pulse of
//             event_o (FFD_EVENT_*) with the packet's number since reset and the beat's in it.
// Formats:    kind is that of ffd_stream_header, of the same beat; coefficients leave as weights of
//             FORMAT; source {resident, slot or
//             buffer}; changed: points or coefficients were loaded since the vertex before; user
//             {resident, buffer, bank, that of ffd_stream_vertex}. The exponent of points comes in
//             the header of opcodes 2 and 4 and goes with each of their vertices.
// Pipeline:   a vertex leaves in the clock after its last beat; II 1 resident, 49 interleaved.
// Freezes:    s_beat_ready is 0 when a header waits for its bank or buffer, a vertex for a slot, or
//             a finished vertex for the one before it.
// Parameters: FORMAT as in ffd_num.vh, SLOTS >= 2, IN_FLIGHT the most vertices behind the decoder.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module ffd_stream_decoder #(
  parameter FORMAT    = 18,
  parameter SLOTS     = 3,
  parameter SLOT_W    = $clog2(SLOTS),
  parameter IN_FLIGHT = 16
) (
  input  wire                                            clk,
  input  wire                                            rst,
  input  wire                                            s_beat_valid,
  output reg                                             s_beat_ready,
  input  wire [127:0]                                    s_beat_data,
  input  wire [`FFD_KIND_W-1:0]                          s_beat_kind,
  input  wire                                            s_beat_last,
  output wire                                            load_o,
  output wire [1:0]                                      load_axis_o,
  output wire [3:0]                                      load_address_o,
  output wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_o,
  output wire                                            lattice_write_o,
  output wire                                            lattice_buffer_o,
  output wire [11:0]                                     lattice_at_o,
  output wire [95:0]                                     lattice_words_o,
  output wire                                            slot_write_o,
  output wire [SLOT_W-1:0]                               slot_o,
  output wire [11:0]                                     slot_cell_o,
  output wire [3:0]                                      slot_group_o,
  output wire [1:0]                                      slot_phase_o,
  output wire [127:0]                                    slot_words_o,
  output reg  [`FFD_EXPONENT_W-1:0]                      write_exponent_o,
  output wire                                            m_vertex_valid,
  input  wire                                            m_vertex_ready,
  output wire [95:0]                                     m_vertex_coordinates,
  output wire [11:0]                                     m_vertex_cell,
  output wire [SLOT_W:0]                                 m_vertex_source,
  output wire                                            m_vertex_bank,
  output wire                                            m_vertex_changed,
  output wire [1:0]                                      m_vertex_results,
  output wire [`FFD_EXPONENT_W-1:0]                      m_vertex_exponent,
  output wire [`FFD_USER_W-1:0]                          m_vertex_user,
  input  wire                                            slot_free_i,
  input  wire                                            retire_i,
  input  wire [2:0]                                      retire_user_i,
  output wire [`FFD_EVENTS-1:0]                          event_o,
  output reg  [31:0]                                     event_packet_o,
  output reg  [31:0]                                     event_beat_o,
  output wire                                            idle_o
);
  localparam [2:0] HEADER       = 3'd0;
  localparam [2:0] COEFFICIENTS = 3'd1;
  localparam [2:0] LATTICE      = 3'd2;
  localparam [2:0] VERTEX       = 3'd3;
  localparam [2:0] POINTS       = 3'd4;
  localparam [2:0] DONE         = 3'd5;
  localparam [2:0] DROP         = 3'd6;

  localparam [1:0] LAST_PHASE = 2'd2;

  reg  [2:0]  state_q;
  reg  [3:0]  group_q;
  reg  [1:0]  phase_q;
  reg  [31:0] count_q;
  reg         resident_q;
  reg  [1:0]  results_q;
  wire        take            = s_beat_valid && s_beat_ready;
  wire        header          = take && state_q == HEADER;
  wire [31:0] count           = s_beat_data[63:32];
  wire        is_coefficients = s_beat_kind[`FFD_KIND_COEFFICIENTS];
  wire        is_lattice      = s_beat_kind[`FFD_KIND_LATTICE];
  wire        good_lattice    = s_beat_kind[`FFD_KIND_DIMENSIONS];
  wire [1:0]  results         = s_beat_data[73:72];
  wire        is_vertices     = s_beat_kind[`FFD_KIND_VERTICES];
  wire        is_interleaved  = s_beat_kind[`FFD_KIND_INTERLEAVED];
  wire        some            = s_beat_kind[`FFD_KIND_SOME];
  wire        known           = is_coefficients || is_lattice || is_vertices || is_interleaved;
  wire        last_phase      = phase_q == LAST_PHASE;
  wire        last_point      = &group_q && last_phase;
  wire        last_vertex     = count_q == 32'd1;
  wire        last_function;
  wire        last_of_lattice;

  // The last beat of a vertex: its own, its last point, or a tlast that comes too early.
  wire vertex_ends = (state_q == VERTEX && (resident_q || s_beat_last)) ||
                     (state_q == POINTS && (last_point || s_beat_last));
  wire finish      = take && vertex_ends;
  wire truncated   = state_q == VERTEX ? !resident_q : !last_point;

  // ---- where the next beat belongs

  reg [2:0] state_d;
  always @* begin
    state_d = state_q;
    case (state_q)
      HEADER:
        if (is_coefficients) state_d = COEFFICIENTS;
        else if (is_lattice && good_lattice) state_d = LATTICE;
        else if ((is_vertices || is_interleaved) && some) state_d = VERTEX;
        else state_d = DROP;
      COEFFICIENTS: if (last_function) state_d = DONE;
      LATTICE:      if (last_of_lattice) state_d = DONE;
      VERTEX:       state_d = !resident_q ? POINTS : last_vertex ? DONE : VERTEX;
      POINTS:       if (last_point) state_d = last_vertex ? DONE : VERTEX;
      default:      state_d = DROP;
    endcase
  end
  wire complete = state_d == DONE;

  always @(posedge clk) begin
    if (rst) state_q <= HEADER;
    else if (take) state_q <= s_beat_last ? HEADER : state_d;
  end

  // Points come in groups of four, three beats each.
  always @(posedge clk) begin
    if (take) begin
      if (state_q != POINTS) begin
        group_q <= 4'd0;
        phase_q <= 2'd0;
      end else begin
        if (last_phase) group_q <= group_q + 4'd1;
        phase_q <= last_phase ? 2'd0 : phase_q + 2'd1;
      end
      if (state_q == HEADER) begin
        count_q    <= count;
        resident_q <= is_vertices;
        results_q  <= results;
      end else if (finish) begin
        count_q <= count_q - 32'd1;
      end
    end
  end

  // The exponent of the points that this packet brings, where there is such a thing.
  wire [`FFD_EXPONENT_W-1:0] exponent = s_beat_data[96 +: `FFD_EXPONENT_W]
                                      & {`FFD_EXPONENT_W{`FFD_FORMAT_BLOCK(FORMAT)}};
  always @(posedge clk) begin
    if (header) write_exponent_o <= exponent;
  end

  // ---- when it may come

  wire [1:0] bank_busy;
  wire [1:0] buffer_busy;
  wire       bank;
  wire       buffer;
  wire       slot_free;
  wire       room = !m_vertex_valid || m_vertex_ready;

  always @* begin
    case (state_q)
      HEADER:
        s_beat_ready = is_coefficients ? !bank_busy[!bank]
                     : !is_lattice || !good_lattice || !buffer_busy[!buffer];
      VERTEX:  s_beat_ready = (resident_q || slot_free) && (!vertex_ends || room);
      POINTS:  s_beat_ready = !vertex_ends || room;
      default: s_beat_ready = 1'b1;
    endcase
  end

  // ---- coefficients and lattice

  wire coefficients_loaded;
  wire derivatives_loaded;
  ffd_stream_coefficients #(
    .FORMAT(FORMAT)
  ) u_coefficients (
    .clk           (clk),
    .rst           (rst),
    .header_i      (header),
    .beat_i        (take && state_q == COEFFICIENTS),
    .data_i        (s_beat_data),
    .last_o        (last_function),
    .load_o        (load_o),
    .load_axis_o   (load_axis_o),
    .load_address_o(load_address_o),
    .load_entry_o  (load_entry_o),
    .bank_o        (bank),
    .loaded_o      (coefficients_loaded),
    .derivatives_o (derivatives_loaded)
  );

  wire                       lattice_loaded;
  wire [11:0]                last_cell;
  wire [`FFD_EXPONENT_W-1:0] lattice_exponent;
  ffd_stream_lattice u_lattice (
    .clk           (clk),
    .rst           (rst),
    .header_i      (header),
    .beat_i        (take && state_q == LATTICE),
    .data_i        (s_beat_data),
    .exponent_i    (write_exponent_o),
    .last_o        (last_of_lattice),
    .write_o       (lattice_write_o),
    .write_buffer_o(lattice_buffer_o),
    .write_at_o    (lattice_at_o),
    .write_words_o (lattice_words_o),
    .buffer_o      (buffer),
    .loaded_o      (lattice_loaded),
    .last_cell_o   (last_cell),
    .exponent_o    (lattice_exponent)
  );

  // Vertices that have not retired: those behind the decoder and the one it offers.
  ffd_stream_readers #(
    .MOST(IN_FLIGHT + 1)
  ) u_bank_readers (
    .clk         (clk),
    .rst         (rst),
    .enter_i     (finish),
    .enter_bank_i(bank),
    .leave_i     (retire_i),
    .leave_bank_i(retire_user_i[`FFD_RETIRE_BANK]),
    .busy_o      (bank_busy)
  );

  ffd_stream_readers #(
    .MOST(IN_FLIGHT + 1)
  ) u_buffer_readers (
    .clk         (clk),
    .rst         (rst),
    .enter_i     (finish && resident_q),
    .enter_bank_i(buffer),
    .leave_i     (retire_i && retire_user_i[`FFD_RETIRE_RESIDENT]),
    .leave_bank_i(retire_user_i[`FFD_RETIRE_BUFFER]),
    .busy_o      (buffer_busy)
  );

  // ---- slots: handed out and freed in turn, because vertices keep their order

  localparam              TOP       = SLOTS - 1;
  localparam [SLOT_W-1:0] LAST_SLOT = TOP[SLOT_W-1:0];
  localparam [SLOT_W:0]   ALL_SLOTS = SLOTS[SLOT_W:0];
  reg  [SLOT_W-1:0] slot_q;
  reg  [SLOT_W:0]   used_q;
  wire              vertex = take && state_q == VERTEX;
  wire              claim  = vertex && !resident_q;
  assign slot_free = used_q != ALL_SLOTS;

  always @(posedge clk) begin
    if (rst) begin
      slot_q <= {SLOT_W{1'b0}};
      used_q <= {(SLOT_W + 1) {1'b0}};
    end else begin
      if (finish && !resident_q) slot_q <= slot_q == LAST_SLOT ? {SLOT_W{1'b0}} : slot_q + 1'b1;
      used_q <= used_q + {{SLOT_W{1'b0}}, claim} - {{SLOT_W{1'b0}}, slot_free_i};
    end
  end

  assign slot_write_o = take && state_q == POINTS;
  assign slot_o       = slot_q;
  assign slot_group_o = group_q;
  assign slot_phase_o = phase_q;
  assign slot_words_o = s_beat_data;

  // ---- vertices

  wire [SLOT_W-1:0] buffer_source = {{(SLOT_W - 1) {1'b0}}, buffer};
  wire [23:0]       vertex_user;
  wire              position = results_q == `FFD_RESULTS_POSITION;
  wire              no_functions = !coefficients_loaded || (!position && !derivatives_loaded);
  wire              unloaded = no_functions || (resident_q && !lattice_loaded);
  wire              nan;
  wire              outside;
  wire              cell_outside;

  // Whether bank, buffer or slot may hold other numbers than for the vertex before.
  reg changed_q;
  always @(posedge clk) begin
    if (rst || load_o || lattice_write_o) changed_q <= 1'b1;
    else if (finish) changed_q <= 1'b0;
  end

  ffd_stream_vertex #(
    .FORMAT  (FORMAT),
    .SOURCE_W(SLOT_W + 1)
  ) u_vertex (
    .clk                 (clk),
    .rst                 (rst),
    .header_i            (header),
    .vertex_i            (state_q == VERTEX),
    .finish_i            (finish),
    .data_i              (s_beat_data),
    .bounded_i           (resident_q && lattice_loaded),
    .last_cell_i         (last_cell),
    .truncated_i         (truncated),
    .unloaded_i          (unloaded),
    .last_i              (last_vertex || s_beat_last),
    .source_i            ({resident_q, resident_q ? buffer_source : slot_q}),
    .bank_i              (bank),
    .changed_i           (changed_q || !resident_q),
    .results_i           (results_q),
    .exponent_i          (resident_q ? lattice_exponent : write_exponent_o),
    .cell_o              (slot_cell_o),
    .m_vertex_valid      (m_vertex_valid),
    .m_vertex_ready      (m_vertex_ready),
    .m_vertex_coordinates(m_vertex_coordinates),
    .m_vertex_cell       (m_vertex_cell),
    .m_vertex_source     (m_vertex_source),
    .m_vertex_bank       (m_vertex_bank),
    .m_vertex_changed    (m_vertex_changed),
    .m_vertex_results    (m_vertex_results),
    .m_vertex_exponent   (m_vertex_exponent),
    .m_vertex_user       (vertex_user),
    .nan_o               (nan),
    .outside_o           (outside),
    .cell_outside_o      (cell_outside)
  );

  // The buffer is that bit of the source where there is one.
  assign m_vertex_user = {m_vertex_source[SLOT_W], m_vertex_source[0], m_vertex_bank, vertex_user};

  // ---- events

  wire payload    = state_q != HEADER && state_q != DONE && state_q != DROP;
  wire refused    = !known || (is_lattice && !good_lattice);
  wire no_vertex  = (is_vertices || is_interleaved) && !some;
  wire ends_short = (take && payload && s_beat_last && !complete) ||
                    (header && !refused && (s_beat_last || no_vertex));
  assign event_o[`FFD_EVENT_UNKNOWN_OPCODE]       = header && !known;
  assign event_o[`FFD_EVENT_PACKET_SHORT]        = ends_short;
  assign event_o[`FFD_EVENT_PACKET_LONG]         = take && state_q == DONE;
  assign event_o[`FFD_EVENT_NO_COEFFICIENTS] = finish && no_functions;
  assign event_o[`FFD_EVENT_NO_LATTICE]      = finish && resident_q && !lattice_loaded;
  assign event_o[`FFD_EVENT_LATTICE_SIZE]   = header && is_lattice && !good_lattice;
  assign event_o[`FFD_EVENT_CELL_OUTSIDE]         = cell_outside;
  assign event_o[`FFD_EVENT_COORDINATE_NAN]          = nan;
  assign event_o[`FFD_EVENT_COORDINATE_OUTSIDE]   = outside;

  always @(posedge clk) begin
    if (rst) begin
      event_packet_o <= 32'd0;
      event_beat_o   <= 32'd0;
    end else if (take) begin
      if (s_beat_last) event_packet_o <= event_packet_o + 32'd1;
      event_beat_o <= s_beat_last ? 32'd0 : event_beat_o + 32'd1;
    end
  end

  assign idle_o = state_q == HEADER && !m_vertex_valid && bank_busy == 2'd0;
endmodule

`default_nettype wire
