// ffd_clock_multiplier: a multiplier between registers, whose clock after routing is the measure of
// `make pnr`: what the chip can do with one product.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_clock_multiplier #(
  parameter WIDTH = 18
) (
  input  wire                      clk,
  input  wire signed [WIDTH-1:0]   a_i,
  input  wire signed [WIDTH-1:0]   b_i,
  output reg  signed [2*WIDTH-1:0] product_o
);
  reg signed [WIDTH-1:0] a_q;
  reg signed [WIDTH-1:0] b_q;

  always @(posedge clk) begin
    a_q       <= a_i;
    b_q       <= b_i;
    product_o <= a_q * b_q;
  end
endmodule

`default_nettype wire
