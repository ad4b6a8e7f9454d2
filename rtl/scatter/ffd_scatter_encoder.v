// ffd_scatter_encoder: sums that a collect reads become result beats {status, tag, z, y, x}
//
// Tags count up from that of the packet. Status bits (docs/interface.md section 2): 0 saturated, of
// this beat's words or of a vertex of the page; 7 overflowed, of the page. ffd_stream_ending adds
// what the flags ask for.
//
// Formats:    words as stream words; flags {I, R} and status {overflowed, saturated} stay from the
//             first word of a collect until collected_o.
// Pipeline:   as ffd_stream_ending.
// Freezes:    s_word_ready is 0 while a beat waits to be taken.
// Model:      golden/include/hwffd/model/scatter_stream.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_scatter_encoder (
  input  wire         clk,
  input  wire         rst,
  input  wire [15:0]  tag_i,
  input  wire [1:0]   flags_i,
  input  wire [1:0]   status_i,
  input  wire         s_word_valid,
  output wire         s_word_ready,
  input  wire [95:0]  s_word_data,
  input  wire         s_word_saturated,
  input  wire         s_word_last,
  output wire         saturated_o,   // event: a word that is taken
  output wire         collected_o,   // the last beat is on its way
  output wire         idle_o,
  output wire         m_beat_valid,
  input  wire         m_beat_ready,
  output wire [127:0] m_beat_data,
  output wire         m_beat_last,
  output wire         m_beat_mark
);
  wire [31:0]  number;
  wire         unused_two;  // a point is one unit
  wire [15:0]  tag    = tag_i + number[15:0];
  wire [7:0]   status = {status_i[1], 6'd0, status_i[0] || s_word_saturated};
  ffd_stream_ending u_ending (
    .clk         (clk),
    .rst         (rst),
    .flags_i     (flags_i),
    .number_o    (number),
    .ended_o     (collected_o),
    .s_beat_valid(s_word_valid),
    .s_beat_ready(s_word_ready),
    .s_beat_data ({8'd0, status, tag, s_word_data}),
    .s_beat_two  (1'b0),
    .s_beat_last (s_word_last),
    .m_beat_valid(m_beat_valid),
    .m_beat_ready(m_beat_ready),
    .m_beat_data (m_beat_data),
    .m_beat_two  (unused_two),
    .m_beat_last (m_beat_last),
    .m_beat_mark (m_beat_mark)
  );
  assign saturated_o = s_word_valid && s_word_ready && s_word_saturated;
  assign idle_o      = !m_beat_valid;

  wire unused_ok = &{1'b0, number[31:16]};
endmodule

`default_nettype wire
