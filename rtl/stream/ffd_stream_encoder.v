// ffd_stream_encoder: a result becomes a beat {status, tag, z, y, x}
//
// Status bits (docs/interface.md section 4): 0 saturated, 1 clamped, 2 NaN, 3 outside, 4 truncated,
// 5 unloaded, 6 folded: det J, which is the word x of its result, is not positive; the rest is 0. A
// blank vertex gives blank coordinates (canonical NaN, or 0 in fixed
// point), never what the datapath made of half a vertex. Beside a determinant y and z are 0.
//
// Formats:    flags {folded, nan, saturated}; user as FFD_USER_*.
// Pipeline:   1 clock: the last register of the stream.
// Freezes:    s_word_ready is 0 while a beat waits to be taken.
// Parameters: FORMAT as in ffd_num.vh.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_stream.vh"

module ffd_stream_encoder #(
  parameter FORMAT = 18
) (
  input  wire                    clk,
  input  wire                    rst,
  input  wire                    s_word_valid,
  output wire                    s_word_ready,
  input  wire [95:0]             s_word_data,
  input  wire [2:0]              s_word_flags,
  input  wire                    s_word_determinant,
  input  wire [`FFD_USER_W-1:0]  s_word_user,
  output reg                     m_beat_valid,
  input  wire                    m_beat_ready,
  output wire [127:0]            m_beat_data,
  output reg                     m_beat_last
);
  wire       blank = s_word_user[`FFD_USER_BLANK];
  wire [2:0] flags = s_word_flags & {3{!blank}};
  wire [6:0] found = {flags[2], 3'd0, flags[1], 1'b0, flags[0]};

  // The words y and z are 0 beside a determinant, and where the blank word is.
  wire clear = blank ? `FFD_BLANK_IS_ZERO(FORMAT) : s_word_determinant;

  reg [95:0] words_q;
  reg [6:0]  status_q;
  reg [15:0] tag_q;
  assign s_word_ready = !m_beat_valid || m_beat_ready;
  assign m_beat_data  = {9'd0, status_q, tag_q, words_q};

  always @(posedge clk) begin
    if (rst) m_beat_valid <= 1'b0;
    else if (s_word_ready) m_beat_valid <= s_word_valid;
  end
  always @(posedge clk) begin
    if (s_word_ready && blank) words_q[31:0] <= `FFD_BLANK_WORD(FORMAT);
    else if (s_word_ready) words_q[31:0] <= s_word_data[31:0];
  end
  always @(posedge clk) begin
    if (s_word_ready && clear) words_q[95:32] <= 64'd0;
    else if (s_word_ready && blank) words_q[95:32] <= {2{`FFD_BLANK_WORD(FORMAT)}};
    else if (s_word_ready) words_q[95:32] <= s_word_data[95:32];
  end
  always @(posedge clk) begin
    if (s_word_ready) begin
      status_q    <= {1'b0, s_word_user[`FFD_USER_STATUS]} | found;
      tag_q       <= s_word_user[`FFD_USER_TAG];
      m_beat_last <= s_word_user[`FFD_USER_LAST];
    end
  end

  wire unused_ok = &{1'b0, s_word_user};
endmodule

`default_nettype wire
