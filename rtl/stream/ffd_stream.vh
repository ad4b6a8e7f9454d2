// What the parts of the stream share: headers, status, events.
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_STREAM_VH
`define FFD_STREAM_VH

`include "ffd_events.vh"
`include "ffd_fields.vh"

// Of the user word, a vertex's way around the evaluator: its highest bits, which say what is free
// when the vertex has left.
`define FFD_USER_RETIRE(WIDTH) WIDTH-1 -: `FFD_RETIRE_W

// What a beat would be as a header: its opcode, good dimensions, a count of 0,
// spans beyond the table.
`define FFD_KIND_COEFFICIENTS 0
`define FFD_KIND_LATTICE      1
`define FFD_KIND_DIMENSIONS   2
`define FFD_KIND_VERTICES     3
`define FFD_KIND_INTERLEAVED  4
`define FFD_KIND_NONE         5
`define FFD_KIND_SPANS        6
`define FFD_KIND_BEYOND       7
`define FFD_KIND_W            8

// What a packet of vertices asks for; docs/interface.md section 2.
`define FFD_RESULTS_POSITION    2'd0
`define FFD_RESULTS_DERIVATIVES 2'd1
`define FFD_RESULTS_DETERMINANT 2'd2

// What a core has, bits of FEATURES; docs/interface.md section 1.
`define FFD_FEATURE_SPANS(FEATURES)       (((FEATURES) >> 3) % 2)
`define FFD_FEATURE_RESIDENT(FEATURES)    (((FEATURES) >> 8) % 2)
`define FFD_FEATURE_INTERLEAVED(FEATURES) (((FEATURES) >> 9) % 2)
`define FFD_FEATURE_DERIVATIVES(FEATURES) (((FEATURES) >> 10) % 2)
`define FFD_FEATURE_DETERMINANT(FEATURES) (((FEATURES) >> 11) % 2)
`define FFD_FEATURES                      3840
`define FFD_FEATURES_BAD(FEATURES) \
  ((FEATURES) < 256 || (FEATURES) / 256 > `FFD_FEATURES / 256 \
   || ((FEATURES) % 256 != 0 && (FEATURES) % 256 != 8) \
   || (FEATURES) / 256 % 4 == 0 || (FEATURES) / 1024 == 2)

// Events of the core, a pulse each (docs/interface.md section 5), and the bit of one of them. In
// ERROR_STATUS those of the DMA lie between the first ten and the last four.
`define FFD_EVENTS            14
`define FFD_STREAM_EVENT(BIT) ((BIT) > `FFD_EVENT_SATURATED ? (BIT) - 14 : (BIT))

`endif
