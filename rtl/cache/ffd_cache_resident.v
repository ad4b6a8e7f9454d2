// ffd_cache_resident: whole lattices on chip (paper, 3.3.1)
//
// Two buffers of up to AXIS points an axis: one is read while the other is loaded. A point lies in
// bank (i mod 4, j mod 4, k mod 4), so any 4 x 4 x 4 support has one point in each of the 64 banks,
// and two neighbouring addresses an axis reach it. N banks are read a clock, each in a lane of its
// own: bank q in lane q mod N, row q / N; N = 64 reads a whole support.
//
// Formats:    words as in the stream, stored as points of FORMAT; N points a read, component x
//             lowest, from bank read_index_i (a multiple of N) on.
// Pipeline:   READ_LATENCY 2: memory | register; II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh, N a power of two from 1 to 64, AXIS 4 to 16.
// Not checked: a cell outside the lattice reads some point, never an address outside the memory.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_cache_resident #(
  parameter FORMAT = 18,
  parameter N      = 1,
  parameter AXIS   = 16
) (
  input  wire                                 clk,
  input  wire                                 write_i,
  input  wire                                 write_buffer_i,
  input  wire [11:0]                          write_at_i,
  input  wire [95:0]                          write_words_i,
  input  wire [`FFD_EXPONENT_W-1:0]           write_exponent_i,
  input  wire                                 read_buffer_i,
  input  wire [11:0]                          read_cell_i,
  input  wire [5:0]                           read_index_i,
  output wire [N*3*`FFD_POINT_W(FORMAT)-1:0]  points_o
);
  localparam POINT_W = `FFD_POINT_W(FORMAT);
  localparam HIGH_W  = AXIS > 8 ? 2 : 1;  // of an index, above its two bits of bank
  localparam ROWS    = 64 / N;
  localparam ROW_W   = $clog2(ROWS);
  localparam PLACE_W = 1 + 3 * HIGH_W;
  localparam ADDR_W  = PLACE_W + ROW_W;
  localparam DEPTH   = (HIGH_W == 2 ? 128 : 16) * ROWS;

  generate
    if (N < 1 || N > 64 || (N & (N - 1)) != 0) begin : gen_bad_n
      ERROR_ffd_cache_resident_n_must_be_a_power_of_two_to_64 u_error ();
    end
    if (AXIS < 4 || AXIS > 16) begin : gen_bad_axis
      ERROR_ffd_cache_resident_axis_must_be_4_to_16 u_error ();
    end
  endgenerate

  // ---- write: index i, j, k lowest first

  wire [5:0]           write_bank = {write_at_i[1:0], write_at_i[5:4], write_at_i[9:8]};
  wire [PLACE_W-1:0]   write_place;
  wire [3*POINT_W-1:0] write_point;

  assign write_place = {write_buffer_i, write_at_i[2 +: HIGH_W], write_at_i[6 +: HIGH_W],
                        write_at_i[10 +: HIGH_W]};

  genvar c;
  generate
    for (c = 0; c < 3; c = c + 1) begin : gen_component
      ffd_num_in #(
        .FORMAT(FORMAT),
        .ROLE  (`FFD_ROLE_POINT)
      ) u_in (
        .word_i    (write_words_i[32*c +: 32]),
        .exponent_i(write_exponent_i),
        .number_o  (write_point[c*POINT_W +: POINT_W])
      );
    end
  endgenerate

  // ---- lanes

  genvar p;
  genvar a;
  generate
    for (p = 0; p < N; p = p + 1) begin : gen_lane
      localparam [5:0] OFFSET = p;
      wire [5:0]          bank = read_index_i + OFFSET;
      wire [PLACE_W-1:0]  place;
      wire [ADDR_W-1:0]   write_address;
      wire [ADDR_W-1:0]   read_address;
      wire                here;
      wire [3*POINT_W-1:0] point;
      reg  [3*POINT_W-1:0] point_q;

      // A bank below the cell's own lies in the next group of four.
      for (a = 0; a < 3; a = a + 1) begin : gen_axis
        wire [1:0] next = {1'b0, bank[4-2*a +: 2] < read_cell_i[4*a +: 2]};
        wire [1:0] high = read_cell_i[4*a+2 +: 2] + next;
        assign place[(2-a)*HIGH_W +: HIGH_W] = high[HIGH_W-1:0];
        if (HIGH_W < 2) begin : gen_unused
          wire unused_ok = &{1'b0, high};
        end
      end
      assign place[3*HIGH_W] = read_buffer_i;

      if (N == 1) begin : gen_one
        assign here = 1'b1;
      end else begin : gen_several
        assign here = write_bank[$clog2(N)-1:0] == OFFSET[$clog2(N)-1:0];
      end
      if (ROW_W > 0) begin : gen_rows
        assign write_address = {write_place, write_bank[5:6-ROW_W]};
        assign read_address  = {place, bank[5:6-ROW_W]};
      end else begin : gen_one_row
        assign write_address = write_place;
        assign read_address  = place;
      end

      ffd_mem_sdp #(
        .WIDTH       (3 * POINT_W),
        .DEPTH       (DEPTH),
        .READ_LATENCY(1)
      ) u_memory (
        .clk            (clk),
        .write_i        (write_i && here),
        .write_address_i(write_address),
        .write_data_i   (write_point),
        .read_address_i (read_address),
        .read_data_o    (point)
      );

      always @(posedge clk) point_q <= point;
      assign points_o[p*3*POINT_W +: 3*POINT_W] = point_q;
    end
  endgenerate

  wire unused_ok = &{1'b0, write_at_i, write_bank};
endmodule

`default_nettype wire
