// ffd_eval_accumulator: sum = (clear ? 0 : sum) + term, one component (fig. 1 stage 3)
//
// Successive terms of one vertex are DISTANCE clocks apart; between them the adder serves the terms
// of other vertices. The paper draws an asynchronous reset by the counter's NOR gate; here the
// first term of a vertex is added to +0: the register in front of the adder is cleared in the clock
// before (clear_next_i), which costs no gate. Fused, the term comes as its two factors.
//
// Formats, rounding: those of ffd_num_add, or of ffd_num_mac.
// Pipeline:   ADD_LATENCY registers (FMA_LATENCY where fused); the sum is back DISTANCE clocks
//             after its term. DISTANCE is CONTEXTS * INTERVAL with the fewest contexts that
//             suffice, so what has to wait is one sum at a time: one register holds it.
// Parameters: FORMAT as in ffd_num.vh; ADD_LATENCY >= 1; FMA_LATENCY >= 1 fuses, 0 does not;
//             DISTANCE >= the latency.
// Not checked: that terms are at least DISTANCE - latency clocks apart.
// Model:      golden/include/hwffd/model (each organization's order).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"

module ffd_eval_accumulator #(
  parameter FORMAT      = 18,
  parameter ADD_LATENCY = 1,
  parameter FMA_LATENCY = 0,
  parameter DISTANCE    = 1
) (
  input  wire                              clk,
  input  wire                              rst,
  input  wire                              valid_i,
  input  wire                              clear_next_i,
  input  wire [`FFD_SUM_W(FORMAT)-1:0]     term_i,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  weight_i,
  input  wire [`FFD_POINT_W(FORMAT)-1:0]   point_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]     sum_o
);
  localparam SUM_W   = `FFD_SUM_W(FORMAT);
  localparam LATENCY = FMA_LATENCY > 0 ? FMA_LATENCY : ADD_LATENCY;
  `FFD_TAKES(LATENCY)
  localparam HOLD    = DISTANCE > LATENCY;
  // Where no register lies between, the adder's last one is here, twice: one holds the result, the
  // other is cleared.
  localparam DOUBLE  = HOLD ? 0 : 1;

  generate
    if (DISTANCE < LATENCY) begin : gen_bad_distance
      ERROR_ffd_eval_accumulator_distance_is_below_the_latency u_error ();
    end
  endgenerate

  wire [SUM_W-1:0] augend;
  wire [SUM_W-1:0] total;

  ffd_num_delay #(
    .WIDTH  (SUM_W),
    .LATENCY(DOUBLE ? 1 : 0)
  ) u_sum (
    .clk(clk),
    .rst(1'b0),
    .d_i(total),
    .q_o(sum_o)
  );

  generate
    if (HOLD) begin : gen_hold
      wire             valid;
      reg  [SUM_W-1:0] hold_q;

      ffd_num_delay #(
        .WIDTH  (1),
        .LATENCY(LATENCY),
        .RESET  (1)
      ) u_valid (
        .clk(clk),
        .rst(rst),
        .d_i(valid_i),
        .q_o(valid)
      );
      always @(posedge clk) begin
        if (clear_next_i) hold_q <= {SUM_W{1'b0}};
        else if (valid) hold_q <= sum_o;
      end
      assign augend = hold_q;
    end else begin : gen_double
      reg [SUM_W-1:0] total_q;
      always @(posedge clk) begin
        if (clear_next_i) total_q <= {SUM_W{1'b0}};
        else total_q <= total;
      end
      assign augend = total_q;
      wire unused_ok = &{1'b0, rst, valid_i};
    end

    if (FMA_LATENCY > 0) begin : gen_fused
      ffd_num_mac #(
        .FORMAT (FORMAT),
        .LATENCY(FMA_LATENCY),
        .OPEN   (DOUBLE)
      ) u_mac (
        .clk     (clk),
        .weight_i(weight_i),
        .point_i (point_i),
        .sum_i   (augend),
        .sum_o   (total)
      );
      wire unused_term_ok = &{1'b0, term_i};
    end else begin : gen_add
      ffd_num_add #(
        .FORMAT (FORMAT),
        .LATENCY(ADD_LATENCY),
        .OPEN   (DOUBLE)
      ) u_add (
        .clk  (clk),
        .a_i  (augend),
        .b_i  (term_i),
        .sum_o(total)
      );
      wire unused_factors_ok = &{1'b0, weight_i, point_i};
    end
  endgenerate
endmodule

`default_nettype wire
