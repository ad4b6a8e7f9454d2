// hwffd_stream: the evaluator between two AXI4-Streams
//
// Packets in, result beats out, in the order of the vertices: docs/interface.md. Every ready, valid
// and data bit of the streams leaves a register; with grids or packed vertices tready leaves gates.
//
// Formats:    128-bit beats, four little-endian words; words by FORMAT (interface.md section 3).
// Pipeline:   the organization's; the next vertex is loaded while the present one is evaluated.
// Freezes:    backpressure holds back vertices at the evaluator's entry (credits), then the input.
// Bad input:  nothing can hang it; see the decoder. event_o has a pulse for each kind, vertex_o one
//             for each vertex, a clock after its last result has left the evaluator; wait_o says
//             what waits (docs/interface.md); idle_o: no packet is under way, no vertex inside.
// Two units:  with RESULT_WIDTH 256, and where FFD_TWO_RESULTS, two of the four results of a vertex
//             are a beat, the first one low, and bit 1 of second_o is event 9 of the second one. A
//             beat of one result is its lower half, and bit 255 is 1.
// Pairs:      where FFD_PAIRS, two neighbours of a row of a grid with the flag H go through at
//             once; second_o has pulses for the second one with those for the first: its vertex,
//             and in bit 1 event 9 of it. Else it is 0.
// Stop:       grid_stop_i ends a grid that is under way with the next vertex.
// Parameters: a row of configurations.csv; AXIS 4 to 32, with pages to 64, the most points an axis
//             of a resident lattice; PAGES 1 to 256, 2 where there are no pages; IN_FLIGHT a power
//             of two >= 4, the most evaluations inside, 0: what ORG needs; WAITING, one >= 2, the
//             most vertices before them; RESIDENT to HALVES 0 or 1, what is built: vertices of a
//             resident lattice and with their own points, pages, a fourth component, grids, packed
//             vertices, counts and interrupts of packets, derivatives, det J, two results a beat;
//             SPANS 1 to 128, runs of cells of an axis with functions of their own; GRID_LIMIT 0 to
//             48, log2 of the most vertices of a grid; HARDENED 0, or 1: points have a parity, and
//             upset_o is a pulse for one that is wrong; BESIDE 1: a scatter core is on the same
//             stream (hwffd_adjoint), whose packets pass without an event; RESULT_WIDTH 128 or
//             256; RESET_REGISTER 0 or 1, as REGISTERED of ffd_reset_register.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module hwffd_stream #(
  parameter ORG             = 1,
  parameter N               = `FFD_ORG_N(ORG),
  parameter FORMAT          = 18,
  parameter SCHEDULE        = `FFD_SCHEDULE_OVERLAPPED,
  parameter EVALUATOR       = `FFD_EVALUATOR_ITERATIVE,
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 1,
  parameter AXIS            = 16,
  parameter PAGES           = 2,
  parameter IN_FLIGHT       = 0,
  parameter WAITING         = 16,
  parameter RESIDENT        = 1,
  parameter INTERLEAVED     = 1,
  parameter PAGED           = 0,
  parameter FOURTH          = 0,
  parameter GRIDS           = 0,
  parameter PACKED          = 0,
  parameter MARKS           = 0,
  parameter DERIVATIVES     = 0,
  parameter DETERMINANT     = 0,
  parameter HALVES          = 0,
  parameter SPANS           = 1,
  parameter GRID_LIMIT      = 48,
  parameter HARDENED        = 0,
  parameter BESIDE          = 0,
  parameter RESULT_WIDTH    = 128,
  parameter RESET_REGISTER  = 0
) (
  input  wire         aclk,
  input  wire         aresetn,
  input  wire         s_axis_tvalid,
  output wire         s_axis_tready,
  input  wire [127:0] s_axis_tdata,
  input  wire         s_axis_tlast,
  output wire         m_axis_tvalid,
  input  wire         m_axis_tready,
  output wire [RESULT_WIDTH-1:0] m_axis_tdata,
  output wire         m_axis_tlast,
  output wire         m_axis_tuser,  // with the last beat of a packet with the flag I
  input  wire         grid_stop_i,   // ends a grid that is under way
  output wire [`FFD_EVENTS-1:0] event_o,
  output wire [31:0]  event_packet_o,
  output wire [31:0]  event_beat_o,
  output wire         vertex_o,
  output wire [1:0]   second_o,      // {event 9, vertex} of a second vertex in the same clock
  output wire [2:0]   wait_o,
  output wire         idle_o,
  output wire         upset_o
);
  localparam WEIGHT_W     = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W      = `FFD_POINT_W(FORMAT);
  localparam PORTS        = `FFD_ORG_PORTS(ORG);
  // Registers around the memories of a lane, in front of those of 32 and more and of several
  // stores; not with the paper's units.
  localparam READ_LATENCY = MUL_LATENCY < 2 ? 2 : N == 1 ? 4 : N >= 32 || PORTS > 1 ? 3 : 2;
  // An organization that accumulates works on as many vertices in turn as its accumulator is deep,
  // and `cg` holds two more; one drains, one loads.
  localparam ACCUMULATE   = !`FFD_ORG_IN_TURN(ORG) ? 1
                          : FMA_LATENCY > ADD_LATENCY ? FMA_LATENCY : ADD_LATENCY;
  // Where no vertex brings its points nothing is in a slot, and 16 are enough.
  localparam SLOTS        = INTERLEAVED == 0 && ACCUMULATE > 12 ? 16 : ACCUMULATE + 4;
  localparam SLOT_W       = $clog2(SLOTS);
  // What is built, as the modules within take it.
  localparam FEATURES     = `FFD_FEATURES_NAMED;
  // Of a vertex; of an evaluation one more, and the user word another with a fourth component.
  localparam SOURCE_W     = `FFD_SOURCE_W(SLOTS, PAGES, AXIS, FEATURES);
  localparam USER_W       = `FFD_USER_W;
  localparam EVALUATIONS  = `FFD_IN_FLIGHT(IN_FLIGHT, ORG, N);
  localparam INSIDE       = `FFD_MOST_INSIDE(EVALUATIONS, WAITING);
  localparam PAIRS        = `FFD_PAIRS(ORG, FEATURES);
  localparam UNITS        = RESULT_WIDTH == 256 && `FFD_TWO_RESULTS(ORG, FEATURES) ? 2 : 1;
  localparam PART_W       = USER_W + 1 + `FFD_FEATURE_FOURTH(FEATURES) + PAIRS;
  localparam PAGE_W       = `FFD_PAGE_NUMBER_W(PAGES);
  localparam PLACE_W      = 3 * `FFD_AXIS_W(AXIS);
  // Whether functions must sum to one, here or in the scatter core beside.
  localparam SUMS         = `FFD_FUNCTIONS_SUM(ORG, EVALUATOR)
                         || (BESIDE != 0 && EVALUATOR != `FFD_EVALUATOR_POWERS) ? 1 : 0;
  // Of a read: whether it is the vertex's last, its source, and whether it may find no points.
  localparam READ_W       = SOURCE_W + 1 + HARDENED;

  generate
    if ((RESIDENT | INTERLEAVED | PAGED | FOURTH | GRIDS | PACKED | MARKS | DERIVATIVES
         | DETERMINANT | HALVES) >> 1 != 0) begin : gen_bad_features
      ERROR_hwffd_stream_features_must_be_0_or_1 u_error ();
    end
    if (RESULT_WIDTH != 128 && RESULT_WIDTH != 256) begin : gen_bad_result_width
      ERROR_hwffd_stream_result_width_must_be_128_or_256 u_error ();
    end
  endgenerate

  wire clk = aclk;
  wire rst;
  wire unused_differs;  // 0: its register is not held three times
  wire                     ingress_idle;
  wire                     slot_free;
  wire                     rooms;
  wire                     in_valid;
  wire                     in_held;
  wire                     in_go;
  wire [127:0]             in_data;
  wire                     in_last;
  wire [32:0]              in_second;
  wire [`FFD_FRAME_W-1:0]  in_frame;
  wire                     refuse;
  wire                     place_valid;
  wire [PLACE_W-1:0]       place;
  wire [PLACE_W-1:0]       tops;
  wire                     lattice_loaded;
  wire [PLACE_W-1:0]       last_cell;
  wire                     in_pairs;

  ffd_reset_register #(
    .REGISTERED(RESET_REGISTER),
    .HARDENED  (0)
  ) u_reset (
    .clk      (aclk),
    .resetn_i (aresetn),
    .rst_o    (rst),
    .differs_o(unused_differs)
  );

  ffd_channel_check #(
    .WIDTH(129)
  ) u_check_in (
    .clk      (clk),
    .rst      (rst),
    .valid_i  (s_axis_tvalid),
    .ready_i  (s_axis_tready),
    .payload_i({s_axis_tlast, s_axis_tdata})
  );

  ffd_channel_check #(
    .WIDTH(RESULT_WIDTH + 2)
  ) u_check_out (
    .clk      (clk),
    .rst      (rst),
    .valid_i  (m_axis_tvalid),
    .ready_i  (m_axis_tready),
    .payload_i({m_axis_tuser, m_axis_tlast, m_axis_tdata})
  );

  ffd_stream_packet_check u_check_packets (
    .clk        (clk),
    .rst        (rst),
    .grid_stop_i(grid_stop_i),
    .event_i    (event_o),
    .packet_i   (event_packet_o),
    .beat_i     (event_beat_o)
  );

  ffd_stream_ingress #(
    .FORMAT    (FORMAT),
    .FEATURES  (FEATURES),
    .AXIS      (AXIS),
    .SPANS     (SPANS),
    .GRID_LIMIT(GRID_LIMIT),
    .BESIDE    (BESIDE),
    .PAIRS     (PAIRS)
  ) u_ingress (
    .clk          (clk),
    .rst          (rst),
    .s_beat_valid (s_axis_tvalid),
    .s_beat_ready (s_axis_tready),
    .s_beat_data  (s_axis_tdata),
    .s_beat_last  (s_axis_tlast),
    .beat_valid_o (in_valid),
    .beat_data_o  (in_data),
    .beat_last_o  (in_last),
    .beat_second_o(in_second),
    .frame_o      (in_frame),
    .held_o       (in_held),
    .go_i         (in_go),
    .refuse_i     (refuse),
    .place_valid_i(place_valid),
    .place_i      (place),
    .tops_i       (tops),
    .slot_free_i  (slot_free),
    .rooms_i      (rooms),
    .loaded_i     (lattice_loaded),
    .last_cell_i  (last_cell),
    .pairs_i      (in_pairs),
    .grid_stop_i  (grid_stop_i),
    .idle_o       (ingress_idle)
  );

  wire [4*POINT_W-1:0]              numbers;
  wire                              load;
  wire [1:0]                        load_axis;
  wire [`FFD_OWN_W(SPANS)-1:0]      load_address;
  wire [1:0]                        load_shift;
  wire [`FFD_ENTRY_W(WEIGHT_W)-1:0] load_entry;
  wire                              lattice_write;
  wire [PAGE_W-1:0]                 lattice_buffer;
  wire [PLACE_W-1:0]                lattice_at;
  wire                              lattice_fourth;
  wire                              slot_write;
  wire [SLOT_W-1:0]                 slot;
  wire [11:0]                       slot_cell;
  wire [3:0]                        slot_group;
  wire [1:0]                        slot_phase;
  wire                              vertex_valid, vertex_ready;
  wire [3*WEIGHT_W-1:0]             vertex_coordinates;
  wire [WEIGHT_W:0]                 vertex_second;
  wire [11:0]                       vertex_cell;
  wire [SOURCE_W-1:0]               vertex_source;
  wire [`FFD_PLACES_W(SPANS)-1:0]   vertex_bank;
  wire [`FFD_EXPONENT_W-1:0]        vertex_exponent;
  wire                              vertex_changed;
  wire [1:0]                        vertex_results;
  wire [USER_W-1:0]                 vertex_user;
  wire                              part_valid, part_ready;
  wire [READ_W-1:0]                 part_source;
  wire [3*`FFD_PLACE_W(SPANS)-1:0]  part_bank;
  wire [1:0]                        part_column;
  wire                              part_fourth;
  wire [PART_W-1:0]                 part_words;
  wire [USER_W:0]                   part_user;
  wire [PORTS-1:0]                  read;
  wire [PORTS-1:0]                  read_last;
  wire [PORTS*READ_W-1:0]           read_source;
  wire [PORTS*12-1:0]               read_cell;
  wire [PORTS*6-1:0]                read_index;
  wire                              read_slot_last;
  wire [PORTS*N*3*POINT_W-1:0]      points;
  wire                              result_valid;
  wire                              result_ready;
  wire [96*UNITS-1:0]               result_words;
  wire [3*UNITS-1:0]                result_flags;
  wire                              result_two;
  wire                              result_determinant;
  wire                              result_last;
  wire                              result_fourth;
  wire                              result_pair;
  wire [97:0]                       result_second;
  wire [PART_W-1:0]                 result_words_user;
  wire [`FFD_EVENTS-1:0]            decoder_event;
  wire [1:0]                        decoder_wait;
  wire                              result_final = result_words_user[PART_W-1] && result_last;
  wire [USER_W-1:0]                 result_user  = result_words_user[USER_W-1:0];
  wire                              evaluating, decoder_idle, encoder_idle;
  wire                              leave  = result_valid && result_ready;

  wire                              saturates, second_saturates;

  // Of the bank and buffer that a vertex has read, a clock after it has left.
  reg                               retire_q, saturated_q;
  reg  [1:0]                        second_q;
  reg  [2:0]                        retire_user_q;
  always @(posedge clk) begin
    retire_q      <= leave && result_final && !rst;
    saturated_q   <= leave && saturates && !rst;
    second_q      <= {2{leave && !rst}} & {second_saturates, result_pair};
    retire_user_q <= result_user[`FFD_USER_RETIRE(USER_W)];
  end

  ffd_stream_decoder #(
    .FORMAT     (FORMAT),
    .FEATURES   (FEATURES),
    .SLOTS      (SLOTS),
    .WAITING    (WAITING),
    .EVERY_CLOCK(`FFD_RESULT_INTERVAL(ORG, N) == 1),
    .PAGES      (PAGES),
    .AXIS       (AXIS),
    .INSIDE     (INSIDE),
    .SPANS      (SPANS),
    .SUMS       (SUMS),
    .PAIRS      (PAIRS)
  ) u_decoder (
    .clk                 (clk),
    .rst                 (rst),
    .beat_valid_i        (in_valid),
    .beat_data_i         (in_data),
    .beat_last_i         (in_last),
    .beat_second_i       (in_second),
    .beat_frame_i        (in_frame),
    .beat_held_i         (in_held),
    .go_o                (in_go),
    .wait_o              (decoder_wait),
    .refuse_o            (refuse),
    .place_valid_o       (place_valid),
    .place_o             (place),
    .tops_o              (tops),
    .numbers_o           (numbers),
    .load_o              (load),
    .load_axis_o         (load_axis),
    .load_address_o      (load_address),
    .load_shift_o        (load_shift),
    .lattice_write_o     (lattice_write),
    .lattice_buffer_o    (lattice_buffer),
    .lattice_at_o        (lattice_at),
    .lattice_fourth_o    (lattice_fourth),
    .slot_write_o        (slot_write),
    .slot_o              (slot),
    .slot_cell_o         (slot_cell),
    .slot_group_o        (slot_group),
    .slot_phase_o        (slot_phase),
    .m_vertex_valid      (vertex_valid),
    .m_vertex_ready      (vertex_ready),
    .m_vertex_coordinates(vertex_coordinates),
    .m_vertex_second     (vertex_second),
    .m_vertex_cell       (vertex_cell),
    .m_vertex_source     (vertex_source),
    .m_vertex_bank       (vertex_bank),
    .m_vertex_changed    (vertex_changed),
    .m_vertex_results    (vertex_results),
    .m_vertex_exponent   (vertex_exponent),
    .m_vertex_user       (vertex_user),
    .lattice_loaded_o    (lattice_loaded),
    .last_cell_o         (last_cell),
    .pairs_o             (in_pairs),
    .slot_free_o         (slot_free),
    .rooms_o             (rooms),
    .slot_free_i         (read_slot_last),
    .evaluating_i        (evaluating),
    .retire_i            (retire_q),
    .retire_user_i       (retire_user_q),
    .event_o             (decoder_event),
    .event_packet_o      (event_packet_o),
    .event_beat_o        (event_beat_o),
    .idle_o              (decoder_idle)
  );

  assign load_entry[4*WEIGHT_W +: 2] = load_shift;
  genvar w;
  generate
    for (w = 0; w < 4; w = w + 1) begin : gen_power
      assign load_entry[w*WEIGHT_W +: WEIGHT_W] = numbers[w*POINT_W +: WEIGHT_W];
    end
  endgenerate

  // Points that no packet has written have any parity, and so have those that one is writing: of a
  // lattice that is not loaded, and of a vertex that is cut short.
  wire [READ_W-2:0] checked_source;
  generate
    if (HARDENED != 0) begin : gen_checked
      assign checked_source = {vertex_source, vertex_user[`FFD_USER_UNLOADED]
                                            || vertex_user[`FFD_USER_TRUNCATED]};
    end else begin : gen_source
      assign checked_source = vertex_source;
    end
  endgenerate

  ffd_stream_derivatives #(
    .FEATURES(FEATURES),
    .SOURCE_W(READ_W - 1),
    .USER_W  (USER_W),
    .SPANS   (SPANS),
    .JACOBIAN(`FFD_ORG_JACOBIAN(ORG))
  ) u_derivatives (
    .clk             (clk),
    .rst             (rst),
    .s_vertex_valid  (vertex_valid),
    .s_vertex_ready  (vertex_ready),
    .s_vertex_source (checked_source),
    .s_vertex_bank   (vertex_bank),
    .s_vertex_results(vertex_results),
    .s_vertex_user   (vertex_user),
    .m_vertex_valid  (part_valid),
    .m_vertex_ready  (part_ready),
    .m_vertex_source (part_source),
    .m_vertex_bank   (part_bank),
    .m_vertex_column (part_column),
    .m_vertex_fourth (part_fourth),
    .m_vertex_user   (part_user)
  );

  // {result_final, a second vertex, fourth component, that of the vertex}
  assign part_words[PART_W-1]   = part_user[USER_W];
  assign part_words[USER_W-1:0] = part_user[USER_W-1:0];
  generate
    if (`FFD_FEATURE_FOURTH(FEATURES) != 0) begin : gen_fourth
      assign part_words[USER_W] = part_fourth;
      assign result_fourth      = result_words_user[USER_W];
    end else begin : gen_no_fourth
      assign result_fourth = 1'b0;
    end
    if (PAIRS != 0) begin : gen_pairs
      assign part_words[PART_W-2] = vertex_second[WEIGHT_W];
      assign result_pair          = result_words_user[PART_W-2];
    end else begin : gen_no_pairs
      assign result_pair = 1'b0;
    end
  endgenerate

  ffd_cache_stores #(
    .FORMAT  (FORMAT),
    .FEATURES(FEATURES),
    .PORTS   (PORTS),
    .N       (N),
    .SLOTS   (SLOTS),
    .PAGES   (PAGES),
    .AXIS    (AXIS),
    .LATENCY (READ_LATENCY),
    .HARDENED(HARDENED)
  ) u_stores (
    .clk             (clk),
    .rst             (rst),
    .numbers_i       (numbers),
    .lattice_write_i (lattice_write),
    .lattice_buffer_i(lattice_buffer),
    .lattice_at_i    (lattice_at),
    .lattice_fourth_i(lattice_fourth),
    .slot_write_i    (slot_write),
    .slot_i          (slot),
    .slot_cell_i     (slot_cell),
    .slot_group_i    (slot_group),
    .slot_phase_i    (slot_phase),
    .read_i          (read),
    .read_last_i     (read_last),
    .read_source_i   (read_source),
    .read_cell_i     (read_cell),
    .read_index_i    (read_index),
    .slot_free_o     (read_slot_last),
    .points_o        (points),
    .odd_o           (upset_o)
  );

  ffd_eval_stream #(
    `include "ffd_row_arguments.vh"
    .READ_LATENCY   (READ_LATENCY),
    .SOURCE_W       (READ_W),
    .USER_W         (PART_W),
    .IN_FLIGHT      (EVALUATIONS),
    .RESULTS        (UNITS),
    .DETERMINANT    (`FFD_FEATURE_DETERMINANT(FEATURES)),
    .SPANS          (SPANS),
    .PAIRS          (PAIRS)
  ) u_evaluator (
    .clk                 (clk),
    .rst                 (rst),
    .load_i              (load),
    .load_axis_i         (load_axis),
    .load_address_i      (load_address),
    .load_entry_i        (load_entry),
    .s_vertex_valid      (part_valid),
    .s_vertex_ready      (part_ready),
    .s_vertex_coordinates(vertex_coordinates),
    .s_vertex_cell       (vertex_cell),
    .s_vertex_source     (part_source),
    .s_vertex_bank       (part_bank),
    .s_vertex_changed    (vertex_changed),
    .s_vertex_second     (vertex_second[WEIGHT_W-1:0]),
    .s_vertex_exponent   (vertex_exponent),
    .s_vertex_column     (part_column),
    .s_vertex_user       (part_words),
    .read_o              (read),
    .read_last_o         (read_last),
    .read_source_o       (read_source),
    .read_cell_o         (read_cell),
    .read_index_o        (read_index),
    .read_points_i       (points),
    .evaluating_o        (evaluating),
    .m_result_valid      (result_valid),
    .m_result_ready      (result_ready),
    .m_result_words      (result_words),
    .m_result_flags      (result_flags),
    .m_result_determinant(result_determinant),
    .m_result_two        (result_two),
    .m_result_last       (result_last),
    .m_result_user       (result_words_user),
    .m_result_second     (result_second)
  );

  wire [128*UNITS-1:0] beat;
  wire                 beat_two;
  assign m_axis_tdata[127:0] = beat[127:0];
  generate
    if (UNITS == 2) begin : gen_two
      assign m_axis_tdata[255:128] = {!beat_two, beat[254:128]};
      wire unused_beat = &{1'b0, beat[255]};  // 0: no bit of a status
    end else begin : gen_one
      if (RESULT_WIDTH == 256) begin : gen_none
        assign m_axis_tdata[255:128] = {128{1'b1}};
      end
      wire unused_beat = &{1'b0, beat_two};
    end
  endgenerate

  // The last register: a beat leaves it when it is taken, or when there was none.
  ffd_stream_encoder #(
    .FORMAT  (FORMAT),
    .FEATURES(FEATURES),
    .INSIDE  (INSIDE),
    .PAIRS   (PAIRS),
    .UNITS   (UNITS)
  ) u_encoder (
    .clk               (clk),
    .rst               (rst),
    .idle_o            (encoder_idle),
    .valid_i           (in_valid),
    .data_i            (in_data[31:0]),
    .frame_i           (in_frame),
    .s_word_valid      (result_valid),
    .s_word_ready      (result_ready),
    .saturates_o       (saturates),
    .s_word_data       (result_words),
    .s_word_flags      (result_flags),
    .s_word_determinant(result_determinant || result_fourth),
    .s_word_final      (result_final),
    .s_word_user       (result_user),
    .s_word_pair       (result_pair),
    .s_word_second     (result_second),
    .s_word_two        (result_two),
    .second_saturates_o(second_saturates),
    .m_beat_valid      (m_axis_tvalid),
    .m_beat_ready      (m_axis_tready),
    .m_beat_data       (beat),
    .m_beat_two        (beat_two),
    .m_beat_last       (m_axis_tlast),
    .m_beat_mark       (m_axis_tuser)
  );

  wire [`FFD_EVENTS-1:0] saturated = {{(`FFD_EVENTS - 1) {1'b0}}, saturated_q};
  assign event_o  = decoder_event | saturated << `FFD_EVENT_SATURATED;
  assign vertex_o = retire_q;
  assign second_o = second_q;

  assign wait_o    = {1'b0, decoder_wait};
  assign idle_o    = ingress_idle && decoder_idle && encoder_idle;
  wire unused_ok = &{1'b0, part_fourth, vertex_second};
endmodule

`default_nettype wire
