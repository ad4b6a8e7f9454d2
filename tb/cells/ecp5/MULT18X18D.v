// MULT18X18D: the multiplier of Lattice ECP5, as yosys and synth/ecp5 use it
//
// P = A B, each factor two's complement where its SIGNED pin is 1. Registers of one clock, never
// reset nor stopped, where their parameter is "CLK0": of the factors, of the product inside, and of
// what leaves. The pins of the shift chains are not there: a netlist that uses one does not
// elaborate.
//
// Pipeline:   0 to 3 registers, as the parameters say.
// Not checked: SOURCEA and SOURCEB, which are 0 (factors from the pins), CE and RST (1 and 0).
// Test:       the tests netlist.ecp5.* (tests/system), tests/synth/test_blocks.py.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module MULT18X18D #(
  parameter REG_INPUTA_CLK   = "NONE",
  parameter REG_INPUTB_CLK   = "NONE",
  parameter REG_PIPELINE_CLK = "NONE",
  parameter REG_OUTPUT_CLK   = "NONE",
  parameter GSR              = "ENABLED"
) (
  input wire A17, A16, A15, A14, A13, A12, A11, A10, A9, A8, A7, A6, A5, A4, A3, A2, A1, A0,
  input wire B17, B16, B15, B14, B13, B12, B11, B10, B9, B8, B7, B6, B5, B4, B3, B2, B1, B0,
  input wire C17, C16, C15, C14, C13, C12, C11, C10, C9, C8, C7, C6, C5, C4, C3, C2, C1, C0,
  input wire SIGNEDA, SIGNEDB, SOURCEA, SOURCEB,
  input wire CLK0, CLK1, CLK2, CLK3,
  input wire CE0, CE1, CE2, CE3,
  input wire RST0, RST1, RST2, RST3,
  output wire P35, P34, P33, P32, P31, P30, P29, P28, P27, P26, P25, P24, P23, P22, P21, P20, P19,
    P18, P17, P16, P15, P14, P13, P12, P11, P10, P9, P8, P7, P6, P5, P4, P3, P2, P1, P0
);
  wire [17:0] a = {A17, A16, A15, A14, A13, A12, A11, A10, A9, A8, A7, A6, A5, A4, A3, A2, A1, A0};
  wire [17:0] b = {B17, B16, B15, B14, B13, B12, B11, B10, B9, B8, B7, B6, B5, B4, B3, B2, B1, B0};

  reg [18:0] a_q;
  reg [18:0] b_q;
  reg [35:0] inside_q;
  reg [35:0] product_q;
  wire signed [18:0] factor_a = REG_INPUTA_CLK == "CLK0" ? a_q : {SIGNEDA & A17, a};
  wire signed [18:0] factor_b = REG_INPUTB_CLK == "CLK0" ? b_q : {SIGNEDB & B17, b};
  wire signed [36:0] exact    = factor_a * factor_b;
  wire [35:0]        inside   = REG_PIPELINE_CLK == "CLK0" ? inside_q : exact[35:0];

  always @(posedge CLK0) begin
    a_q       <= {SIGNEDA & A17, a};
    b_q       <= {SIGNEDB & B17, b};
    inside_q  <= exact[35:0];
    product_q <= inside;
  end

  assign {P35, P34, P33, P32, P31, P30, P29, P28, P27, P26, P25, P24, P23, P22, P21, P20, P19, P18,
    P17, P16, P15, P14, P13, P12, P11, P10, P9, P8, P7, P6, P5, P4, P3, P2, P1, P0} =
    REG_OUTPUT_CLK == "CLK0" ? product_q : inside;
endmodule

`default_nettype wire
