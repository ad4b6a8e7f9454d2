// ffd_scatter_entry: two beats of a stream wait here
//
// A beat leaves a register; one that comes while it waits stands in a second register behind it.
//
// Pipeline:   1 clock, II 1. No beat is taken in the first clock after reset.
// Freezes:    s_beat_ready is 0 while two beats wait.
// Cuts:       all paths: s_beat_ready and outputs leave registers.
// Parameters: WIDTH >= 1.
// Model:      none (transport only).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_scatter_entry #(
  parameter WIDTH = 129
) (
  input  wire             clk,
  input  wire             rst,
  input  wire             s_beat_valid,
  output wire             s_beat_ready,
  input  wire [WIDTH-1:0] s_beat_data,
  output wire             m_beat_valid,
  input  wire             m_beat_ready,
  output wire [WIDTH-1:0] m_beat_data
);
  reg              ready_q;
  reg              valid_q;
  reg  [WIDTH-1:0] data_q;
  reg              second_q;  // the second register has a beat
  reg  [WIDTH-1:0] second_data_q;
  wire             take   = s_beat_valid && ready_q;
  wire             free   = !valid_q || m_beat_ready;
  wire             second = (second_q || take) && !free;

  assign s_beat_ready = ready_q;
  assign m_beat_valid = valid_q;
  assign m_beat_data  = data_q;

  always @(posedge clk) begin
    if (rst) begin
      ready_q  <= 1'b0;
      valid_q  <= 1'b0;
      second_q <= 1'b0;
    end else begin
      ready_q  <= !second;
      second_q <= second;
      if (free) valid_q <= take || second_q;
    end
  end
  always @(posedge clk) begin
    if (free) data_q <= second_q ? second_data_q : s_beat_data;
    if (ready_q) second_data_q <= s_beat_data;
  end
endmodule

`default_nettype wire
