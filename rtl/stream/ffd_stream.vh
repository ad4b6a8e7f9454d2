// What the parts of the stream share: headers, status, events.
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_STREAM_VH
`define FFD_STREAM_VH

`include "ffd_events.vh"
`include "ffd_features.vh"
`include "ffd_fields.vh"

// Of the user word, a vertex's way around the evaluator: its highest bits, which say what is free
// when the vertex has left.
`define FFD_USER_RETIRE(WIDTH) WIDTH-1 -: `FFD_RETIRE_W

// What a beat would be as a header of the kind that ffd_stream_opcode says: what of it the core
// takes, good dimensions, a count of 0; points of a part of a page; vertices until tlast; spans,
// and whether they are beyond the table.
`define FFD_KIND_COEFFICIENTS 0
`define FFD_KIND_LATTICE      1
`define FFD_KIND_DIMENSIONS   2
`define FFD_KIND_VERTICES     3
`define FFD_KIND_INTERLEAVED  4
`define FFD_KIND_NONE         5
`define FFD_KIND_PART         6
`define FFD_KIND_EVERY        7
`define FFD_KIND_SPANS        8
`define FFD_KIND_BEYOND       9
`define FFD_KIND_W            10

// What ffd_stream_expand says of a beat: the header of a grid; a vertex that is refused; the end of
// a grid that is refused, or was cut short; the last vertex of a packet that is too long; what is
// behind the last vertex.
`define FFD_AS_IT_IS    3'd0
`define FFD_AS_GRID     3'd1
`define FFD_AS_REFUSED  3'd2
`define FFD_AS_NO_GRID  3'd3
`define FFD_AS_SHORT    3'd4
`define FFD_AS_LONG     3'd5
`define FFD_AS_NOTHING  3'd6
`define FFD_AS_STOPPED  3'd7

// What a packet of vertices asks for; docs/interface.md section 2.
`define FFD_RESULTS_POSITION    2'd0
`define FFD_RESULTS_DERIVATIVES 2'd1
`define FFD_RESULTS_DETERMINANT 2'd2
`define FFD_RESULTS_ALONE       2'd3  // det J without the position

// Of FEATURES (ffd_features.vh): grids or packed vertices, which ffd_stream_expand makes; what a
// module by itself has unless told, which is more than the core without a parameter; and what it
// cannot have.
`define FFD_FEATURE_EXPANDED(FEATURES) \
  (`FFD_FEATURE_GRIDS(FEATURES) != 0 || `FFD_FEATURE_PACKED(FEATURES) != 0)
`define FFD_FEATURES_USUAL 3840
// Whether two neighbours of a row of a grid go through the core at once: the organization takes two
// vertices, and results of two are one beat.
`define FFD_PAIRS(ORG, FEATURES) \
  (`FFD_ORG_PAIRS(ORG) && `FFD_FEATURE_GRIDS(FEATURES) != 0 \
   && `FFD_FEATURE_HALVES(FEATURES) != 0 ? 1 : 0)
// Whether two of the four results of a vertex may leave the core at once.
`define FFD_TWO_RESULTS(ORG, FEATURES) \
  (`FFD_ORG_JACOBIAN(ORG) != 0 && `FFD_FEATURE_DERIVATIVES(FEATURES) != 0)
`define FFD_FEATURES_BAD(FEATURES) \
  ((FEATURES) % 4096 < 256 || (FEATURES) >= 8192 \
   || (FEATURES) / 128 % 2 != 0 \
   || (`FFD_FEATURE_EXPANDED(FEATURES) && (FEATURES) / 256 % 2 == 0) \
   || (FEATURES) / 256 % 4 == 0 || (FEATURES) / 1024 % 4 == 2 \
   || (((FEATURES) % 8 != 0 || `FFD_FEATURE_MARKS(FEATURES) != 0 \
        || `FFD_FEATURE_HALVES(FEATURES) != 0) \
       && ((FEATURES) % 2 == 0 || (FEATURES) / 256 % 2 == 0)))

// Bits of an index of a point or a cell along an axis; those above four, which go from the vertex
// to its reads as part of its source; and whether AXIS is no number of points.
`define FFD_AXIS_W(AXIS) ((AXIS) > 32 ? 6 : (AXIS) > 16 ? 5 : 4)
`define FFD_HIGH_W(AXIS) (`FFD_AXIS_W(AXIS) - 4)
`define FFD_AXIS_BAD(AXIS, FEATURES) \
  ((AXIS) < 4 || (AXIS) > 64 || ((AXIS) > 32) != (`FFD_FEATURE_LARGE(FEATURES) != 0))

// Bits of the number of a page, one where there is one page only.
`define FFD_PAGE_NUMBER_W(PAGES) ((PAGES) > 2 ? $clog2(PAGES) : 1)

// Of the source of a vertex {resident, fourth component, high bits of the cell, slot or page}.
`define FFD_AT_W(SLOTS, PAGES) \
  ($clog2(SLOTS) > $clog2(PAGES) ? $clog2(SLOTS) : $clog2(PAGES))
`define FFD_SOURCE_W(SLOTS, PAGES, AXIS, FEATURES) \
  (1 + `FFD_FEATURE_FOURTH(FEATURES) + 3 * `FFD_HIGH_W(AXIS) + `FFD_AT_W(SLOTS, PAGES))

// The most vertices inside at once, from their last beat to the clock behind their last result:
// evaluations, those that wait before them, and up to 8 in the registers between. Every queue and
// every count of vertices is as large as this says.
`define FFD_MOST_INSIDE(IN_FLIGHT, WAITING) ((IN_FLIGHT) + (WAITING) + 8)

// What is known of the header of a page, and of its payload.
`define FFD_PAGE_UNKNOWN 0
`define FFD_PAGE_BEYOND  1
`define FFD_PAGE_SIZE    2
`define FFD_PAGE_POINTS  3
`define FFD_PAGE_FOURTH  4
`define FFD_PAGE_W       5

`endif
