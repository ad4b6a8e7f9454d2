// ffd_stream_numbers: the four words of a beat become numbers
//
// All words pass one row of converters, whatever the beat is: a blending function, a vertex or a
// point, which has no fourth word that counts.
//
// Formats:    numbers {w3, w2, w1, w0}, weights or points; beyond_i, of an axis: the cell is
//             beyond the last one, and a coordinate that is clamped becomes 1.
// Pipeline:   LATENCY.
// Parameters: FORMAT as in ffd_num.vh, LATENCY >= 0.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_stream_numbers #(
  parameter FORMAT  = 18,
  parameter LATENCY = 2
) (
  input  wire                              clk,
  input  wire                              function_i,
  input  wire                              vertex_i,
  input  wire [1:0]                        degree_i,  // of the function
  input  wire                              clamp_i,
  input  wire [2:0]                        beyond_i,
  input  wire [127:0]                      data_i,
  input  wire [`FFD_EXPONENT_W-1:0]        exponent_i,
  output wire [4*`FFD_POINT_W(FORMAT)-1:0] numbers_o,
  output wire                              nan_o,     // a coordinate is none
  output wire                              outside_o
);
  localparam POINT_W = `FFD_POINT_W(FORMAT);

  wire [1:0] role = function_i ? `FFD_ROLE_COEFFICIENT
                  : vertex_i   ? `FFD_ROLE_COORDINATE : `FFD_ROLE_POINT;
  wire [3:0] at_end = {1'b0, beyond_i};
  wire [3:0] nan;
  wire [3:0] outside;

  genvar w;
  generate
    for (w = 0; w < 4; w = w + 1) begin : gen_word
      localparam [3:0] ABOVE = (1 << w) - 1;  // the degrees that this power is above
      ffd_num_in #(
        .FORMAT (FORMAT),
        .LATENCY(LATENCY)
      ) u_in (
        .clk       (clk),
        .role_i    (role),
        .clear_i   (function_i && ABOVE[degree_i]),
        .clamp_i   (clamp_i),
        .one_i     (at_end[w]),
        .word_i    (data_i[32*w +: 32]),
        .exponent_i(exponent_i),
        .number_o  (numbers_o[w*POINT_W +: POINT_W]),
        .nan_o     (nan[w]),
        .outside_o (outside[w])
      );
    end
  endgenerate

  assign nan_o     = |nan[2:0];
  assign outside_o = |outside[2:0];
  wire unused_ok = &{1'b0, nan[3], outside[3]};
endmodule

`default_nettype wire
