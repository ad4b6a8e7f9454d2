// ffd_stream_lattice: the payload of a control points packet, into the buffer that is not in use
//
// A beat a point, k fastest, then j, then i (docs/interface.md section 2). The buffer comes into
// use with the last one.
//
// Formats:    words go on as they came; write_at_o is {k, j, i}, 4 bits each, last_cell_o likewise.
// Pipeline:   write_o in the clock of its beat.
// Not checked: the dimensions in the header (ffd_stream_header).
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_stream_lattice (
  input  wire                        clk,
  input  wire                        rst,
  input  wire                        header_i,
  input  wire                        beat_i,
  input  wire [127:0]                data_i,
  input  wire [`FFD_EXPONENT_W-1:0]  exponent_i,
  output wire                        last_o,
  output wire                        write_o,
  output wire                        write_buffer_o,
  output wire [11:0]                 write_at_o,
  output wire [95:0]                 write_words_o,
  output wire                        buffer_o,
  output wire                        loaded_o,
  output wire [11:0]                 last_cell_o,
  output reg  [`FFD_EXPONENT_W-1:0]  exponent_o
);
  reg buffer_q;
  reg loaded_q;
  assign buffer_o = buffer_q;
  assign loaded_o = loaded_q;

  always @(posedge clk) begin
    if (rst) begin
      buffer_q <= 1'b0;
      loaded_q <= 1'b0;
    end else if (beat_i && last_o) begin
      buffer_q <= !buffer_q;
      loaded_q <= 1'b1;
    end
  end

  // Of the buffer in use.
  always @(posedge clk) begin
    if (beat_i && last_o) exponent_o <= exponent_i;
  end

  // An axis: its points as the header says, and an index that steps when those below it wrap.
  wire [2:0] at_top;
  wire [2:0] step = {beat_i, beat_i && at_top[2], beat_i && at_top[2] && at_top[1]};

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      wire [3:0] points = data_i[64+8*a +: 4];
      reg  [3:0] top_q;
      reg  [3:0] index_q;
      reg  [3:0] last_cell_q;
      assign at_top[a] = index_q == top_q;
      always @(posedge clk) begin
        if (header_i) begin
          top_q   <= points - 4'd1;
          index_q <= 4'd0;
        end else if (step[a]) begin
          index_q <= at_top[a] ? 4'd0 : index_q + 4'd1;
        end
        if (beat_i && last_o) last_cell_q <= top_q - 4'd3;
      end
      assign write_at_o[4*a +: 4]  = index_q;
      assign last_cell_o[4*a +: 4] = last_cell_q;
    end
  endgenerate

  assign last_o         = &at_top;
  assign write_o        = beat_i;
  assign write_buffer_o = !buffer_q;
  assign write_words_o  = data_i[95:0];

  wire unused_ok = &{1'b0, data_i};
endmodule

`default_nettype wire
