// ffd_cache_lane: one of the N memories of control points
//
// Lane p has the banks q of all supports with q mod N = p, in rows q / N: of the pages of
// resident lattices at each place, and of SLOTS supports that came with their vertices. Both share
// a memory where that is no deeper than a block memory is at its full width; else each has its own.
//
// Formats:    place {page, i / 4, j / 4, k / 4}, or the slot; points {z, y, x}.
// Pipeline:   2 clocks: memory | register. II 1, never frozen.
// Parameters: WIDTH of a point; ROWS a power of two; PLACES >= 2; LATTICES 0 or 1; SLOTS 0 or >= 2;
//             HARDENED 0, or 1: a point is stored with its parity, and odd_o comes with one that
//             has another.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_cache_lane #(
  parameter WIDTH    = 57,
  parameter ROWS     = 64,
  parameter PLACES   = 128,
  parameter LATTICES = 1,
  parameter SLOTS    = 3,
  parameter HARDENED = 0,
  parameter ROW_W    = ROWS > 1 ? $clog2(ROWS) : 1,
  parameter PLACE_W  = $clog2(PLACES)
) (
  input  wire               clk,
  input  wire               write_i,
  input  wire               write_slot_i,  // of a slot
  input  wire [PLACE_W-1:0] write_place_i,
  input  wire [ROW_W-1:0]   write_row_i,
  input  wire [WIDTH-1:0]   write_point_i,
  input  wire               read_slot_i,
  input  wire [PLACE_W-1:0] read_place_i,
  input  wire [ROW_W-1:0]   read_row_i,
  output wire [WIDTH-1:0]   point_o,
  output wire               odd_o
);
  localparam STORED_W    = WIDTH + HARDENED;
  localparam BLOCK_DEPTH = 512;
  localparam DEPTH       = PLACES * ROWS;
  localparam SLOT_DEPTH  = SLOTS * ROWS;
  localparam ROW_BITS    = ROWS > 1 ? ROW_W : 0;
  localparam ADDRESS_W   = PLACE_W + ROW_BITS;
  localparam JOINED      = LATTICES != 0 && SLOTS != 0 && DEPTH == 2 ** ADDRESS_W
                      && DEPTH + SLOT_DEPTH <= BLOCK_DEPTH;

  wire [ADDRESS_W-1:0] write_address;
  wire [ADDRESS_W-1:0] read_address;
  wire [STORED_W-1:0]  written;
  wire [STORED_W-1:0]  stored;
  assign written[WIDTH-1:0] = write_point_i;
  assign point_o            = stored[WIDTH-1:0];
  generate
    if (HARDENED != 0) begin : gen_parity
      assign written[WIDTH] = ^write_point_i;
      assign odd_o          = ^stored;
    end else begin : gen_no_parity
      assign odd_o = 1'b0;
    end

    if (ROWS > 1) begin : gen_rows
      assign write_address = {write_place_i, write_row_i};
      assign read_address  = {read_place_i, read_row_i};
    end else begin : gen_single_row
      assign write_address = write_place_i;
      assign read_address  = read_place_i;
      wire unused_rows = &{1'b0, write_row_i, read_row_i};
    end

    if (JOINED) begin : gen_joined
      wire [STORED_W-1:0] point;
      reg  [STORED_W-1:0] point_q;
      ffd_mem_sdp #(
        .WIDTH    (STORED_W),
        .DEPTH    (DEPTH + SLOT_DEPTH),
        .ADDRESS_W(ADDRESS_W + 1)
      ) u_memory (
        .clk            (clk),
        .write_i        (write_i),
        .write_address_i({write_slot_i, write_address}),
        .write_data_i   (written),
        .read_i         (1'b1),
        .read_address_i ({read_slot_i, read_address}),
        .read_data_o    (point)
      );
      always @(posedge clk) point_q <= point;
      assign stored = point_q;
    end else begin : gen_apart
      reg  slot_q;
      reg  slot_qq;
      wire [STORED_W-1:0] of_lattice;
      wire [STORED_W-1:0] of_slot;
      always @(posedge clk) begin
        slot_q  <= read_slot_i;
        slot_qq <= slot_q;
      end
      assign stored = SLOTS == 0    ? of_lattice
                    : LATTICES == 0 ? of_slot
                    : slot_qq       ? of_slot : of_lattice;

      if (LATTICES != 0) begin : gen_lattices
        wire [STORED_W-1:0] point;
        reg  [STORED_W-1:0] point_q;
        ffd_mem_sdp #(
          .WIDTH    (STORED_W),
          .DEPTH    (DEPTH),
          .ADDRESS_W(ADDRESS_W)
        ) u_memory (
          .clk            (clk),
          .write_i        (write_i && !write_slot_i),
          .write_address_i(write_address),
          .write_data_i   (written),
          .read_i         (1'b1),
          .read_address_i (read_address),
          .read_data_o    (point)
        );
        always @(posedge clk) point_q <= point;
        assign of_lattice = point_q;
      end else begin : gen_no_lattices
        assign of_lattice = {STORED_W{1'b0}};
      end

      if (SLOTS != 0) begin : gen_slots
        localparam SLOT_ADDRESS_W = $clog2(SLOT_DEPTH);
        wire [STORED_W-1:0] point;
        reg  [STORED_W-1:0] point_q;
        ffd_mem_sdp #(
          .WIDTH    (STORED_W),
          .DEPTH    (SLOT_DEPTH),
          .ADDRESS_W(SLOT_ADDRESS_W)
        ) u_memory (
          .clk            (clk),
          .write_i        (write_i && write_slot_i),
          .write_address_i(write_address[SLOT_ADDRESS_W-1:0]),
          .write_data_i   (written),
          .read_i         (1'b1),
          .read_address_i (read_address[SLOT_ADDRESS_W-1:0]),
          .read_data_o    (point)
        );
        always @(posedge clk) point_q <= point;
        assign of_slot = point_q;
      end else begin : gen_no_slots
        assign of_slot = {STORED_W{1'b0}};
      end
      wire unused_slot = &{1'b0, slot_qq, write_slot_i};
    end
  endgenerate

  wire unused_ok = &{1'b0, write_i, written, write_address, read_address};
endmodule

`default_nettype wire
