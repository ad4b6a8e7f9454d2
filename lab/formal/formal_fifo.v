// formal_fifo: ffd_stream_fifo with any traffic and any reset
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_fifo #(
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

  ffd_stream_fifo #(
    .WIDTH(WIDTH),
    .DEPTH(DEPTH)
  ) u_dut (
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
    .CAPACITY(DEPTH),
    .LATENCY (1),
    .WAIT    (0)
  ) u_properties (
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
endmodule

`default_nettype wire
