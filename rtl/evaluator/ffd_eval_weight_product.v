// ffd_eval_weight_product: (B_l * B_m) * B_n for every unit of one step
//
// S x T x U units share the weights of S, T and U blending functions, u varying fastest, and the
// products B_l * B_m of those with the same l and m.
//
// Formats, rounding: those of ffd_num_mul, twice.
// Pipeline:   2 * MUL_LATENCY registers, II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh, S, T, U >= 1, MUL_LATENCY >= 1.
// Model:      golden/include/hwffd/model/organization.hpp (weight_of).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_eval_weight_product #(
  parameter FORMAT      = 18,
  parameter S           = 1,
  parameter T           = 1,
  parameter U           = 1,
  parameter MUL_LATENCY = 1
) (
  input  wire                                    clk,
  input  wire [S*`FFD_WEIGHT_W(FORMAT)-1:0]      weights_s_i,
  input  wire [T*`FFD_WEIGHT_W(FORMAT)-1:0]      weights_t_i,
  input  wire [U*`FFD_WEIGHT_W(FORMAT)-1:0]      weights_u_i,
  output wire [S*T*U*`FFD_WEIGHT_W(FORMAT)-1:0]  weights_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);

  wire [U*WEIGHT_W-1:0] weights_u;

  ffd_num_delay #(
    .WIDTH  (U * WEIGHT_W),
    .LATENCY(MUL_LATENCY)
  ) u_weights_u (
    .clk(clk),
    .rst(1'b0),
    .d_i(weights_u_i),
    .q_o(weights_u)
  );

  genvar i;
  genvar j;
  generate
    for (i = 0; i < S * T; i = i + 1) begin : gen_st
      wire [WEIGHT_W-1:0] weight_st;

      ffd_num_mul #(
        .FORMAT (FORMAT),
        .LATENCY(MUL_LATENCY)
      ) u_mul_st (
        .clk      (clk),
        .a_i      (weights_s_i[(i/T)*WEIGHT_W +: WEIGHT_W]),
        .b_i      (weights_t_i[(i%T)*WEIGHT_W +: WEIGHT_W]),
        .product_o(weight_st)
      );

      for (j = 0; j < U; j = j + 1) begin : gen_u
        ffd_num_mul #(
          .FORMAT (FORMAT),
          .LATENCY(MUL_LATENCY)
        ) u_mul_stu (
          .clk      (clk),
          .a_i      (weight_st),
          .b_i      (weights_u[j*WEIGHT_W +: WEIGHT_W]),
          .product_o(weights_o[(i*U+j)*WEIGHT_W +: WEIGHT_W])
        );
      end
    end
  endgenerate
endmodule

`default_nettype wire
