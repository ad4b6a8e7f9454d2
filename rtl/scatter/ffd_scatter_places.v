// ffd_scatter_places: the places along an axis of the four points of a cell, by bank
//
// Of cell i, bank b has the point at place i / 4, or the next one if b < i mod 4.
//
// Pipeline:   combinational.
// Bad input:  a cell beyond the last has the place 0 behind the last one.
// Parameters: AXIS 4 to 64.
// Model:      none (order only).  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_scatter.vh"

module ffd_scatter_places #(
  parameter AXIS   = 16,
  parameter AXIS_W = `FFD_AXIS_W(AXIS)
) (
  input  wire [AXIS_W-1:0]                      cell_i,
  output wire [4*`FFD_SCATTER_HIGH_W(AXIS)-1:0] places_o  // that of bank 0 lowest
);
  localparam HIGH_W = `FFD_SCATTER_HIGH_W(AXIS);

  generate
    if (AXIS < 4 || AXIS > 64) begin : gen_bad_axis
      ERROR_ffd_scatter_places_axis_must_be_4_to_64 u_error ();
    end
  endgenerate

  genvar b;
  generate
    for (b = 0; b < 4; b = b + 1) begin : gen_bank
      localparam [3:0] ABOVE = 4'b1110 << b;  // the cells whose own bank is above this one
      wire [HIGH_W:0]  next  = {{HIGH_W{1'b0}}, ABOVE[cell_i[1:0]]};
      assign places_o[b*HIGH_W +: HIGH_W] = cell_i[2 +: HIGH_W] + next[HIGH_W-1:0];
      wire unused_ok = &{1'b0, next[HIGH_W]};
    end
    if (AXIS_W > HIGH_W + 2) begin : gen_unused
      wire unused_ok = &{1'b0, cell_i};
    end
  endgenerate
endmodule

`default_nettype wire
