// ffd_stream_header: what a beat would be as the header of a packet
//
// In front of the first register of the stream (docs/interface.md section 2 has the fields).
//
// Formats:    packet as in ffd_stream_opcode; kind as FFD_KIND_* in ffd_stream.vh: what of it the
//             core takes, whether dimensions are good, whether the count is 0, whether spans are
//             beyond the table. Pages are lattices, and their vertices are vertices; what else
//             their headers say, ffd_stream_pages checks.
// Pipeline:   combinational.
// Parameters: AXIS 4 to 32, or to 64 where FEATURES says so, the most points an axis of a lattice;
//             FEATURES as in ffd_stream.vh, with the bit of spans where SPANS is above 1; BESIDE 1:
//             a scatter core on the same stream wants derivatives, so coefficients may have them.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_stream.vh"

module ffd_stream_header #(
  parameter AXIS     = 16,
  parameter FEATURES = `FFD_FEATURES_USUAL,
  parameter SPANS    = 1,
  parameter BESIDE   = 0
) (
  input  wire [127:0]             data_i,
  input  wire [`FFD_PACKET_W-1:0] packet_i,
  input  wire                     grid_i,  // it is that of a grid
  output wire [`FFD_KIND_W-1:0]   kind_o
);
  generate
    if (`FFD_AXIS_BAD(AXIS, FEATURES)) begin : gen_bad_axis
      ERROR_ffd_stream_header_axis_must_be_4_to_32_or_large_to_64 u_error ();
    end
    if ((SPANS > 1) != (`FFD_FEATURE_SPANS(FEATURES) != 0)) begin : gen_bad_spans
      ERROR_ffd_stream_header_spans_and_their_feature_come_together u_error ();
    end
    if (`FFD_FEATURES_BAD(FEATURES)) begin : gen_bad_features
      ERROR_ffd_stream_header_features_do_not_go_together u_error ();
    end
  endgenerate

  localparam [31:0] SPANS_WORD         = SPANS;
  // Bit n: an axis may have n points. A table and not a comparison: no chain of carries.
  localparam [255:0] LESS_THAN_4       = 256'd15;
  localparam [255:0] POINTS            = ((256'd2 << AXIS) - 256'd1) & ~LESS_THAN_4;
  localparam [255:0] SMALL             = ((256'd2 << 32) - 256'd1) & ~LESS_THAN_4;  // no flag L

  localparam LARGE             = `FFD_FEATURE_LARGE(FEATURES);
  localparam DERIVATIVES       = `FFD_FEATURE_DERIVATIVES(FEATURES);
  localparam DETERMINANT       = `FFD_FEATURE_DETERMINANT(FEATURES);

  wire [1:0] results      = data_i[73:72];
  wire       good_results = results == `FFD_RESULTS_POSITION
                         || (results == `FFD_RESULTS_DERIVATIVES && DERIVATIVES != 0)
                         || ((results == `FFD_RESULTS_DETERMINANT || results == `FFD_RESULTS_ALONE)
                             && DETERMINANT != 0);
  wire       twice        = data_i[95];
  wire       page         = packet_i[`FFD_PACKET_PAGE];
  wire       of_page      = packet_i[`FFD_PACKET_PAGE_VERTICES];
  wire       every        = (of_page || grid_i) && data_i[16];
  wire       flag         = LARGE == 0 || (page && data_i[19]);
  wire [2:0] good;

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      wire [7:0] points = data_i[64+8*a +: 8];
      assign good[a] = flag ? POINTS[points] : SMALL[points];
    end
  endgenerate

  assign kind_o[`FFD_KIND_COEFFICIENTS] = packet_i[`FFD_PACKET_COEFFICIENTS]
                                       && (DERIVATIVES != 0 || BESIDE != 0 || !twice);
  assign kind_o[`FFD_KIND_LATTICE]      = packet_i[`FFD_PACKET_LATTICE] || page;
  assign kind_o[`FFD_KIND_DIMENSIONS]   = &good;
  assign kind_o[`FFD_KIND_VERTICES]     = (packet_i[`FFD_PACKET_VERTICES] || of_page)
                                       && good_results;
  assign kind_o[`FFD_KIND_INTERLEAVED]  = packet_i[`FFD_PACKET_INTERLEAVED] && good_results;
  assign kind_o[`FFD_KIND_NONE]         = data_i[63:32] == 32'd0 && !every;
  assign kind_o[`FFD_KIND_PART]         = packet_i[`FFD_PACKET_POINTS];
  assign kind_o[`FFD_KIND_EVERY]        = every;

  // Bits that have no meaning must be 0, and there is no axis 3.
  generate
    if (`FFD_FEATURE_SPANS(FEATURES) != 0) begin : gen_spans
      localparam [31:0] UNKNOWN_FLAGS = 32'hFFFE_FF00;
      localparam [31:0] UNKNOWN_BITS  = 32'h7F33_00CC;
      wire strange = (data_i[31:0] & UNKNOWN_FLAGS) != 32'd0
                  || (data_i[95:64] & UNKNOWN_BITS) != 32'd0
                  || data_i[127:96] != 32'd0 || data_i[87:86] == 2'd3;
      wire [8:0] behind = {1'b0, data_i[79:72]} + {1'b0, data_i[39:32]};
      assign kind_o[`FFD_KIND_SPANS]  = packet_i[`FFD_PACKET_SPANS] && !strange
                                     && (DERIVATIVES != 0 || !twice);
      assign kind_o[`FFD_KIND_BEYOND] = data_i[63:40] != 24'd0 || behind > SPANS_WORD[8:0];
    end else begin : gen_no_spans
      assign kind_o[`FFD_KIND_SPANS]  = 1'b0;
      assign kind_o[`FFD_KIND_BEYOND] = 1'b0;
      wire unused_spans = &{1'b0, SPANS_WORD};
    end
  endgenerate

  wire unused_ok = &{1'b0, data_i, packet_i};
endmodule

`default_nettype wire
