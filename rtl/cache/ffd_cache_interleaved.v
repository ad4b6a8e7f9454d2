// ffd_cache_interleaved: the control points that came with their vertex (paper, fig. 3)
//
// A slot holds the 64 points of one vertex, in local order (l, m, n), n fastest, as the stream's
// beats bring them: 48 beats of four words, point p in words 3p to 3p + 2. Word w lies in lane
// w mod 4 at row w / 4, so a beat writes one row of all lanes, and the three words of any point lie
// in three different lanes: one point a clock, with neither packing nor padding.
//
// Formats:    words as in the stream, stored as points of FORMAT. The reader asks for bank
//             (l, m, n) of a cell; its local index is (bank - cell) mod 4 an axis.
// Pipeline:   READ_LATENCY 2: memory | lanes turned; II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh, SLOTS >= 2.
// Not checked: whether a slot has been filled: the stream decoder hands out full slots only.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_cache_interleaved #(
  parameter FORMAT = 18,
  parameter SLOTS  = 3,
  parameter SLOT_W = $clog2(SLOTS)
) (
  input  wire                               clk,
  input  wire                               write_i,
  input  wire [SLOT_W-1:0]                  write_slot_i,
  input  wire [5:0]                         write_row_i,
  input  wire [127:0]                       write_words_i,
  input  wire [SLOT_W-1:0]                  read_slot_i,
  input  wire [11:0]                        read_cell_i,
  input  wire [5:0]                         read_index_i,
  output wire [3*`FFD_POINT_W(FORMAT)-1:0]  point_o
);
  localparam POINT_W = `FFD_POINT_W(FORMAT);

  // First word of the point: 3p = p + 2p.
  wire [1:0] l     = read_index_i[5:4] - read_cell_i[1:0];
  wire [1:0] m     = read_index_i[3:2] - read_cell_i[5:4];
  wire [1:0] n     = read_index_i[1:0] - read_cell_i[9:8];
  wire [5:0] local_index = {l, m, n};
  wire [7:0] word  = {2'b00, local_index} + {1'b0, local_index, 1'b0};
  wire [5:0] row   = word[7:2];
  wire [1:0] first = word[1:0];

  wire [4*POINT_W-1:0] lanes;
  reg  [1:0]           first_q;
  always @(posedge clk) first_q <= first;

  genvar i;
  generate
    for (i = 0; i < 4; i = i + 1) begin : gen_lane
      localparam [2:0] LANE = i;
      wire [POINT_W-1:0] number;
      wire [5:0]         lane_row = {1'b0, first} > LANE ? row + 6'd1 : row;

      ffd_num_in #(
        .FORMAT(FORMAT),
        .ROLE  (`FFD_ROLE_POINT)
      ) u_in (
        .word_i  (write_words_i[32*i +: 32]),
        .number_o(number)
      );

      ffd_mem_sdp #(
        .WIDTH       (POINT_W),
        .DEPTH       (SLOTS * 64),
        .READ_LATENCY(1),
        .ADDRESS_W   (SLOT_W + 6)
      ) u_memory (
        .clk            (clk),
        .write_i        (write_i),
        .write_address_i({write_slot_i, write_row_i}),
        .write_data_i   (number),
        .read_address_i ({read_slot_i, lane_row}),
        .read_data_o    (lanes[i*POINT_W +: POINT_W])
      );
    end
  endgenerate

  // Component c lies in lane first + c.
  wire [3*POINT_W-1:0] turned;
  genvar c;
  generate
    for (c = 0; c < 3; c = c + 1) begin : gen_component
      localparam [1:0] OFFSET = c;
      wire [1:0] lane = first_q + OFFSET;
      assign turned[c*POINT_W +: POINT_W] = lanes[lane*POINT_W +: POINT_W];
    end
  endgenerate

  ffd_num_delay #(
    .WIDTH  (3 * POINT_W),
    .LATENCY(1)
  ) u_point (
    .clk(clk),
    .rst(1'b0),
    .d_i(turned),
    .q_o(point_o)
  );

  wire unused_ok = &{1'b0, read_cell_i[3:2], read_cell_i[7:6], read_cell_i[11:10]};
endmodule

`default_nettype wire
