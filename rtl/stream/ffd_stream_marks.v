// ffd_stream_marks: the flags R and I of packets of vertices, at their last result
//
// Behind the encoder. What a packet of opcode 7 asks for waits in a queue from its last vertex on
// until its last result, behind which ffd_stream_ending gives it.
//
// Formats:    data_i and frame_i of the decoder's beats; beats as those of hwffd_stream.
// Pipeline:   1 clock, the last register of the stream; II 1, and one more for a count.
// Freezes:    while m_beat_ready is 0.
// Parameters: FEATURES as in ffd_stream.vh: without that of marks all of it is wires; INSIDE, the
//             most vertices that are inside; UNITS as in ffd_stream_ending.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_stream.vh"

module ffd_stream_marks #(
  parameter FEATURES = `FFD_FEATURES_USUAL,
  parameter INSIDE   = 152,
  parameter UNITS    = 1
) (
  input  wire                    clk,
  input  wire                    rst,
  input  wire                    valid_i,
  input  wire [31:0]             data_i,  // word 0
  input  wire [`FFD_FRAME_W-1:0] frame_i,
  input  wire                    s_beat_valid,
  output wire                    s_beat_ready,
  input  wire [128*UNITS-1:0]    s_beat_data,
  input  wire                    s_beat_two,
  input  wire                    s_beat_last,
  output wire                    m_beat_valid,
  input  wire                    m_beat_ready,
  output wire [128*UNITS-1:0]    m_beat_data,
  output wire                    m_beat_two,
  output wire                    m_beat_last,
  output wire                    m_beat_mark
);
  generate
    if (`FFD_FEATURE_MARKS(FEATURES) == 0) begin : gen_none
      assign s_beat_ready = m_beat_ready;
      assign m_beat_valid = s_beat_valid;
      assign m_beat_data  = s_beat_data;
      assign m_beat_two   = s_beat_two;
      assign m_beat_last  = s_beat_last;
      assign m_beat_mark  = 1'b0;
      wire unused_ok = &{1'b0, clk, rst, valid_i, data_i, frame_i};
    end else begin : gen_marks
      localparam DEPTH = 1 << $clog2(INSIDE);

      // ---- what is asked for, packet by packet

      reg  [1:0] flags_q;    // {I, R}
      wire [`FFD_PACKET_W-1:0] packet = frame_i[`FFD_FRAME_PACKET];
      wire       queue_ready;
      wire       known;
      wire       pop;
      wire [1:0] flags;

      always @(posedge clk) begin
        if (valid_i && frame_i[`FFD_FRAME_HEADER]) begin
          flags_q <= data_i[21:20] & {2{packet[`FFD_PACKET_PAGE_VERTICES]}};
        end
      end

      ffd_stream_fifo #(
        .WIDTH(2),
        .DEPTH(DEPTH)
      ) u_asked (
        .clk         (clk),
        .rst         (rst),
        .s_word_valid(valid_i && frame_i[`FFD_FRAME_FINISH] && frame_i[`FFD_FRAME_FINAL]),
        .s_word_ready(queue_ready),
        .s_word_data (flags_q),
        .m_word_valid(known),
        .m_word_ready(pop),
        .m_word_data (flags)
      );

      // ---- results

      wire [31:0] number;
      ffd_stream_ending #(
        .UNITS(UNITS)
      ) u_ending (
        .clk         (clk),
        .rst         (rst),
        .flags_i     (flags),
        .number_o    (number),
        .ended_o     (pop),
        .s_beat_valid(s_beat_valid),
        .s_beat_ready(s_beat_ready),
        .s_beat_data (s_beat_data),
        .s_beat_two  (s_beat_two),
        .s_beat_last (s_beat_last),
        .m_beat_valid(m_beat_valid),
        .m_beat_ready(m_beat_ready),
        .m_beat_data (m_beat_data),
        .m_beat_two  (m_beat_two),
        .m_beat_last (m_beat_last),
        .m_beat_mark (m_beat_mark)
      );

      wire unused_ok = &{1'b0, queue_ready, known, data_i, frame_i, packet, number};
      `FFD_ASSERT(a_packet_ends_and_the_queue_is_full,
                  !(valid_i && frame_i[`FFD_FRAME_FINISH] && frame_i[`FFD_FRAME_FINAL])
                  || queue_ready)
      `FFD_ASSERT(a_packet_s_last_result_comes_before_the_packet_has_ended, !pop || known)
    end
  endgenerate
endmodule

`default_nettype wire
