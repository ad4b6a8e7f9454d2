// ffd_cache_writer: control points on their way to the lanes
//
// Two buses go to the lanes: bus 0 to those of even banks, bus 1 to those of odd ones. A point of a
// resident lattice goes on the bus of its bank. Of interleaved points three beats bring four, at
// most two of them complete in a beat; their banks differ in the lowest bit, so they never want the
// same bus.
//
// Formats:    at {k, j, i}; bank {i, j, k} mod 4; place as in ffd_cache_lane; a slot's points come
//             in local order and lie in bank local + cell modulo 4 an axis.
// Pipeline:   1 clock, II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh; AXIS_W bits of an index, HIGH_W used above its two of bank;
//             PAGE_W >= 1; SLOT_W at most PLACE_W, which is that of the lanes.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_cache_writer #(
  parameter FORMAT  = 18,
  parameter AXIS_W  = 4,
  parameter HIGH_W  = 2,
  parameter PAGE_W  = 1,
  parameter SLOT_W  = 2,
  parameter PLACE_W = 3 * HIGH_W + PAGE_W
) (
  input  wire                                 clk,
  input  wire [4*`FFD_POINT_W(FORMAT)-1:0]    numbers_i,
  input  wire                                 lattice_write_i,
  input  wire [PAGE_W-1:0]                    lattice_buffer_i,
  input  wire [3*AXIS_W-1:0]                  lattice_at_i,
  input  wire                                 slot_write_i,
  input  wire [SLOT_W-1:0]                    slot_i,
  input  wire [11:0]                          slot_cell_i,
  input  wire [3:0]                           slot_group_i,
  input  wire [1:0]                           slot_phase_i,
  output reg  [1:0]                           write_o,
  output reg                                  write_slot_o,
  output reg  [PLACE_W-1:0]                   place_o,
  output reg  [2*6-1:0]                       bank_o,
  output reg  [2*3*`FFD_POINT_W(FORMAT)-1:0]  point_o
);
  localparam POINT_W = `FFD_POINT_W(FORMAT);
  localparam [1:0] LAST_PHASE = 2'd2;

  wire [POINT_W-1:0] n0 = numbers_i[0*POINT_W +: POINT_W];
  wire [POINT_W-1:0] n1 = numbers_i[1*POINT_W +: POINT_W];
  wire [POINT_W-1:0] n2 = numbers_i[2*POINT_W +: POINT_W];
  wire [POINT_W-1:0] n3 = numbers_i[3*POINT_W +: POINT_W];

  // ---- points: the first components of one come at the end of the beat before

  reg  [POINT_W-1:0]   x_q;
  reg  [POINT_W-1:0]   y_q;
  wire [1:0]           phase = slot_write_i ? slot_phase_i : 2'd0;
  wire [3*POINT_W-1:0] first = phase == 2'd0 ? {n2, n1, n0}
                             : phase == 2'd1 ? {n1, n0, x_q} : {n0, y_q, x_q};
  wire [3*POINT_W-1:0] second = {n3, n2, n1};
  wire                 two    = slot_write_i && phase == LAST_PHASE;
  always @(posedge clk) begin
    if (slot_write_i) begin
      x_q <= phase == 2'd0 ? n3 : n2;
      y_q <= n3;
    end
  end

  // ---- their banks; the second of a group's two is its last point

  wire [1:0] l       = slot_group_i[3:2] + slot_cell_i[1:0];
  wire [1:0] m       = slot_group_i[1:0] + slot_cell_i[5:4];
  wire [1:0] n       = slot_phase_i + slot_cell_i[9:8];
  wire [5:0] at_bank = {lattice_at_i[1:0], lattice_at_i[AXIS_W +: 2],
                        lattice_at_i[2*AXIS_W +: 2]};
  wire [5:0] bank    = slot_write_i ? {l, m, n} : at_bank;
  wire [5:0] next    = {bank[5:2], bank[1:0] + 2'd1};
  wire       odd     = bank[0];

  wire [PLACE_W-1:0] at_place = {lattice_buffer_i, lattice_at_i[2 +: HIGH_W],
                                 lattice_at_i[AXIS_W+2 +: HIGH_W],
                                 lattice_at_i[2*AXIS_W+2 +: HIGH_W]};
  wire [PLACE_W-1:0] at_slot  = {{(PLACE_W - SLOT_W) {1'b0}}, slot_i};

  always @(posedge clk) begin
    write_o      <= {2{lattice_write_i || slot_write_i}} & {odd || two, !odd || two};
    write_slot_o <= slot_write_i;
    place_o      <= slot_write_i ? at_slot : at_place;
    bank_o       <= odd ? {bank, next} : {next, bank};
    point_o      <= odd ? {first, second} : {second, first};
  end

  wire unused_ok = &{1'b0, slot_cell_i, lattice_at_i};
endmodule

`default_nettype wire
