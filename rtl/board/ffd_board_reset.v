// ffd_board_reset: reset for the first clocks after configuration, where a board has no pin for it
//
// Relies on registers that start from 0, as those of FPGAs do.
//
// Pipeline:   rst_o falls 16 clocks after the first edge.
// Model:      none.  Test: tests/boards.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_board_reset (
  input  wire clk,
  output wire rst_o
);
  reg [4:0] count_q = 5'd0;

  assign rst_o = !count_q[4];

  always @(posedge clk) begin
    if (rst_o) count_q <= count_q + 5'd1;
  end
endmodule

`default_nettype wire
