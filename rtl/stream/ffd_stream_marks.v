// ffd_stream_marks: the flags R and I of packets of vertices, at their last result
//
// Behind the encoder. What a packet of opcode 7 asks for waits in a queue from its last vertex on
// until its last result. With R that result is no longer the last beat: one more comes, {all ones,
// 0, 0, results of the packet}. m_beat_mark: the last beat of a packet with I.
//
// Formats:    data_i and frame_i of the decoder's beats; beats as those of hwffd_stream.
// Pipeline:   1 clock, the last register of the stream; II 1, and one more for a count.
// Freezes:    while m_beat_ready is 0.
// Parameters: FEATURES as in ffd_stream.vh: without that of marks all of it is wires; INSIDE, the
//             most vertices that are inside.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_stream.vh"

module ffd_stream_marks #(
  parameter FEATURES = `FFD_FEATURES,
  parameter INSIDE   = 152
) (
  input  wire                    clk,
  input  wire                    rst,
  input  wire                    valid_i,
  input  wire [31:0]             data_i,  // word 0
  input  wire [`FFD_FRAME_W-1:0] frame_i,
  input  wire                    s_beat_valid,
  output wire                    s_beat_ready,
  input  wire [127:0]            s_beat_data,
  input  wire                    s_beat_last,
  output wire                    m_beat_valid,
  input  wire                    m_beat_ready,
  output wire [127:0]            m_beat_data,
  output wire                    m_beat_last,
  output wire                    m_beat_mark
);
  generate
    if (`FFD_FEATURE_MARKS(FEATURES) == 0) begin : gen_none
      assign s_beat_ready = m_beat_ready;
      assign m_beat_valid = s_beat_valid;
      assign m_beat_data  = s_beat_data;
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
      wire       interrupt;
      wire       count;

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
        .m_word_data ({interrupt, count})
      );

      // ---- results, and behind the last one their count

      reg         valid_q;
      reg         last_q;
      reg         mark_q;
      reg [127:0] data_q;
      reg         due_q;      // the count comes next
      reg         first_q;    // the next result is the first of its packet
      reg [31:0]  count_q;
      wire        free = !valid_q || m_beat_ready;
      wire        take = s_beat_valid && s_beat_ready;

      assign s_beat_ready = free && !due_q;
      assign m_beat_valid = valid_q;
      assign m_beat_data  = data_q;
      assign m_beat_last  = last_q;
      assign m_beat_mark  = mark_q;
      assign pop          = (take && s_beat_last && !count) || (free && due_q);

      always @(posedge clk) begin
        if (rst) begin
          valid_q <= 1'b0;
          due_q   <= 1'b0;
          first_q <= 1'b1;
        end else begin
          if (free) valid_q <= s_beat_valid || due_q;
          if (free) due_q <= take && s_beat_last && count;
          if (take) first_q <= s_beat_last;
        end
      end

      always @(posedge clk) begin
        if (take) count_q <= first_q ? 32'd1 : count_q + 1'b1;
        if (free) begin
          data_q <= due_q ? {32'hFFFF_FFFF, 64'd0, count_q} : s_beat_data;
          last_q <= due_q || (s_beat_last && !count);
          mark_q <= interrupt && (due_q || (s_beat_last && !count));
        end
      end

      wire unused_ok = &{1'b0, queue_ready, known, data_i, frame_i, packet};
      `FFD_ASSERT(a_packet_ends_and_the_queue_is_full,
                  !(valid_i && frame_i[`FFD_FRAME_FINISH] && frame_i[`FFD_FRAME_FINAL])
                  || queue_ready)
      `FFD_ASSERT(a_packet_s_last_result_comes_before_the_packet_has_ended, !pop || known)
    end
  endgenerate
endmodule

`default_nettype wire
