// model_intake: framer and intake as hwffd_stream has them, in front of a decoder under proof
//
// sound_o is a part of the lemma `in_order`: the beat in the intake is one that a packet can have
// at this place, the framer expects what can follow it, and a beat that goes on finds what it needs
// free. The harness says what the decoder has come to: whether the packet's vertices are resident,
// the size of the lattice that comes, and what is busy or full.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_stream.vh"

module model_intake #(
  parameter AXIS = 16
) (
  input  wire                    clk,
  input  wire                    rst,
  input  wire                    s_valid,
  output wire                    s_ready,
  input  wire [127:0]            s_data,
  input  wire                    s_last,
  input  wire                    go_i,
  output wire                    there_o,  // a beat, held or on its way
  output wire                    m_valid,
  output wire [127:0]            m_data,
  output wire                    m_last,
  output wire [`FFD_FRAME_W-1:0] m_frame,
  input  wire                    slot_free_i,
  input  wire                    rooms_i,
  input  wire                    resident_i,
  input  wire                    decoder_resident_i,  // the decoder's own register
  input  wire [11:0]             size_i,
  input  wire                    no_slot_i,
  input  wire                    no_room_i,
  input  wire                    bank_busy_i,
  input  wire                    buffer_busy_i,
  output wire                    idle_o,
  output wire                    passes_o,
  output wire                    functions_o,  // what comes next is one
  output wire                    lattice_o,
  output wire                    points_o,
  output wire                    sound_o
);
  wire [`FFD_FRAME_W-1:0] frame;
  wire                    claims;
  wire                    held;
  assign there_o = held || m_valid;

  wire [`FFD_PACKET_W-1:0] packet;
  ffd_stream_opcode u_opcode (
    .opcode_i(s_data[7:0]),
    .packet_o(packet)
  );

  ffd_stream_framer #(
    .AXIS(AXIS)
  ) u_framer (
    .clk     (clk),
    .rst     (rst),
    .take_i  (s_valid && s_ready),
    .data_i  (s_data),
    .packet_i(packet),
    .last_i  (s_last),
    .as_i    (3'd0),
    .refuse_i(1'b0),
    .place_valid_i(1'b0),
    .place_i (12'd0),
    .tops_i  (12'd0),
    .frame_o (frame),
    .claims_o(claims),
    .idle_o  (idle_o)
  );

  wire waits = frame[`FFD_FRAME_BANK] || frame[`FFD_FRAME_BUFFER] || (claims && !slot_free_i)
            || (frame[`FFD_FRAME_FINISH] && !rooms_i);

  ffd_stream_intake #(
    .WIDTH(`FFD_FRAME_W + 129)
  ) u_in (
    .clk         (clk),
    .rst         (rst),
    .s_beat_valid(s_valid),
    .s_beat_ready(s_ready),
    .s_beat_waits(waits),
    .s_beat_data ({frame, s_last, s_data}),
    .go_i        (go_i),
    .held_o      (held),
    .beat_valid_o(m_valid),
    .beat_data_o ({m_frame, m_last, m_data})
  );

  // ---- the beat that came, and nothing else, is in the intake until it goes on

  wire                      take = s_valid && s_ready;
  reg                       came_q;
  reg  [`FFD_FRAME_W+128:0] beat_q;
  always @(posedge clk) begin
    came_q <= !rst && (take || (came_q && !m_valid));
    if (take) beat_q <= {frame, s_last, s_data};
  end
  assign passes_o = there_o == came_q && !(held && (take || m_valid))
                 && (!came_q || {m_frame, m_last, m_data} == beat_q);

  // ---- what follows what

  (* hierconn *) wire        \u_framer.header_q ;
  (* hierconn *) wire        \u_framer.function_q ;
  (* hierconn *) wire        \u_framer.point_q ;
  (* hierconn *) wire        \u_framer.vertex_q ;
  (* hierconn *) wire        \u_framer.points_q ;
  (* hierconn *) wire        \u_framer.done ;
  (* hierconn *) wire        \u_framer.own_q ;
  (* hierconn *) wire [11:0] \u_framer.index ;
  (* hierconn *) wire [3:0]  \u_framer.gen_digit[0].top_q ;
  (* hierconn *) wire [3:0]  \u_framer.gen_digit[1].top_q ;
  (* hierconn *) wire [3:0]  \u_framer.gen_digit[2].top_q ;
  wire        next_function = \u_framer.function_q ;
  wire        next_point    = \u_framer.point_q ;
  wire        next_vertex   = \u_framer.vertex_q ;
  wire        next_points   = \u_framer.points_q ;
  wire        next_resident = !\u_framer.own_q ;
  wire [11:0] next_index    = \u_framer.index ;
  wire [11:0] next_top      = {\u_framer.gen_digit[2].top_q , \u_framer.gen_digit[1].top_q ,
                               \u_framer.gen_digit[0].top_q };
  wire [5:0]  next_kinds    = {\u_framer.header_q , next_function, next_point, next_vertex,
                               next_points, \u_framer.done };

  wire        header   = m_frame[`FFD_FRAME_HEADER];
  wire        function_beat = m_frame[`FFD_FRAME_FUNCTION];
  wire        point    = m_frame[`FFD_FRAME_POINT];
  wire        vertex   = m_frame[`FFD_FRAME_VERTEX];
  wire        points   = m_frame[`FFD_FRAME_POINTS];
  wire        bank     = m_frame[`FFD_FRAME_BANK];
  wire        buffer   = m_frame[`FFD_FRAME_BUFFER];
  wire        top      = m_frame[`FFD_FRAME_TOP];
  wire        finish   = m_frame[`FFD_FRAME_FINISH];
  wire [11:0] index    = m_frame[`FFD_FRAME_INDEX];
  wire [4:0]  kinds    = {header, function_beat, point, vertex, points};
  // Points - 1 an axis: here those of u, at the header those of s, are in the lowest bits.
  wire [11:0] header_top = {m_data[67:64] - 4'd1, m_data[75:72] - 4'd1, m_data[83:80] - 4'd1};
  wire [11:0] size_top   = {size_i[3:0], size_i[7:4], size_i[11:8]};

  function at_least_3(input [11:0] all);
    at_least_3 = all[3:0] >= 3 && all[7:4] >= 3 && all[11:8] >= 3;
  endfunction
  function below(input [11:0] place, input [11:0] last);
    below = place[3:0] <= last[3:0] && place[7:4] <= last[7:4] && place[11:8] <= last[11:8];
  endfunction

  wire [`FFD_PACKET_W-1:0] m_packet;
  ffd_stream_opcode u_framed (
    .opcode_i(m_data[7:0]),
    .packet_o(m_packet)
  );

  wire one_kind = (!there_o || (kinds & (kinds - 5'd1)) == 0)
               && (next_kinds & (next_kinds - 6'd1)) == 0;
  wire legal    = m_frame[`FFD_FRAME_PACKET] == m_packet
               && (!finish || vertex || points) && (finish || !m_last || !(vertex || points))
               && (header || !(bank || buffer)) && (!buffer || at_least_3(header_top))
               && (!bank || m_data[7:0] == 1) && (!buffer || m_data[7:0] == 2)
               && (!point || below(index, size_top))
               && (!vertex || finish == (resident_i || m_last)) && (!points || !resident_i);
  reg  expects;
  always @* begin
    expects = !next_function && !next_point && !next_vertex && !next_points;
    if (header) expects = !next_points && (!next_function || bank) && (!next_point || buffer)
                       && (!next_vertex || m_data[7:0] == (next_resident ? 3 : 4));
    if (function_beat) expects = !next_point && !next_vertex && !next_points
                              && !(next_function && top);
    if (point) expects = !next_function && !next_vertex && !next_points && !(next_point && top);
    if (vertex) expects = !next_function && !next_point && next_points == !finish
                       && (!next_vertex || next_resident);
    if (points) expects = !next_function && !next_point && next_points == !finish;
  end

  wire with_header = there_o && header;
  wire next_source = next_vertex || next_points;
  wire of_vertices = next_source || (there_o && (vertex || points));
  wire same        = (!of_vertices || with_header || decoder_resident_i == resident_i)
                  && (!next_source || with_header || decoder_resident_i == next_resident)
                  && (!next_points || !next_resident)
                  && (!next_point || (at_least_3(next_top) && below(next_index, next_top)
                                      && next_top == (with_header ? header_top : size_top)));
  wire surely      = !(bank && bank_busy_i) && !(buffer && buffer_busy_i)
                  && !(vertex && !resident_i && no_slot_i) && !(finish && no_room_i);

  assign functions_o = there_o ? function_beat : next_function;
  assign lattice_o   = there_o ? point : next_point;
  assign points_o    = there_o ? points : next_points;
  assign sound_o     = passes_o && !(held && s_ready) && !(m_valid && !s_ready)
                    && one_kind && (!there_o || (legal && expects)) && same
                    && !(m_valid && !surely);
endmodule

`default_nettype wire
