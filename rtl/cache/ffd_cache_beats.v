// ffd_cache_beats: the points of interleaved vertices, a word of a beat in each of four memories
//
// For organizations that read a point a clock. A slot holds the 48 beats of one vertex as they
// came: word w of beat {group, phase} in memory w. Point n of a group has its components in words
// 3 n to 3 n + 2, and three words in a row lie in three memories: so any point is read in one
// clock, each memory at the beat in question, and turned round by n.
//
// Formats:    numbers of four words; point {z, y, x} of the slot at local index {l, m, n}.
// Pipeline:   2 clocks: memory | register; turned round behind it. II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh, SLOTS >= 2; HARDENED 0, or 1: each word is stored with its
//             parity. odd_o, with the point: that of one of its three words is wrong.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_cache_beats #(
  parameter FORMAT   = 18,
  parameter SLOTS    = 3,
  parameter HARDENED = 0,
  parameter SLOT_W   = $clog2(SLOTS)
) (
  input  wire                                 clk,
  input  wire                                 write_i,
  input  wire [SLOT_W-1:0]                    write_slot_i,
  input  wire [3:0]                           write_group_i,
  input  wire [1:0]                           write_phase_i,
  input  wire [4*`FFD_POINT_W(FORMAT)-1:0]    write_numbers_i,
  input  wire [SLOT_W-1:0]                    read_slot_i,
  input  wire [5:0]                           read_local_i,
  output wire [3*`FFD_POINT_W(FORMAT)-1:0]    point_o,
  output wire                                 odd_o
);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam STORED_W = POINT_W + HARDENED;

  wire [3:0]           group = read_local_i[5:2];
  wire [1:0]           n     = read_local_i[1:0];
  wire [4*POINT_W-1:0] words;
  reg  [4*POINT_W-1:0] words_q;
  reg  [1:0]           n_q;
  reg  [1:0]           n_qq;
  always @(posedge clk) begin
    words_q <= words;
    n_q     <= n;
    n_qq    <= n_q;
  end

  // All but the word that is not of the point: 3 n + 3 modulo 4.
  wire [3:0] odd;
  wire [1:0] other = 2'd3 - n_qq;
  assign odd_o = |(odd & ~(4'd1 << other));

  // The beat of a group that has word w of point n, where there is such a word.
  wire [7:0] phase = {n == 2'd0 ? 2'd0 : n - 2'd1,   // w = 3: points 1, 2, 3
                      n > 2'd1 ? n - 2'd1 : 2'd0,    // w = 2: points 0, 2, 3
                      n == 2'd3 ? 2'd2 : n,          // w = 1: points 0, 1, 3
                      n};                            // w = 0: points 0, 1, 2

  genvar w;
  generate
    for (w = 0; w < 4; w = w + 1) begin : gen_word
      wire [POINT_W-1:0]  number = write_numbers_i[w*POINT_W +: POINT_W];
      wire [STORED_W-1:0] written;
      wire [STORED_W-1:0] stored;
      assign written[POINT_W-1:0]        = number;
      assign words[w*POINT_W +: POINT_W] = stored[POINT_W-1:0];
      if (HARDENED != 0) begin : gen_parity
        reg odd_q;
        always @(posedge clk) odd_q <= ^stored;
        assign written[STORED_W-1] = ^number;
        assign odd[w]              = odd_q;
      end else begin : gen_no_parity
        assign odd[w] = 1'b0;
      end

      ffd_mem_sdp #(
        .WIDTH       (STORED_W),
        .DEPTH       (64 * SLOTS),
        .READ_LATENCY(1),
        .ADDRESS_W   (SLOT_W + 6)
      ) u_memory (
        .clk            (clk),
        .write_i        (write_i),
        .write_address_i({write_slot_i, write_group_i, write_phase_i}),
        .write_data_i   (written),
        .read_i         (1'b1),
        .read_address_i ({read_slot_i, group, phase[2*w +: 2]}),
        .read_data_o    (stored)
      );
    end
  endgenerate

  genvar c;
  generate
    for (c = 0; c < 3; c = c + 1) begin : gen_component
      // Word 3 n + c modulo 4.
      localparam OF_0 = c;
      localparam OF_1 = (c + 3) % 4;
      localparam OF_2 = (c + 2) % 4;
      localparam OF_3 = (c + 1) % 4;
      assign point_o[c*POINT_W +: POINT_W] =
        n_qq[1] ? (n_qq[0] ? words_q[OF_3*POINT_W +: POINT_W] : words_q[OF_2*POINT_W +: POINT_W])
                : (n_qq[0] ? words_q[OF_1*POINT_W +: POINT_W] : words_q[OF_0*POINT_W +: POINT_W]);
    end
  endgenerate
endmodule

`default_nettype wire
