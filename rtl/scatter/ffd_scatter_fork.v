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
// Pipeline:   1 clock to the scatter core, which begins with an ffd_scatter_entry, 2 to the
//             evaluator, which does not; a beat a clock. A header that changes the half goes 3
//             clocks behind the first in which idle is 1.
// Freezes:    s_beat_ready is 0 while two beats wait: for both halves, and as above.
// Cuts:       s_beat_ready and what goes to the evaluator leave registers; m_scatter_valid follows
//             registers of this module alone.
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
  output wire [127:0] m_evaluator_data,
  output wire         m_evaluator_last,
  output wire [127:0] m_scatter_data,
  output wire         m_scatter_last,
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

  wire there;
  wire take;
  wire scatter;  // the packet, if the beat is a header
  ffd_scatter_entry #(
    .WIDTH(130)
  ) u_entry (
    .clk         (clk),
    .rst         (rst),
    .s_beat_valid(s_beat_valid),
    .s_beat_ready(s_beat_ready),
    .s_beat_data ({s_scatter, s_beat_last, s_beat_data}),
    .m_beat_valid(there),
    .m_beat_ready(take),
    .m_beat_data ({scatter, m_scatter_last, m_scatter_data})
  );

  // The scatter core has such an entry of its own.
  wire evaluator_valid;
  wire evaluator_ready;
  ffd_scatter_entry #(
    .WIDTH(129)
  ) u_evaluator (
    .clk         (clk),
    .rst         (rst),
    .s_beat_valid(evaluator_valid),
    .s_beat_ready(evaluator_ready),
    .s_beat_data ({m_scatter_last, m_scatter_data}),
    .m_beat_valid(m_evaluator_valid),
    .m_beat_ready(m_evaluator_ready),
    .m_beat_data ({m_evaluator_last, m_evaluator_data})
  );

  // ---- what may go on: idle is that of two clocks before, since when no beat has gone

  reg  header_q;
  reg  scatter_q;
  reg  take_q;
  reg  evaluator_idle_q;
  reg  scatter_idle_q;
  reg  free_q;
  wire changes = header_q && scatter != scatter_q;
  wire goes    = there && !(changes && !free_q);
  assign take            = goes && evaluator_ready && m_scatter_ready;
  assign evaluator_valid = goes && m_scatter_ready;
  assign m_scatter_valid = goes && evaluator_ready;
  assign scatter_o       = scatter_q;
  assign waits_o         = there && changes && !free_q;
  assign idle_o          = !there && header_q && !m_evaluator_valid;
  always @(posedge clk) begin
    if (rst) begin
      header_q  <= 1'b1;
      scatter_q <= 1'b0;
    end else if (take) begin
      header_q <= m_scatter_last;
      if (header_q) scatter_q <= scatter;
    end
  end
  always @(posedge clk) begin
    take_q           <= take;
    evaluator_idle_q <= evaluator_idle_i && !m_evaluator_valid;
    scatter_idle_q   <= scatter_idle_i;
    free_q           <= !rst && !take && !take_q
                     && (scatter_q ? scatter_idle_q : evaluator_idle_q);
  end

  wire unused_ok = &{1'b0, packet};
endmodule

`default_nettype wire
