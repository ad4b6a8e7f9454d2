// ffd_stream_place: where an event is: the number of its packet since reset, and of its beat in it
//
// Pipeline:   those of the beat that is taken.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_stream_place (
  input  wire        clk,
  input  wire        rst,
  input  wire        take_i,
  input  wire        last_i,
  output reg  [31:0] packet_o,
  output reg  [31:0] beat_o
);
  always @(posedge clk) begin
    if (rst) packet_o <= 32'd0;
    else if (take_i && last_i) packet_o <= packet_o + 32'd1;
  end
  always @(posedge clk) begin
    if (rst || (take_i && last_i)) beat_o <= 32'd0;
    else if (take_i) beat_o <= beat_o + 32'd1;
  end
endmodule

`default_nettype wire
