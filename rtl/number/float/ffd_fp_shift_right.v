// ffd_fp_shift_right: y_o = floor(x_i / 2^amount_i), sticky_o = whether a one was shifted out
//
// Exact: {y_o, sticky_o} rounds as x_i / 2^amount_i does at every bit of y_o. An amount beyond
// WIDTH leaves only the sticky bit, so a user clamps a large distance to all ones.
//
// LARGE_FIRST only chooses the cheaper order of the steps: 1 where few of the low bits of y_o are
// used, 0 where x_i has few bits and they enter at the top.
//
// Pipeline:   none, combinational.
// Parameters: WIDTH >= 2; AMOUNT_W >= 1; LARGE_FIRST 0 or 1. Set by the units, not guarded.
// Test:       tests/unit/float/float_test.cpp, through the units.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_fp_shift_right #(
  parameter WIDTH       = 26,
  parameter AMOUNT_W    = 5,
  parameter LARGE_FIRST = 0
) (
  input  wire [WIDTH-1:0]    x_i,
  input  wire [AMOUNT_W-1:0] amount_i,
  output reg  [WIDTH-1:0]    y_o,
  output reg                 sticky_o
);
  integer i;
  integer k;
  reg [WIDTH-1:0] dropped;  // the bits that step k leaves behind
  always @* begin
    y_o      = x_i;
    sticky_o = 1'b0;
    dropped     = {WIDTH{1'b0}};
    for (i = 0; i < AMOUNT_W; i = i + 1) begin
      k        = LARGE_FIRST != 0 ? AMOUNT_W - 1 - i : i;
      dropped     = y_o & ~({WIDTH{1'b1}} << (1 << k));
      sticky_o = sticky_o | (amount_i[k] & (|dropped));
      y_o      = amount_i[k] ? y_o >> (1 << k) : y_o;
    end
  end
endmodule

`default_nettype wire
