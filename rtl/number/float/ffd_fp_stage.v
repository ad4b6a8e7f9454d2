// ffd_fp_stage: the registers that follow step STEP of a unit made of STEPS combinational steps
//
//   registers = floor((STEP + 1) * LATENCY / STEPS) - floor(STEP * LATENCY / STEPS)
//
// The sum over all steps is LATENCY and the last step always gets one, whatever LATENCY >= 1 is: a
// unit is written once, as its steps, and cut where the latency asked for puts the registers. With
// OPEN the last register of the unit is left to the module around it.
//
// Pipeline:   that many registers, II 1, never frozen, never reset.
// Parameters: WIDTH >= 1; LATENCY >= 1 of the whole unit (guarded here, for every unit);
//             STEPS >= 1; 0 <= STEP < STEPS; OPEN 0 or 1.
// Model:      none (transport only).  Test: tests/unit/float/float_test.cpp, latency tests.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_fp_stage #(
  parameter WIDTH   = 1,
  parameter LATENCY = 1,
  parameter STEPS   = 1,
  parameter STEP    = 0,
  parameter OPEN    = 0
) (
  input  wire             clk,
  input  wire [WIDTH-1:0] d_i,
  output wire [WIDTH-1:0] q_o
);
  generate
    if (LATENCY < 1) begin : gen_bad_latency
      ERROR_ffd_fp_stage_latency_must_be_at_least_1 u_error ();
    end
    if (STEP < 0 || STEP >= STEPS) begin : gen_bad_step
      ERROR_ffd_fp_stage_step_must_be_below_steps u_error ();
    end
  endgenerate

  localparam LAST      = STEP == STEPS - 1;
  localparam REGISTERS = `FFD_FP_REGISTERS(LATENCY, STEPS, STEP) - (LAST && OPEN != 0 ? 1 : 0);

  ffd_num_delay #(
    .WIDTH  (WIDTH),
    .LATENCY(REGISTERS),
    .RESET  (0)
  ) u_delay (
    .clk(clk),
    .rst(1'b0),
    .d_i(d_i),
    .q_o(q_o)
  );
endmodule

`default_nettype wire
