// ffd_stream_queue: first in, first out in block memory, DEPTH words, out of registers
//
// ffd_stream_deep_fifo with a skid buffer behind it: a block memory's output comes late in its
// clock, and nothing but the skid buffer's registers has to wait for it.
//
// Pipeline:   3 clocks from in to out, II 1.  Freezes: s_ready is 0 when full. Every output leaves
//             a register.
// Parameters: WIDTH >= 1, DEPTH a power of two >= 2; two words more fit behind the memory.
// Model:      none (transport only).  Test: every system test; its parts are proved.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_stream_queue #(
  parameter WIDTH = 32,
  parameter DEPTH = 128
) (
  input  wire             clk,
  input  wire             rst,
  input  wire             s_word_valid,
  output wire             s_word_ready,
  input  wire [WIDTH-1:0] s_word_data,
  output wire             m_word_valid,
  input  wire             m_word_ready,
  output wire [WIDTH-1:0] m_word_data
);
  wire             stored_valid;
  wire             stored_ready;
  wire [WIDTH-1:0] stored_data;

  ffd_stream_deep_fifo #(
    .WIDTH(WIDTH),
    .DEPTH(DEPTH)
  ) u_fifo (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(s_word_valid),
    .s_word_ready(s_word_ready),
    .s_word_data (s_word_data),
    .m_word_valid(stored_valid),
    .m_word_ready(stored_ready),
    .m_word_data (stored_data)
  );

  ffd_stream_skid #(
    .WIDTH(WIDTH)
  ) u_skid (
    .clk         (clk),
    .rst         (rst),
    .s_beat_valid(stored_valid),
    .s_beat_ready(stored_ready),
    .s_beat_data (stored_data),
    .m_beat_valid(m_word_valid),
    .m_beat_ready(m_word_ready),
    .m_beat_data (m_word_data)
  );
endmodule

`default_nettype wire
