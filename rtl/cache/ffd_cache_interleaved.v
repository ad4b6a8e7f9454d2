// ffd_cache_interleaved: the control points that came with their vertex (paper, fig. 3)
//
// A slot holds the 64 points of one vertex. They come in local order (l, m, n), n fastest, in 48
// beats of four words, and are kept by bank, local + cell modulo 4 an axis, as organizations ask
// for them: bank q lies in lane q mod LANES, row q / LANES, and each lane has one memory a
// component. The four words of a beat belong to at most two points, p and p + 1, whose banks differ
// in their lowest bit: with two lanes or more they always fall into different memories.
//
// Formats:    words as in the stream, stored as points of FORMAT; N points a read, component x
//             lowest, from bank read_index_i (a multiple of N) on.
// Pipeline:   READ_LATENCY 2: memory | lane; II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh, N a power of two from 1 to 64, SLOTS >= 2.
// Not checked: whether a slot has been filled: the stream decoder hands out full slots only.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_cache_interleaved #(
  parameter FORMAT = 18,
  parameter N      = 1,
  parameter SLOTS  = 3,
  parameter SLOT_W = $clog2(SLOTS)
) (
  input  wire                                 clk,
  input  wire                                 write_i,
  input  wire [SLOT_W-1:0]                    write_slot_i,
  input  wire [11:0]                          write_cell_i,
  input  wire [3:0]                           write_group_i,
  input  wire [1:0]                           write_phase_i,
  input  wire [127:0]                         write_words_i,
  input  wire [`FFD_EXPONENT_W-1:0]           write_exponent_i,
  input  wire [SLOT_W-1:0]                    read_slot_i,
  input  wire [5:0]                           read_index_i,
  output wire [N*3*`FFD_POINT_W(FORMAT)-1:0]  points_o
);
  localparam POINT_W = `FFD_POINT_W(FORMAT);
  localparam LANES   = N > 1 ? N : 2;
  localparam LANE_W  = $clog2(LANES);
  localparam ROWS    = 64 / LANES;
  localparam ROW_W   = LANES < 64 ? $clog2(ROWS) : 0;

  generate
    if (N < 1 || N > 64 || (N & (N - 1)) != 0) begin : gen_bad_n
      ERROR_ffd_cache_interleaved_n_must_be_a_power_of_two_to_64 u_error ();
    end
  endgenerate

  // ---- write: three beats bring four points; beat `phase` of a group starts in point `phase`

  wire [4*POINT_W-1:0] numbers;
  genvar i;
  generate
    for (i = 0; i < 4; i = i + 1) begin : gen_word
      ffd_num_in #(
        .FORMAT(FORMAT),
        .ROLE  (`FFD_ROLE_POINT)
      ) u_in (
        .word_i    (write_words_i[32*i +: 32]),
        .exponent_i(write_exponent_i),
        .number_o  (numbers[i*POINT_W +: POINT_W])
      );
    end
  endgenerate

  // Word i is component (phase + i) mod 3 of the first point, from phase + i = 3 on of the second.
  genvar o;
  genvar c;
  generate
    for (o = 0; o < 2; o = o + 1) begin : gen_point
      wire [5:0]           place = {write_group_i, write_phase_i} + o;
      wire [1:0]           bank_l = place[5:4] + write_cell_i[1:0];
      wire [1:0]           bank_m = place[3:2] + write_cell_i[5:4];
      wire [1:0]           bank_n = place[1:0] + write_cell_i[9:8];
      wire [5:0]           bank   = {bank_l, bank_m, bank_n};
      wire [2:0]           here;
      wire [3*POINT_W-1:0] point;
      for (c = 0; c < 3; c = c + 1) begin : gen_component
        localparam [2:0] NUMBER = 3 * o + c;
        wire [2:0] word = NUMBER - {1'b0, write_phase_i};
        assign here[c] = word < 3'd4;
        assign point[c*POINT_W +: POINT_W] = numbers[word[1:0]*POINT_W +: POINT_W];
      end
    end
  endgenerate

  wire [5:0]           bank_0  = gen_point[0].bank;
  wire [5:0]           bank_1  = gen_point[1].bank;
  wire [2:0]           here_0  = gen_point[0].here;
  wire [2:0]           here_1  = gen_point[1].here;
  wire [3*POINT_W-1:0] point_0 = gen_point[0].point;
  wire [3*POINT_W-1:0] point_1 = gen_point[1].point;

  // ---- memories, one a lane and component

  wire [LANES*3*POINT_W-1:0] lanes;
  genvar j;
  generate
    for (j = 0; j < LANES; j = j + 1) begin : gen_lane
      localparam [5:0] LANE_I = j;
      wire       lane_0 = bank_0[LANE_W-1:0] == LANE_I[LANE_W-1:0];
      wire       lane_1 = bank_1[LANE_W-1:0] == LANE_I[LANE_W-1:0];
      wire [5:0] bank   = lane_0 ? bank_0 : bank_1;
      for (c = 0; c < 3; c = c + 1) begin : gen_memory
        wire               write = write_i && ((lane_0 && here_0[c]) || (lane_1 && here_1[c]));
        wire [POINT_W-1:0] number = lane_0 ? point_0[c*POINT_W +: POINT_W]
                                           : point_1[c*POINT_W +: POINT_W];
        wire [SLOT_W+ROW_W-1:0] write_address;
        wire [SLOT_W+ROW_W-1:0] read_address;
        if (ROW_W > 0) begin : gen_rows
          assign write_address = {write_slot_i, bank[5:6-ROW_W]};
          assign read_address  = {read_slot_i, read_index_i[5:6-ROW_W]};
        end else begin : gen_one_row
          assign write_address = write_slot_i;
          assign read_address  = read_slot_i;
        end
        ffd_mem_sdp #(
          .WIDTH       (POINT_W),
          .DEPTH       (SLOTS * ROWS),
          .READ_LATENCY(1),
          .ADDRESS_W   (SLOT_W + ROW_W)
        ) u_memory (
          .clk            (clk),
          .write_i        (write),
          .write_address_i(write_address),
          .write_data_i   (number),
          .read_address_i (read_address),
          .read_data_o    (lanes[(3*j+c)*POINT_W +: POINT_W])
        );
      end
      wire unused_ok = &{1'b0, bank};
    end
  endgenerate

  // ---- read

  wire [N*3*POINT_W-1:0] points;
  generate
    if (N == 1) begin : gen_select
      reg select_q;
      always @(posedge clk) select_q <= read_index_i[0];
      assign points = select_q ? lanes[3*POINT_W +: 3*POINT_W] : lanes[0 +: 3*POINT_W];
    end else begin : gen_all
      assign points = lanes;
    end
  endgenerate

  ffd_num_delay #(
    .WIDTH  (N * 3 * POINT_W),
    .LATENCY(1)
  ) u_points (
    .clk(clk),
    .rst(1'b0),
    .d_i(points),
    .q_o(points_o)
  );

  wire unused_ok = &{1'b0, write_cell_i, read_index_i};
endmodule

`default_nettype wire
