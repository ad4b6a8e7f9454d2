// ffd_num_in: a word of the stream becomes a coordinate, a coefficient or a point
//
// Formats:    fp32: the word is the number. fxW, by ROLE (docs/interface.md section 3):
//               coordinate   unsigned Q1.31, 0x80000000 = 1.0  ->  Q2.(W-2); above 1.0 it is
//                            clamped to 1.0 and flagged
//               coefficient  Q2.30 (already times 2^-shift)    ->  Q2.(W-2)
//               point        Q1.31                             ->  Q1.(W-1)
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

  generate
    if (FORMAT == `FFD_FORMAT_FP32) begin : gen_float
      assign number_o = word_i;
    end else if (ROLE == `FFD_ROLE_COORDINATE) begin : gen_coordinate
      wire        above = word_i > 32'h8000_0000;
      wire [32:0] word  = {1'b0, above ? 32'h8000_0000 : word_i};
      wire        saturated;
      ffd_fx_round #(
        .IN_W (33),
        .DROP (33 - FORMAT),
        .OUT_W(FORMAT)
      ) u_round (
        .value_i    (word),
        .addend_i   ({FORMAT{1'b0}}),
        .value_o    (number_o[FORMAT-1:0]),
        .saturated_o(saturated)
      );
      assign number_o[FORMAT] = above | saturated;
    end else begin : gen_signed
      ffd_fx_round #(
        .IN_W (32),
        .DROP (32 - FORMAT),
        .OUT_W(FORMAT)
      ) u_round (
        .value_i    (word_i),
        .addend_i   ({FORMAT{1'b0}}),
        .value_o    (number_o[FORMAT-1:0]),
        .saturated_o(number_o[FORMAT])
      );
    end
  endgenerate
endmodule

`default_nettype wire
