// ffd_bus_sleep: whether the clock may stop
//
// Nothing has happened (calm_i) for so many clocks that all that follows an event has ended:
// counts, error record, interrupt.
//
// Pipeline:   sleep_o rises 9 clocks after the last that was not calm, and falls after the next.
// Freezes:    never.
// Model:      none.  Test: tests/bus/axi/sleep_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_bus_sleep (
  input  wire clk,
  input  wire rst,
  input  wire calm_i,
  output reg  sleep_o
);
  reg [2:0] calm_q;

  always @(posedge clk) begin
    if (rst || !calm_i) begin
      sleep_o <= 1'b0;
      calm_q  <= 3'd0;
    end else begin
      sleep_o <= calm_q == 3'd7;
      if (calm_q != 3'd7) calm_q <= calm_q + 3'd1;
    end
  end
endmodule

`default_nettype wire
