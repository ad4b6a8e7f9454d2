// ffd_num_half: a word of the stream becomes one of 20 bits, for results of two vertices a beat
//
// Formats:    fxW: Q1.31 -> Q1.19, half up; saturated_o where that would be 1. Others are refused.
// Pipeline:   combinational.
// Parameters: FORMAT as in ffd_num.vh, of fixed point.
// Model:      golden/include/hwffd/stream/halves.hpp.  Test: tests/system/halves_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_half #(
  parameter FORMAT = 18
) (
  input  wire [31:0] word_i,
  output wire [19:0] half_o,
  output wire        saturated_o
);
  generate
    if (`FFD_OFFSET_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_half_needs_fixed_point u_error ();
    end
  endgenerate

  localparam [19:0] MOST = 20'h7_FFFF;
  wire [19:0] whole = word_i[31:12];
  assign saturated_o = whole == MOST && word_i[11];
  assign half_o      = saturated_o ? MOST : whole + {19'd0, word_i[11]};
  wire unused_ok = &{1'b0, word_i[10:0]};
endmodule

`default_nettype wire
