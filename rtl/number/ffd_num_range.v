// ffd_num_range: whether the stream word of a coordinate is a number in [0, 1]
//
// Formats:    stream words (docs/interface.md section 3): binary32 (fp32, block), or units of 2^-31
//             modulo 2^32 from -1/2 on, so that words from 0xC0000000 on are below 0. NaN and the
//             infinities are no numbers (nan_o), -0 is 0. clamped_o is the nearest word in [0, 1];
//             of what is no number it is one of both ends.
// Pipeline:   combinational.
// Parameters: FORMAT as in ffd_num.vh.
// Model:      golden/include/hwffd/numerics (range).  Test: tests/unit/range.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_range #(
  parameter FORMAT = 18
) (
  input  wire [31:0] word_i,
  output wire        nan_o,
  output wire        outside_o,
  output wire [31:0] clamped_o
);
  localparam [31:0] ONE = `FFD_ONE_WORD(FORMAT);

  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_range_format_is_unknown u_error ();
    end
  endgenerate

  wire above;
  wire below;
  generate
    if (FORMAT == `FFD_FORMAT_FP32 || `FFD_FORMAT_BLOCK(FORMAT)) begin : gen_float
      assign nan_o = &word_i[30:23];
      assign above = !word_i[31] && (word_i[30] || (&word_i[29:23] && |word_i[22:0]));
      assign below = word_i[31] && |word_i[30:0];
    end else begin : gen_fixed
      assign nan_o = 1'b0;
      assign above = word_i[31] && |word_i[30:0] && !below;
      assign below = &word_i[31:30];
    end
  endgenerate

  assign outside_o = (above || below) && !nan_o;
  assign clamped_o = above ? ONE : below ? 32'd0 : word_i;
endmodule

`default_nettype wire
