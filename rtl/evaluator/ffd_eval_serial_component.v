// ffd_eval_serial_component: a component of ffd_eval_serial: one multiplier, a point a clock
//
// Points come bank by bank, the base of each four first. While it comes the multiplier is free, and
// works on the axis above, of which every fourth such clock is free for the one above that:
//
//   clock of a group of four    0: base      1      2      3
//   multiplication along        t, or s      u      u      u
//
// Formats, rounding: those of ffd_num_offset, ffd_num_offset_term and ffd_num_narrow, as in
//             ffd_eval_affine: sums are exact, so their order does not matter.
// Pipeline:   point | 1: offset, weight | MUL_LATENCY: term | 1: sum | CONVERT_LATENCY: point of
//             the axis above | DELAY. One clock, the phases of all stages, comes from outside.
// Freezes:    never.
// Parameters: FORMAT 8 to 32; MUL_LATENCY 1 or 2; CONVERT_LATENCY, DELAY >= 0: together with
//             MUL_LATENCY they make a number of groups of four of these stages.
// Model:      golden/include/hwffd/model/org_affine.hpp.  Test: tests/evaluator.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_eval_serial_component #(
  parameter FORMAT          = 17,
  parameter MUL_LATENCY     = 2,
  parameter CONVERT_LATENCY = 1,
  parameter DELAY           = 0
) (
  input  wire                                clk,
  input  wire [`FFD_POINT_W(FORMAT)-1:0]     point_i,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]    weight_i,       // a clock after what it is for
  // Of the stage of points: what is multiplied, and what begins.
  input  wire                                base_i,         // of u: nothing along u
  input  wire                                of_s_i,         // else along t, where base_i
  input  wire                                begin_t_i,
  input  wire                                begin_s_i,
  // Whether bases count: not in a derivative, whose weights sum to zero.
  input  wire                                whole_u_i,
  input  wire                                whole_t_i,
  input  wire                                whole_s_i,
  input  wire                                keep_s_i,       // what s takes next has been narrowed
  // Of the stage of sums.
  input  wire                                sum_begins_u_i,
  input  wire                                sum_of_u_i,
  input  wire                                sum_of_s_i,     // where not of u; else of t
  // A clock after the stage of sums.
  input  wire                                keep_sum_t_i,
  input  wire                                keep_sum_s_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]       sum_o
);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam OFFSET_W = `FFD_OFFSET_W(FORMAT);
  localparam SUM_W    = `FFD_SUM_W(FORMAT);

  generate
    if (MUL_LATENCY < 1 || MUL_LATENCY > 2) begin : gen_bad_latency
      ERROR_ffd_eval_serial_component_mul_latency_must_be_1_or_2 u_error ();
    end
  endgenerate

  // ---- points: those that are read, and sums of an axis as points of the next

  wire [POINT_W-1:0] narrowed;
  wire [POINT_W-1:0] of_t;
  reg  [POINT_W-1:0] of_s_q;
  reg  [POINT_W-1:0] base_u_q;
  reg  [POINT_W-1:0] base_t_q;
  reg  [POINT_W-1:0] base_s_q;

  always @(posedge clk) begin
    if (base_i) base_u_q <= point_i;
    if (begin_t_i) base_t_q <= of_t;
    if (begin_s_i) base_s_q <= of_s_q;
    if (keep_s_i) of_s_q <= narrowed;
  end

  wire [POINT_W-1:0]  point = !base_i ? point_i : of_s_i ? of_s_q : of_t;
  wire [POINT_W-1:0]  base  = !base_i ? base_u_q : of_s_i ? base_s_q : base_t_q;
  wire [OFFSET_W-1:0] offset;
  wire [SUM_W-1:0]    term;

  ffd_num_offset #(
    .FORMAT (FORMAT),
    .LATENCY(1)
  ) u_offset (
    .clk     (clk),
    .point_i (point),
    .base_i  (base),
    .offset_o(offset)
  );

  ffd_num_offset_term #(
    .FORMAT (FORMAT),
    .LATENCY(MUL_LATENCY)
  ) u_term (
    .clk     (clk),
    .weight_i(weight_i),
    .offset_i(offset),
    .term_o  (term)
  );

  // ---- sums: a base, then its terms

  wire [SUM_W-1:0] start_u;
  wire [SUM_W-1:0] start_t;
  wire [SUM_W-1:0] start_s;
  reg  [SUM_W-1:0] sum_t_q;
  reg  [SUM_W-1:0] sum_s_q;

  ffd_num_widen #(
    .FORMAT(FORMAT)
  ) u_start_u (
    .point_i(base_u_q & {POINT_W{whole_u_i}}),
    .shift_i(2'd0),
    .sum_o  (start_u)
  );

  ffd_num_widen #(
    .FORMAT(FORMAT)
  ) u_start_t (
    .point_i(of_t & {POINT_W{whole_t_i}}),
    .shift_i(2'd0),
    .sum_o  (start_t)
  );

  ffd_num_widen #(
    .FORMAT(FORMAT)
  ) u_start_s (
    .point_i(of_s_q & {POINT_W{whole_s_i}}),
    .shift_i(2'd0),
    .sum_o  (start_s)
  );

  always @(posedge clk) begin
    if (begin_t_i) sum_t_q <= start_t;
    else if (keep_sum_t_i) sum_t_q <= sum_o;
    if (begin_s_i) sum_s_q <= start_s;
    else if (keep_sum_s_i) sum_s_q <= sum_o;
  end

  wire [SUM_W-1:0] augend = sum_of_u_i ? (sum_begins_u_i ? start_u : sum_o)
                                       : (sum_of_s_i ? sum_s_q : sum_t_q);

  ffd_num_add #(
    .FORMAT (FORMAT),
    .LATENCY(1)
  ) u_add (
    .clk  (clk),
    .a_i  (augend),
    .b_i  (term),
    .sum_o(sum_o)
  );

  ffd_num_narrow #(
    .FORMAT (FORMAT),
    .LATENCY(CONVERT_LATENCY)
  ) u_narrow (
    .clk    (clk),
    .sum_i  (sum_o),
    .point_o(narrowed)
  );

  ffd_num_delay #(
    .WIDTH  (POINT_W),
    .LATENCY(DELAY)
  ) u_of_t (
    .clk(clk),
    .rst(1'b0),
    .d_i(narrowed),
    .q_o(of_t)
  );
endmodule

`default_nettype wire
