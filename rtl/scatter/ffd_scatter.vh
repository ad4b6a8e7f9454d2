// Widths and latencies that the parts of scatter share (docs/numerics.md section 11).
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_SCATTER_VH
`define FFD_SCATTER_VH

`include "ffd_num.vh"
`include "ffd_eval.vh"
`include "ffd_stream.vh"

// A sum, and what memory has of it: {epoch, sum}.
`define FFD_SCATTER_SUM_W  `FFD_WIDE_W
`define FFD_SCATTER_WORD_W 36

// Of an index of a point along an axis, the bits above its bank: its place in the bank.
`define FFD_SCATTER_HIGH_W(AXIS) ((AXIS) > 8 ? `FFD_AXIS_W(AXIS) - 2 : 1)

// Registers of a conversion between kinds of number, in front of a weight.
`define FFD_SCATTER_CONVERT_LATENCY 1

// Clocks from the coordinate of an axis, evaluated and cumulated, to its weights, and a clock more
// where the axis is chosen.
`define FFD_SCATTER_OWN_WEIGHTS_LATENCY(EVALUATOR, MUL_LATENCY, ADD_LATENCY) \
  (2 * (ADD_LATENCY) + `FFD_POLY_LATENCY(EVALUATOR, \
  `FFD_FILE_LATENCY(`FFD_SCHEDULE_OVERLAPPED, EVALUATOR), \
  `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, 0), `FFD_SCATTER_CONVERT_LATENCY))
`define FFD_SCATTER_WEIGHTS_LATENCY(EVALUATOR, MUL_LATENCY, ADD_LATENCY) \
  (1 + `FFD_SCATTER_OWN_WEIGHTS_LATENCY(EVALUATOR, MUL_LATENCY, ADD_LATENCY))

// Clocks from a part to the four that it is expanded into: multiplied, rounded, subtracted. Of a
// wide one two partial products are added first, and rounding and saturating take a clock each.
`define FFD_SCATTER_SHARE_LATENCY(WIDE, MUL_LATENCY, ADD_LATENCY) \
  ((MUL_LATENCY) + ((WIDE) == 0 ? 1 : 3) * (ADD_LATENCY))
`define FFD_SCATTER_LESS_LATENCY(WIDE, ADD_LATENCY) (((WIDE) == 0 ? 1 : 2) * (ADD_LATENCY))
`define FFD_SCATTER_EXPAND_LATENCY(WIDE, MUL_LATENCY, ADD_LATENCY) \
  (`FFD_SCATTER_SHARE_LATENCY(WIDE, MUL_LATENCY, ADD_LATENCY) \
   + `FFD_SCATTER_LESS_LATENCY(WIDE, ADD_LATENCY))

// Axes along which what has a slot is expanded, s, t and u of a vertex, t and u of a layer.
`define FFD_SCATTER_AXES(ROWS) ((ROWS) == 0 ? 3 : 2)

// Clocks from a vertex, or with ROWS from a layer, to where it has added: its steps begin in the
// next clock, the last component is two clocks behind, and what comes of it is in memory two clocks
// after its parts.
`define FFD_SCATTER_ADDED_LATENCY(ROWS, EVALUATOR, MUL_LATENCY, ADD_LATENCY) \
  (`FFD_SCATTER_WEIGHTS_LATENCY(EVALUATOR, MUL_LATENCY, ADD_LATENCY) + 5 \
   + `FFD_SCATTER_AXES(ROWS) * `FFD_SCATTER_EXPAND_LATENCY(ROWS, MUL_LATENCY, ADD_LATENCY))

// Rows that are under way at once, at most, and layers of each bank.
`define FFD_SCATTER_ROWS_INSIDE 16

// Vertices, or with ROWS rows, in the datapath at most, one every three clocks; and of all that are
// inside those that do not wait: so many, and 8 in the registers in front. 64 are room for the
// latencies of the table.
`define FFD_SCATTER_MOST(ROWS, EVALUATOR, MUL_LATENCY, ADD_LATENCY) \
  (`FFD_SCATTER_ADDED_LATENCY(ROWS, EVALUATOR, MUL_LATENCY, ADD_LATENCY) / 3 + 2 \
   + ((ROWS) == 0 ? 0 : `FFD_SCATTER_ROWS_INSIDE + 3))
`define FFD_SCATTER_MOVING(ROWS, EVALUATOR, MUL_LATENCY, ADD_LATENCY) \
  (`FFD_SCATTER_MOST(ROWS, EVALUATOR, MUL_LATENCY, ADD_LATENCY) > 56 \
   ? `FFD_SCATTER_MOST(ROWS, EVALUATOR, MUL_LATENCY, ADD_LATENCY) + 8 : 64)

// Clocks from the slot of a point to its words as ffd_scatter_sums reads them.
`define FFD_SCATTER_READ_LATENCY 6

`endif
