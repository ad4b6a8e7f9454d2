// ffd_fx_block: product_o = a_i * b_i in a MULT18X18D of Lattice ECP5 with the registers of the block
//
// Takes the place of rtl/number/fixed/ffd_fx_block.v where ECP5 is the target. The last register in
// front of the multiplier, the one behind it, and of two behind it the first are those of the block;
// others are flip-flops. A product wider than a block is left to the synthesis.
//
// Formats, pipeline, parameters: as there; equal to it for all operands (tests/synth/test_blocks.py).
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_fx_block #(
  parameter W      = 18,
  parameter BEFORE = 0,
  parameter BEHIND = 1
) (
  input  wire                  clk,
  input  wire signed [W-1:0]   a_i,
  input  wire signed [W-1:0]   b_i,
  output wire signed [2*W-1:0] product_o
);
  localparam INSIDE = W > 18 ? 0 : 1;
  localparam AHEAD  = INSIDE != 0 && BEFORE > 0 ? BEFORE - 1 : BEFORE;
  localparam AFTER  = INSIDE == 0 ? BEHIND : BEHIND > 2 ? BEHIND - 2 : 0;

  wire signed [W-1:0]   a;
  wire signed [W-1:0]   b;
  wire signed [2*W-1:0] product;

  ffd_num_delay #(
    .WIDTH  (2 * W),
    .LATENCY(AHEAD)
  ) u_operands (
    .clk(clk),
    .rst(1'b0),
    .d_i({a_i, b_i}),
    .q_o({a, b})
  );

  generate
    if (INSIDE == 0) begin : gen_wide
      wire signed [2*W-1:0] wide_a = {{W{a[W-1]}}, a};
      wire signed [2*W-1:0] wide_b = {{W{b[W-1]}}, b};
      assign product = wide_a * wide_b;
    end else begin : gen_block
      wire signed [17:0] block_a = a;
      wire signed [17:0] block_b = b;
      wire [35:0]        block_p;
      assign product = block_p[2*W-1:0];

      MULT18X18D #(
        .REG_INPUTA_CLK  (BEFORE > 0 ? "CLK0" : "NONE"),
        .REG_INPUTB_CLK  (BEFORE > 0 ? "CLK0" : "NONE"),
        .REG_PIPELINE_CLK(BEHIND > 1 ? "CLK0" : "NONE"),
        .REG_OUTPUT_CLK  (BEHIND > 0 ? "CLK0" : "NONE"),
        .GSR             ("DISABLED")
      ) u_multiplier (
        .A17(block_a[17]), .A16(block_a[16]), .A15(block_a[15]), .A14(block_a[14]),
        .A13(block_a[13]), .A12(block_a[12]), .A11(block_a[11]), .A10(block_a[10]), .A9(block_a[9]),
        .A8(block_a[8]), .A7(block_a[7]), .A6(block_a[6]), .A5(block_a[5]), .A4(block_a[4]),
        .A3(block_a[3]), .A2(block_a[2]), .A1(block_a[1]), .A0(block_a[0]),
        .B17(block_b[17]), .B16(block_b[16]), .B15(block_b[15]), .B14(block_b[14]),
        .B13(block_b[13]), .B12(block_b[12]), .B11(block_b[11]), .B10(block_b[10]), .B9(block_b[9]),
        .B8(block_b[8]), .B7(block_b[7]), .B6(block_b[6]), .B5(block_b[5]), .B4(block_b[4]),
        .B3(block_b[3]), .B2(block_b[2]), .B1(block_b[1]), .B0(block_b[0]),
        .C17(1'b0), .C16(1'b0), .C15(1'b0), .C14(1'b0), .C13(1'b0), .C12(1'b0), .C11(1'b0),
        .C10(1'b0), .C9(1'b0), .C8(1'b0), .C7(1'b0), .C6(1'b0), .C5(1'b0), .C4(1'b0), .C3(1'b0),
        .C2(1'b0), .C1(1'b0), .C0(1'b0),
        .P35(block_p[35]), .P34(block_p[34]), .P33(block_p[33]), .P32(block_p[32]),
        .P31(block_p[31]), .P30(block_p[30]), .P29(block_p[29]), .P28(block_p[28]),
        .P27(block_p[27]), .P26(block_p[26]), .P25(block_p[25]), .P24(block_p[24]),
        .P23(block_p[23]), .P22(block_p[22]), .P21(block_p[21]), .P20(block_p[20]),
        .P19(block_p[19]), .P18(block_p[18]), .P17(block_p[17]), .P16(block_p[16]),
        .P15(block_p[15]), .P14(block_p[14]), .P13(block_p[13]), .P12(block_p[12]),
        .P11(block_p[11]), .P10(block_p[10]), .P9(block_p[9]), .P8(block_p[8]), .P7(block_p[7]),
        .P6(block_p[6]), .P5(block_p[5]), .P4(block_p[4]), .P3(block_p[3]), .P2(block_p[2]),
        .P1(block_p[1]), .P0(block_p[0]),
        .CLK0(clk), .CLK1(1'b0), .CLK2(1'b0), .CLK3(1'b0),
        .CE0(1'b1), .CE1(1'b1), .CE2(1'b1), .CE3(1'b1),
        .RST0(1'b0), .RST1(1'b0), .RST2(1'b0), .RST3(1'b0),
        .SIGNEDA(1'b1), .SIGNEDB(1'b1), .SOURCEA(1'b0), .SOURCEB(1'b0)
      );
    end
  endgenerate

  ffd_num_delay #(
    .WIDTH  (2 * W),
    .LATENCY(AFTER)
  ) u_product (
    .clk(clk),
    .rst(1'b0),
    .d_i(product),
    .q_o(product_o)
  );
endmodule

`default_nettype wire
