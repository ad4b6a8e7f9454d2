// ffd_hard_triple: a register that is held three times, and what two of them say
//
// q_o is the majority of the three, bit by bit. A bit that flips in one of them is outvoted, and is
// right again from the next clock on, because all three take d_i in every clock: whoever wants to
// hold a value gives q_o back. differs_o: one of them differs from q_o.
//
// Pipeline:   1 register, never frozen; a level of gates behind it.  Reset: none, as ffd_hard_copy.
// Parameters: WIDTH >= 1.
// Model:      none (storage only).  Test: tests/bus/axi.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_hard_triple #(
  parameter WIDTH = 1
) (
  input  wire             clk,
  input  wire [WIDTH-1:0] d_i,
  output wire [WIDTH-1:0] q_o,
  output wire             differs_o
);
  wire [3*WIDTH-1:0] copies;
  wire [WIDTH-1:0]   a = copies[0 +: WIDTH];
  wire [WIDTH-1:0]   b = copies[WIDTH +: WIDTH];
  wire [WIDTH-1:0]   c = copies[2*WIDTH +: WIDTH];

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : gen_copy
      ffd_hard_copy #(
        .WIDTH(WIDTH)
      ) u_copy (
        .clk(clk),
        .d_i(d_i),
        .q_o(copies[k*WIDTH +: WIDTH])
      );
    end
  endgenerate

  assign q_o       = (a & b) | (a & c) | (b & c);
  assign differs_o = a != b || a != c;
endmodule

`default_nettype wire
