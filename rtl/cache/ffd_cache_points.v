// ffd_cache_points: control points from where a vertex has them: its slot or the resident lattice
//
// Pages of resident lattices of up to AXIS points an axis, two or more (paper, 3.3.1): one is read
// while another is loaded. A point lies in bank (i mod 4, j mod 4, k mod 4), so any 4 x 4 x 4
// support has one point in each of the 64 banks, and two neighbouring places an axis reach it. A
// slot is a support that came with its vertex (paper, fig. 3): one place of its own. N banks are
// read a clock, each in a lane of its own: bank q in lane q mod N, row q / N; N = 64 reads a whole
// support.
//
// Where a single lane is read, slots keep their beats as they came (ffd_cache_beats): one write a
// clock could not keep up with four words a beat.
//
// A fourth component has lanes of its own. A read gives it as all three components of a point, so
// that whatever is said of any of them is said of it.
//
// Formats:    numbers of four words; at {k, j, i}; source as in ffd_stream.vh; N points a
//             read, component x lowest, from bank read_index_i (a multiple of N) on.
// Pipeline:   LATENCY: memory | register, with a third one in front of the memory, a fourth one
//             behind the choice between lattice and slot. II 1, never frozen. What is written is
//             there for reads from the second clock after it: no vertex reads its points sooner.
// Parameters: FORMAT as in ffd_num.vh, FEATURES as in ffd_stream.vh, N a power of two from 1 to 64,
//             SLOTS >= 2, PAGES >= 1, AXIS 4 to 64, LATENCY >= 2; HARDENED 0, or 1: points have a
//             parity, and odd_o comes with points of which one has another.
// Not checked: a cell outside the lattice reads some point, never an address outside the memory;
//             whether a slot has been filled: the stream decoder hands out full slots only.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_stream.vh"

