// ffd_scatter_choice: one of four words, in a register
//
// Pipeline:   1 register, II 1, never frozen.
// Parameters: WIDTH >= 1.
// Model:      none (transport only).  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_scatter_choice #(
  parameter WIDTH = 36
) (
  input  wire               clk,
  input  wire [1:0]         number_i,
  input  wire [4*WIDTH-1:0] words_i,
  output reg  [WIDTH-1:0]   word_o
);
  // (An index that is computed would be given a multiplier.)
  wire [2*WIDTH-1:0] pair = number_i[1] ? words_i[2*WIDTH +: 2*WIDTH] : words_i[0 +: 2*WIDTH];
  always @(posedge clk) word_o <= number_i[0] ? pair[WIDTH +: WIDTH] : pair[0 +: WIDTH];
endmodule

`default_nettype wire
