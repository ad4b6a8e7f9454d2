// SDPX9B: a block memory of Gowin with a port that writes and one that reads, as synth/gowin uses it
//
// 16 kbit and their ninths in words of one, two or four bytes of nine bits, the same for both ports.
// The address counts bits, a byte as eight of them; two bytes have their enables on its pins 1 and 0,
// four on 3 to 0. Read data is registered. Bytes that are read in the clock in which they are written
// are x, as yosys may not count on them.
//
// Pipeline:   the read register. LATENCY 1; CEB holds it.
// Parameters: others than these do not elaborate, nor do widths that differ, nor other contents than
//             zeros; they start at x, which is stricter. Blocks are selected by zeros.
// Not checked: OCE, which means nothing without an output register, and RESET, which is 0.
// Test:       the tests netlist.gw5a.* (tests/system).
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module SDPX9B #(
  parameter         BIT_WIDTH_0 = 36,
  parameter         BIT_WIDTH_1 = 36,
  parameter [287:0] INIT_RAM_00 = 288'd0
) (
  input  wire        CLKA,
  input  wire        CEA,
  input  wire [2:0]  BLKSELA,
  input  wire [13:0] ADA,
  input  wire [35:0] DI,
  input  wire        CLKB,
  input  wire        CEB,
  input  wire        OCE,
  input  wire        RESET,
  input  wire [2:0]  BLKSELB,
  input  wire [13:0] ADB,
  output wire [35:0] DO
);
  localparam WIDTH = BIT_WIDTH_0;
  localparam BYTES = WIDTH / 9;
  // Address pins that count within a word.
  localparam WITHIN = BYTES == 4 ? 5 : BYTES == 2 ? 4 : 3;

  generate
    if (BIT_WIDTH_0 != BIT_WIDTH_1 || (WIDTH != 9 && WIDTH != 18 && WIDTH != 36))
    begin : gen_bad_width
      ERROR_SDPX9B_widths_must_be_equal_and_9_18_or_36 u_error ();
    end
    if (INIT_RAM_00 != 288'd0) begin : gen_bad_contents
      ERROR_SDPX9B_contents_must_be_zeros u_error ();
    end
  endgenerate

  reg  [WIDTH-1:0] memory_q [0:(16384>>WITHIN)-1];
  reg  [WIDTH-1:0] read_q;
  wire             write = CEA && BLKSELA == 3'd0;
  wire [WIDTH-1:0] mask;

  wire [13-WITHIN:0] write_word = ADA[13:WITHIN];
  wire [13-WITHIN:0] read_word  = ADB[13:WITHIN];

  genvar i;
  generate
    for (i = 0; i < BYTES; i = i + 1) begin : gen_byte
      assign mask[9*i +: 9] = {9{write && (BYTES < 2 || ADA[i])}};
    end
  endgenerate

  always @(posedge CLKA) begin
    if (write) memory_q[write_word] <= memory_q[write_word] & ~mask | DI[WIDTH-1:0] & mask;
  end

  wire [WIDTH-1:0] clash = write_word == read_word ? mask : {WIDTH{1'b0}};
  always @(posedge CLKB) begin
    if (CEB && BLKSELB == 3'd0) begin
      read_q <= memory_q[read_word] & ~clash | {WIDTH{1'bx}} & clash;
    end
  end

  wire [71:0] wide = {{72-WIDTH{1'b0}}, read_q};
  assign DO = wide[35:0];
endmodule

`default_nettype wire
