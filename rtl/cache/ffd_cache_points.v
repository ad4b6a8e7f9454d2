// ffd_cache_points: control points from where a vertex has them: its slot or the resident lattice
//
// Pipeline:   READ_LATENCY 2, II 1, never frozen. What is written is there for reads from the
//             second clock after it: no vertex reads its points sooner.
// Parameters: those of ffd_cache_interleaved and ffd_cache_resident; the source is {resident, slot
//             or buffer}.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_cache_points #(
  parameter FORMAT = 18,
  parameter N      = 1,
  parameter SLOTS  = 3,
  parameter SLOT_W = $clog2(SLOTS),
  parameter AXIS   = 16
) (
  input  wire                                 clk,
  input  wire                                 lattice_write_i,
  input  wire                                 lattice_buffer_i,
  input  wire [11:0]                          lattice_at_i,
  input  wire [95:0]                          lattice_words_i,
  input  wire                                 slot_write_i,
  input  wire [SLOT_W-1:0]                    slot_i,
  input  wire [11:0]                          slot_cell_i,
  input  wire [3:0]                           slot_group_i,
  input  wire [1:0]                           slot_phase_i,
  input  wire [127:0]                         slot_words_i,
  input  wire [`FFD_EXPONENT_W-1:0]           write_exponent_i,
  input  wire [SLOT_W:0]                      read_source_i,
  input  wire [11:0]                          read_cell_i,
  input  wire [5:0]                           read_index_i,
  output wire [N*3*`FFD_POINT_W(FORMAT)-1:0]  points_o
);
  localparam POINTS_W = N * 3 * `FFD_POINT_W(FORMAT);

  reg                        lattice_write_q;
  reg                        lattice_buffer_q;
  reg [11:0]                 lattice_at_q;
  reg [95:0]                 lattice_words_q;
  reg                        slot_write_q;
  reg [SLOT_W-1:0]           slot_q;
  reg [11:0]                 slot_cell_q;
  reg [3:0]                  slot_group_q;
  reg [1:0]                  slot_phase_q;
  reg [127:0]                slot_words_q;
  reg [`FFD_EXPONENT_W-1:0]  write_exponent_q;
  always @(posedge clk) begin
    lattice_write_q  <= lattice_write_i;
    lattice_buffer_q <= lattice_buffer_i;
    lattice_at_q     <= lattice_at_i;
    lattice_words_q  <= lattice_words_i;
    slot_write_q     <= slot_write_i;
    slot_q           <= slot_i;
    slot_cell_q      <= slot_cell_i;
    slot_group_q     <= slot_group_i;
    slot_phase_q     <= slot_phase_i;
    slot_words_q     <= slot_words_i;
    write_exponent_q <= write_exponent_i;
  end

  wire [POINTS_W-1:0] of_lattice;
  wire [POINTS_W-1:0] of_slot;
  wire                resident;

  ffd_cache_resident #(
    .FORMAT(FORMAT),
    .N     (N),
    .AXIS  (AXIS)
  ) u_resident (
    .clk             (clk),
    .write_i         (lattice_write_q),
    .write_buffer_i  (lattice_buffer_q),
    .write_at_i      (lattice_at_q),
    .write_words_i   (lattice_words_q),
    .write_exponent_i(write_exponent_q),
    .read_buffer_i   (read_source_i[0]),
    .read_cell_i     (read_cell_i),
    .read_index_i    (read_index_i),
    .points_o        (of_lattice)
  );

  ffd_cache_interleaved #(
    .FORMAT(FORMAT),
    .N     (N),
    .SLOTS (SLOTS)
  ) u_interleaved (
    .clk             (clk),
    .write_i         (slot_write_q),
    .write_slot_i    (slot_q),
    .write_cell_i    (slot_cell_q),
    .write_group_i   (slot_group_q),
    .write_phase_i   (slot_phase_q),
    .write_words_i   (slot_words_q),
    .write_exponent_i(write_exponent_q),
    .read_slot_i     (read_source_i[SLOT_W-1:0]),
    .read_index_i    (read_index_i),
    .points_o        (of_slot)
  );

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(2)
  ) u_resident_late (
    .clk(clk),
    .rst(1'b0),
    .d_i(read_source_i[SLOT_W]),
    .q_o(resident)
  );

  assign points_o = resident ? of_lattice : of_slot;
endmodule

`default_nettype wire
