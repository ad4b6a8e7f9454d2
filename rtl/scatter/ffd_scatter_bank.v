// ffd_scatter_bank: the sums of one bank, and the adder in front of them
//
// A word is read, and the part of a vertex is added to it, or to 0 where it is of another epoch;
// what comes of it is written two clocks after the read. So a word can be read again in the third
// clock after, and no sum is handed around the memory.
//
// Formats:    word {epoch, sum}, sum of 35 bits and part of PART_W in units of 2^-(W-1).
// Rounding:   none; modulo 2^35.
// Pipeline:   read_i | epoch_i, part | word_o, sum: write_i. II 1, never frozen; a word every third
//             clock.
// Bad input:  a word that is read again before it is written: FFD_ASSERTIONS.
// Parameters: PART_W 1 to 35; DEPTH >= 2, in words.
// Model:      golden/include/hwffd/model/scatter.hpp (ScatterPage).  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_scatter.vh"

module ffd_scatter_bank #(
  parameter PART_W    = 18,
  parameter DEPTH     = 512,
  parameter ADDRESS_W = $clog2(DEPTH)
) (
  input  wire                             clk,
  input  wire                             rst,
  input  wire                             read_i,
  input  wire [ADDRESS_W-1:0]             read_address_i,
  output reg  [`FFD_SCATTER_WORD_W-1:0]   word_o,         // as it is read, a clock later
  input  wire                             epoch_i,        // of its page, with the word
  input  wire                             keep_i,         // the sum stays, else 0
  input  wire                             add_i,          // there is a part, else 0
  input  wire [PART_W-1:0]                part_i,
  input  wire                             write_i,        // a clock after the word
  input  wire [ADDRESS_W-1:0]             write_address_i,
  input  wire                             write_epoch_i
);
  localparam SUM_W = `FFD_SCATTER_SUM_W;

  // What a memory gives comes late in its clock: of it nothing but a register follows.
  wire [`FFD_SCATTER_WORD_W-1:0] word;
  reg               keep_q;
  reg  [PART_W-1:0] part_q;
  wire [SUM_W-1:0]  sum = (word_o[SUM_W-1:0] & {SUM_W{keep_q}})
                        + {{(SUM_W - PART_W + 1) {part_q[PART_W-1]}}, part_q[PART_W-2:0]};

  always @(posedge clk) begin
    word_o <= word;
    keep_q <= keep_i && word[SUM_W] == epoch_i;
  end
  always @(posedge clk) begin
    if (!add_i) part_q <= {PART_W{1'b0}};
    else part_q <= part_i;
  end

  ffd_mem_sdp #(
    .WIDTH       (`FFD_SCATTER_WORD_W),
    .DEPTH       (DEPTH),
    .READ_LATENCY(1)
  ) u_words (
    .clk            (clk),
    .write_i        (write_i),
    .write_address_i(write_address_i),
    .write_data_i   ({write_epoch_i, sum}),
    .read_i         (read_i),
    .read_address_i (read_address_i),
    .read_data_o    (word)
  );

`ifdef FFD_ASSERTIONS
  reg [1:0]             read_q;
  reg [2*ADDRESS_W-1:0] address_q;
  always @(posedge clk) begin
    read_q    <= {read_q[0] && !rst, read_i && !rst};
    address_q <= {address_q[0 +: ADDRESS_W], read_address_i};
  end
  `FFD_ASSERT(a_word_is_read_in_the_clock_after_a_read_of_it,
              !(read_i && read_q[0]) || read_address_i != address_q[0 +: ADDRESS_W])
  `FFD_ASSERT(a_word_is_read_in_the_second_clock_after_a_read_of_it,
              !(read_i && read_q[1]) || read_address_i != address_q[ADDRESS_W +: ADDRESS_W])
  `FFD_ASSERT(a_word_is_written_that_was_not_read_two_clocks_ago,
              !write_i || (read_q[1] && write_address_i == address_q[ADDRESS_W +: ADDRESS_W]))
`endif
  wire unused_ok = &{1'b0, rst};
endmodule

`default_nettype wire
