// async_fifo: a queue from one clock to another
//
// The counts of what was written and read cross in Gray code, of which one bit changes at a time, each
// through two flip-flops: either side sees a count that was true a little before, so the queue may look
// fuller, or emptier, than it is, and is never overrun. Words lie in a memory that is written with one
// clock and read in the other, where they have stood for two clocks before they are seen.
//
// Pipeline:   a word is seen three read clocks after its write, at most; II 1 in either clock.
// Parameters: WIDTH >= 1; DEPTH_LOG2 2 to 8, of words.
// Reset:      each side has its own, synchronous to its clock; let both go only when both are in reset.
// Source:     the scheme is the one of C. Cummings, SNUG 2002.  Test: tests/standalone/test_two_clocks.py
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module async_fifo #(
  parameter WIDTH      = 8,
  parameter DEPTH_LOG2 = 3
) (
  input  wire             write_clk,
  input  wire             write_rst,
  input  wire             write_valid_i,
  output wire             write_ready_o,
  input  wire [WIDTH-1:0] write_data_i,

  input  wire             read_clk,
  input  wire             read_rst,
  output wire             read_valid_o,
  input  wire             read_ready_i,
  output wire [WIDTH-1:0] read_data_o
);
  reg [WIDTH-1:0]    memory_q [0:2**DEPTH_LOG2-1];
  reg [DEPTH_LOG2:0] written_q, written_gray_q;  // how many, and a bit more: full is not empty
  reg [DEPTH_LOG2:0] read_q, read_gray_q;
  (* ASYNC_REG = "TRUE" *) reg [DEPTH_LOG2:0] read_at_write_q  [0:1];
  (* ASYNC_REG = "TRUE" *) reg [DEPTH_LOG2:0] written_at_read_q [0:1];

  wire                write_go    = write_valid_i && write_ready_o;
  wire                read_go     = read_valid_o && read_ready_i;
  wire [DEPTH_LOG2:0] written_d   = written_q + {{DEPTH_LOG2 {1'b0}}, write_go};
  wire [DEPTH_LOG2:0] read_d      = read_q + {{DEPTH_LOG2 {1'b0}}, read_go};
  // In Gray code a whole round differs in the two highest bits.
  wire [DEPTH_LOG2:0] a_round_ago = read_at_write_q[1] ^ {2'b11, {(DEPTH_LOG2 - 1) {1'b0}}};

  assign write_ready_o = !write_rst && written_gray_q != a_round_ago;
  assign read_valid_o  = !read_rst && read_gray_q != written_at_read_q[1];
  assign read_data_o   = memory_q[read_q[DEPTH_LOG2-1:0]];

  always @(posedge write_clk) begin
    if (write_go) memory_q[written_q[DEPTH_LOG2-1:0]] <= write_data_i;
    written_q          <= written_d;
    written_gray_q     <= written_d ^ written_d >> 1;
    read_at_write_q[0] <= read_gray_q;
    read_at_write_q[1] <= read_at_write_q[0];
    if (write_rst) begin
      written_q          <= 0;
      written_gray_q     <= 0;
      read_at_write_q[0] <= 0;
      read_at_write_q[1] <= 0;
    end
  end

  always @(posedge read_clk) begin
    read_q               <= read_d;
    read_gray_q          <= read_d ^ read_d >> 1;
    written_at_read_q[0] <= written_gray_q;
    written_at_read_q[1] <= written_at_read_q[0];
    if (read_rst) begin
      read_q               <= 0;
      read_gray_q          <= 0;
      written_at_read_q[0] <= 0;
      written_at_read_q[1] <= 0;
    end
  end
endmodule

`default_nettype wire
