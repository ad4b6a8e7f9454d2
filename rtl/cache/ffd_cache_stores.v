// ffd_cache_stores: a store of control points for each read port of the evaluator
//
// Lanes that read in every clock have a store each; all are written at once, with the same points.
//
// Formats, pipeline, parameters: those of ffd_cache_points; PORTS >= 1. Ports from the lowest on:
//             source, with a bit above SOURCE_W that says whether the vertex reads again, and with
//             HARDENED one below that says that its points may not be there; cell; index; points.
// odd_o, with HARDENED: a point that was there has another parity than when it was written.
// slot_free_o: the last read of a vertex whose points came with it; of one vertex in a clock.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_stream.vh"

module ffd_cache_stores #(
  parameter FORMAT   = 18,
  parameter FEATURES = `FFD_FEATURES_USUAL,
  parameter PORTS    = 1,
  parameter N        = 1,
  parameter SLOTS    = 3,
  parameter SLOT_W   = $clog2(SLOTS),
  parameter PAGES    = 2,
  parameter PAGE_W   = `FFD_PAGE_NUMBER_W(PAGES),
  parameter AXIS     = 16,
  parameter AT_W     = 3 * `FFD_AXIS_W(AXIS),
  parameter SOURCE_W = `FFD_SOURCE_W(SLOTS, PAGES, AXIS, FEATURES),
  parameter LATENCY  = 2,
  parameter HARDENED = 0,
  parameter READ_W   = SOURCE_W + 1 + HARDENED
) (
  input  wire                                       clk,
  input  wire                                       rst,
  input  wire [4*`FFD_POINT_W(FORMAT)-1:0]          numbers_i,
  input  wire                                       lattice_write_i,
  input  wire [PAGE_W-1:0]                          lattice_buffer_i,
  input  wire [AT_W-1:0]                            lattice_at_i,
  input  wire                                       lattice_fourth_i,
  input  wire                                       slot_write_i,
  input  wire [SLOT_W-1:0]                          slot_i,
  input  wire [11:0]                                slot_cell_i,
  input  wire [3:0]                                 slot_group_i,
  input  wire [1:0]                                 slot_phase_i,
  input  wire [PORTS-1:0]                           read_i,
  input  wire [PORTS-1:0]                           read_last_i,
  input  wire [PORTS*READ_W-1:0]                    read_source_i,
  input  wire [PORTS*12-1:0]                        read_cell_i,
  input  wire [PORTS*6-1:0]                         read_index_i,
  output wire                                       slot_free_o,
  output wire [PORTS*N*3*`FFD_POINT_W(FORMAT)-1:0]  points_o,
  output wire                                       odd_o
);
  localparam POINTS_W = N * 3 * `FFD_POINT_W(FORMAT);

  wire [PORTS-1:0] odd;
  wire [PORTS-1:0] absent;
  generate
    if (HARDENED != 0 && HARDENED != 1) begin : gen_bad_hardened
      ERROR_ffd_cache_stores_hardened_must_be_0_or_1 u_error ();
    end
    if (HARDENED != 0) begin : gen_odd
      // When the points come that were asked for.
      wire [PORTS-1:0] come;
      reg              odd_q;
      ffd_num_delay #(
        .WIDTH  (PORTS),
        .LATENCY(LATENCY),
        .RESET  (1)
      ) u_come (
        .clk(clk),
        .rst(rst),
        .d_i(read_i & ~absent),
        .q_o(come)
      );
      always @(posedge clk) odd_q <= |(odd & come) && !rst;
      assign odd_o = odd_q;
    end else begin : gen_no_odd
      assign odd_o = 1'b0;
      wire unused_ok = &{1'b0, rst, odd, read_i, absent};
    end
  endgenerate

  wire [PORTS-1:0] slot_last;
  assign slot_free_o = |slot_last;

  genvar p;
  generate
    for (p = 0; p < PORTS; p = p + 1) begin : gen_store
      wire [READ_W-1:0] asked  = read_source_i[READ_W*p +: READ_W];
      wire [SOURCE_W:0] source = asked[READ_W-1 -: SOURCE_W+1];
      assign absent[p]    = HARDENED != 0 && asked[0];
      assign slot_last[p] = read_last_i[p] && source[SOURCE_W:SOURCE_W-1] == 2'b00;

      ffd_cache_points #(
        .FORMAT  (FORMAT),
        .FEATURES(FEATURES),
        .N       (N),
        .SLOTS   (SLOTS),
        .PAGES   (PAGES),
        .AXIS    (AXIS),
        .LATENCY (LATENCY),
        .HARDENED(HARDENED)
      ) u_points (
        .clk             (clk),
        .numbers_i       (numbers_i),
        .lattice_write_i (lattice_write_i),
        .lattice_buffer_i(lattice_buffer_i),
        .lattice_at_i    (lattice_at_i),
        .lattice_fourth_i(lattice_fourth_i),
        .slot_write_i    (slot_write_i),
        .slot_i          (slot_i),
        .slot_cell_i     (slot_cell_i),
        .slot_group_i    (slot_group_i),
        .slot_phase_i    (slot_phase_i),
        .read_source_i   (source[SOURCE_W-1:0]),
        .read_cell_i     (read_cell_i[12*p +: 12]),
        .read_index_i    (read_index_i[6*p +: 6]),
        .points_o        (points_o[POINTS_W*p +: POINTS_W]),
        .odd_o           (odd[p])
      );
    end
  endgenerate
endmodule

`default_nettype wire
