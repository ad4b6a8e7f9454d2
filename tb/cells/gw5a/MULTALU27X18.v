// MULTALU27X18: the multiplier of Gowin GW5A, as synth/gw5a uses it
//
// DOUT = A B, two's complement, without registers. What else the cell can do, the map leaves at 0, and
// DOUT is x where it does not: shift chains (SIA, ASEL), pre-adder (D, PSEL, PADDSUB), adder and
// accumulator (C, CASI and what chooses and negates them). The cell has parameters, which the map
// leaves as they are: the model has none, so that a netlist that sets one does not elaborate.
//
// Pipeline:   none.
// Not checked: CLK, CE and RESET, which mean nothing without registers; CASO and SOA lead nowhere.
// Test:       the tests netlist.gw5a.* (tests/system).
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module MULTALU27X18 (
  input  wire [26:0] A,
  input  wire [26:0] SIA,
  input  wire        ASEL,
  input  wire [25:0] D,
  input  wire        PSEL,
  input  wire        PADDSUB,
  input  wire [17:0] B,
  input  wire [47:0] C,
  input  wire        CSEL,
  input  wire [47:0] CASI,
  input  wire        CASISEL,
  input  wire        ACCSEL,
  input  wire [1:0]  ADDSUB,
  input  wire [1:0]  CLK,
  input  wire [1:0]  CE,
  input  wire [1:0]  RESET,
  output wire [47:0] DOUT,
  output wire [47:0] CASO,
  output wire [26:0] SOA
);
  wire signed [47:0] a       = {{21{A[26]}}, A};
  wire signed [47:0] b       = {{30{B[17]}}, B};
  wire signed [47:0] product = a * b;
  wire               more    = |{SIA, ASEL, D, PSEL, PADDSUB, C, CSEL, CASI, CASISEL, ACCSEL, ADDSUB};

  assign DOUT = more ? 48'bx : product;
  assign CASO = 48'bx;
  assign SOA  = 27'bx;
endmodule

`default_nettype wire
