// ffd_num_add: sum + sum -> sum
//
// Rounding:   fp32: to nearest even. Else: none.
// Overflow:   fixed point: none in a vertex: 64 products of magnitude at most 2 x 1 stay within
//             [-128, 128], and the sum is Q9.
// Pipeline:   LATENCY registers, II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh; LATENCY >= 1; OPEN 1: the last of these registers is left to
//             the module around it.
// Model:      golden/include/hwffd/numerics (add).  Test: tests/unit/fixed, tests/unit/float.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_add #(
  parameter FORMAT  = 18,
  parameter LATENCY = 1,
  parameter OPEN    = 0
) (
  input  wire                           clk,
  input  wire [`FFD_SUM_W(FORMAT)-1:0]  a_i,
  input  wire [`FFD_SUM_W(FORMAT)-1:0]  b_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]  sum_o
);
  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_add_format_is_unknown u_error ();
    end
    if (LATENCY < 1) begin : gen_bad_latency
      ERROR_ffd_num_add_latency_must_be_at_least_1 u_error ();
    end
  endgenerate

  generate
    if (FORMAT == `FFD_FORMAT_FP32) begin : gen_float
      ffd_fp_add #(
        .EXP_W  (8),
        .SIG_W  (24),
        .LATENCY(LATENCY),
        .OPEN   (OPEN)
      ) u_add (
        .clk     (clk),
        .a_i     (a_i),
        .b_i     (b_i),
        .result_o(sum_o)
      );
    end else begin : gen_fixed
      localparam VALUE_W = 2 * `FFD_FIXED_W(FORMAT) + 6;
      localparam FLAGS_W = `FFD_FLAGS_W(FORMAT);
      wire signed [VALUE_W-1:0] a   = a_i[VALUE_W-1:0];
      wire signed [VALUE_W-1:0] b   = b_i[VALUE_W-1:0];
      wire signed [VALUE_W-1:0] sum = a + b;

      ffd_num_delay #(
        .WIDTH  (FLAGS_W + VALUE_W),
        .LATENCY(LATENCY - OPEN)
      ) u_sum (
        .clk(clk),
        .rst(1'b0),
        .d_i({a_i[VALUE_W +: FLAGS_W] | b_i[VALUE_W +: FLAGS_W], sum}),
        .q_o(sum_o)
      );
    end
  endgenerate
endmodule

`default_nettype wire
