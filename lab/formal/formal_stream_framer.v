// formal_stream_framer: ffd_stream_framer with any beats whatever
//
// Beside it stands a reading of docs/interface.md section 2 that only counts beats: which beat of
// its packet this is, and how many vertices are to come. What the frame says of a beat must be what
// this count says.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_stream.vh"

module formal_stream_framer #(
  parameter AXIS = 16
) (
  input wire         clk,
  input wire         rst,
  input wire         take,
  input wire [127:0] data,
  input wire         last
);
  wire [`FFD_FRAME_W-1:0] frame;
  wire                    claims;
  wire                    idle;

  wire [`FFD_PACKET_W-1:0] packet;
  ffd_stream_opcode u_opcode (
    .opcode_i(data[7:0]),
    .packet_o(packet)
  );

  ffd_stream_framer #(
    .AXIS(AXIS)
  ) u_dut (
    .clk     (clk),
    .rst     (rst),
    .take_i  (take),
    .data_i  (data),
    .packet_i(packet),
    .last_i  (last),
    .as_i    (3'd0),
    .refuse_i(1'b0),
    .place_valid_i(1'b0),
    .place_i (12'd0),
    .tops_i  (12'd0),
    .frame_o (frame),
    .claims_o(claims),
    .idle_o  (idle)
  );

  // ---- the header

  localparam [2:0] DROPPED = 3'd0, COEFFICIENTS = 3'd1, LATTICE = 3'd2, VERTICES = 3'd3,
                   INTERLEAVED = 3'd4;
  wire [7:0]  opcode       = data[7:0];
  wire [11:0] size         = {data[67:64] - 4'd1, data[75:72] - 4'd1, data[83:80] - 4'd1};
  wire        good         = data[71:64] >= 4 && data[71:64] <= AXIS && data[79:72] >= 4
                          && data[79:72] <= AXIS && data[87:80] >= 4 && data[87:80] <= AXIS;
  wire        of_vertices  = opcode == 3 || opcode == 4;
  wire        accepted     = opcode == 1 || (opcode == 2 && good) || of_vertices;
  wire        none         = of_vertices && data[63:32] == 0;

  // ---- the packet, by counting beats

  reg         first_q = 1'b1;
  reg         header_q;   // the next beat is a header
  reg  [2:0]  opcode_q;
  reg         twice_q;    // derivatives behind the coefficients
  reg  [31:0] left_q;     // vertices to come
  reg  [11:0] at_q;       // beats of the vertex, the coefficients or the lattice so far
  reg  [11:0] size_q;     // points - 1 an axis of the lattice, those of u lowest
  reg         behind_q;   // the payload was complete with the beat before

  function [11:0] at_point(input [11:0] point, input [11:0] top);
    at_point = (point[11:8] * (12'd1 + top[7:4]) + point[7:4]) * (12'd1 + top[3:0]) + point[3:0];
  endfunction

  wire [11:0] last_at  = opcode_q == COEFFICIENTS ? (twice_q ? 12'd23 : 12'd11)
                       : opcode_q == LATTICE      ? at_point(size_q, size_q)
                       : opcode_q == INTERLEAVED  ? 12'd48 : 12'd0;
  wire        payload  = !header_q && opcode_q != DROPPED;
  wire        vertices = payload && (opcode_q == VERTICES || opcode_q == INTERLEAVED);
  wire        whole    = payload && at_q == last_at;
  wire        complete = whole && (!vertices || left_q == 1);
  wire        finish   = vertices && (whole || last);

  always @(posedge clk) begin
    first_q <= 1'b0;
    if (rst) header_q <= 1'b1;
    else if (take) header_q <= last;
    if (rst) behind_q <= 1'b0;
    else if (take) behind_q <= complete && !last;
    if (take && header_q) begin
      opcode_q <= accepted && !none ? opcode[2:0] : DROPPED;
      twice_q  <= data[95];
      left_q   <= data[63:32];
      at_q     <= 12'd0;
      size_q   <= size;
    end else if (take) begin
      at_q <= whole ? 12'd0 : at_q + 12'd1;
      if (complete) opcode_q <= DROPPED;
      if (vertices && whole) left_q <= left_q - 1;
    end
  end

  always @* if (first_q) assume (rst);

  // ---- what ties the framer's registers to those above

  (* hierconn *) wire        \u_dut.header_q ;
  (* hierconn *) wire        \u_dut.function_q ;
  (* hierconn *) wire        \u_dut.point_q ;
  (* hierconn *) wire        \u_dut.vertex_q ;
  (* hierconn *) wire        \u_dut.points_q ;
  (* hierconn *) wire        \u_dut.done ;
  (* hierconn *) wire        \u_dut.own_q ;
  (* hierconn *) wire        \u_dut.number_last ;
  (* hierconn *) wire [31:0] \u_dut.left_q ;
  (* hierconn *) wire [11:0] \u_dut.index ;
  (* hierconn *) wire [3:0]  \u_dut.gen_digit[0].top_q ;
  (* hierconn *) wire [3:0]  \u_dut.gen_digit[1].top_q ;
  (* hierconn *) wire [3:0]  \u_dut.gen_digit[2].top_q ;

  wire [11:0] digits = \u_dut.index ;
  wire [11:0] top    = {\u_dut.gen_digit[2].top_q , \u_dut.gen_digit[1].top_q ,
                       \u_dut.gen_digit[0].top_q };
  wire        below  = digits[3:0] <= top[3:0] && digits[7:4] <= top[7:4]
                    && digits[11:8] <= top[11:8];
  wire        same_left   = left_q != 0 && \u_dut.left_q == left_q
                         && \u_dut.number_last == (left_q == 1)
                         && \u_dut.own_q == (opcode_q == INTERLEAVED);
  wire        begins      = opcode_q == VERTICES || at_q == 0;
  wire [11:0] functions   = 12'd12 * digits[11:8] + 12'd4 * digits[7:4] + digits[3:0];
  wire [11:0] points_sent = 12'd3 * digits[7:4] + digits[3:0] + 12'd1;
  reg         same;
  always @* begin
    case (opcode_q)
      DROPPED:      same = 1'b1;
      COEFFICIENTS: same = top == {3'd0, twice_q, 4'd2, 4'd3} && below && at_q == functions;
      LATTICE:      same = top == size_q && below && at_q == at_point(digits, top);
      VERTICES:     same = same_left && at_q == 0;
      INTERLEAVED:  same = same_left && top == 12'h0f2 && below
                        && at_q == (begins ? 12'd0 : points_sent);
      default:      same = 1'b0;
    endcase
  end
  wire flags = \u_dut.header_q == header_q && \u_dut.done == behind_q && !(behind_q && payload)
            && \u_dut.function_q == (payload && opcode_q == COEFFICIENTS)
            && \u_dut.point_q == (payload && opcode_q == LATTICE)
            && \u_dut.vertex_q == (vertices && begins)
            && \u_dut.points_q == (vertices && !begins);

  // ---- what the frame must say

  wire [5:0]  kinds  = {header_q, payload && opcode_q == COEFFICIENTS,
                        payload && opcode_q == LATTICE, vertices && begins, vertices && !begins,
                        vertices && begins && opcode_q == INTERLEAVED};
  wire [5:0]  framed = {frame[`FFD_FRAME_HEADER], frame[`FFD_FRAME_FUNCTION],
                        frame[`FFD_FRAME_POINT], frame[`FFD_FRAME_VERTEX],
                        frame[`FFD_FRAME_POINTS], claims};
  wire [11:0] place  = frame[`FFD_FRAME_INDEX];
  wire        within = place[3:0] <= size_q[3:0] && place[7:4] <= size_q[7:4]
                    && place[11:8] <= size_q[11:8];
  wire        has_place = payload && !(vertices && begins);
  wire [11:0] place_at  = opcode_q == COEFFICIENTS
                        ? 12'd12 * place[11:8] + 12'd4 * place[7:4] + place[3:0]
                        : opcode_q == LATTICE ? at_point(place, size_q)
                        : 12'd3 * place[7:4] + place[3:0] + 12'd1;

  always @* if (!first_q && !rst) begin
    resync: assert (frame[`FFD_FRAME_HEADER] == header_q && idle == header_q);
    follows: assert (flags && (header_q || same));
    kind: assert (framed == kinds
                  && frame[`FFD_FRAME_BANK] == (header_q && opcode == 1)
                  && frame[`FFD_FRAME_BUFFER] == (header_q && opcode == 2 && good));
    index: assert (!has_place || (place_at == at_q && frame[`FFD_FRAME_TOP] == whole));
    point_inside: assert (!frame[`FFD_FRAME_POINT] || within);
    ends: assert (frame[`FFD_FRAME_FINISH] == finish
                  && (!finish || frame[`FFD_FRAME_FINAL] == (left_q == 1 || last)));
    faults: assert (frame[`FFD_FRAME_UNKNOWN] == (header_q && opcode != 2 && !accepted)
                    && frame[`FFD_FRAME_SIZE] == (header_q && opcode == 2 && !good)
                    && frame[`FFD_FRAME_SHORT] == (header_q ? accepted && (last || none)
                                                            : payload && last && !complete)
                    && frame[`FFD_FRAME_LONG] == behind_q);
  end
endmodule

`default_nettype wire
