// ffd_stream_queue: a FIFO whose words leave a register
//
// Up to 16 words, what a look-up table holds, wait in distributed memory, more in block memory; and
// there is a register for the word that is next: what a memory gives comes too late in its clock
// for any logic.
//
// Pipeline:   a word can leave in the third clock after it came, without BLOCK in the second; II 1.
// Freezes:    s_word_ready is 0 while DEPTH words wait in the memory.
// Parameters: WIDTH >= 1, DEPTH a power of two >= 2, BLOCK 0 or 1: which memory; COUNTED as in
//             ffd_stream_deep_fifo, in block memory only.
// Model:      none (storage only).  Test: every system test.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_stream_queue #(
  parameter WIDTH   = 32,
  parameter DEPTH   = 128,
  parameter BLOCK   = DEPTH > 16,
  parameter COUNTED = 0
) (
  input  wire             clk,
  input  wire             rst,
  input  wire             s_word_valid,
  output wire             s_word_ready,
  input  wire [WIDTH-1:0] s_word_data,
  output reg              m_word_valid,
  input  wire             m_word_ready,
  output reg  [WIDTH-1:0] m_word_data
);
  wire             stored_valid;
  wire             stored_ready = !m_word_valid || m_word_ready;
  wire [WIDTH-1:0] stored_data;

  generate
    if (BLOCK) begin : gen_block
      ffd_stream_deep_fifo #(
        .WIDTH  (WIDTH),
        .DEPTH  (DEPTH),
        .COUNTED(COUNTED)
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
    end else begin : gen_distributed
      ffd_stream_fifo #(
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
    end
  endgenerate

  always @(posedge clk) begin
    if (rst) m_word_valid <= 1'b0;
    else if (stored_ready) m_word_valid <= stored_valid;
  end
  always @(posedge clk) if (stored_ready) m_word_data <= stored_data;
endmodule

`default_nettype wire
