// ffd_board_core: hwffd_stream for a small chip: positions in a resident lattice, one at a time
//
// The packets and results of docs/interface.md, and the same parts, but for what costs most where
// small memories are flip-flops:
//   no queues          a vertex enters when the sum of the one before has gone on to be sent
//   positions only     packets of interleaved vertices, and of vertices that want more than their
//                      position, are dropped as one with an unknown opcode is; derivatives that
//                      come with coefficients are not kept
//   one bank of        the header of coefficients waits until no vertex is inside; after a packet
//   coefficients       cut short vertices are blank, marked unloaded, until a whole one came
//
// Formats:    128-bit beats, four little-endian 32-bit words; words by FORMAT (interface.md,
//             section 3).
// Pipeline:   decoder | organization | sum, until the result before has left | sum, until its own
//             result has left; converted there, so CONVERT_LATENCY is of the organization only.
// Freezes:    a result that is not taken holds back the next vertex, then the input.
// Not checked: nothing on the input can hang it; what it does with bad packets is in the decoder.
// Parameters: a row of configurations.csv; AXIS 4 to 16, the most points an axis of a lattice.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/boards.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module ffd_board_core #(
  parameter ORG             = 0,
  parameter N               = 1,
  parameter FORMAT          = 16,
  parameter SCHEDULE        = `FFD_SCHEDULE_OVERLAPPED,
  parameter EVALUATOR       = `FFD_EVALUATOR_ITERATIVE,
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 1,
  parameter AXIS            = 4
) (
  input  wire         clk,
  input  wire         rst,
  input  wire         s_beat_valid,
  output wire         s_beat_ready,
  input  wire [127:0] s_beat_data,
  input  wire         s_beat_last,
  output reg          m_beat_valid,
  input  wire         m_beat_ready,
  output wire [127:0] m_beat_data,
  output wire         m_beat_last
);
  localparam WEIGHT_W     = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W      = `FFD_POINT_W(FORMAT);
  localparam SUM_W        = `FFD_SUM_W(FORMAT);
  localparam USER_W       = `FFD_USER_W;
  localparam READ_LATENCY = 2;
  localparam SLOTS        = 2;  // of interleaved vertices: none comes so far
  localparam SOURCE_W     = 2;
  localparam UNLOADED     = `FFD_USER_UNLOADED;
  localparam BLANK        = `FFD_USER_BLANK;

  localparam [7:0] OPCODE_NONE         = 8'd0;
  localparam [7:0] OPCODE_COEFFICIENTS = 8'd1;
  localparam [7:0] OPCODE_VERTICES     = 8'd3;
  localparam [7:0] OPCODE_INTERLEAVED  = 8'd4;

  // ---- headers: of what this core does not do, and of coefficients, which wait

  reg        header_q;
  reg        inside_q;
  wire       vertex_valid;
  wire       beat_ready;
  wire [7:0] opcode   = s_beat_data[7:0];
  wire       position = s_beat_data[73:72] == `FFD_RESULTS_POSITION;
  wire       refused  = opcode == OPCODE_INTERLEAVED || (opcode == OPCODE_VERTICES && !position);
  wire [7:0] lowest   = header_q && refused ? OPCODE_NONE : opcode;
  wire       hold     = header_q && opcode == OPCODE_COEFFICIENTS && (inside_q || vertex_valid);

  assign s_beat_ready = beat_ready && !hold;

  always @(posedge clk) begin
    if (rst) header_q <= 1'b1;
    else if (s_beat_valid && s_beat_ready) header_q <= s_beat_last;
  end

  wire                              load;
  wire [1:0]                        load_axis;
  wire [3:0]                        load_address;
  wire [`FFD_ENTRY_W(WEIGHT_W)-1:0] load_entry;
  wire                              lattice_write;
  wire                              lattice_buffer;
  wire [11:0]                       lattice_at;
  wire [95:0]                       lattice_words;
  wire [`FFD_EXPONENT_W-1:0]        write_exponent;
  wire                              slot_write;
  wire [0:0]                        slot;
  wire [11:0]                       slot_cell;
  wire [3:0]                        slot_group;
  wire [1:0]                        slot_phase;
  wire [127:0]                      slot_words;
  wire                              vertex_ready;
  wire [95:0]                       vertex_words;
  wire [11:0]                       vertex_cell;
  wire [SOURCE_W-1:0]               vertex_source;
  wire                              vertex_bank;
  wire                              vertex_changed;
  wire [1:0]                        vertex_results;
  wire [`FFD_EXPONENT_W-1:0]        vertex_exponent;
  wire [USER_W-1:0]                 vertex_user;
  wire [`FFD_EVENTS-1:0]            events;
  wire [31:0]                       event_packet;
  wire [31:0]                       event_beat;
  wire                              idle;
  wire                              leave = m_beat_valid && m_beat_ready;
  reg  [USER_W-1:0]                 user_q;
  reg  [USER_W-1:0]                 sent_user_q;

  wire [127:0]           beat_data = {s_beat_data[127:8], lowest};
  wire [`FFD_KIND_W-1:0] beat_kind;

  ffd_stream_header #(
    .AXIS(AXIS)
  ) u_header (
    .data_i(beat_data),
    .kind_o(beat_kind)
  );

  ffd_stream_decoder #(
    .FORMAT   (FORMAT),
    .SLOTS    (SLOTS),
    .IN_FLIGHT(2)
  ) u_decoder (
    .clk                 (clk),
    .rst                 (rst),
    .s_beat_valid        (s_beat_valid && !hold),
    .s_beat_ready        (beat_ready),
    .s_beat_data         (beat_data),
    .s_beat_kind         (beat_kind),
    .s_beat_last         (s_beat_last),
    .load_o              (load),
    .load_axis_o         (load_axis),
    .load_address_o      (load_address),
    .load_entry_o        (load_entry),
    .lattice_write_o     (lattice_write),
    .lattice_buffer_o    (lattice_buffer),
    .lattice_at_o        (lattice_at),
    .lattice_words_o     (lattice_words),
    .slot_write_o        (slot_write),
    .slot_o              (slot),
    .slot_cell_o         (slot_cell),
    .slot_group_o        (slot_group),
    .slot_phase_o        (slot_phase),
    .slot_words_o        (slot_words),
    .write_exponent_o    (write_exponent),
    .m_vertex_valid      (vertex_valid),
    .m_vertex_ready      (vertex_ready),
    .m_vertex_coordinates(vertex_words),
    .m_vertex_cell       (vertex_cell),
    .m_vertex_source     (vertex_source),
    .m_vertex_bank       (vertex_bank),
    .m_vertex_changed    (vertex_changed),
    .m_vertex_results    (vertex_results),
    .m_vertex_exponent   (vertex_exponent),
    .m_vertex_user       (vertex_user),
    .slot_free_i         (1'b0),
    .retire_i            (leave),
    .retire_user_i       (sent_user_q[`FFD_USER_RETIRE(USER_W)]),
    .event_o             (events),
    .event_packet_o      (event_packet),
    .event_beat_o        (event_beat),
    .idle_o              (idle)
  );

  // ---- one vertex at a time, and one result

  wire                       move;
  reg  [`FFD_EXPONENT_W-1:0] exponent_q;
  reg                        written_q;  // the decoder's bank that came last, whole or not
  wire                       ready;
  wire                       enter = vertex_valid && vertex_ready;
  wire                       mixed = vertex_bank != written_q;

  assign vertex_ready = ready && !inside_q;

  always @(posedge clk) begin
    if (rst || move) inside_q <= 1'b0;
    else if (enter) inside_q <= 1'b1;
  end

  always @(posedge clk) begin
    if (load) written_q <= load_address[2];
  end

  always @(posedge clk) begin
    if (enter) begin
      user_q     <= vertex_user;
      exponent_q <= vertex_exponent;
      if (mixed) begin
        user_q[UNLOADED] <= 1'b1;
        user_q[BLANK]    <= 1'b1;
      end
    end
  end

  wire [3*WEIGHT_W-1:0] vertex_coordinates;

  ffd_eval_coordinates #(
    .FORMAT(FORMAT)
  ) u_coordinates (
    .words_i      (vertex_words),
    .coordinates_o(vertex_coordinates)
  );

  wire                   read;
  wire                   read_last;
  wire                   read_source;
  wire [11:0]            read_cell;
  wire [5:0]             read_index;
  wire [N*3*POINT_W-1:0] points;
  wire                   sum_valid;
  wire [3*SUM_W-1:0]     sum;

  ffd_cache_resident #(
    .FORMAT(FORMAT),
    .N     (N),
    .AXIS  (AXIS)
  ) u_cache (
    .clk             (clk),
    .write_i         (lattice_write),
    .write_buffer_i  (lattice_buffer),
    .write_at_i      (lattice_at),
    .write_words_i   (lattice_words),
    .write_exponent_i(write_exponent),
    .read_buffer_i   (read_source),
    .read_cell_i     (read_cell),
    .read_index_i    (read_index),
    .points_o        (points)
  );

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
    .SOURCE_W       (1)
  ) u_org (
    .clk                 (clk),
    .rst                 (rst),
    .load_i              (load && !load_address[3]),
    .load_axis_i         (load_axis),
    .load_address_i      ({2'b00, load_address[1:0]}),
    .load_entry_i        (load_entry),
    .s_vertex_valid      (vertex_valid && !inside_q),
    .s_vertex_ready      (ready),
    .s_vertex_coordinates(vertex_coordinates),
    .s_vertex_cell       (vertex_cell),
    .s_vertex_source     (vertex_source[0]),
    .s_vertex_bank       (6'd0),
    .s_vertex_changed    (vertex_changed),
    .read_o              (read),
    .read_last_o         (read_last),
    .read_source_o       (read_source),
    .read_cell_o         (read_cell),
    .read_index_o        (read_index),
    .read_points_i       (points),
    .result_valid_o      (sum_valid),
    .result_sum_o        (sum)
  );

  // ---- sums: of the vertex inside, and of the result that is being sent

  reg                        summed_q;
  reg  [3*SUM_W-1:0]         sum_q;
  reg  [3*SUM_W-1:0]         sent_sum_q;
  reg  [`FFD_EXPONENT_W-1:0] sent_exponent_q;
  wire [95:0]                words;
  wire [2:0]                 saturated;
  wire [2:0]                 nan;

  assign move = summed_q && (!m_beat_valid || m_beat_ready);

  always @(posedge clk) begin
    if (rst || move) summed_q <= 1'b0;
    else if (sum_valid) summed_q <= 1'b1;
  end

  always @(posedge clk) begin
    if (sum_valid) sum_q <= sum;
  end

  always @(posedge clk) begin
    if (rst) m_beat_valid <= 1'b0;
    else m_beat_valid <= move || (m_beat_valid && !m_beat_ready);
  end

  always @(posedge clk) begin
    if (move) begin
      sent_sum_q      <= sum_q;
      sent_user_q     <= user_q;
      sent_exponent_q <= exponent_q;
    end
  end

  genvar c;
  generate
    for (c = 0; c < 3; c = c + 1) begin : gen_component
      ffd_num_out #(
        .FORMAT (FORMAT),
        .LATENCY(0)
      ) u_out (
        .clk        (clk),
        .sum_i      (sent_sum_q[c*SUM_W +: SUM_W]),
        .exponent_i (sent_exponent_q),
        .word_o     (words[32*c +: 32]),
        .saturated_o(saturated[c]),
        .nan_o      (nan[c])
      );
    end
  endgenerate

  ffd_stream_encoder #(
    .FORMAT(FORMAT)
  ) u_encoder (
    .words_i      (words),
    .flags_i      ({|nan, |saturated}),
    .determinant_i(1'b0),
    .user_i       (sent_user_q[`FFD_USER_RESULT]),
    .beat_o       (m_beat_data)
  );

  assign m_beat_last = sent_user_q[`FFD_USER_LAST];

  wire unused_ok = &{1'b0, slot_write, slot, slot_cell, slot_group, slot_phase, slot_words,
                     vertex_source[1], vertex_results, events, event_packet, event_beat, idle,
                     read, read_last};
endmodule

`default_nettype wire
