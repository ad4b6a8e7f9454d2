// The number formats: widths, latencies and constants of the number layer (docs/numerics.md).
//
// FORMAT is 0 for binary32 (fp32) and the operand width W = 8 to 32 for fixed point (fxW).
// A format fixes three kinds of number, and no module outside number/ looks inside them:
//
//   kind                                   fp32       fxW (leading bit: saturated)
//   weight (coordinate, coefficient too)   32 bits    1 + W,      Q2.(W-2)
//   point                                  32 bits    1 + W,      Q1.(W-1)
//   sum                                    32 bits    1 + 2W+6,   Q9.(2W-3): 64 exact products
//
// Weight and point are equally wide, so that a word of one can be taken for the other, at half or
// twice its value in fixed point: the nested form does.
//
// The saturated flag is part of a number: each operation ORs those of its operands, so a result
// that any saturation touched says so, and no organization carries a flag of its own.
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_NUM_VH
`define FFD_NUM_VH

`define FFD_FORMAT_FP32 0
`define FFD_FORMAT_BAD(FORMAT) ((FORMAT) != 0 && ((FORMAT) < 8 || (FORMAT) > 32))

`define FFD_WEIGHT_W(FORMAT) ((FORMAT) == 0 ? 32 : (FORMAT) + 1)
`define FFD_POINT_W(FORMAT)  ((FORMAT) == 0 ? 32 : (FORMAT) + 1)
`define FFD_SUM_W(FORMAT)    ((FORMAT) == 0 ? 32 : 2 * (FORMAT) + 7)

// Roles of ffd_num_in.
`define FFD_ROLE_COORDINATE  0
`define FFD_ROLE_COEFFICIENT 1
`define FFD_ROLE_POINT       2
`define FFD_IN_W(FORMAT, ROLE) \
  ((ROLE) == 2 ? `FFD_POINT_W(FORMAT) : `FFD_WEIGHT_W(FORMAT))

// A multiplication and the addition behind it: two units, or one fused unit of FMA_LATENCY clocks
// where that is not 0 (binary32 only: in fixed point the bits would be the same).
`define FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY) \
  ((FMA_LATENCY) > 0 ? (FMA_LATENCY) : (MUL_LATENCY) + (ADD_LATENCY))
// Clocks after which a step adds its coefficient.
`define FFD_STEP_JOIN(MUL_LATENCY, FMA_LATENCY) ((FMA_LATENCY) > 0 ? 0 : (MUL_LATENCY))
`define FFD_FMA_BAD(FORMAT, FMA_LATENCY) ((FMA_LATENCY) < 0 || ((FMA_LATENCY) > 0 && (FORMAT) != 0))

// The stream word of a coordinate that could not be computed: canonical NaN, or 0.
`define FFD_BLANK_WORD(FORMAT) ((FORMAT) == 0 ? 32'h7FC0_0000 : 32'h0000_0000)

// The stream word of the coordinate 1.
`define FFD_ONE_WORD(FORMAT) ((FORMAT) == 0 ? 32'h3F80_0000 : 32'h8000_0000)

`endif
