// ffd_eval_horner: a cubic by Horner's rule, ((c3 x + c2) x + c1) x + c0, one unit a step
//
// Nothing is delayed in here: each operand comes when its step wants it, so that what stands still,
// or is itself computed, needs no registers. With L = FFD_STEP_LATENCY and J = FFD_STEP_JOIN, after
// the start: x at 0, L, 2 L; c3 at 0, c2 at J, c1 at L + J, c0 at 2 L + J.
//
// Formats, rounding: those of ffd_num_step.
// Pipeline:   start | FFD_STEP_LATENCY | FFD_STEP_LATENCY | FFD_STEP_LATENCY: value. II 1, never
//             frozen.
// Parameters: FORMAT, MUL_LATENCY, ADD_LATENCY, FMA_LATENCY as in ffd_num_step.
// Model:      golden/include/hwffd/model/org_nested.hpp (horner).  Test: tests/evaluator.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_eval_horner #(
  parameter FORMAT      = 18,
  parameter MUL_LATENCY = 2,
  parameter ADD_LATENCY = 1,
  parameter FMA_LATENCY = 0
) (
  input  wire                                clk,
  input  wire [4*`FFD_WEIGHT_W(FORMAT)-1:0]  coefficients_i,
  input  wire [3*`FFD_WEIGHT_W(FORMAT)-1:0]  coordinate_i,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]    value_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);

  genvar p;
  generate
    for (p = 0; p < 3; p = p + 1) begin : gen_step
      wire [WEIGHT_W-1:0] previous;
      wire [WEIGHT_W-1:0] value;
      if (p == 0) begin : gen_first
        assign previous = coefficients_i[3*WEIGHT_W +: WEIGHT_W];
      end else begin : gen_next
        assign previous = gen_step[p-1].value;
      end

      ffd_num_step #(
        .FORMAT     (FORMAT),
        .MUL_LATENCY(MUL_LATENCY),
        .ADD_LATENCY(ADD_LATENCY),
        .FMA_LATENCY(FMA_LATENCY),
        .LATE       (1)
      ) u_step (
        .clk          (clk),
        .coefficient_i(coefficients_i[(2-p)*WEIGHT_W +: WEIGHT_W]),
        .coordinate_i (coordinate_i[p*WEIGHT_W +: WEIGHT_W]),
        .weight_i     (previous),
        .weight_o     (value)
      );
    end
  endgenerate

  assign value_o = gen_step[2].value;
endmodule

`default_nettype wire
