// ffd_eval_vector_accumulator: sum = (clear ? 0 : sum) + term, three components (fig. 1 stage 3)
//
// Successive terms of one vertex are DISTANCE clocks apart; between them the adders serve the terms
// of other vertices. The paper draws an asynchronous reset by the counter's NOR gate; here the
// first term of a vertex is added to +0 in its own clock.
//
// Formats, rounding: those of ffd_num_add. Component 0 (x) lowest.
// Pipeline:   ADD_LATENCY registers; the sum comes back DISTANCE clocks after its term, held in one
//             register in between: with DISTANCE < ADD_LATENCY + spacing of terms, only one waits.
// Parameters: FORMAT as in ffd_num.vh, ADD_LATENCY >= 1, DISTANCE >= ADD_LATENCY, and terms are at
//             least DISTANCE - ADD_LATENCY clocks apart.
// Model:      golden/include/hwffd/model (each organization's order).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_eval_vector_accumulator #(
  parameter FORMAT      = 18,
  parameter ADD_LATENCY = 1,
  parameter DISTANCE    = 1
) (
  input  wire                             clk,
  input  wire                             rst,
  input  wire                             valid_i,
  input  wire                             clear_i,
  input  wire [3*`FFD_SUM_W(FORMAT)-1:0]  term_i,
  output wire [3*`FFD_SUM_W(FORMAT)-1:0]  sum_o
);
  localparam SUM_W = `FFD_SUM_W(FORMAT);

  generate
    if (DISTANCE < ADD_LATENCY) begin : gen_bad_distance
      ERROR_ffd_eval_vector_accumulator_distance_is_below_add_latency u_error ();
    end
  endgenerate

  wire [3*SUM_W-1:0] back;

  generate
    if (DISTANCE == ADD_LATENCY) begin : gen_direct
      assign back = sum_o;
      wire unused_ok = &{1'b0, rst, valid_i};
    end else begin : gen_hold
      wire               valid;
      reg  [3*SUM_W-1:0] hold_q;

      ffd_num_delay #(
        .WIDTH  (1),
        .LATENCY(ADD_LATENCY),
        .RESET  (1)
      ) u_valid (
        .clk(clk),
        .rst(rst),
        .d_i(valid_i),
        .q_o(valid)
      );
      always @(posedge clk) begin
        if (valid) hold_q <= sum_o;
      end
      assign back = hold_q;
    end
  endgenerate

  genvar c;
  generate
    for (c = 0; c < 3; c = c + 1) begin : gen_component
      ffd_num_add #(
        .FORMAT (FORMAT),
        .LATENCY(ADD_LATENCY)
      ) u_add (
        .clk  (clk),
        .a_i  (clear_i ? {SUM_W{1'b0}} : back[c*SUM_W +: SUM_W]),
        .b_i  (term_i[c*SUM_W +: SUM_W]),
        .sum_o(sum_o[c*SUM_W +: SUM_W])
      );
    end
  endgenerate
endmodule

`default_nettype wire
