// ffd_stream_encoder: a result becomes a beat {status, tag, z, y, x}
//
// Status bits (docs/interface.md section 4): 0 saturated, 1 clamped, 2 NaN, 3 outside, 4 truncated,
// 5 unloaded, 6 folded: det J, which is the word x of its result, is not positive; the rest is 0. A
// blank vertex gives blank coordinates (canonical NaN, or 0 in fixed
// point), never what the datapath made of half a vertex.
//
// Pipeline:   combinational, between the result queue and the output's skid buffer.
// Parameters: FORMAT as in ffd_num.vh.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_stream.vh"

module ffd_stream_encoder #(
  parameter FORMAT = 18
) (
  input  wire [95:0]  words_i,
  input  wire [1:0]   flags_i,
  input  wire         determinant_i,
  input  wire [`FFD_USER_RESULT] user_i,
  output wire [127:0] beat_o
);
  wire       blank = user_i[`FFD_USER_BLANK];
  wire       nan   = flags_i[1] && !blank;
  wire       full  = flags_i[0] && !blank;
  wire [5:0] found = {3'd0, nan, 1'b0, full};

  // The words of both kinds of format have their sign in front, and only one for zero.
  wire       folded = determinant_i && !blank && (words_i[31] || words_i[31:0] == 32'd0);

  assign beat_o = {9'd0, folded, user_i[`FFD_USER_STATUS] | found, user_i[`FFD_USER_TAG],
                   blank ? {3{`FFD_BLANK_WORD(FORMAT)}} : words_i};
endmodule

`default_nettype wire
