// entry_units: converters of one format side by side, of 0, 1, 2, 3, 4 and 9 registers
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module entry_units #(
  parameter FORMAT = 18
) (
  input  wire                        clk,
  input  wire [31:0]                 word_i,
  input  wire [`FFD_EXPONENT_W-1:0]  exponent_i,
  input  wire [1:0]                  role_i,
  input  wire                        clear_i, clamp_i, one_i,
  output wire [63:0]                 now_o,  // {outside, NaN, number}, of every latency
  output wire [63:0]                 after_1_o,
  output wire [63:0]                 after_2_o,
  output wire [63:0]                 after_3_o,
  output wire [63:0]                 after_4_o,
  output wire [63:0]                 after_9_o
);
  localparam POINT_W = `FFD_POINT_W(FORMAT);

  genvar i;
  generate
    for (i = 0; i < 6; i = i + 1) begin : gen_unit
      wire [POINT_W-1:0] number;
      wire               nan;
      wire               outside;
      ffd_num_in #(
        .FORMAT (FORMAT),
        .LATENCY(i == 5 ? 9 : i)
      ) u_in (
        .clk       (clk),
        .role_i    (role_i),
        .clear_i   (clear_i),
        .clamp_i   (clamp_i),
        .one_i     (one_i),
        .word_i    (word_i),
        .exponent_i(exponent_i),
        .number_o  (number),
        .nan_o     (nan),
        .outside_o (outside)
      );
      wire [63:0] all = {outside, nan, {(62 - POINT_W) {1'b0}}, number};
    end
  endgenerate
  assign now_o     = gen_unit[0].all;
  assign after_1_o = gen_unit[1].all;
  assign after_2_o = gen_unit[2].all;
  assign after_3_o = gen_unit[3].all;
  assign after_4_o = gen_unit[4].all;
  assign after_9_o = gen_unit[5].all;
endmodule

`default_nettype wire
