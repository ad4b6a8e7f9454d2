// ffd_scatter_header: what a beat would be as the header of a packet of a scatter core
//
// Fields of opcodes 10 and 11 (docs/interface.md section 2), and whether they are good. Of opcode 1
// all bits are taken.
//
// Bad input:  unknown_o where the opcode is, or a flag, a mode or a bit that must be 0; size_o
//             where gradients have bad points an axis.
// Formats:    packet as in ffd_stream_opcode; tops, points an axis - 1, {u, t, s}.
// Pipeline:   combinational.
// Parameters: AXIS 4 to 32, the most points an axis.
// Model:      golden/include/hwffd/model/scatter_stream.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_stream.vh"

module ffd_scatter_header #(
  parameter AXIS = 16
) (
  input  wire [127:0]                   data_i,
  input  wire [`FFD_PACKET_W-1:0]       packet_i,
  output wire                           unknown_o,
  output wire                           size_o,
  output wire                           none_o,   // no vertex is announced
  output wire                           grid_o,
  output wire                           begin_o,
  output wire [3*`FFD_AXIS_W(AXIS)-1:0] tops_o
);
  generate
    if (AXIS < 4 || AXIS > 32) begin : gen_bad_axis
      ERROR_ffd_scatter_header_axis_must_be_4_to_32 u_error ();
    end
  endgenerate

  localparam AXIS_W = `FFD_AXIS_W(AXIS);
  // Bits of words 0 to 3 that must be 0.
  localparam [127:0] OF_GRADIENTS = {32'hFFFF_0000, 32'hF100_0000, 32'h0000_0000, 32'hFF3F_0000};
  localparam [127:0] OF_COLLECT   = {32'hFFFF_0000, 32'hFFFF_FFFC, 32'hFFFF_FFFF, 32'hFFCF_0000};
  // Bit n: an axis may have n points. A table and not a comparison: no chain of carries.
  localparam [255:0] LESS_THAN_4  = 256'd15;
  localparam [255:0] POINTS       = ((256'd2 << AXIS) - 256'd1) & ~LESS_THAN_4;

  wire gradients = packet_i[`FFD_PACKET_GRADIENTS];
  wire collect   = packet_i[`FFD_PACKET_COLLECT];
  wire known     = gradients || collect || packet_i[`FFD_PACKET_COEFFICIENTS];
  wire no_count  = !grid_o && data_i[111:96] != 16'd0;
  wire [2:0] good;

  assign grid_o    = data_i[22];
  assign begin_o   = data_i[23];
  assign none_o    = !grid_o && data_i[63:32] == 32'd0;
  assign size_o    = gradients && !(&good);
  assign unknown_o = !known
                  || (gradients && ((data_i & OF_GRADIENTS) != 128'd0 || no_count))
                  || (collect && (data_i & OF_COLLECT) != 128'd0);

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      wire [7:0] points = data_i[64+8*a +: 8];
      assign good[a]                    = POINTS[points];
      assign tops_o[AXIS_W*a +: AXIS_W] = points[AXIS_W-1:0] - 1'b1;
    end
  endgenerate

  wire unused_ok = &{1'b0, data_i, packet_i};
endmodule

`default_nettype wire
