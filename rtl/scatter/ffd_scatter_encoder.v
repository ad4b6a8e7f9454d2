// ffd_scatter_encoder: sums that a collect reads become result beats {status, tag, z, y, x}
//
// Tags count up from that of the packet. Status bits (docs/interface.md section 2): 0 saturated, of
// this beat's words or of a vertex of the page; 7 overflowed, of the page. With the flag R one more
// beat follows, {all ones, 0, 0, points}, and tlast is with it; mark with I comes with tlast.
//
// Formats:    words as stream words; flags {I, R} and status {overflowed, saturated} stay from the
//             collect's start_i until collected_o.
// Pipeline:   1 clock: the last register of the stream. II 1, and one more for a count.
// Freezes:    s_word_ready is 0 while a beat waits to be taken.
// Model:      golden/include/hwffd/model/scatter_stream.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_scatter_encoder (
  input  wire         clk,
  input  wire         rst,
  input  wire         start_i,       // before its first word
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
  reg          valid_q;
  reg          due_q;    // the count comes next
  reg          last_q;
  reg          mark_q;
  reg  [127:0] data_q;
  reg  [31:0]  count_q;
  wire         free    = !valid_q || m_beat_ready;
  wire         take    = s_word_valid && s_word_ready;
  wire         counted = free && due_q;
  wire         last    = due_q || (s_word_last && !flags_i[0]);
  wire [15:0]  tag     = tag_i + count_q[15:0];
  wire [7:0]   status  = {status_i[1], 6'd0, status_i[0] || s_word_saturated};

  assign s_word_ready = free && !due_q;
  assign saturated_o  = take && s_word_saturated;
  assign collected_o  = (take || counted) && last;
  assign idle_o       = !valid_q && !due_q;

  always @(posedge clk) begin
    if (rst) begin
      valid_q <= 1'b0;
      due_q   <= 1'b0;
    end else if (free) begin
      valid_q <= s_word_valid || due_q;
      due_q   <= take && s_word_last && flags_i[0];
    end
  end
  always @(posedge clk) begin
    if (start_i) count_q <= 32'd0;
    else if (take) count_q <= count_q + 32'd1;
  end
  always @(posedge clk) begin
    if (free) begin
      data_q <= due_q ? {32'hFFFF_FFFF, 64'd0, count_q} : {8'd0, status, tag, s_word_data};
      last_q <= last;
      mark_q <= last && flags_i[1];
    end
  end

  assign m_beat_valid = valid_q;
  assign m_beat_data  = data_q;
  assign m_beat_last  = last_q;
  assign m_beat_mark  = mark_q;
endmodule

`default_nettype wire
