// ffd_stream_intake: the first register of a stream, without a second one to fall back on
//
// s_beat_ready leaves a register, so it is promised a clock before anyone knows whether the beat in
// here can go on. It is promised only behind a beat that surely can: s_beat_waits says of each beat
// that comes whether it may have to wait. Such a beat is held, with a pause behind it, until go_i
// says that it can go; all others go on in the next clock.
//
// Pipeline:   1 clock, II 1; a beat that may have to wait 2, and a pause of 2 behind it.
// Freezes:    s_beat_ready is 0 while a beat is held. What goes on is never held back.
// Parameters: WIDTH >= 1.
// Model:      none (transport only).  Test: tests/system; proved with the decoder behind it.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_stream_intake #(
  parameter WIDTH = 129
) (
  input  wire             clk,
  input  wire             rst,
  input  wire             s_beat_valid,
  output reg              s_beat_ready,
  input  wire             s_beat_waits,
  input  wire [WIDTH-1:0] s_beat_data,
  input  wire             go_i,           // the beat that is held can go on
  output wire             held_o,
  output reg              beat_valid_o,
  output reg  [WIDTH-1:0] beat_data_o
);
  reg  held_q;
  wire take = s_beat_valid && s_beat_ready;
  wire stay = held_q && !go_i;
  assign held_o = held_q;

  always @(posedge clk) begin
    if (rst) begin
      s_beat_ready <= 1'b0;
      held_q       <= 1'b0;
      beat_valid_o <= 1'b0;
    end else begin
      s_beat_ready <= take ? !s_beat_waits : !stay;
      held_q       <= take ? s_beat_waits : stay;
      beat_valid_o <= take ? !s_beat_waits : held_q && go_i;
    end
  end
  always @(posedge clk) if (take) beat_data_o <= s_beat_data;
endmodule

`default_nettype wire
