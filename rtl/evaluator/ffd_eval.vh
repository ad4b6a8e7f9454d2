// Latencies and widths that the evaluator's parts and the organizations share.
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_EVAL_VH
`define FFD_EVAL_VH

`define FFD_SCHEDULE_OVERLAPPED 0
`define FFD_SCHEDULE_PAPER      1

`define FFD_EVALUATOR_PIPELINED 0
`define FFD_EVALUATOR_ITERATIVE 1

// Clocks around the loop of the iterative evaluator: one step, and one more where three passes
// would otherwise meet a polynomial that started 6 or 12 clocks later.
`define FFD_LOOP_LATENCY(STEP_LATENCY) \
  ((STEP_LATENCY) % 3 == 0 ? (STEP_LATENCY) + 1 : (STEP_LATENCY))

// Clocks from a coordinate to its weight: three steps and the shift back.
`define FFD_POLY_LATENCY(EVALUATOR, STEP_LATENCY, CONVERT_LATENCY) \
  (3 * ((EVALUATOR) == 1 ? `FFD_LOOP_LATENCY(STEP_LATENCY) : (STEP_LATENCY)) + (CONVERT_LATENCY))

// Clocks between polynomials of one evaluator.
`define FFD_POLY_INTERVAL(EVALUATOR) ((EVALUATOR) == 1 ? 6 : 1)

// One blending function in the coefficient file: {shift, coefficients of x^3, x^2, x, 1}.
`define FFD_ENTRY_W(WEIGHT_W) (4 * (WEIGHT_W) + 2)

`endif
