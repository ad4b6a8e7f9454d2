// ffd_fp_lzc: count_o = number of zeros in front of the leading one of x_i, none_o = (x_i == 0)
//
// By halves: the upper half of what is left is empty or not, which is one bit of the count, and
// the search goes on in the half that holds the leading one.
//
// Pipeline:   none, combinational.
// Unchecked:  count_o means nothing where none_o is set.
// Parameters: WIDTH >= 2. Set by the units, not guarded.
// Test:       tests/unit/float/float_test.cpp, through the units.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_fp_lzc #(
  parameter WIDTH = 28
) (
  input  wire [WIDTH-1:0]         x_i,
  output reg  [$clog2(WIDTH)-1:0] count_o,
  output wire                     none_o
);
  localparam LEVELS = $clog2(WIDTH);

  integer k;
  reg [WIDTH-1:0] rest;
  always @* begin
    rest    = x_i;
    count_o = {LEVELS{1'b0}};
    for (k = LEVELS - 1; k >= 0; k = k - 1) begin
      if ((rest & ~({WIDTH{1'b1}} >> (1 << k))) == {WIDTH{1'b0}}) begin
        count_o[k] = 1'b1;
        rest       = rest << (1 << k);
      end
    end
  end
  assign none_o = ~|x_i;
endmodule

`default_nettype wire
