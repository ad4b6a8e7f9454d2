// Widths and latencies that the parts of scatter share (docs/numerics.md section 11).
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_SCATTER_VH
`define FFD_SCATTER_VH

`include "ffd_num.vh"
`include "ffd_eval.vh"
`include "ffd_stream.vh"

// A sum, and what memory has of it: {epoch, sum}.
`define FFD_SCATTER_SUM_W  35
`define FFD_SCATTER_WORD_W 36

// Of an index of a point along an axis, the bits above its bank: its place in the bank.
`define FFD_SCATTER_HIGH_W(AXIS) ((AXIS) > 8 ? `FFD_AXIS_W(AXIS) - 2 : 1)

// Registers of a conversion between kinds of number, in front of a weight.
`define FFD_SCATTER_CONVERT_LATENCY 1

// Clocks from the coordinate of an axis, chosen, evaluated and cumulated, to its weights; and from
// a part to the four that it is expanded into: multiplied, rounded, subtracted.
`define FFD_SCATTER_WEIGHTS_LATENCY(EVALUATOR, MUL_LATENCY, ADD_LATENCY) \
  (1 + 2 * (ADD_LATENCY) + `FFD_POLY_LATENCY(EVALUATOR, \
  `FFD_FILE_LATENCY(`FFD_SCHEDULE_OVERLAPPED, EVALUATOR), \
  `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, 0), `FFD_SCATTER_CONVERT_LATENCY))
`define FFD_SCATTER_EXPAND_LATENCY(MUL_LATENCY, ADD_LATENCY) ((MUL_LATENCY) + 2 * (ADD_LATENCY))

// Clocks from a vertex to where it has added: its steps begin in the next clock, the last component
// is two clocks behind, and what comes of it is in memory two clocks after its parts.
`define FFD_SCATTER_ADDED_LATENCY(EVALUATOR, MUL_LATENCY, ADD_LATENCY) \
  (`FFD_SCATTER_WEIGHTS_LATENCY(EVALUATOR, MUL_LATENCY, ADD_LATENCY) \
   + 3 * `FFD_SCATTER_EXPAND_LATENCY(MUL_LATENCY, ADD_LATENCY) + 5)

// Clocks from the slot of a point to its words as ffd_scatter_sums reads them.
`define FFD_SCATTER_READ_LATENCY 5

`endif
