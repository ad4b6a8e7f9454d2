// The number formats: widths, latencies and constants of the number layer (docs/numerics.md).
//
// FORMAT is 0 for binary32 (fp32), the operand width W = 8 to 32 for fixed point (fxW), and 64 + W,
// W = 8 to 35, for block floating point (bfp32 is W = 35): stream words in binary32, points times
// 2^-exponent in fixed point. A format fixes three kinds of number, and no module outside number/
// looks inside them:
//
//   kind                                   fp32       fxW and block, flags in front
//   weight (coordinate, coefficient too)   32 bits    1 + W,          Q2.(W-2)
//   point                                  32 bits    F + W,          Q1.(W-1)
//   sum                                    32 bits    F + 2W+6,       Q9.(2W-3): 64 exact products
//
// Flags are part of a number: each operation ORs those of its operands, so a result that any
// saturation touched says so, and no organization carries a flag of its own. In fixed point F is 1,
// {saturated}. In block floating point it is 3, {minus, plus, saturated}: a number with plus is an
// infinity, with minus one below 0, with both a NaN, whatever its value; so OR adds these too.
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_NUM_VH
`define FFD_NUM_VH

`define FFD_FORMAT_FP32 0
`define FFD_FORMAT_BLOCK(FORMAT) ((FORMAT) > 64)
`define FFD_FORMAT_BAD(FORMAT) \
  ((FORMAT) != 0 && ((FORMAT) < 8 || (FORMAT) > 32) && ((FORMAT) < 72 || (FORMAT) > 99))

// W and F, where the format is not binary32.
`define FFD_FIXED_W(FORMAT) (`FFD_FORMAT_BLOCK(FORMAT) ? (FORMAT) - 64 : (FORMAT))
`define FFD_FLAGS_W(FORMAT) (`FFD_FORMAT_BLOCK(FORMAT) ? 3 : 1)

`define FFD_WEIGHT_W(FORMAT) ((FORMAT) == 0 ? 32 : `FFD_FIXED_W(FORMAT) + 1)
`define FFD_POINT_W(FORMAT)  ((FORMAT) == 0 ? 32 : `FFD_FIXED_W(FORMAT) + `FFD_FLAGS_W(FORMAT))
`define FFD_SUM_W(FORMAT) \
  ((FORMAT) == 0 ? 32 : 2 * `FFD_FIXED_W(FORMAT) + 6 + `FFD_FLAGS_W(FORMAT))

// From one point to another, a bit more than a point; in fixed point only, where it is exact.
`define FFD_OFFSET_W(FORMAT)   (`FFD_FIXED_W(FORMAT) + 2)
`define FFD_OFFSET_BAD(FORMAT) ((FORMAT) < 8 || (FORMAT) > 32)

// Of what a gradient is expanded into, as wide as an offset without its flag; in fixed point of 12
// to 18 bits only.
`define FFD_PART_W(FORMAT)   (`FFD_FIXED_W(FORMAT) + 1)
`define FFD_PART_BAD(FORMAT) ((FORMAT) < 12 || (FORMAT) > 18)

// Of a sum of parts, and of what it is expanded into: in the units of a part.
`define FFD_WIDE_W 35

// The exponent of a block: signed; points below 2^exponent fit. Other formats ignore it.
`define FFD_EXPONENT_W 10

// Registers of ffd_num_out and of ffd_num_narrow where it stands behind a sum: in fixed point
// rounding and saturation of so many bits want one each, and a block's word is made in six steps.
`define FFD_OUT_LATENCY(FORMAT, CONVERT_LATENCY) \
  ((CONVERT_LATENCY) == 0 || (FORMAT) == 0 ? (CONVERT_LATENCY) : (CONVERT_LATENCY) \
   + (`FFD_FORMAT_BLOCK(FORMAT) ? 3 : 1))
`define FFD_NARROW_LATENCY(FORMAT, CONVERT_LATENCY) \
  ((CONVERT_LATENCY) == 0 || (FORMAT) == 0 || `FFD_FORMAT_BLOCK(FORMAT) ? (CONVERT_LATENCY) \
                                                                       : (CONVERT_LATENCY) + 1)

// Roles of ffd_num_in, and the registers that the core gives it.
`define FFD_ROLE_COORDINATE  2'd0
`define FFD_ROLE_COEFFICIENT 2'd1
`define FFD_ROLE_POINT       2'd2
`define FFD_IN_LATENCY(FORMAT) \
  ((FORMAT) == `FFD_FORMAT_FP32 ? 1 : `FFD_FORMAT_BLOCK(FORMAT) ? 4 : 2)

// A multiplication and the addition behind it: two units, or one fused unit of FMA_LATENCY clocks
// where that is not 0 (binary32 only: in fixed point the bits would be the same). With the 0 it has
// 32 bits: a latency that is given as 3'd4 has three.
`define FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY) \
  ((FMA_LATENCY) > 0 ? (FMA_LATENCY) : 0 + (MUL_LATENCY) + (ADD_LATENCY))

// Registers behind step STEP of a float unit of STEPS steps, LATENCY in all (ffd_fp_stage).
`define FFD_FP_REGISTERS(LATENCY, STEPS, STEP) \
  (((STEP) + 1) * (LATENCY) / (STEPS) - (STEP) * (LATENCY) / (STEPS))

`define FFD_FMA_BAD(FORMAT, FMA_LATENCY) ((FMA_LATENCY) < 0 || ((FMA_LATENCY) > 0 && (FORMAT) != 0))

// The stream word of a coordinate that could not be computed: canonical NaN, or 0.
`define FFD_BLANK_WORD(FORMAT) \
  ((FORMAT) == 0 || `FFD_FORMAT_BLOCK(FORMAT) ? 32'h7FC0_0000 : 32'h0000_0000)
`define FFD_BLANK_IS_ZERO(FORMAT) (`FFD_BLANK_WORD(FORMAT) == 32'd0)

// The stream word of the coordinate 1.
`define FFD_ONE_WORD(FORMAT) \
  ((FORMAT) == 0 || `FFD_FORMAT_BLOCK(FORMAT) ? 32'h3F80_0000 : 32'h8000_0000)

`endif
