// ffd_eval_vector_multiplier: term = ((B_l * B_m) * B_n) * P, three components
//
// Stage 2 of the paper's fig. 1.
//
// Formats, rounding: those of ffd_num_mul (twice) and ffd_num_term. Component 0 (x) lowest.
// Pipeline:   3 * MUL_LATENCY registers, II 1, never frozen. The point enters 2 * MUL_LATENCY
//             clocks after the weights.
// Parameters: FORMAT as in ffd_num.vh, MUL_LATENCY >= 1.
// Model:      golden/include/hwffd/model/organization.hpp (term_of).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_eval_vector_multiplier #(
  parameter FORMAT      = 18,
  parameter MUL_LATENCY = 1
) (
  input  wire                               clk,
  input  wire [3*`FFD_WEIGHT_W(FORMAT)-1:0] weights_i,
  input  wire [3*`FFD_POINT_W(FORMAT)-1:0]  point_i,
  output wire [3*`FFD_SUM_W(FORMAT)-1:0]    term_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam SUM_W    = `FFD_SUM_W(FORMAT);

  wire [WEIGHT_W-1:0] weight_st;
  wire [WEIGHT_W-1:0] weight_u;
  wire [WEIGHT_W-1:0] weight_stu;

  ffd_num_mul #(
    .FORMAT (FORMAT),
    .LATENCY(MUL_LATENCY)
  ) u_mul_st (
    .clk      (clk),
    .a_i      (weights_i[0*WEIGHT_W +: WEIGHT_W]),
    .b_i      (weights_i[1*WEIGHT_W +: WEIGHT_W]),
    .product_o(weight_st)
  );

  ffd_num_delay #(
    .WIDTH  (WEIGHT_W),
    .LATENCY(MUL_LATENCY)
  ) u_weight_u (
    .clk(clk),
    .rst(1'b0),
    .d_i(weights_i[2*WEIGHT_W +: WEIGHT_W]),
    .q_o(weight_u)
  );

  ffd_num_mul #(
    .FORMAT (FORMAT),
    .LATENCY(MUL_LATENCY)
  ) u_mul_stu (
    .clk      (clk),
    .a_i      (weight_st),
    .b_i      (weight_u),
    .product_o(weight_stu)
  );

  genvar c;
  generate
    for (c = 0; c < 3; c = c + 1) begin : gen_component
      ffd_num_term #(
        .FORMAT (FORMAT),
        .LATENCY(MUL_LATENCY)
      ) u_term (
        .clk     (clk),
        .weight_i(weight_stu),
        .point_i (point_i[c*POINT_W +: POINT_W]),
        .term_o  (term_o[c*SUM_W +: SUM_W])
      );
    end
  endgenerate
endmodule

`default_nettype wire
