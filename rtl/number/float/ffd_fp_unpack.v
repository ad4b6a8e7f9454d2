// ffd_fp_unpack: a floating-point word into its parts
//
//   value = (-1)^sign * significand * 2^(exponent - BIAS - (SIG_W - 1)),  BIAS = 2^(EXP_W-1) - 1
//
// IEEE-754 interchange format {sign, EXP_W, SIG_W - 1}. The hidden bit is put in front of the
// fraction; a subnormal is not normalised: its hidden bit is 0 and its exponent reads 1, so that
// the formula holds for every finite word. Exact.
//
// Pipeline:   none, combinational.
// Unchecked:  for an infinity or a NaN, exponent and significand are what the formula makes of
//             them: the user looks at infinite_o and nan_o.
// Parameters: 3 <= EXP_W <= 11; 3 <= SIG_W <= 53 (width with the hidden bit); SIG_W + 4 <= 2^EXP_W,
//             so that a shift over a significand with its guard bits fits an exponent. Guarded
//             here for every unit of the family.
// Test:       tests/unit/float/float_test.cpp, through the units.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_fp_unpack #(
  parameter EXP_W = 8,
  parameter SIG_W = 24
) (
  input  wire [EXP_W+SIG_W-1:0] word_i,
  output wire                   sign_o,
  output wire [EXP_W-1:0]       exponent_o,
  output wire [SIG_W-1:0]       significand_o,
  output wire                   zero_o,
  output wire                   infinite_o,
  output wire                   nan_o
);
  generate
    if (EXP_W < 3 || EXP_W > 11) begin : gen_bad_exp_w
      ERROR_ffd_fp_unpack_exp_w_must_be_3_to_11 u_error ();
    end
    if (SIG_W < 3 || SIG_W > 53) begin : gen_bad_sig_w
      ERROR_ffd_fp_unpack_sig_w_must_be_3_to_53 u_error ();
    end
    if (SIG_W + 4 > (1 << EXP_W)) begin : gen_bad_format
      ERROR_ffd_fp_unpack_sig_w_must_not_exceed_2_to_the_exp_w_less_4 u_error ();
    end
  endgenerate

  wire [EXP_W-1:0] field         = word_i[SIG_W-1 +: EXP_W];
  wire [SIG_W-2:0] fraction      = word_i[SIG_W-2:0];
  wire             hidden        = |field;
  wire             maximal       = &field;
  wire             fraction_zero = ~|fraction;

  assign sign_o        = word_i[EXP_W+SIG_W-1];
  assign exponent_o    = {field[EXP_W-1:1], field[0] | ~hidden};
  assign significand_o = {hidden, fraction};
  assign zero_o        = ~hidden & fraction_zero;
  assign infinite_o    = maximal & fraction_zero;
  assign nan_o         = maximal & ~fraction_zero;
endmodule

`default_nettype wire
