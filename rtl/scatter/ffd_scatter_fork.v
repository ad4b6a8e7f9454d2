// ffd_scatter_fork: each beat goes to an evaluator and to a scatter core at once
//
// Packets are of one of the two: gradients and collects of the scatter core, all others of the
// evaluator, coefficients among them, which both take. Each half drops what is the other's, and
// counts it. A header waits here until the half that the packet before was of is idle, where it is
// not of the same one: so one half alone has results and events, in the order of the packets. It
// waits for nothing that is behind it, and a half whose results are taken gets idle.
//
// Formats:    scatter_o says of which half the packet is that was given last: the place of an
//             event is that half's.
// Pipeline:   1 clock, a beat a clock; a header that changes the half 2 clocks behind the first in
//             which idle is 1.
// Freezes:    s_beat_ready is 0 while two beats wait: for both halves, and as above.
// Cuts:       s_beat_ready leaves registers through gates, none an input of its stream; the valid
//             of a half follows the ready of the other one.
// Model:      none (transport only).  Test: tests/system/adjoint_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_stream.vh"

module ffd_scatter_fork (
  input  wire         clk,
  input  wire         rst,
  input  wire         s_beat_valid,
  output wire         s_beat_ready,
  input  wire [127:0] s_beat_data,
  input  wire         s_beat_last,
  output wire         m_evaluator_valid,
  input  wire         m_evaluator_ready,
  output wire         m_scatter_valid,
  input  wire         m_scatter_ready,
  output wire [127:0] m_beat_data,        // of both
  output wire         m_beat_last,
  input  wire         evaluator_idle_i,
  input  wire         scatter_idle_i,
  output wire         scatter_o,
  output wire         waits_o,            // a header, for a half
  output wire         idle_o
);
  wire [`FFD_PACKET_W-1:0] packet;
  ffd_stream_opcode #(
    .FEATURES(0),
    .SCATTER (1)
  ) u_opcode (
    .opcode_i(s_beat_data[7:0]),
    .packet_o(packet)
  );
  wire s_scatter = packet[`FFD_PACKET_GRADIENTS] || packet[`FFD_PACKET_COLLECT];

  // ---- two beats wait here; none is taken in the first clock after reset

  reg  open_q;
  wire ready;
  wire there;
  wire take;
  wire scatter;  // the packet, if the beat is a header
  always @(posedge clk) open_q <= !rst;
  assign s_beat_ready = ready && open_q;
  ffd_stream_fifo #(
    .WIDTH(130),
    .DEPTH(2)
  ) u_in (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(s_beat_valid && open_q),
    .s_word_ready(ready),
    .s_word_data ({s_scatter, s_beat_last, s_beat_data}),
    .m_word_valid(there),
    .m_word_ready(take),
    .m_word_data ({scatter, m_beat_last, m_beat_data})
  );

  // ---- what may go on: idle is that of the clock before, in which no beat went

  reg  header_q;
  reg  scatter_q;
  reg  free_q;
  wire changes = header_q && scatter != scatter_q;
  wire goes    = there && !(changes && !free_q);
  assign take              = goes && m_evaluator_ready && m_scatter_ready;
  assign m_evaluator_valid = goes && m_scatter_ready;
  assign m_scatter_valid   = goes && m_evaluator_ready;
  assign scatter_o         = scatter_q;
  assign waits_o           = there && changes && !free_q;
  assign idle_o            = !there && header_q;
  always @(posedge clk) begin
    if (rst) begin
      header_q  <= 1'b1;
      scatter_q <= 1'b0;
    end else if (take) begin
      header_q <= m_beat_last;
      if (header_q) scatter_q <= scatter;
    end
  end
  always @(posedge clk) begin
    free_q <= !rst && !take && (scatter_q ? scatter_idle_i : evaluator_idle_i);
  end

  wire unused_ok = &{1'b0, packet};
endmodule

`default_nettype wire
