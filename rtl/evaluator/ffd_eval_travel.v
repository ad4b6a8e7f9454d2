// ffd_eval_travel: weights of three axes that come one after the other, each when it is used
//
// The weights of the axis of step 0 are used as they come, those of step 1 DISTANCE clocks after
// them, those of step 2 DISTANCE clocks later still. They travel beside what uses them, and each
// axis holds its own until those of the next vertex come.
//
// Formats:    step 0 to 2, 3 where there is none; weights_o: those of step 0 lowest.
// Pipeline:   weights_i LATENCY clocks behind step_i | those of step 0 in the same clock; those of
//             step s come s clocks later and leave s DISTANCE clocks behind those of step 0. A step
//             a clock, those of a vertex one after the other; never frozen.
// Parameters: WIDTH of the weights of an axis, LATENCY >= 0, DISTANCE >= 1.
// Model:      none (transport only).  Test: tests/evaluator, tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_eval_travel #(
  parameter WIDTH    = 76,
  parameter LATENCY  = 16,
  parameter DISTANCE = 5
) (
  input  wire               clk,
  input  wire [1:0]         step_i,
  input  wire [WIDTH-1:0]   weights_i,
  output wire [3*WIDTH-1:0] weights_o
);
  generate
    if (DISTANCE < 1) begin : gen_bad_distance
      ERROR_ffd_eval_travel_distance_must_be_at_least_1 u_error ();
    end
  endgenerate

  genvar axis;
  generate
    for (axis = 0; axis < 3; axis = axis + 1) begin : gen_axis
      localparam [1:0] STEP = axis;
      wire [1:0]       step;
      wire [WIDTH-1:0] weights;
      reg  [WIDTH-1:0] held_q;
      wire             come = step == STEP;

      if (axis == 0) begin : gen_first
        assign weights = weights_i;
        ffd_num_delay #(
          .WIDTH  (2),
          .LATENCY(LATENCY)
        ) u_step (
          .clk(clk),
          .rst(1'b0),
          .d_i(step_i),
          .q_o(step)
        );
      end else begin : gen_next
        ffd_num_delay #(
          .WIDTH  (2 + WIDTH),
          .LATENCY(DISTANCE - 1)
        ) u_weights (
          .clk(clk),
          .rst(1'b0),
          .d_i({gen_axis[axis-1].step, gen_axis[axis-1].weights}),
          .q_o({step, weights})
        );
      end

      always @(posedge clk) if (come) held_q <= weights;
      assign weights_o[WIDTH*axis +: WIDTH] = come ? weights : held_q;
    end
  endgenerate
endmodule

`default_nettype wire
