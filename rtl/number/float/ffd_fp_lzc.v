// ffd_fp_lzc: count_o = number of zeros in front of the leading one of x_i, none_o = (x_i == 0)
//
// A binary tree over x_i, filled up with zeros behind to a power of two. A node of level k covers
// 2^k bits; it knows whether they are all zero and how many zeros lead in them: those of its upper
// half, or, where that is empty, 2^(k-1) and those of its lower half.
//
// Pipeline:   none, combinational, clog2(WIDTH) levels.
// Unchecked:  count_o means nothing where none_o is set.
// Parameters: WIDTH >= 2. Set by the units, not guarded.
// Test:       tests/unit/float/float_test.cpp, through the units.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_fp_lzc #(
  parameter WIDTH = 28
) (
  input  wire [WIDTH-1:0]         x_i,
  output wire [$clog2(WIDTH)-1:0] count_o,
  output wire                     none_o
);
  localparam LEVELS = $clog2(WIDTH);
  localparam LEAVES = 1 << LEVELS;

  wire [LEAVES:0] filled = {x_i, {(LEAVES - WIDTH + 1){1'b0}}};  // a bit more: never {0{...}}

  genvar k;
  genvar n;
  generate
    for (k = 1; k <= LEVELS; k = k + 1) begin : gen_level
      for (n = 0; n < (LEAVES >> k); n = n + 1) begin : gen_node
        wire         none;
        wire [k-1:0] count;
        if (k == 1) begin : gen_pair
          assign none  = ~|filled[2*n+1 +: 2];
          assign count = ~filled[2*n+2];
        end else begin : gen_join
          wire upper_empty = gen_level[k-1].gen_node[2*n+1].none;
          assign none  = upper_empty & gen_level[k-1].gen_node[2*n].none;
          assign count = {upper_empty, upper_empty ? gen_level[k-1].gen_node[2*n].count
                                                   : gen_level[k-1].gen_node[2*n+1].count};
        end
      end
    end
  endgenerate

  assign count_o = gen_level[LEVELS].gen_node[0].count;
  assign none_o  = gen_level[LEVELS].gen_node[0].none;

  wire unused_ok = &{1'b0, filled[0]};
endmodule

`default_nettype wire
