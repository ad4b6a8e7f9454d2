// ffd_fp_shift_left: y_o = x_i * 2^amount_i modulo 2^WIDTH
//
// A normalising shift: large steps first, so that a user of only the upper bits of y_o pays for
// ever narrower steps. Nothing but leading zeros may be shifted out, or it is lost.
//
// Pipeline:   none, combinational.
// Parameters: WIDTH >= 2; AMOUNT_W >= 1. Set by the units, not guarded.
// Test:       tests/unit/float/float_test.cpp, through the units.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_fp_shift_left #(
  parameter WIDTH    = 28,
  parameter AMOUNT_W = 5
) (
  input  wire [WIDTH-1:0]    x_i,
  input  wire [AMOUNT_W-1:0] amount_i,
  output reg  [WIDTH-1:0]    y_o
);
  integer k;
  always @* begin
    y_o = x_i;
    for (k = AMOUNT_W - 1; k >= 0; k = k - 1) begin
      y_o = amount_i[k] ? y_o << (1 << k) : y_o;
    end
  end
endmodule

`default_nettype wire
