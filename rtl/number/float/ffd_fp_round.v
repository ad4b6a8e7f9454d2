// ffd_fp_round: rounds an exact significand with guard and sticky bit and packs the word
//
//   magnitude = {exponent, 0} + significand + (guard and (sticky or odd)),   result = {sign, it}
//
// Round to nearest, ties to even. exponent_i is one less than the field of a normal number and 0
// for a subnormal: the hidden bit adds the one. Because exponent and fraction are one integer, the
// step from subnormal to normal, the carry into the next binade and the overflow of the largest
// finite number to infinity all fall out of that sum. A NaN is always {0, all ones, 1, 0...}; a
// zero is always +0.
//
// Pipeline:   none, combinational.
// Unchecked:  exponent_i plus the hidden bit must stay below the all-ones field unless infinite_i
//             or nan_i is set: an overflow before rounding is the user's to find.
// Parameters: EXP_W, SIG_W as in ffd_fp_unpack, which guards them.
// Test:       tests/unit/float/float_test.cpp, through the units.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_fp_round #(
  parameter EXP_W = 8,
  parameter SIG_W = 24
) (
  input  wire                   sign_i,
  input  wire [EXP_W-1:0]       exponent_i,
  input  wire [SIG_W-1:0]       significand_i,
  input  wire                   guard_i,
  input  wire                   sticky_i,
  input  wire                   infinite_i,
  input  wire                   nan_i,
  output wire [EXP_W+SIG_W-1:0] result_o
);
  localparam MAG_W = EXP_W + SIG_W - 1;  // the word without its sign

  wire             special  = infinite_i | nan_i;
  wire [EXP_W-1:0] exponent = exponent_i | {EXP_W{special}};
  wire             hidden   = significand_i[SIG_W-1] & ~special;
  wire [SIG_W-2:0] fraction = special ? {nan_i, {(SIG_W-2){1'b0}}} : significand_i[SIG_W-2:0];
  wire             up       = guard_i & (sticky_i | significand_i[0]) & ~special;

  // The hidden bit and the increment never meet: one carry chain adds both.
  wire [MAG_W-1:0] truncated = {exponent, fraction};
  wire [MAG_W-1:0] additions = {{(EXP_W-1){1'b0}}, hidden, {(SIG_W-2){1'b0}}, up};
  wire             nonzero   = (|truncated) | hidden | up;

  assign result_o = {sign_i & nonzero & ~nan_i, truncated + additions};
endmodule

`default_nettype wire
