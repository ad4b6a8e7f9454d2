// ffd_num_in: a word of the stream becomes a coordinate, a coefficient or a point
//
// Formats:    fp32: the word is the number. fxW, by ROLE (docs/interface.md section 3):
//               coordinate   unsigned Q1.31, 0x80000000 = 1.0  ->  Q2.(W-2); outside [0, 1] it is
//                            clamped (ffd_num_range) and flagged
//               coefficient  Q2.30 (already times 2^-shift)    ->  Q2.(W-2)
//               point        Q1.31                             ->  Q1.(W-1)
//             Block: coordinates and points are binary32, aligned to 1 and to 2^exponent_i, the
//             exponent of the block; coefficients as in fxW.
// Rounding:   half up; a word that rounds past the largest value saturates and is flagged.
// Pipeline:   combinational.
// Parameters: FORMAT as in ffd_num.vh, ROLE 0 to 2.
// Model:      golden/include/hwffd/numerics (coordinate, coefficient, point).
// Test:       tests/unit/fixed.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_in #(
  parameter FORMAT = 18,
  parameter ROLE   = `FFD_ROLE_POINT
) (
  input  wire [31:0]                         word_i,
  input  wire [`FFD_EXPONENT_W-1:0]          exponent_i,
  output wire [`FFD_IN_W(FORMAT, ROLE)-1:0]  number_o
);
  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_in_format_is_unknown u_error ();
    end
    if (ROLE < 0 || ROLE > 2) begin : gen_bad_role
      ERROR_ffd_num_in_role_is_unknown u_error ();
    end
  endgenerate

  localparam W = `FFD_FIXED_W(FORMAT);

  generate
    if (FORMAT == `FFD_FORMAT_FP32) begin : gen_float
      assign number_o = word_i;
    end else if (ROLE == `FFD_ROLE_COORDINATE) begin : gen_coordinate
      // Into [0, 1] first, so that what is clamped is no infinity.
      wire        nan;
      wire        outside;
      wire [31:0] clamped;
      wire        saturated;
      wire        infinite;
      ffd_num_range #(
        .FORMAT(FORMAT)
      ) u_range (
        .word_i   (word_i),
        .nan_o    (nan),
        .outside_o(outside),
        .clamped_o(clamped)
      );
      if (`FFD_FORMAT_BLOCK(FORMAT)) begin : gen_block
        // Q2.(W-2) is a point's Q1.(W-1) in a block of exponent 1.
        wire plus;
        wire minus;
        ffd_bfp_align #(
          .W(W)
        ) u_align (
          .word_i     (clamped),
          .exponent_i (`FFD_EXPONENT_W'd1),
          .value_o    (number_o[W-1:0]),
          .saturated_o(saturated),
          .plus_o     (plus),
          .minus_o    (minus)
        );
        assign infinite = plus | minus;
      end else begin : gen_fixed
        wire [32:0] word = {1'b0, clamped};
        ffd_fx_round #(
          .IN_W (33),
          .DROP (33 - W),
          .OUT_W(W)
        ) u_round (
          .value_i    (word),
          .addend_i   ({W{1'b0}}),
          .value_o    (number_o[W-1:0]),
          .saturated_o(saturated)
        );
        assign infinite = 1'b0;
      end
      assign number_o[W] = nan | outside | saturated | infinite;
    end else if (`FFD_FORMAT_BLOCK(FORMAT) && ROLE == `FFD_ROLE_POINT) begin : gen_block_point
      ffd_bfp_align #(
        .W(W)
      ) u_align (
        .word_i     (word_i),
        .exponent_i (exponent_i),
        .value_o    (number_o[W-1:0]),
        .saturated_o(number_o[W]),
        .plus_o     (number_o[W+1]),
        .minus_o    (number_o[W+2])
      );
    end else begin : gen_signed
      localparam PAD = W > 32 ? W - 32 : 0;
      wire signed [31+PAD:0] word;
      if (PAD > 0) begin : gen_pad
        assign word = {word_i, {PAD{1'b0}}};
      end else begin : gen_no_pad
        assign word = word_i;
      end
      ffd_fx_round #(
        .IN_W (32 + PAD),
        .DROP (32 + PAD - W),
        .OUT_W(W)
      ) u_round (
        .value_i    (word),
        .addend_i   ({W{1'b0}}),
        .value_o    (number_o[W-1:0]),
        .saturated_o(number_o[W])
      );
    end
  endgenerate

  wire unused_ok = &{1'b0, exponent_i};
endmodule

`default_nettype wire
