// ffd_stream_encoder: a result becomes a beat {status, tag, z, y, x}
//
// Status bits (docs/interface.md section 4): 0 saturated, 2 NaN, 4 truncated, 5 unloaded; the rest
// is 0. A truncated or unloaded vertex gives blank coordinates (canonical NaN, or 0 in fixed
// point), never what the datapath made of half a vertex.
//
// Pipeline:   combinational, between the result queue and the output's skid buffer.
// Parameters: FORMAT as in ffd_num.vh.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_stream_encoder #(
  parameter FORMAT = 18
) (
  input  wire [95:0]  words_i,
  input  wire [1:0]   flags_i,
  input  wire [17:0]  user_i,
  output wire [127:0] beat_o
);
  wire [15:0] tag       = user_i[15:0];
  wire        truncated = user_i[16];
  wire        unloaded  = user_i[17];
  wire        blank     = truncated || unloaded;
  wire        saturated = flags_i[0] && !blank;
  wire        nan       = flags_i[1] && !blank;

  assign beat_o = {10'd0, unloaded, truncated, 1'b0, nan, 1'b0, saturated, tag,
                   blank ? {3{`FFD_BLANK_WORD(FORMAT)}} : words_i};
endmodule

`default_nettype wire
