// ffd_stream_opcode: the kind of a packet, one bit for each, from the opcode of its header
//
// The one place that knows opcodes (docs/interface.md section 2): all that lies behind looks at the
// bits, which go with the header. What the core lacks is no kind: none of the bits is set.
//
// Formats:    packet as FFD_PACKET_* in ffd_fields.vh, bit n for opcode n + 1.
// Pipeline:   combinational.
// Parameters: FEATURES as in ffd_stream.vh, 0 where there are coefficients alone; SCATTER 1:
//             gradients and collects too.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_stream.vh"

module ffd_stream_opcode #(
  parameter FEATURES = `FFD_FEATURES_USUAL,
  parameter SCATTER  = 0
) (
  input  wire [7:0]               opcode_i,
  output wire [`FFD_PACKET_W-1:0] packet_o
);
  wire [`FFD_PACKET_W-1:0] built;
  assign built[`FFD_PACKET_COEFFICIENTS]  = 1'b1;
  assign built[`FFD_PACKET_LATTICE]       = `FFD_FEATURE_RESIDENT(FEATURES) != 0;
  assign built[`FFD_PACKET_VERTICES]      = `FFD_FEATURE_RESIDENT(FEATURES) != 0;
  assign built[`FFD_PACKET_INTERLEAVED]   = `FFD_FEATURE_INTERLEAVED(FEATURES) != 0;
  assign built[`FFD_PACKET_PAGE]          = `FFD_FEATURE_PAGES(FEATURES) != 0;
  assign built[`FFD_PACKET_POINTS]        = `FFD_FEATURE_PAGES(FEATURES) != 0;
  assign built[`FFD_PACKET_PAGE_VERTICES] = `FFD_FEATURE_PAGES(FEATURES) != 0;
  assign built[`FFD_PACKET_GRID]          = `FFD_FEATURE_GRIDS(FEATURES) != 0;
  assign built[`FFD_PACKET_SPANS]         = `FFD_FEATURE_SPANS(FEATURES) != 0;
  assign built[`FFD_PACKET_GRADIENTS]     = SCATTER != 0;
  assign built[`FFD_PACKET_COLLECT]       = SCATTER != 0;

  genvar n;
  generate
    for (n = 0; n < `FFD_PACKET_W; n = n + 1) begin : gen_packet
      localparam [7:0] OPCODE = n + 1;
      assign packet_o[n] = built[n] && opcode_i == OPCODE;
    end
  endgenerate
endmodule

`default_nettype wire
