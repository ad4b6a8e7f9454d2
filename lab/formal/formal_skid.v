// formal_skid: ffd_stream_skid with any traffic and any reset
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_skid #(
  parameter WIDTH = 8
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

  ffd_stream_skid #(
    .WIDTH(WIDTH)
  ) u_dut (
    .clk         (clk),
    .rst         (rst),
    .s_beat_valid(s_valid),
    .s_beat_ready(s_ready),
    .s_beat_data (s_data),
    .m_beat_valid(m_valid),
    .m_beat_ready(m_ready),
    .m_beat_data (m_data)
  );

  properties_queue #(
    .WIDTH   (WIDTH),
    .CAPACITY(2),
    .LATENCY (1),
    .WAIT    (1)
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

  // Ready is 0 in the first clock after reset too, and otherwise 1 whenever there is room.
  reg first_q = 1'b1;
  reg rst_q;
  always @(posedge clk) begin
    first_q <= 1'b0;
    rst_q   <= rst;
  end
  always @* if (!first_q) begin
    closed: assert (!rst_q || !s_ready);
  end

  (* hierconn *) wire [1:0] \u_properties.inside_q ;
  always @* if (!first_q && !rst && !rst_q) begin
    rate: assert (s_ready == (\u_properties.inside_q < 2));
  end
endmodule

`default_nettype wire
