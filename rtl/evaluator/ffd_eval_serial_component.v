// ffd_eval_serial_component: a component of ffd_eval_serial: one multiplier, a point a clock
//
// Points come bank by bank, the base of each four first. While it comes the multiplier is free, and
// works on the axis above, of which every fourth such clock is free for the one above that:
//
//   clock of a group of four    0: base      1      2      3
//   multiplication along        t, or s      u      u      u
//
// A sum begins with its base, which came as the subtrahend of its first offset, and with the half
// that rounds it. Those of t and s wait in a memory between their terms.
//
// Formats, rounding: those of ffd_num_offset and ffd_num_offset_term, and of ffd_num_narrow,
//             as in ffd_eval_affine: sums are exact, so their order does not matter.
// Pipeline:   point | 1: offset, weight | MUL_LATENCY: term | 1: sum | CONVERT_LATENCY: point of
//             the axis above | DELAY. One clock, the phases of all stages, comes from outside.
// Freezes:    never.
// Parameters: FORMAT 8 to 32; MUL_LATENCY >= 1; CONVERT_LATENCY, DELAY >= 0: together with
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
  // Of the stage of points.
  input  wire                                base_i,         // of u: nothing is multiplied along u
  input  wire                                of_s_i,         // where base_i: along s, else along t
  input  wire                                begin_t_i,      // this is its base
  input  wire                                begin_s_i,
  input  wire                                keep_s_i,       // what s takes next has been narrowed
  // Of a clock before the stage of sums: what the term is added to, else to the sum before it.
  input  wire                                add_base_i,
  input  wire                                add_nothing_i,  // a base that is left out
  input  wire                                add_half_i,     // with a base: it will be narrowed
  input  wire                                add_shadow_i,     // the last sum of t or s
  input  wire                                shadow_of_s_i,
  // A clock after the stage of sums.
  input  wire                                keep_i,
  input  wire                                keep_of_s_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]       sum_o
);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam OFFSET_W = `FFD_OFFSET_W(FORMAT);
  localparam SUM_W    = `FFD_SUM_W(FORMAT);

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

  // ---- sums; what is not added is cleared, so that the choice is an OR

  wire [POINT_W-1:0] late_base;
  reg  [POINT_W-1:0] base_q;
  wire [SUM_W-1:0]   start;
  wire [SUM_W-1:0]   shadow;
  reg  [SUM_W-1:0]   shadow_q;
  reg                half_q;
  reg                go_on_q;

  ffd_num_delay #(
    .WIDTH  (POINT_W),
    .LATENCY(MUL_LATENCY)
  ) u_late_base (
    .clk(clk),
    .rst(1'b0),
    .d_i(base),
    .q_o(late_base)
  );

  ffd_mem_sdp #(
    .WIDTH       (SUM_W),
    .DEPTH       (2),
    .READ_LATENCY(0)
  ) u_shadow (
    .clk            (clk),
    .write_i        (keep_i),
    .write_address_i(keep_of_s_i),
    .write_data_i   (sum_o),
    .read_i         (1'b1),
    .read_address_i (shadow_of_s_i),
    .read_data_o    (shadow)
  );

  always @(posedge clk) begin
    if (!add_base_i || add_nothing_i) base_q <= {POINT_W{1'b0}};
    else base_q <= late_base;
    if (!add_shadow_i) shadow_q <= {SUM_W{1'b0}};
    else shadow_q <= shadow;
    half_q  <= add_base_i && add_half_i;
    go_on_q <= !add_base_i && !add_shadow_i;
  end

  ffd_num_begin #(
    .FORMAT(FORMAT)
  ) u_start (
    .point_i(base_q),
    .half_i (half_q),
    .sum_o  (start)
  );

  ffd_num_add #(
    .FORMAT (FORMAT),
    .LATENCY(1)
  ) u_add (
    .clk  (clk),
    .a_i  (start | shadow_q | (sum_o & {SUM_W{go_on_q}})),
    .b_i  (term),
    .sum_o(sum_o)
  );

  ffd_num_cut #(
    .FORMAT (FORMAT),
    .LATENCY(CONVERT_LATENCY)
  ) u_cut (
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
