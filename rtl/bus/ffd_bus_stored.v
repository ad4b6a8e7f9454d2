// ffd_bus_stored: settings of the registers, kept a second time, to be read without a multiplexer
//
// WORDS words of 32 bits in a memory. What is written to a setting is written here too, byte by
// byte; word_o is the word of read_slot_i, in the same clock. After rst the words are set to 0, one
// a clock; clearing_o is 1 meanwhile, and nothing may be written or read.
//
// Pipeline:   a write is seen from the next clock on; clearing_o for WORDS clocks after rst.
// Freezes:    never.
// Parameters: WORDS a power of two, 2 to 64. HARDENED 0, or 1: the count of words that are cleared
//             is held three times; differs_o: one of the three differs.
// Model:      tests/bus/axil/register_model.hpp.  Test: tests/bus/axil.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_bus_stored #(
  parameter WORDS    = 16,
  parameter HARDENED = 0,
  parameter SLOT_W   = $clog2(WORDS)
) (
  input  wire              clk,
  input  wire              rst,
  output wire              clearing_o,
  output wire              differs_o,
  input  wire              write_i,
  input  wire [SLOT_W-1:0] write_slot_i,
  input  wire [31:0]       write_data_i,
  input  wire [3:0]        write_strobe_i,
  input  wire [SLOT_W-1:0] read_slot_i,
  output wire [31:0]       word_o
);
  generate
    if (WORDS < 2 || WORDS > 64 || (1 << SLOT_W) != WORDS) begin : gen_bad_words
      ERROR_ffd_bus_stored_words_must_be_a_power_of_two_up_to_64 u_error ();
    end
  endgenerate

  // Counts the words that are cleared; the bit above says that all are.
  wire [SLOT_W:0]   cleared_q;
  wire              clearing = !cleared_q[SLOT_W];
  wire [SLOT_W-1:0] slot     = clearing ? cleared_q[SLOT_W-1:0] : write_slot_i;
  wire [31:0]       data     = clearing ? 32'd0 : write_data_i;

  assign clearing_o = clearing;

  generate
    if (HARDENED == 0) begin : gen_single
      reg [SLOT_W:0] count_q;
      always @(posedge clk) begin
        if (rst) count_q <= {(SLOT_W + 1) {1'b0}};
        else if (clearing) count_q <= count_q + 1'b1;
      end
      assign cleared_q = count_q;
      assign differs_o = 1'b0;
    end else begin : gen_three
      wire [SLOT_W:0] next = cleared_q + {{SLOT_W {1'b0}}, clearing};
      ffd_hard_triple #(
        .WIDTH(SLOT_W + 1)
      ) u_cleared (
        .clk      (clk),
        .d_i      (rst ? {(SLOT_W + 1) {1'b0}} : next),
        .q_o      (cleared_q),
        .differs_o(differs_o)
      );
    end
  endgenerate

  genvar b;
  generate
    for (b = 0; b < 4; b = b + 1) begin : gen_byte
      ffd_mem_sdp #(
        .WIDTH       (8),
        .DEPTH       (WORDS),
        .READ_LATENCY(0)
      ) u_memory (
        .clk            (clk),
        .write_i        (clearing || (write_i && write_strobe_i[b])),
        .write_address_i(slot),
        .write_data_i   (data[8*b +: 8]),
        .read_i         (1'b1),
        .read_address_i (read_slot_i),
        .read_data_o    (word_o[8*b +: 8])
      );
    end
  endgenerate
endmodule

`default_nettype wire
