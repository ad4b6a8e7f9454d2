// What the parts of the stream share: headers, status, events.
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_STREAM_VH
`define FFD_STREAM_VH

// A vertex's way around the evaluator: {resident, buffer, bank, last, blank, status, tag}.
`define FFD_USER_W 27
`define FFD_USER_LAST 23

// What a beat would be as a header: its opcode, good dimensions, a count that is not 0.
`define FFD_KIND_COEFFICIENTS 0
`define FFD_KIND_LATTICE      1
`define FFD_KIND_DIMENSIONS   2
`define FFD_KIND_VERTICES     3
`define FFD_KIND_INTERLEAVED  4
`define FFD_KIND_SOME         5
`define FFD_KIND_W            6

// What a packet of vertices asks for; docs/interface.md section 2.
`define FFD_RESULTS_POSITION    2'd0
`define FFD_RESULTS_DERIVATIVES 2'd1
`define FFD_RESULTS_DETERMINANT 2'd2
`define FFD_RESULTS_BAD         2'd3

// Events of the input, one pulse each; docs/interface.md section 5.
`define FFD_EVENT_OPCODE       0
`define FFD_EVENT_SHORT        1
`define FFD_EVENT_LONG         2
`define FFD_EVENT_COEFFICIENTS 3
`define FFD_EVENT_LATTICE      4
`define FFD_EVENT_DIMENSIONS   5
`define FFD_EVENT_CELL         6
`define FFD_EVENT_NAN          7
`define FFD_EVENT_COORDINATE   8
`define FFD_EVENTS             9

// One more, of the result.
`define FFD_EVENT_SATURATED    9

`endif
