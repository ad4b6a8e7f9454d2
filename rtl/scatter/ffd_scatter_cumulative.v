// ffd_scatter_cumulative: the weights of an axis by bank become those of its banks up to one
//
//   C_0 = w_0    C_1 = saturate(C_0 + w_1)    C_2 = saturate(C_1 + w_2)
//
// What stands in place of the weight of bank 3 is what all four sum to: 1, or 0 of a derivative.
//
// Formats:    weights Q2.(W-2); sums saturate, flagged (ffd_num_cumulate), and the flag of C_2 is
//             that of all three.
// Pipeline:   weights | ADD_LATENCY | ADD_LATENCY: sums. II 1, never frozen.
// Bad input:  none.
// Parameters: FORMAT 12 to 18, ADD_LATENCY >= 0.
// Model:      golden/include/hwffd/model/scatter.hpp (cumulative).  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_scatter.vh"

module ffd_scatter_cumulative #(
  parameter FORMAT      = 17,
  parameter ADD_LATENCY = 1
) (
  input  wire                               clk,
  input  wire [4*`FFD_WEIGHT_W(FORMAT)-1:0] weights_i,  // that of bank 0 lowest
  output wire [3*`FFD_WEIGHT_W(FORMAT)-1:0] sums_o,     // {C_2, C_1, C_0}
  output wire                               whole_o     // they sum to 1
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  `FFD_TAKES(2 * ADD_LATENCY)

  wire [WEIGHT_W-1:0] two;
  wire [WEIGHT_W-1:0] third;
  wire                third_whole;

  ffd_num_cumulate #(
    .FORMAT (FORMAT),
    .LATENCY(ADD_LATENCY)
  ) u_two (
    .clk     (clk),
    .a_i     (weights_i[0*WEIGHT_W +: WEIGHT_W]),
    .b_i     (weights_i[1*WEIGHT_W +: WEIGHT_W]),
    .weight_o(two)
  );

  ffd_num_delay #(
    .WIDTH  (1 + WEIGHT_W),
    .LATENCY(ADD_LATENCY)
  ) u_third (
    .clk(clk),
    .rst(1'b0),
    .d_i({|weights_i[3*WEIGHT_W +: WEIGHT_W], weights_i[2*WEIGHT_W +: WEIGHT_W]}),
    .q_o({third_whole, third})
  );

  ffd_num_cumulate #(
    .FORMAT (FORMAT),
    .LATENCY(ADD_LATENCY)
  ) u_three (
    .clk     (clk),
    .a_i     (two),
    .b_i     (third),
    .weight_o(sums_o[2*WEIGHT_W +: WEIGHT_W])
  );

  ffd_num_delay #(
    .WIDTH  (1 + WEIGHT_W),
    .LATENCY(ADD_LATENCY)
  ) u_c_1 (
    .clk(clk),
    .rst(1'b0),
    .d_i({third_whole, two}),
    .q_o({whole_o, sums_o[1*WEIGHT_W +: WEIGHT_W]})
  );

  ffd_num_delay #(
    .WIDTH  (WEIGHT_W),
    .LATENCY(2 * ADD_LATENCY)
  ) u_c_0 (
    .clk(clk),
    .rst(1'b0),
    .d_i(weights_i[0*WEIGHT_W +: WEIGHT_W]),
    .q_o(sums_o[0*WEIGHT_W +: WEIGHT_W])
  );
endmodule

`default_nettype wire
