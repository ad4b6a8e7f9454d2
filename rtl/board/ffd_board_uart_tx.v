// ffd_board_uart_tx: bytes to a serial line, 8 data bits, no parity, 1 stop bit
//
// Pipeline:   the start bit begins in the clock after a byte was taken; the next byte is taken in
//             the last clock of the stop bit, so that characters follow each other without a gap.
// Freezes:    s_byte_ready is 0 while a character is under way.
// Parameters: CLOCKS a bit, 2 or more.
// Model:      none (bytes only).  Test: tests/boards.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_board_uart_tx #(
  parameter CLOCKS = 12
) (
  input  wire       clk,
  input  wire       rst,
  input  wire       s_byte_valid,
  output wire       s_byte_ready,
  input  wire [7:0] s_byte_data,
  output wire       uart_tx_o
);
  generate
    if (CLOCKS < 2) begin : gen_bad_clocks
      ERROR_ffd_board_uart_tx_clocks_must_be_at_least_2 u_error ();
    end
  endgenerate

  localparam               CLOCK_W = $clog2(CLOCKS);
  localparam               LAST_I  = CLOCKS - 1;
  localparam [CLOCK_W-1:0] LAST    = LAST_I[CLOCK_W-1:0];
  localparam [3:0]         BITS    = 4'd10;

  reg  [3:0]         left_q;   // bits, the one on the line included
  reg  [CLOCK_W-1:0] clock_q;
  reg  [8:0]         shift_q;  // lowest on the line; ones follow
  wire               turn = clock_q == LAST;
  wire               take = s_byte_valid && s_byte_ready;

  assign s_byte_ready = left_q == 4'd0 || (left_q == 4'd1 && turn);
  assign uart_tx_o    = shift_q[0];

  always @(posedge clk) begin
    if (rst) left_q <= 4'd0;
    else if (take) left_q <= BITS;
    else if (turn && left_q != 4'd0) left_q <= left_q - 4'd1;
  end

  always @(posedge clk) begin
    if (take || turn) clock_q <= {CLOCK_W{1'b0}};
    else clock_q <= clock_q + 1'b1;
  end

  always @(posedge clk) begin
    if (rst) shift_q <= 9'h1ff;
    else if (take) shift_q <= {s_byte_data, 1'b0};
    else if (turn) shift_q <= {1'b1, shift_q[8:1]};
  end
endmodule

`default_nettype wire
