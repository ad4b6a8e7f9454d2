// Latencies and widths that the evaluator's parts and the organizations share.
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_EVAL_VH
`define FFD_EVAL_VH

`include "ffd_organizations.vh"

`define FFD_SCHEDULE_OVERLAPPED 0
`define FFD_SCHEDULE_PAPER      1

`define FFD_EVALUATOR_PIPELINED 0
`define FFD_EVALUATOR_ITERATIVE 1
`define FFD_EVALUATOR_POWERS    3

// Clocks around the loop of the iterative evaluator: one step, and one more where the second or
// third pass would otherwise meet a polynomial that started FFD_POLY_INTERVAL clocks later, or a
// multiple of them.
`define FFD_LOOP_LATENCY(STEP_LATENCY) \
  ((STEP_LATENCY) % 3 == 0 ? (STEP_LATENCY) + 1 : (STEP_LATENCY))

// Clocks of reading a coefficient: the paper's schedule has none to spare; the iterative evaluator
// chooses behind the memory; from powers, none is read.
`define FFD_FILE_LATENCY(SCHEDULE, EVALUATOR) \
  ((SCHEDULE) == `FFD_SCHEDULE_PAPER || (EVALUATOR) == `FFD_EVALUATOR_POWERS ? 0 : \
  (EVALUATOR) == `FFD_EVALUATOR_ITERATIVE ? 2 : 1)

