// model_decoder: the decoder under proof, and what the stream has said of the vertices inside
//
// follows_o is a part of the lemma `in_order`: it says where in the decoder the vertices of the
// list are (model_vertices), and that its registers hold there what the stream said of them; that
// the bank, buffer and slot in use are those of a plain count; and what the converters hold.
//
// Formats:    words of a vertex, m_word and those of the decoder's queue alike: {user, results,
//             exponent, source, bank, changed, cell, coordinates}; head_o as in model_vertices.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_stream.vh"

module model_decoder #(
  parameter FORMAT      = 8,
  parameter SLOTS       = 3,
  parameter EVERY_CLOCK = 0
) (
  input  wire                    clk,
  input  wire                    rst,
  input  wire                    s_valid,
  input  wire [127:0]            s_data,
  input  wire                    s_last,
  input  wire [`FFD_FRAME_W-1:0] s_frame,
  output wire                    go_o,
  input  wire                    functions_i,  // what the stream has come to
  input  wire                    lattice_i,
  input  wire                    midst_i,
  output wire                    load_o,
  output wire [1:0]              load_axis_o,
  output wire [3:0]              load_address_o,
  output wire                    lattice_write_o,
  output wire                    lattice_buffer_o,
  output wire [11:0]             lattice_at_o,
  output wire                    slot_write_o,
  output wire [1:0]              slot_o,
  output wire [3:0]              slot_group_o,
  output wire [1:0]              slot_phase_o,
  output wire                    m_valid,
  input  wire                    m_ready,
  output wire [83:0]             m_word,
  output wire                    slot_free_o,
  output wire                    rooms_o,
  input  wire                    free_i,
  input  wire                    linger_i,
  input  wire                    retire_i,
  input  wire [1:0]              there_i,      // with the evaluator: the older, the younger
  input  wire [1:0]              holds_i,      // a slot
  input  wire [5:0]              a_word_i,
  input  wire [5:0]              b_word_i,
  output wire [`FFD_EVENTS-1:0]  event_o,
  output wire [31:0]             event_packet_o,
  output wire [31:0]             event_beat_o,
  output wire                    idle_o,
  output wire                    bank_o,       // in use
  output wire                    buffer_o,
  output wire                    resident_o,
  output wire                    own_resident_o,
  output wire [11:0]             size_o,
  output wire                    no_slot_o,
  output wire                    no_room_o,
  output wire                    bank_busy_o,
  output wire                    buffer_busy_o,
  output wire                    room_o,       // in the queue for what comes
  output wire [2:0]              inside_o,
  output wire [48:0]             head_o,       // what the stream said of the vertex offered
  output wire                    sized_o,      // lattices, as their headers say
  output wire [3:0]              moving_o,     // in the converters: a beat, the last of its packet
  output wire                    follows_o,
  output wire                    bank_clash_o,
  output wire                    buffer_clash_o,
  output wire                    slot_clash_o
);
  ffd_stream_decoder #(
    .FORMAT     (FORMAT),
    .SLOTS      (SLOTS),
    .WAITING    (2),
    .EVERY_CLOCK(EVERY_CLOCK)
  ) u_dut (
    .clk                 (clk),
    .rst                 (rst),
    .beat_valid_i        (s_valid),
    .beat_data_i         (s_data),
    .beat_last_i         (s_last),
    .beat_second_i       (33'd0),
    .beat_frame_i        (s_frame),
    .beat_held_i         (1'b0),  // of a page
    .go_o                (go_o),
    .load_o              (load_o),
    .load_axis_o         (load_axis_o),
    .load_address_o      (load_address_o),
    .lattice_write_o     (lattice_write_o),
    .lattice_buffer_o    (lattice_buffer_o),
    .lattice_at_o        (lattice_at_o),
    .slot_write_o        (slot_write_o),
    .slot_o              (slot_o),
    .slot_group_o        (slot_group_o),
    .slot_phase_o        (slot_phase_o),
    .m_vertex_valid      (m_valid),
    .m_vertex_ready      (m_ready),
    .m_vertex_coordinates(m_word[26:0]),
    .m_vertex_cell       (m_word[38:27]),
    .m_vertex_source     (m_word[43:41]),
    .m_vertex_bank       (m_word[40]),
    .m_vertex_changed    (m_word[39]),
    .m_vertex_results    (m_word[55:54]),
    .m_vertex_exponent   (m_word[53:44]),
    .m_vertex_user       (m_word[83:56]),
    .slot_free_o         (slot_free_o),
    .rooms_o             (rooms_o),
    .slot_free_i         (free_i),
    .evaluating_i        (there_i != 2'd0 || linger_i),
    .retire_i            (retire_i),
    .retire_user_i       (a_word_i[5:3]),
    .event_o             (event_o),
    .event_packet_o      (event_packet_o),
    .event_beat_o        (event_beat_o),
    .idle_o              (idle_o)
  );

  // ---- its registers; of two in the converters, _0 is the younger

  (* hierconn *) wire        \u_dut.resident_q , \u_dut.u_functions.bank_o , \u_dut.changed_q ;
  (* hierconn *) wire        \u_dut.u_resident.gen_buffers.u_buffers.buffer_o ;
  (* hierconn *) wire        \u_dut.u_resident.gen_buffers.u_buffers.loaded_o ;
  (* hierconn *) wire        \u_dut.bank_busy , \u_dut.buffer_busy ;
  (* hierconn *) wire [1:0]  \u_dut.results_q , \u_dut.u_slots.gen_slots.slot_q ;
  (* hierconn *) wire [2:0]  \u_dut.u_sideband.moving_q , \u_dut.u_slots.gen_slots.used_q ;
  (* hierconn *) wire [11:0] \u_dut.cell_index ;
  (* hierconn *) wire [11:0] \u_dut.u_resident.gen_buffers.u_buffers.last_cell_o ;
  (* hierconn *) wire [11:0] \u_dut.u_resident.gen_buffers.u_buffers.new_last_cell_q ;
  (* hierconn *) wire [14:0] \u_dut.u_sideband.u_taken.gen_stage[0].data_q ;
  (* hierconn *) wire [14:0] \u_dut.u_sideband.u_taken.gen_stage[1].data_q ;
  (* hierconn *) wire [14:0] \u_dut.u_sideband.u_place.gen_stage[0].data_q ;
  (* hierconn *) wire [14:0] \u_dut.u_sideband.u_place.gen_stage[1].data_q ;
  (* hierconn *) wire [7:0]  \u_dut.u_sideband.u_page.gen_stage[0].data_q ;
  (* hierconn *) wire [7:0]  \u_dut.u_sideband.u_page.gen_stage[1].data_q ;
  (* hierconn *) wire [2:0]  \u_dut.u_functions.gen_single.u_load.gen_stage[0].data_q ;
  (* hierconn *) wire [2:0]  \u_dut.u_functions.gen_single.u_load.gen_stage[1].data_q ;
  (* hierconn *) wire [51:0] \u_dut.u_vertex.u_known.gen_stage[0].data_q ;
  (* hierconn *) wire [51:0] \u_dut.u_vertex.u_known.gen_stage[1].data_q ;
  (* hierconn *) wire [51:0] \u_dut.u_vertex.known_q ;
  (* hierconn *) wire        \u_dut.u_vertex.whole_q , \u_dut.u_vertex.final_q ;
  (* hierconn *) wire        \u_dut.u_vertex.queue_ready ;
  (* hierconn *) wire [1:0]  \u_dut.u_vertex.waiting_q ;
  (* hierconn *) wire [1:0]  \u_dut.u_vertex.u_queue.write_q , \u_dut.u_vertex.u_queue.read_q ;
  (* hierconn *) wire [83:0] \u_dut.u_vertex.u_queue.u_memory.gen_slice[0].memory_q[0] ;
  (* hierconn *) wire [83:0] \u_dut.u_vertex.u_queue.u_memory.gen_slice[0].memory_q[1] ;
  wire [83:0] memory_0 = \u_dut.u_vertex.u_queue.u_memory.gen_slice[0].memory_q[0] ;
  wire [83:0] memory_1 = \u_dut.u_vertex.u_queue.u_memory.gen_slice[0].memory_q[1] ;
  wire [14:0] taken_0  = \u_dut.u_sideband.u_taken.gen_stage[0].data_q ;
  wire [14:0] taken_1  = \u_dut.u_sideband.u_taken.gen_stage[1].data_q ;
  wire [14:0] place_0  = \u_dut.u_sideband.u_place.gen_stage[0].data_q ;
  wire [14:0] place_1  = \u_dut.u_sideband.u_place.gen_stage[1].data_q ;
  wire [7:0]  page_0   = \u_dut.u_sideband.u_page.gen_stage[0].data_q ;
  wire [7:0]  page_1   = \u_dut.u_sideband.u_page.gen_stage[1].data_q ;
  wire [2:0]  loads_0  = \u_dut.u_functions.gen_single.u_load.gen_stage[0].data_q ;
  wire [2:0]  loads_1  = \u_dut.u_functions.gen_single.u_load.gen_stage[1].data_q ;
  wire [51:0] known_0  = \u_dut.u_vertex.u_known.gen_stage[0].data_q ;
  wire [51:0] known_1  = \u_dut.u_vertex.u_known.gen_stage[1].data_q ;
  wire [51:0] known    = \u_dut.u_vertex.known_q ;
  wire        whole    = \u_dut.u_vertex.whole_q ;
  wire [1:0]  waiting  = \u_dut.u_vertex.waiting_q ;
  wire [1:0]  read     = \u_dut.u_vertex.u_queue.read_q ;
  wire [1:0]  queued   = \u_dut.u_vertex.u_queue.write_q - read;
  wire [2:0]  used     = \u_dut.u_slots.gen_slots.used_q ;
  wire        function_0 = taken_0[12], point_0 = taken_0[11], points_0 = taken_0[10];
  wire        function_1 = taken_1[12], point_1 = taken_1[11], points_1 = taken_1[10];
  wire        vertex_0   = taken_0[9], finish_0 = taken_0[8];
  wire        vertex_1   = taken_1[9], finish_1 = taken_1[8];

  // ---- what the stream has said up to here

  wire        take          = s_valid;
  wire        function_beat = s_frame[`FFD_FRAME_FUNCTION];
  wire        point         = s_frame[`FFD_FRAME_POINT];
  wire        vertex        = s_frame[`FFD_FRAME_VERTEX];
  wire        top           = s_frame[`FFD_FRAME_TOP];
  wire        finish        = s_frame[`FFD_FRAME_FINISH];
  reg         bank_q;        // in use
  reg         buffer_q;
  reg         loaded_q;      // a lattice
  reg  [11:0] new_size_q;    // points - 1 an axis of the lattice that comes, those of s lowest
  reg  [11:0] size_q;        // of that in use
  reg  [1:0]  slot_q;        // of the next interleaved vertex
  reg         resident_q;
  reg  [1:0]  results_q;
  reg         written_q;     // since the vertex before
  reg  [34:0] begun_q;       // the vertex whose points come
  wire [2:0]  source = {resident_q, resident_q ? {1'b0, buffer_q} : slot_q};
  wire [11:0] named  = resident_q ? \u_dut.cell_index : s_data[123:112];
  wire [34:0] begins = {results_q, source, bank_q, written_q || !resident_q, named, s_data[111:96]};

  always @(posedge clk) begin
    if (rst) begin
      {bank_q, buffer_q, loaded_q, slot_q} <= 5'd0;
      written_q                            <= 1'b1;
    end else if (take) begin
      if (top && function_beat) bank_q <= !bank_q;
      if (top && point) {buffer_q, loaded_q} <= {!buffer_q, 1'b1};
      if (finish && !resident_q) slot_q <= slot_q == SLOTS - 1 ? 2'd0 : slot_q + 2'd1;
      if (function_beat || point || vertex) written_q <= !vertex;
    end
    if (take && top && point) size_q <= new_size_q;
    if (take && s_frame[`FFD_FRAME_HEADER]) begin
      new_size_q <= {s_data[83:80] - 4'd1, s_data[75:72] - 4'd1, s_data[67:64] - 4'd1};
      resident_q <= s_data[7:0] == 3;
      results_q  <= s_data[73:72];
    end
    if (take && vertex) begun_q <= begins;
  end
  assign {bank_o, buffer_o, resident_o, size_o} = {bank_q, buffer_q, resident_q, new_size_q};
  assign own_resident_o = \u_dut.resident_q ;
  assign no_slot_o      = used == SLOTS;
  assign no_room_o      = waiting[1];
  assign bank_busy_o    = \u_dut.bank_busy ;
  assign buffer_busy_o  = \u_dut.buffer_busy ;
  assign room_o         = !whole || \u_dut.u_vertex.queue_ready ;

  // ---- the vertices inside: with the evaluator, offered, queued, in front of that, converted

  wire [2:0]      out       = {2'd0, there_i[0]} + {2'd0, there_i[1]};
  wire [2:0]      out_head  = out + m_valid;
  wire [2:0]      out_queue = out_head + queued;
  wire [2:0]      out_whole = out_queue + whole;
  wire [4*49-1:0] list;
  wire            ordered;
  model_vertices #(
    .SLOTS(SLOTS)
  ) u_vertices (
    .clk           (clk),
    .rst           (rst),
    .enter_i       (take && finish),
    .entry_i       ({s_frame[`FFD_FRAME_FINAL], loaded_q, size_q, vertex ? begins : begun_q}),
    .leave_i       (retire_i),
    .inside_o      (inside_o),
    .list_o        (list),
    .bank_i        (bank_q),
    .bank_busy_i   (\u_dut.bank_busy ),
    .buffer_i      (buffer_q),
    .buffer_busy_i (\u_dut.buffer_busy ),
    .slot_i        (slot_q),
    .midst_i       (midst_i),
    .used_i        (used),
    .there_i       (out_whole),
    .young_i       (finish_0),
    .evaluated_i   (there_i),
    .freed_i       (~holds_i),
    .function_0_i  ({function_0, page_0[7], loads_0[2]}),
    .function_1_i  ({function_1, page_1[7], loads_1[2]}),
    .point_0_i     ({point_0, page_0[7], loads_0[2]}),
    .point_1_i     ({point_1, page_1[7], loads_1[2]}),
    .slot_write_i  ({slot_write_o, slot_o}),
    .ordered_o     (ordered),
    .bank_clash_o  (bank_clash_o),
    .buffer_clash_o(buffer_clash_o),
    .slot_clash_o  (slot_clash_o)
  );

  function [48:0] at(input [4*49-1:0] all, input [2:0] number);
    at = all >> (number[1:0] * 49);
  endfunction
  // The fields of an entry in the words of known, of the queue, and of what retires.
  function [34:0] of_known(input [51:0] word);
    of_known = {word[49:48], word[37:21], word[15:0]};
  endfunction
  function same_word(input [83:0] word, input [48:0] entry);
    same_word = {word[79], word[55:54], word[43:27], word[71:56]} == {entry[48], entry[34:0]}
             && word[83:81] == {entry[32], entry[30], entry[29]};
  endfunction
  function retires(input [5:0] word, input [48:0] entry);
    retires = word == {entry[32], entry[30], entry[29], entry[32:30]};
  endfunction
  function sized(input [11:0] all, input [11:0] last_cell);
    sized = all[3:0] >= 3 && all[7:4] >= 3 && all[11:8] >= 3
         && last_cell == {all[11:8] - 4'd3, all[7:4] - 4'd3, all[3:0] - 4'd3};
  endfunction

  assign head_o = at(list, out);
  wire [48:0] e_first = at(list, out_head);
  wire [51:0] newest  = vertex_0 ? known_0 : vertex_1 ? known_1 : known;
  wire [48:0] e_whole = at(list, out_queue);
  wire [48:0] e_1     = at(list, out_whole);
  wire [48:0] e_0     = at(list, out_whole + finish_1);
  wire entries = inside_o == out + waiting
              && {1'b0, waiting} == m_valid + queued + whole + finish_1 + finish_0
              && waiting <= 2 && queued <= 2 && there_i != 2'd2 && !(holds_i[0] && there_i[1]
                                                                     && !b_word_i[2] && !holds_i[1])
              && (!there_i[0] || retires(a_word_i, list[48:0]))
              && (!there_i[1] || retires(b_word_i, list[97:49]))
              && (!m_valid || same_word(m_word, head_o))
              && (queued < 1 || same_word(read[0] ? memory_1 : memory_0, e_first))
              && (queued < 2 || same_word(read[0] ? memory_0 : memory_1, at(list, out_head + 3'd1)))
              && (!whole || {\u_dut.u_vertex.final_q , of_known(known)}
                            == {e_whole[48], e_whole[34:0]})
              && (!finish_1 || {place_1[12], of_known(vertex_1 ? known_1 : known)}
                               == {e_1[48], e_1[34:0]})
              && (!finish_0 || {place_0[12], of_known(newest)} == {e_0[48], e_0[34:0]});

  // ---- what is in use, and the beats in the converters

  wire        own_buffer    = \u_dut.u_resident.gen_buffers.u_buffers.buffer_o ;
  wire        own_loaded    = \u_dut.u_resident.gen_buffers.u_buffers.loaded_o ;
  wire [11:0] last_cell     = \u_dut.u_resident.gen_buffers.u_buffers.last_cell_o ;
  wire [11:0] new_last_cell = \u_dut.u_resident.gen_buffers.u_buffers.new_last_cell_q ;
  assign sized_o  = (!loaded_q || sized(size_q, last_cell))
                 && (!lattice_i || sized(new_size_q, new_last_cell));
  assign moving_o = {taken_1[13], place_1[14], taken_0[13], place_0[14]};
  wire in_use = {bank_q, buffer_q, loaded_q, results_q, written_q, slot_q}
                == {\u_dut.u_functions.bank_o , own_buffer, own_loaded,
                    \u_dut.results_q ,
                    \u_dut.changed_q , \u_dut.u_slots.gen_slots.slot_q }
             && sized_o && !(functions_i && \u_dut.bank_busy )
             && !(lattice_i && \u_dut.buffer_busy );

  wire [3:0] kinds_0 = taken_0[12:9];
  wire [3:0] kinds_1 = taken_1[12:9];
  wire stages = (kinds_0 & (kinds_0 - 4'd1)) == 0 && (kinds_1 & (kinds_1 - 4'd1)) == 0
             && (!finish_0 || vertex_0 || points_0) && (!finish_1 || vertex_1 || points_1)
             && (taken_0[13] || taken_0 == 0) && (taken_1[13] || taken_1 == 0)
             && \u_dut.u_sideband.moving_q [1:0] == {taken_1[13], taken_0[13]}
             && (!(vertex_1 || points_1) || finish_1 || (taken_0[13] ? points_0 : midst_i))
             && (!(vertex_0 || points_0) || finish_0 || midst_i)
             && (!midst_i || (of_known(newest) == begun_q
                              && begun_q[32:29] == {1'b0, slot_q, bank_q}));

  assign follows_o = entries && ordered && in_use && stages && !bank_clash_o && !buffer_clash_o;
endmodule

`default_nettype wire
