// ffd_num_coordinate: a coordinate in [0, 2) becomes its stream word
//
// Formats:    unsigned Q1.24 in; out the word of docs/interface.md section 3. Exact in every
//             format, but in fixed point, where no word is 3/2 or more, all those are the largest.
// Not checked: bit 0 where the coordinate is 1 or more, which binary32 would have to round, is
//             taken for 0.
// Pipeline:   combinational.
// Parameters: FORMAT as in ffd_num.vh.
// Model:      golden/include/hwffd/stream/word_codec.hpp.  Test: tests/system/grid_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_coordinate #(
  parameter FORMAT = 18
) (
  input  wire [24:0] coordinate_i,
  output wire [31:0] word_o
);
  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_coordinate_format_is_unknown u_error ();
    end
  endgenerate

  generate
    if (FORMAT == `FFD_FORMAT_FP32 || `FFD_FORMAT_BLOCK(FORMAT)) begin : gen_float
      wire [4:0]  zeros;
      wire        none;
      wire [24:0] normal;
      ffd_fp_lzc #(
        .WIDTH(25)
      ) u_zeros (
        .x_i    (coordinate_i),
        .count_o(zeros),
        .none_o (none)
      );
      ffd_fp_shift_left #(
        .WIDTH   (25),
        .AMOUNT_W(5)
      ) u_normal (
        .x_i     (coordinate_i),
        .amount_i(zeros),
        .y_o     (normal)
      );
      assign word_o = {1'b0, 8'd127 - {3'd0, zeros}, normal[23:1]} & {32{!none}};
      wire unused_ok = &{1'b0, normal[24], normal[0]};
    end else begin : gen_fixed
      wire beyond = &coordinate_i[24:23];
      assign word_o = beyond ? 32'hBFFF_FFFF : {coordinate_i, 7'd0};
    end
  endgenerate
endmodule

`default_nettype wire
