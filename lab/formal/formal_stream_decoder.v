// formal_stream_decoder: framer, intake and decoder as hwffd_stream has them, with any beats
//
// That the framer is right, formal_stream_framer says. Behind the decoder stands any evaluator that
// holds two vertices. A list keeps what the stream said of each vertex from its last beat until it
// retires; the lemma `in_order` says where in the decoder the vertices of the list are, and what
// the registers then hold.
//
// Abstractions: two vertices behind the decoder, where the core has up to 128, and two before it,
// where it has up to 16; fixed point of 8 bits.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_stream.vh"

module formal_stream_decoder #(
  parameter SLOTS       = 3,
  parameter AXIS        = 16,
  parameter EVERY_CLOCK = 0,
  parameter CLOCKS      = 11
) (
  input wire         clk,
  input wire         rst,
  input wire         s_valid,
  input wire [127:0] s_data,
  input wire         s_last,
  input wire         want_vertex,
  input wire         want_free,
  input wire         want_retire,
  input wire         want_linger   // one that has left is still said to be inside
);
  wire                    s_ready;
  wire                    in_there;
  wire                    in_valid;
  wire                    in_go;
  wire [127:0]            in_data;
  wire                    in_last;
  wire [`FFD_FRAME_W-1:0] in_frame;
  wire                    between;
  wire                    passes_on;
  wire                    functions;
  wire                    lattice;
  wire                    midst;
  wire                    sound;
  wire                    load;
  wire [1:0]              load_axis;
  wire [3:0]              load_address;
  wire                    lattice_write;
  wire                    lattice_buffer;
  wire [11:0]             lattice_at;
  wire                    slot_write;
  wire [1:0]              slot;
  wire [3:0]              slot_group;
  wire [1:0]              slot_phase;
  wire                    m_valid;
  wire                    m_ready;
  wire [83:0]             m_word;
  wire                    slot_free;
  wire                    rooms;
  wire                    free;
  wire                    retire;
  wire [1:0]              there;
  wire [1:0]              holds;
  wire [5:0]              a_word;
  wire [5:0]              b_word;
  wire [`FFD_EVENTS-1:0]  events;
  wire [31:0]             event_packet;
  wire [31:0]             event_beat;
  wire                    decoder_idle;
  wire                    bank;
  wire                    buffer;
  wire                    resident;
  wire                    own_resident;
  wire [11:0]             size;
  wire                    no_slot;
  wire                    no_room;
  wire                    bank_busy;
  wire                    buffer_busy;
  wire                    queue_room;
  wire [2:0]              inside;
  wire [48:0]             head;
  wire                    sized;
  wire [3:0]              moving;
  wire                    follows;
  wire                    bank_clash;
  wire                    buffer_clash;
  wire                    slot_clash;

  model_intake #(
    .AXIS(AXIS)
  ) u_intake (
    .clk               (clk),
    .rst               (rst),
    .s_valid           (s_valid),
    .s_ready           (s_ready),
    .s_data            (s_data),
    .s_last            (s_last),
    .go_i              (in_go),
    .there_o           (in_there),
    .m_valid           (in_valid),
    .m_data            (in_data),
    .m_last            (in_last),
    .m_frame           (in_frame),
    .slot_free_i       (slot_free),
    .rooms_i           (rooms),
    .resident_i        (resident),
    .decoder_resident_i(own_resident),
    .size_i            (size),
    .no_slot_i         (no_slot),
    .no_room_i         (no_room),
    .bank_busy_i       (bank_busy),
    .buffer_busy_i     (buffer_busy),
    .idle_o            (between),
    .passes_o          (passes_on),
    .functions_o       (functions),
    .lattice_o         (lattice),
    .points_o          (midst),
    .sound_o           (sound)
  );

  model_decoder #(
    .SLOTS      (SLOTS),
    .EVERY_CLOCK(EVERY_CLOCK)
  ) u_decoder (
    .clk             (clk),
    .rst             (rst),
    .s_valid         (in_valid),
    .s_data          (in_data),
    .s_last          (in_last),
    .s_frame         (in_frame),
    .go_o            (in_go),
    .functions_i     (functions),
    .lattice_i       (lattice),
    .midst_i         (midst),
    .load_o          (load),
    .load_axis_o     (load_axis),
    .load_address_o  (load_address),
    .lattice_write_o (lattice_write),
    .lattice_buffer_o(lattice_buffer),
    .lattice_at_o    (lattice_at),
    .slot_write_o    (slot_write),
    .slot_o          (slot),
    .slot_group_o    (slot_group),
    .slot_phase_o    (slot_phase),
    .m_valid         (m_valid),
    .m_ready         (m_ready),
    .m_word          (m_word),
    .slot_free_o     (slot_free),
    .rooms_o         (rooms),
    .free_i          (free),
    .linger_i        (want_linger),
    .retire_i        (retire),
    .there_i         (there),
    .holds_i         (holds),
    .a_word_i        (a_word),
    .b_word_i        (b_word),
    .event_o         (events),
    .event_packet_o  (event_packet),
    .event_beat_o    (event_beat),
    .idle_o          (decoder_idle),
    .bank_o          (bank),
    .buffer_o        (buffer),
    .resident_o      (resident),
    .own_resident_o  (own_resident),
    .size_o          (size),
    .no_slot_o       (no_slot),
    .no_room_o       (no_room),
    .bank_busy_o     (bank_busy),
    .buffer_busy_o   (buffer_busy),
    .room_o          (queue_room),
    .inside_o        (inside),
    .head_o          (head),
    .sized_o         (sized),
    .moving_o        (moving),
    .follows_o       (follows),
    .bank_clash_o    (bank_clash),
    .buffer_clash_o  (buffer_clash),
    .slot_clash_o    (slot_clash)
  );

  model_evaluator u_evaluator (
    .clk           (clk),
    .rst           (rst),
    .want_vertex   (want_vertex),
    .want_free     (want_free),
    .want_retire   (want_retire),
    .s_vertex_valid(m_valid),
    .s_vertex_ready(m_ready),
    .s_vertex_word ({m_word[83:81], m_word[43:41]}),
    .free_o        (free),
    .retire_o      (retire),
    .a_there_o     (there[0]),
    .a_slot_o      (holds[0]),
    .a_word_o      (a_word),
    .b_there_o     (there[1]),
    .b_slot_o      (holds[1]),
    .b_word_o      (b_word)
  );

  // ---- what the beats taken must do when they leave the converters, two clocks later

  wire [18:0] goes    = {in_valid, in_last, in_frame[`FFD_FRAME_FUNCTION],
                         in_frame[`FFD_FRAME_POINT], in_frame[`FFD_FRAME_POINTS],
                         in_frame[`FFD_FRAME_INDEX], !buffer, !bank};
  reg  [18:0] goes_0_q;
  reg  [18:0] goes_1_q;
  reg  [11:0] size_0_q;
  reg  [11:0] size_1_q;
  always @(posedge clk) begin
    goes_0_q <= rst ? 19'd0 : goes & {19{in_valid}};
    goes_1_q <= rst ? 19'd0 : goes_0_q;
    size_0_q <= size;
    size_1_q <= size_0_q;
  end
  wire [11:0] at    = goes_1_q[13:2];  // the lowest digit is k of a lattice
  wire        right = {load, lattice_write, slot_write} == goes_1_q[16:14]
                   && (!load || {load_address, load_axis}
                                == {at[8], goes_1_q[0], at[1:0], at[5:4]})
                   && (!lattice_write || {lattice_buffer, lattice_at}
                                         == {goes_1_q[1], at[3:0], at[7:4], at[11:8]})
                   && (!slot_write || {slot_group, slot_phase} == {at[7:4], at[1:0]});

  // ---- one clock before

  reg         first_q = 1'b1;
  reg         rst_q;
  reg         held_q;
  reg  [83:0] held_word_q;
  reg  [4:0]  wait_q;      // clocks in which a beat was not taken
  reg  [2:0]  hidden_q;    // clocks in which a vertex was inside and none offered
  reg         taken_q;     // a beat left the converters
  reg         last_q;
  reg  [31:0] event_packet_q;
  reg  [31:0] event_beat_q;
  wire        willing     = want_vertex && want_free && want_retire && !want_linger;
  wire        offerable   = inside != there[0] + there[1];
  wire        same        = moving[3] == goes_1_q[18] && (!moving[3] || moving[2] == goes_1_q[17])
                         && moving[1] == goes_0_q[18] && (!moving[1] || moving[0] == goes_0_q[17]);
  wire [31:0] next_packet = event_packet_q + (taken_q && last_q);
  wire [31:0] next_beat   = !taken_q ? event_beat_q : last_q ? 32'd0 : event_beat_q + 32'd1;
  always @(posedge clk) begin
    first_q        <= 1'b0;
    rst_q          <= rst;
    held_q         <= !rst && m_valid && !m_ready;
    held_word_q    <= m_word;
    wait_q         <= rst || !(s_valid && !s_ready && willing) ? 0 : wait_q + (wait_q != 31);
    hidden_q       <= rst || m_valid || !offerable ? 0 : hidden_q + (hidden_q != 7);
    taken_q        <= !rst && goes_1_q[18];
    last_q         <= goes_1_q[17];
    event_packet_q <= event_packet;
    event_beat_q   <= event_beat;
  end

  always @* if (first_q) assume (rst);

  // The vertex offered, and its cell: one of the lattice that it must read.
  wire        m_resident = m_word[43];
  wire [11:0] m_cell     = m_word[38:27];
  wire        inside_lattice = {1'b0, m_cell[3:0]} + 5'd3 <= head[38:35]
                            && {1'b0, m_cell[7:4]} + 5'd3 <= head[42:39]
                            && {1'b0, m_cell[11:8]} + 5'd3 <= head[46:43];

  always @* if (!first_q && !rst) begin
    in_order: assert (sound && follows);
    passes: assert (passes_on);
    promised: assert (!in_valid || in_go);
    room: assert (queue_room);
    each_vertex: assert (!m_valid || (offerable && {m_word[79], m_word[55:54], m_word[43],
                                                    m_word[71:56]}
                                                   == {head[48], head[34:32], head[15:0]}));
    offered: assert (!offerable || m_valid || hidden_q < 4);
    stable: assert (!held_q || (m_valid && m_word == held_word_q));
    written: assert (right);
    bank_free: assert (!bank_clash);
    buffer_free: assert (!buffer_clash);
    slot_unused: assert (!slot_clash);
    changed: assert (!m_valid || m_word[39] || !head[28]);
    bank_order: assert (!m_valid || (m_word[40] == head[29] && m_word[81] == head[29]));
    buffer_order: assert (!m_valid || !head[32] || {m_word[83:82], m_word[41]}
                                                   == {1'b1, head[30], head[30]});
    slot_order: assert (!m_valid || head[32] || m_word[42:41] == head[31:30]);
    point_inside: assert (!lattice_write || (lattice_at[3:0] <= size_1_q[3:0]
                                             && lattice_at[7:4] <= size_1_q[7:4]
                                             && lattice_at[11:8] <= size_1_q[11:8]));
    cell_inside: assert (sized && (!m_valid || (head[32] ? !head[47] || inside_lattice
                                                           : m_cell == head[27:16])));
    slot_inside: assert ((!slot_write || slot < SLOTS)
                         && (!m_valid || m_resident || m_word[42:41] < SLOTS));
    idle_means: assert (!(between && !in_there && decoder_idle)
                        || (inside == 0 && !m_valid && !load && !lattice_write && !slot_write
                            && events == 0));
    live: assert (wait_q < CLOCKS);
    place: assert (same && event_packet == (rst_q ? 32'd0 : next_packet)
                   && event_beat == (rst_q ? 32'd0 : next_beat));
  end
endmodule

`default_nettype wire
