// formal_deep_fifo: ffd_stream_deep_fifo with any traffic and any reset, without EARLY and with, and
// with COUNTED under one who counts
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_deep_fifo #(
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

  ffd_stream_deep_fifo #(
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
    .CAPACITY(DEPTH + 1),
    .LATENCY (2),
    .WAIT    (0)
  ) exact (
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

  wire             early_ready;
  wire             early_valid;
  wire [WIDTH-1:0] early_data;

  ffd_stream_deep_fifo #(
    .WIDTH(WIDTH),
    .DEPTH(DEPTH),
    .EARLY(1)
  ) u_early (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(s_valid),
    .s_word_ready(early_ready),
    .s_word_data (s_data),
    .m_word_valid(early_valid),
    .m_word_ready(m_ready),
    .m_word_data (early_data)
  );

  // When a word is taken is said below.
  properties_queue #(
    .WIDTH   (WIDTH),
    .CAPACITY(DEPTH + 1),
    .LATENCY (2),
    .WAIT    (16)
  ) early (
    .clk     (clk),
    .rst     (rst),
    .s_valid (s_valid),
    .s_ready (early_ready),
    .s_data  (s_data),
    .m_valid (early_valid),
    .m_ready (m_ready),
    .m_data  (early_data),
    .follow_i(follow)
  );

  reg                       first_q = 1'b1;
  reg                       refused_q;     // with room, in the clock before
  reg [$clog2(DEPTH + 2):0] inside_q;
  wire                      refused = inside_q < DEPTH - 1 && !early_ready;
  always @(posedge clk) begin
    first_q   <= 1'b0;
    refused_q <= refused && !rst;
    inside_q  <= rst ? 0 : inside_q + (s_valid && early_ready) - (early_valid && m_ready);
  end
  always @* if (!first_q && !rst) early_live: assert (!refused || !refused_q);

  wire                      counted_ready;
  wire                      counted_valid;
  wire [WIDTH-1:0]          counted_data;
  reg [$clog2(DEPTH + 2):0] sent_q;        // and not taken
  wire                      send = s_valid && sent_q < DEPTH;
  always @(posedge clk) sent_q <= rst ? 0 : sent_q + send - (counted_valid && m_ready);

  ffd_stream_deep_fifo #(
    .WIDTH  (WIDTH),
    .DEPTH  (DEPTH),
    .COUNTED(1)
  ) u_counted (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(send),
    .s_word_ready(counted_ready),
    .s_word_data (s_data),
    .m_word_valid(counted_valid),
    .m_word_ready(m_ready),
    .m_word_data (counted_data)
  );

  properties_queue #(
    .WIDTH   (WIDTH),
    .CAPACITY(DEPTH),
    .LATENCY (2),
    .WAIT    (0)
  ) counted (
    .clk     (clk),
    .rst     (rst),
    .s_valid (send),
    .s_ready (counted_ready),
    .s_data  (s_data),
    .m_valid (counted_valid),
    .m_ready (m_ready),
    .m_data  (counted_data),
    .follow_i(follow)
  );
endmodule

`default_nettype wire
