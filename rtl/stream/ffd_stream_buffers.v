// ffd_stream_buffers: the resident lattice of a core without pages
//
// Two buffers take turns: a lattice fills the one that is not in use, which comes into use with its
// last point. Whether it is still read is known to ffd_stream_readers.
//
// Formats:    last cell {k, j, i}.
// Pipeline:   what is in use, from the clock after the last point.
// Parameters: AXIS as in ffd_stream_header; EXPONENT_W >= 1.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_stream.vh"

module ffd_stream_buffers #(
  parameter AXIS       = 16,
  parameter EXPONENT_W = 10
) (
  input  wire                             clk,
  input  wire                             rst,
  input  wire                             header_i,
  input  wire [23:0]                      points_i,    // an axis, of the header
  input  wire [EXPONENT_W-1:0]            exponent_i,  // of the packet under way
  input  wire                             whole_i,     // the last point of a lattice
  output reg                              buffer_o,
  output reg                              loaded_o,
  output reg  [3*`FFD_AXIS_W(AXIS)-1:0]   last_cell_o,
  output reg  [EXPONENT_W-1:0]            exponent_o
);
  localparam AXIS_W = `FFD_AXIS_W(AXIS);
  localparam [AXIS_W-1:0] SUPPORT = 4;

  reg [3*AXIS_W-1:0] new_last_cell_q;
  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      always @(posedge clk) begin
        if (header_i) new_last_cell_q[AXIS_W*a +: AXIS_W] <= points_i[8*a +: AXIS_W] - SUPPORT;
      end
    end
  endgenerate

  always @(posedge clk) begin
    if (rst) begin
      buffer_o <= 1'b0;
      loaded_o <= 1'b0;
    end else if (whole_i) begin
      buffer_o <= !buffer_o;
      loaded_o <= 1'b1;
    end
  end
  always @(posedge clk) begin
    if (whole_i) begin
      last_cell_o <= new_last_cell_q;
      exponent_o  <= exponent_i;
    end
  end

  wire unused_ok = &{1'b0, points_i};
endmodule

`default_nettype wire
