// ffd_board_uart_rx: bytes from a serial line, 8 data bits, no parity, 1 stop bit
//
// A start bit is looked at again in its middle, and each bit is sampled once in its middle. A byte
// whose stop bit is low is an error instead; so is a break. After either the line must be high
// before the next start bit.
//
// Pipeline:   two registers against metastability, then byte_valid_o or error_o, for one clock, in
//             the middle of the stop bit. line_o is the line behind the two registers.
// Freezes:    never; a byte that is not taken in its clock is lost.
// Parameters: CLOCKS a bit, 4 or more.
// Model:      none (bytes only).  Test: tests/boards.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_board_uart_rx #(
  parameter CLOCKS = 12
) (
  input  wire       clk,
  input  wire       rst,
  input  wire       uart_rx_i,
  output wire       line_o,
  output reg        byte_valid_o,
  output reg  [7:0] byte_o,
  output reg        error_o
);
  generate
    if (CLOCKS < 4) begin : gen_bad_clocks
      ERROR_ffd_board_uart_rx_clocks_must_be_at_least_4 u_error ();
    end
  endgenerate

  localparam               CLOCK_W = $clog2(CLOCKS);
  localparam               LAST_I  = CLOCKS - 1;
  localparam               HALF_I  = CLOCKS / 2 - 1;
  localparam [CLOCK_W-1:0] LAST    = LAST_I[CLOCK_W-1:0];
  localparam [CLOCK_W-1:0] HALF    = HALF_I[CLOCK_W-1:0];

  // Bits of a character: 0 is the start bit, 1 to 8 are data, 9 is the stop bit.
  localparam [3:0] START = 4'd0;
  localparam [3:0] STOP  = 4'd9;

  reg  [1:0]         line_q;
  reg                busy_q;
  reg                wait_q;  // for a high line
  reg  [3:0]         bit_q;
  reg  [CLOCK_W-1:0] clock_q;
  wire               sample = busy_q && clock_q == (bit_q == START ? HALF : LAST);
  wire               ends   = sample && bit_q == STOP;

  assign line_o = line_q[1];

  always @(posedge clk) line_q <= {line_q[0], uart_rx_i};

  always @(posedge clk) begin
    if (rst) begin
      busy_q <= 1'b0;
      wait_q <= 1'b1;
    end else if (!busy_q) begin
      busy_q <= !line_o && !wait_q;
      wait_q <= !line_o && wait_q;
    end else if (sample && bit_q == START && line_o) begin
      busy_q <= 1'b0;
    end else if (ends) begin
      busy_q <= 1'b0;
      wait_q <= !line_o;
    end
  end

  always @(posedge clk) begin
    if (!busy_q) begin
      clock_q <= {CLOCK_W{1'b0}};
      bit_q   <= START;
    end else begin
      clock_q <= sample ? {CLOCK_W{1'b0}} : clock_q + 1'b1;
      bit_q   <= bit_q + {3'd0, sample};
    end
  end

  always @(posedge clk) begin
    if (sample && bit_q != STOP) byte_o <= {line_o, byte_o[7:1]};
    byte_valid_o <= ends && line_o && !rst;
    error_o      <= ends && !line_o && !rst;
  end
endmodule

`default_nettype wire
