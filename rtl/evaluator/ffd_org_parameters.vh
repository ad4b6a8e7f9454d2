// Parameters of every organization behind FORMAT, N and PORTS, with their defaults
// (docs/architecture.md section 3). To be included in the list of a module's parameters.
// SPDX-License-Identifier: Apache-2.0

// 0: a step begins as soon as the units are free; 1: when the one before has ended (the paper's).
parameter SCHEDULE        = `FFD_SCHEDULE_OVERLAPPED,
// Of polynomials: 0 pipelined, 1 iterative, 3 all four of the B-spline from powers (factored,
// affine).
parameter EVALUATOR       = `FFD_EVALUATOR_PIPELINED,
// Clocks of a multiplication and of an addition.
parameter MUL_LATENCY     = 2,
parameter ADD_LATENCY     = 1,
// Clocks of a fused multiply-add in place of both, binary32 only; 0: there is none.
parameter FMA_LATENCY     = 0,
// Clocks of a conversion between kinds of number.
parameter CONVERT_LATENCY = 1,
// Clocks from a read to its points.
parameter READ_LATENCY    = 2,
// Bits that say where the points of a vertex are; they go from the vertex to its reads.
parameter SOURCE_W        = 2,
// Runs of cells along an axis with blending functions of their own; 1: all cells have the same.
parameter SPANS           = 1
