// formal_queue: ffd_stream_queue with any traffic and any reset, in each kind of memory
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_queue #(
  parameter WIDTH = 4,
  parameter DEPTH = 4
) (
  input wire             clk,
  input wire             rst,
  input wire             s_valid,
  input wire [WIDTH-1:0] s_data,
  input wire             m_ready,
  input wire             follow
);
  wire             s_ready;
  wire             m_valid;
  wire [WIDTH-1:0] m_data;

  ffd_stream_queue #(
    .WIDTH(WIDTH),
    .DEPTH(DEPTH),
    .BLOCK(1)
  ) u_block (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(s_valid),
    .s_word_ready(s_ready),
    .s_word_data (s_data),
    .m_word_valid(m_valid),
    .m_word_ready(m_ready),
    .m_word_data (m_data)
  );

  properties_queue #(
    .WIDTH   (WIDTH),
    .CAPACITY(DEPTH + 2),
    .LATENCY (3),
    .WAIT    (0)
  ) block (
    .clk     (clk),
    .rst     (rst),
    .s_valid (s_valid),
    .s_ready (s_ready),
    .s_data  (s_data),
    .m_valid (m_valid),
    .m_ready (m_ready),
    .m_data  (m_data),
    .follow_i(follow)
  );

  wire             d_ready;
  wire             d_valid;
  wire [WIDTH-1:0] d_data;

  ffd_stream_queue #(
    .WIDTH(WIDTH),
    .DEPTH(DEPTH),
    .BLOCK(0)
  ) u_distributed (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(s_valid),
    .s_word_ready(d_ready),
    .s_word_data (s_data),
    .m_word_valid(d_valid),
    .m_word_ready(m_ready),
    .m_word_data (d_data)
  );

  properties_queue #(
    .WIDTH   (WIDTH),
    .CAPACITY(DEPTH + 1),
    .LATENCY (2),
    .WAIT    (0)
  ) distributed (
    .clk     (clk),
    .rst     (rst),
    .s_valid (s_valid),
    .s_ready (d_ready),
    .s_data  (s_data),
    .m_valid (d_valid),
    .m_ready (m_ready),
    .m_data  (d_data),
    .follow_i(follow)
  );
endmodule

`default_nettype wire