module ffd_cache_points #(
  parameter FORMAT   = 18,
  parameter FEATURES = `FFD_FEATURES_USUAL,
  parameter N        = 1,
  parameter SLOTS    = 3,
  parameter SLOT_W   = $clog2(SLOTS),
  parameter PAGES    = 2,
  parameter PAGE_W   = `FFD_PAGE_NUMBER_W(PAGES),
  parameter AXIS     = 16,
  parameter AT_W     = 3 * `FFD_AXIS_W(AXIS),
  parameter SOURCE_W = `FFD_SOURCE_W(SLOTS, PAGES, AXIS, FEATURES),
  parameter LATENCY  = 2,
  parameter HARDENED = 0
) (
  input  wire                                 clk,
  input  wire [4*`FFD_POINT_W(FORMAT)-1:0]    numbers_i,
  input  wire                                 lattice_write_i,
  input  wire [PAGE_W-1:0]                    lattice_buffer_i,
  input  wire [AT_W-1:0]                      lattice_at_i,
  input  wire                                 lattice_fourth_i,  // its fourth component, too
  input  wire                                 slot_write_i,
  input  wire [SLOT_W-1:0]                    slot_i,
  input  wire [11:0]                          slot_cell_i,
  input  wire [3:0]                           slot_group_i,
  input  wire [1:0]                           slot_phase_i,
  input  wire [SOURCE_W-1:0]                  read_source_i,
  input  wire [11:0]                          read_cell_i,
  input  wire [5:0]                           read_index_i,
  output wire [N*3*`FFD_POINT_W(FORMAT)-1:0]  points_o,
  output wire                                 odd_o
);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam LATTICES = `FFD_FEATURE_RESIDENT(FEATURES);
  localparam COMING   = `FFD_FEATURE_INTERLEAVED(FEATURES);
  localparam FOURTH   = `FFD_FEATURE_FOURTH(FEATURES);
  localparam AXIS_W   = `FFD_AXIS_W(AXIS);
  localparam EARLY    = LATENCY > 2 ? 1 : 0;
  localparam HIGH_W   = AXIS > 8 ? AXIS_W - 2 : 1;  // of an index, above its two bits of bank
  localparam ROWS     = 64 / N;
  localparam ROW_W    = ROWS > 1 ? $clog2(ROWS) : 1;
  // A single lane of lattices of one place has no more than the pages.
  localparam PLACE_W  = AXIS > 4 || N > 1 ? PAGE_W + 3 * HIGH_W : PAGE_W;
  localparam HIGHS_W  = PAGE_W + 3 * HIGH_W;
  // The lanes need no bit of a single page.
  localparam USED_W   = PAGES > 1 || PLACE_W == 1 ? PLACE_W : PLACE_W - 1;
  localparam PLACES   = PAGES > 1 ? PAGES * 2 ** (PLACE_W - PAGE_W) : 2 ** USED_W;

  generate
    if (N < 1 || N > 64 || (N & (N - 1)) != 0) begin : gen_bad_n
      ERROR_ffd_cache_points_n_must_be_a_power_of_two_to_64 u_error ();
    end
    if (AXIS < 4 || AXIS > 64) begin : gen_bad_axis
      ERROR_ffd_cache_points_axis_must_be_4_to_64 u_error ();
    end
    if (COMING != 0 && SLOT_W > HIGHS_W - (PAGES > 1 ? 0 : 1)) begin : gen_bad_slots
      ERROR_ffd_cache_points_has_more_slots_than_places u_error ();
    end
  endgenerate

  wire               of_slot = !read_source_i[SOURCE_W-1];
  wire [SLOT_W-1:0]  slot    = read_source_i[SLOT_W-1:0];
  wire [HIGHS_W-1:0] at_slot = {{(HIGHS_W - SLOT_W) {1'b0}}, slot};

  // ---- the place of a bank: below the cell's own it lies in the next group of four

  // Of each axis, for each of its four banks.
  wire [3*4*HIGH_W-1:0] highs;
  genvar a;
  genvar v;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      wire [1:0] beyond;
      if (AXIS_W > 4) begin : gen_beyond
        localparam BEYOND_W = `FFD_HIGH_W(AXIS);
        localparam LOW      = `FFD_AT_W(SLOTS, PAGES) + BEYOND_W * a;
        assign beyond[BEYOND_W-1:0] = read_source_i[LOW +: BEYOND_W];
        if (BEYOND_W < 2) begin : gen_single
          assign beyond[1] = 1'b0;
        end
      end else begin : gen_within
        assign beyond = 2'd0;
      end
      for (v = 0; v < 4; v = v + 1) begin : gen_bank
        localparam [3:0] ABOVE = 4'b1110 << v;  // the cells whose own bank is above this one
        wire [3:0] next = {3'd0, ABOVE[read_cell_i[4*a +: 2]]};
        wire [3:0] high = {beyond, read_cell_i[4*a+2 +: 2]} + next;
        assign highs[(4*a+v)*HIGH_W +: HIGH_W] =
          COMING != 0 && N > 1 && of_slot ? at_slot[(2-a)*HIGH_W +: HIGH_W] : high[HIGH_W-1:0];
        wire unused_ok = &{1'b0, high};
      end
    end
  endgenerate
  wire [PAGE_W-1:0] page = COMING != 0 && N > 1 && of_slot ? at_slot[HIGHS_W-1 -: PAGE_W]
                                                          : read_source_i[PAGE_W-1:0];

  // ---- write

  wire [1:0]           write;
  wire                 write_slot;
  wire [PLACE_W-1:0]   write_place;
  wire [11:0]          write_bank;
  wire [6*POINT_W-1:0] write_point;
  wire [3*POINT_W-1:0] beat_point;
  wire                 beat_odd;

  generate
    if (N == 1) begin : gen_beats
      // Straight from the converters: a point of a lattice a beat.
      assign write       = {1'b0, lattice_write_i};
      assign write_slot  = 1'b0;
      if (PLACE_W > PAGE_W) begin : gen_places
        assign write_place = {lattice_buffer_i, lattice_at_i[2 +: HIGH_W],
                              lattice_at_i[AXIS_W+2 +: HIGH_W],
                              lattice_at_i[2*AXIS_W+2 +: HIGH_W]};
      end else begin : gen_single_place
        assign write_place = lattice_buffer_i;
      end
      assign write_bank  = {6'd0, lattice_at_i[1:0], lattice_at_i[AXIS_W +: 2],
                            lattice_at_i[2*AXIS_W +: 2]};
      assign write_point = {{(3 * POINT_W) {1'b0}}, numbers_i[3*POINT_W-1:0]};

      if (COMING != 0) begin : gen_slots
        // A slot has its points in local order, banks are local + cell modulo 4.
        wire [5:0] cells = {read_cell_i[1:0], read_cell_i[5:4], read_cell_i[9:8]};
        wire [5:0] local_index = {read_index_i[5:4] - cells[5:4], read_index_i[3:2] - cells[3:2],
                                  read_index_i[1:0] - cells[1:0]};
        wire [SLOT_W-1:0] early_slot;
        wire [5:0]        early_index;
        ffd_num_delay #(
          .WIDTH  (SLOT_W + 6),
          .LATENCY(EARLY)
        ) u_early (
          .clk(clk),
          .rst(1'b0),
          .d_i({slot, local_index}),
          .q_o({early_slot, early_index})
        );
        ffd_cache_beats #(
          .FORMAT  (FORMAT),
          .SLOTS   (SLOTS),
          .HARDENED(HARDENED)
        ) u_beats (
          .clk            (clk),
          .write_i        (slot_write_i),
          .write_slot_i   (slot_i),
          .write_group_i  (slot_group_i),
          .write_phase_i  (slot_phase_i),
          .write_numbers_i(numbers_i),
          .read_slot_i    (early_slot),
          .read_local_i   (early_index),
          .point_o        (beat_point),
          .odd_o          (beat_odd)
        );
      end else begin : gen_no_slots
        assign beat_point = {(3 * POINT_W) {1'b0}};
        assign beat_odd   = 1'b0;
        wire unused_ok = &{1'b0, slot_write_i, slot_i, slot_group_i, slot_phase_i};
      end
      wire unused_ok = &{1'b0, slot_cell_i, at_slot};
    end else begin : gen_writer
      assign beat_point = {(3 * POINT_W) {1'b0}};
      assign beat_odd   = 1'b0;
      ffd_cache_writer #(
        .FORMAT(FORMAT),
        .AXIS_W(AXIS_W),
        .HIGH_W(HIGH_W),
        .PAGE_W(PAGE_W),
        .SLOT_W(SLOT_W)
      ) u_writer (
        .clk             (clk),
        .numbers_i       (numbers_i),
        .lattice_write_i (lattice_write_i),
        .lattice_buffer_i(lattice_buffer_i),
        .lattice_at_i    (lattice_at_i),
        .slot_write_i    (slot_write_i),
        .slot_i          (slot_i),
        .slot_cell_i     (slot_cell_i),
        .slot_group_i    (slot_group_i),
        .slot_phase_i    (slot_phase_i),
        .write_o         (write),
        .write_slot_o    (write_slot),
        .place_o         (write_place),
        .bank_o          (write_bank),
        .point_o         (write_point)
      );
    end
  endgenerate

  // ---- lanes

  wire early_of_slot;
  wire early_fourth;
  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(EARLY)
  ) u_kind (
    .clk(clk),
    .rst(1'b0),
    .d_i({of_slot, FOURTH != 0 && read_source_i[SOURCE_W-2]}),
    .q_o({early_of_slot, early_fourth})
  );

  wire [N*3*POINT_W-1:0] points;
  wire [N*3*POINT_W-1:0] chosen;
  wire [N-1:0]           odd;
  wire                   chosen_odd;
  wire [1:0]             write_fourth;  // on either bus
  wire [2*POINT_W-1:0]   fourth_number;
  generate
    if (N == 1 || FOURTH == 0) begin : gen_fourth_now
      assign write_fourth  = {1'b0, lattice_write_i && lattice_fourth_i};
      assign fourth_number = {2{numbers_i[3*POINT_W +: POINT_W]}};
    end else begin : gen_fourth_later
      // As late as ffd_cache_writer.
      reg               fourth_q;
      reg [POINT_W-1:0] number_q;
      always @(posedge clk) begin
        fourth_q <= lattice_write_i && lattice_fourth_i;
        number_q <= numbers_i[3*POINT_W +: POINT_W];
      end
      assign write_fourth  = write & {2{fourth_q}};
      assign fourth_number = {2{number_q}};
    end
  endgenerate
  genvar p;
  generate
    for (p = 0; p < N; p = p + 1) begin : gen_lane
      localparam [5:0] OFFSET = p;
      localparam       BUS    = N > 1 ? p % 2 : 0;
      wire [5:0]         bank = read_index_i + OFFSET;
      wire [5:0]         at   = write_bank[6*BUS +: 6];
      wire [PLACE_W-1:0] place;
      wire               here;
      wire [ROW_W-1:0]   write_row;
      wire [ROW_W-1:0]   read_row;
      wire [3*POINT_W-1:0] read_point;
      wire                 read_odd;

      assign place[PLACE_W-1 -: PAGE_W] = page;
      for (a = 0; a < 3 && PLACE_W > PAGE_W; a = a + 1) begin : gen_place
        wire [3:0] which = {2'd0, bank[4-2*a +: 2]} + 4 * a;
        assign place[(2-a)*HIGH_W +: HIGH_W] = highs[which*HIGH_W +: HIGH_W];
      end

      if (N == 1) begin : gen_single
        assign here = 1'b1;
      end else begin : gen_several
        assign here = at[$clog2(N)-1:0] == OFFSET[$clog2(N)-1:0];
      end
      if (ROWS > 1) begin : gen_rows
        assign write_row = at[5:6-ROW_W];
        assign read_row  = bank[5:6-ROW_W];
      end else begin : gen_single_row
        assign write_row = 1'b0;
        assign read_row  = 1'b0;
      end

      wire [PLACE_W-1:0] early_place;
      wire [ROW_W-1:0]   early_row;
      ffd_num_delay #(
        .WIDTH  (PLACE_W + ROW_W),
        .LATENCY(EARLY)
      ) u_early (
        .clk(clk),
        .rst(1'b0),
        .d_i({place, read_row}),
        .q_o({early_place, early_row})
      );

      wire unused_page = &{1'b0, early_place};
      ffd_cache_lane #(
        .WIDTH   (3 * POINT_W),
        .HARDENED(HARDENED),
        .ROWS    (ROWS),
        .PLACES  (PLACES),
        .LATTICES(LATTICES),
        .SLOTS   (N > 1 && COMING != 0 ? SLOTS : 0)
      ) u_lane (
        .clk          (clk),
        .write_i      (write[BUS] && here),
        .write_slot_i (write_slot),
        .write_place_i(write_place[USED_W-1:0]),
        .write_row_i  (write_row),
        .write_point_i(write_point[BUS*3*POINT_W +: 3*POINT_W]),
        .read_slot_i  (early_of_slot),
        .read_place_i (early_place[USED_W-1:0]),
        .read_row_i   (early_row),
        .point_o      (read_point),
        .odd_o        (read_odd)
      );

      if (FOURTH != 0) begin : gen_fourth
        wire [POINT_W-1:0] number;
        wire               number_odd;
        reg                fourth_q;
        reg                fourth_qq;
        ffd_cache_lane #(
          .WIDTH   (POINT_W),
          .HARDENED(HARDENED),
          .ROWS    (ROWS),
          .PLACES  (PLACES),
          .SLOTS   (0)
        ) u_lane (
          .clk          (clk),
          .write_i      (write_fourth[BUS] && here),
          .write_slot_i (1'b0),
          .write_place_i(write_place[USED_W-1:0]),
          .write_row_i  (write_row),
          .write_point_i(fourth_number[BUS*POINT_W +: POINT_W]),
          .read_slot_i  (1'b0),
          .read_place_i (early_place[USED_W-1:0]),
          .read_row_i   (early_row),
          .point_o      (number),
          .odd_o        (number_odd)
        );
        always @(posedge clk) begin
          fourth_q  <= early_fourth;
          fourth_qq <= fourth_q;
        end
        assign points[p*3*POINT_W +: 3*POINT_W] = fourth_qq ? {3{number}} : read_point;
        assign odd[p] = fourth_qq ? number_odd : read_odd;
      end else begin : gen_no_fourth
        assign points[p*3*POINT_W +: 3*POINT_W] = read_point;
        assign odd[p] = read_odd;
      end
    end

    if (N == 1 && COMING != 0) begin : gen_choice
      reg slot_q;
      reg slot_qq;
      always @(posedge clk) begin
        slot_q  <= early_of_slot;
        slot_qq <= slot_q;
      end
      assign chosen     = LATTICES == 0 || slot_qq ? beat_point : points;
      assign chosen_odd = LATTICES == 0 || slot_qq ? beat_odd : |odd;
    end else begin : gen_no_choice
      assign chosen     = points;
      assign chosen_odd = |odd;
    end
  endgenerate

  wire [N*3*POINT_W+HARDENED-1:0] leaving, left;
  assign leaving[N*3*POINT_W-1:0] = chosen;
  assign points_o                 = left[N*3*POINT_W-1:0];
  generate
    if (HARDENED != 0) begin : gen_odd
      assign leaving[N*3*POINT_W] = chosen_odd;
      assign odd_o                = left[N*3*POINT_W];
    end else begin : gen_no_odd
      assign odd_o = 1'b0;
    end
  endgenerate
  ffd_num_delay #(
    .WIDTH  (N * 3 * POINT_W + HARDENED),
    .LATENCY(LATENCY - 2 - EARLY)
  ) u_points (
    .clk(clk),
    .rst(1'b0),
    .d_i(leaving),
    .q_o(left)
  );

  wire unused_ok = &{1'b0, write, write_bank, write_point, beat_point, numbers_i, lattice_at_i,
                     highs, read_source_i, write_fourth, fourth_number, lattice_fourth_i,
                     early_fourth, write_place, beat_odd, chosen_odd};
endmodule

`default_nettype wire
