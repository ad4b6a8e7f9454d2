// ffd_stream_skid: a full cut of a stream: ready, valid and data all leave registers
//
// Two registers deep, so that no clock is lost: a beat taken in while the output waits rests in the
// second. No path crosses it, neither valid and data forward nor ready backward. Ready is 0 in
// reset and in the first clock after it: a beat offered then is refused, never lost.
//
// Pipeline:   1 clock, II 1.  Freezes: when m_ready is 0, with at most two beats inside.
// Parameters: WIDTH >= 1.
// Model:      none (transport only).  Test: every system test.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_stream_skid #(
  parameter WIDTH = 129
) (
  input  wire             clk,
  input  wire             rst,
  input  wire             s_beat_valid,
  output reg              s_beat_ready,
  input  wire [WIDTH-1:0] s_beat_data,
  output reg              m_beat_valid,
  input  wire             m_beat_ready,
  output reg  [WIDTH-1:0] m_beat_data
);
  generate
    if (WIDTH < 1) begin : gen_bad_width
      ERROR_ffd_stream_skid_width_must_be_at_least_1 u_error ();
    end
  endgenerate

  reg              waiting_q;
  reg  [WIDTH-1:0] waiting_data_q;
  wire             take = s_beat_valid && s_beat_ready;
  wire             move = m_beat_ready || !m_beat_valid;

  // A beat waits where one came in while the output could not move, until it can.
  wire waiting_d = !move && (waiting_q || take);

  always @(posedge clk) begin
    if (rst) begin
      s_beat_ready <= 1'b0;
      m_beat_valid <= 1'b0;
      waiting_q    <= 1'b0;
    end else begin
      s_beat_ready <= !waiting_d;
      waiting_q    <= waiting_d;
      if (move) m_beat_valid <= waiting_q || take;
    end
  end

  always @(posedge clk) begin
    if (move) m_beat_data <= waiting_q ? waiting_data_q : s_beat_data;
    if (take) waiting_data_q <= s_beat_data;
  end
endmodule

`default_nettype wire