// A folded organization takes three components in turn, or two or four parts of the points, or
// components of halves. With three steps or more, one set of evaluators takes the axes in turn.
`define FFD_FOLD_TURNS(FOLD) ((FOLD) % 3 == 0 ? 3 : 1)
`define FFD_FOLD_PARTS(FOLD) ((FOLD) % 4 == 0 ? 4 : (FOLD) % 2 == 0 ? 2 : 1)
`define FFD_FOLD_SETS(FOLD)  ((FOLD) < 3 ? 3 : 1)
// 1: an organization that reads the points of a vertex in one of three clocks has them in half as
// many banks of two rows, and reads them in two.
`define FFD_READ_HALVES(FOLD, N) ((FOLD) == 3 && (N) == 32 ? 1 : 0)
`define FFD_FOLD_BAD(FOLD) \
  ((FOLD) > 6 || (FOLD) != `FFD_FOLD_TURNS(FOLD) * `FFD_FOLD_PARTS(FOLD))

// Clocks of choosing an axis in front of evaluators that take the axes in turn.
`define FFD_CHOICE_LATENCY(FOLD) (`FFD_FOLD_SETS(FOLD) == 1 ? 1 : 0)

// Clocks from a coordinate to its weight: reading the file, three steps and the shift back, or from
// powers two steps, a third of sums, and the choice of banks.
`define FFD_POLY_LATENCY(EVALUATOR, FILE_LATENCY, STEP_LATENCY, CONVERT_LATENCY) \
  ((FILE_LATENCY) + (CONVERT_LATENCY) + \
  3 * ((EVALUATOR) == 1 ? `FFD_LOOP_LATENCY(STEP_LATENCY) : (STEP_LATENCY)))

// Clocks between polynomials of one evaluator in the overlapped schedule: each uses the loop of an
// iterative one three times. The paper's schedule waits until the one before has ended.
`define FFD_POLY_INTERVAL(EVALUATOR) ((EVALUATOR) == 1 ? 3 : 1)

// Registers of a sum of N terms: the terms, then log2(N) levels of adders; fused, the odd term of
// each pair is added as it is multiplied, and a single one where it is accumulated.
`define FFD_TREE_LATENCY(N, MUL_LATENCY, ADD_LATENCY, FMA_LATENCY) \
  ((FMA_LATENCY) == 0 ? (MUL_LATENCY) + $clog2(N) * (ADD_LATENCY) : (N) == 1 ? 0 : \
  (MUL_LATENCY) + (FMA_LATENCY) + ($clog2(N) - 1) * (ADD_LATENCY))

// Registers of the accumulator behind it; there is none where all 64 terms are one sum.
`define FFD_ACCUMULATE_LATENCY(N, ADD_LATENCY, FMA_LATENCY) \
  ((N) == 64 ? 0 : (N) == 1 && (FMA_LATENCY) > 0 ? (FMA_LATENCY) : (ADD_LATENCY))

// Registers from the points of a contraction to their weights: an affine one subtracts first.
`define FFD_OFFSET_LATENCY(AFFINE, ADD_LATENCY) ((AFFINE) == 0 ? 0 : (ADD_LATENCY))

// Registers from the points of one contraction to those of the next: a sum of four, narrowed.
`define FFD_CONTRACT_LATENCY(AFFINE, MUL_LATENCY, ADD_LATENCY, FMA_LATENCY, CONVERT_LATENCY) \
  (`FFD_OFFSET_LATENCY(AFFINE, ADD_LATENCY) + (CONVERT_LATENCY) \
   + `FFD_TREE_LATENCY(4, MUL_LATENCY, ADD_LATENCY, FMA_LATENCY))

// Sums of a vertex in one pass: its position, or with the Jacobian that and three derivatives.
`define FFD_RESULTS(JACOBIAN) ((JACOBIAN) == 0 ? 1 : 4)

// Steps that an accumulator of that latency leaves idle unless CONTEXTS vertices take turns.
`define FFD_CONTEXTS(LATENCY, INTERVAL) \
  ((LATENCY) <= (INTERVAL) ? 1 : ((LATENCY) + (INTERVAL) - 1) / (INTERVAL))

// Evaluators of each axis that the N combinations of one step need, u varying fastest.
`define FFD_UNITS_S(N) ((N) >= 64 ? 4 : (N) == 32 ? 2 : 1)
`define FFD_UNITS_T(N) ((N) >= 16 ? 4 : (N) == 8 ? 2 : 1)
`define FFD_UNITS_U(N) ((N) >= 4 ? 4 : (N))

// Clocks a vertex takes: an organization that takes its points in turn, N in a clock, has others in
// between. While vertices take turns (FFD_CONTEXTS), two results may come closer, by less than the
// accumulator's latency. Wants ffd_organizations.vh.
`define FFD_RESULT_INTERVAL(ORG, N) (`FFD_ORG_IN_TURN(ORG) ? 64 / (N) : 1)

// Whether functions that are loaded must sum to one: the organization wants it, and it evaluates
// what is loaded.
`define FFD_FUNCTIONS_SUM(ORG, EVALUATOR) \
  (`FFD_ORG_AFFINE(ORG) && (EVALUATOR) != `FFD_EVALUATOR_POWERS)

// Evaluations inside, and places for their results: MOST, or with 0 what an organization needs to
// keep its rate. Pipelines are some 100 clocks long, and at long intervals ten vertices take turns.
`define FFD_IN_FLIGHT(MOST, ORG, N) \
  ((MOST) != 0 ? (MOST) : `FFD_RESULT_INTERVAL(ORG, N) >= 16 ? 16 : 128)

// Clocks from the third column of a Jacobian to its determinant: columns and cofactor narrowed,
// three steps, a product, a sum of three.
`define FFD_DETERMINANT_LATENCY(FORMAT, MUL_LATENCY, ADD_LATENCY, CONVERT_LATENCY) \
  (2 * `FFD_NARROW_LATENCY(FORMAT, CONVERT_LATENCY) \
   + `FFD_OUT_LATENCY(FORMAT, CONVERT_LATENCY) + 2 * (MUL_LATENCY) + 3 * (ADD_LATENCY) + 2)

// Where an axis has its functions, an address of them: {derivative, bank}, or with spans {uniform,
// span, derivative, bank}, where uniform functions are those of opcode 1, whatever the span. A file
// of all axes has the uniform functions where a fourth axis would be, so span holds an axis.
`define FFD_SPAN_W(SPANS)   ((SPANS) > 4 ? $clog2(SPANS) : 2)
`define FFD_PLACE_W(SPANS)  ((SPANS) == 1 ? 2 : 3 + `FFD_SPAN_W(SPANS))
`define FFD_OWN_W(SPANS)    (`FFD_PLACE_W(SPANS) + 2)
`define FFD_SHARED_W(SPANS) ((SPANS) == 1 ? 6 : 6 + `FFD_SPAN_W(SPANS))
// Of the three axes as the decoder gives them, without derivatives: a bank for all, or with spans
// {uniform, span, bank} of each.
`define FFD_PLACES_W(SPANS) ((SPANS) == 1 ? 1 : 3 * (2 + `FFD_SPAN_W(SPANS)))

// One blending function in the coefficient file: {shift, coefficients of x^3, x^2, x, 1}.
`define FFD_ENTRY_W(WEIGHT_W) (4 * (WEIGHT_W) + 2)

`endif
