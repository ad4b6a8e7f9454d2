// Ports of every organization (docs/architecture.md section 3). To be included in the list of a
// module's ports. Numbers are as wide as FORMAT wants them; x or s lies lowest.
// SPDX-License-Identifier: Apache-2.0

input  wire                                            clk,
input  wire                                            rst,   // nothing is inside

// One blending function {shift, c3, c2, c1, c0}: of axis 0 to 2, at {place, function}, where the
// place is {derivative, bank}, or with spans FFD_PLACE_W in ffd_eval.vh.
input  wire                                            load_i,
input  wire [1:0]                                      load_axis_i,
input  wire [`FFD_OWN_W(SPANS)-1:0]                    load_address_i,
input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,

// A vertex: coordinates {u, t, s}, cell {k, j, i}, where its points are, and the places of its
// functions {u, t, s}. Changed: what source and banks name may have been loaded since the vertex
// before, or this one is the first after reset. Ready is the only brake: who offers a vertex has
// room for its result.
input  wire                                            s_vertex_valid,
output wire                                            s_vertex_ready,
input  wire [3*`FFD_WEIGHT_W(FORMAT)-1:0]              s_vertex_coordinates,
input  wire [11:0]                                     s_vertex_cell,
input  wire [SOURCE_W-1:0]                             s_vertex_source,
input  wire [3*`FFD_PLACE_W(SPANS)-1:0]                s_vertex_bank,
input  wire                                            s_vertex_changed,

// Of an organization that takes two vertices at once (FFD_ORG_PAIRS), the coordinate s of a second
// one, which has all else of the first. Where there is none it is any.
input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]                s_vertex_second,

// The points wanted, N from index on, at each of PORTS ports; last: the vertex reads no more, of
// one vertex in a clock. They come as {z, y, x} each, exactly READ_LATENCY clocks later, always.
output wire [PORTS-1:0]                                read_o,
output wire [PORTS-1:0]                                read_last_o,
output wire [PORTS*SOURCE_W-1:0]                       read_source_o,
output wire [PORTS*12-1:0]                             read_cell_o,
output wire [PORTS*6-1:0]                              read_index_o,
input  wire [PORTS*N*3*`FFD_POINT_W(FORMAT)-1:0]       read_points_i,

// The sum {z, y, x}, for one clock, in the order of the vertices; and where an organization gives
// the Jacobian in the same pass, the sums of the derivatives {u, t, s}, else 0. It is asked for by
// places of derivatives on all three axes. With it the sum of a second vertex, else 0.
output wire                                            result_valid_o,
output wire [3*`FFD_SUM_W(FORMAT)-1:0]                 result_sum_o,
output wire [9*`FFD_SUM_W(FORMAT)-1:0]                 result_jacobian_o,
output wire [3*`FFD_SUM_W(FORMAT)-1:0]                 result_second_o
