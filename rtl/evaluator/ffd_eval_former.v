// ffd_eval_former: the 64 coefficient vectors of a cell, from control points and coefficients
//
//   c_ijk = sum_l M_il (sum_m M_jm (sum_n M_kn P_lmn)),  M_kl = sum_j c_lj binom(j, k) / 2^j
//
// M_kl is the coefficient of (2x - 1)^k in blending function l of the axis. One contraction of four
// terms a component (12 multipliers) does it all, an output a clock, in four phases:
//
//   phase  contracts                 steps    digits   kept
//   0      powers of x, all axes     16       l, k     M, by bank l
//   1      points along u            64       m, l, k  lane m, row (l, k)
//   2      phase 1 along t           64       l, k, j  lane l, row (k, j)
//   3      phase 2 along s           64       k, j, i  the coefficients
//
// Lane and row are the digits as they are: each phase reads the rows (the two digits above its
// last) of what the one before has written. l, m, n are banks; function (bank - cell) mod 4 of an
// axis is fetched for them, so no point is moved.
//
// Formats:    M is a weight, its shift undone. A contraction along an axis whose functions have a
//             shift, so may grow, is halved in fxW, the first two of them: write_halvings_o
//             (docs/numerics.md section 3).
// Pipeline:   phases do not overlap: start_i | 208 + 4 (READ_LATENCY + FFD_CONTRACT_LATENCY)
//             clocks, the last one with done_o; the last 64 have a vector, announced a clock ahead
//             by write_o.
// Freezes:    never. cell, source and bank hold from start_i to done_o.
// Parameters: those of every organization with N 4. With SPANS above 1 a
//             function is asked for a clock earlier, with the same clocks in all.
// Model:      golden/include/hwffd/model/org_nested.hpp (form).  Test: tests/evaluator.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_former #(
  parameter FORMAT          = 18,
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 1,
  parameter READ_LATENCY    = 2,
  parameter SOURCE_W        = 2,
  parameter SPANS           = 1
) (
  input  wire                                            clk,
  input  wire                                            rst,
  input  wire                                            load_i,
  input  wire [1:0]                                      load_axis_i,
  input  wire [`FFD_OWN_W(SPANS)-1:0]                    load_address_i,
  input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,
  input  wire                                            start_i,
  input  wire [11:0]                                     cell_i,
  input  wire [SOURCE_W-1:0]                             source_i,
  input  wire [3*`FFD_PLACE_W(SPANS)-1:0]                bank_i,
  output wire                                            done_o,
  output wire                                            read_o,
  output wire                                            read_last_o,
  output wire [SOURCE_W-1:0]                             read_source_o,
  output wire [11:0]                                     read_cell_o,
  output wire [5:0]                                      read_index_o,
  input  wire [4*3*`FFD_POINT_W(FORMAT)-1:0]             read_points_i,
  output wire                                            write_o,
  output wire [5:0]                                      write_index_o,
  output wire [3*`FFD_POINT_W(FORMAT)-1:0]               write_vector_o,
  output wire [1:0]                                      write_halvings_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam SUM_W    = `FFD_SUM_W(FORMAT);
  localparam TREE     = `FFD_TREE_LATENCY(4, MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);

  localparam PLACE_W  = `FFD_PLACE_W(SPANS);
  localparam FILE     = SPANS > 1 ? 1 : 0;  // registers of reading a function

  localparam [1:0] POWERS  = 2'd0;
  localparam [1:0] ALONG_U = 2'd1;
  localparam [1:0] ALONG_T = 2'd2;
  localparam [1:0] ALONG_S = 2'd3;

  // ---- phases: the steps of one are issued, then it drains

  reg        issue_q;
  reg  [1:0] phase_q;
  reg  [5:0] step_q;
  wire       last = step_q == (phase_q == POWERS ? 6'd15 : 6'd63);
  wire       drained;  // the last result of the phase is being kept

  always @(posedge clk) begin
    if (rst) issue_q <= 1'b0;
    else if (start_i) issue_q <= 1'b1;
    else if (issue_q) issue_q <= !last;
    else issue_q <= drained && phase_q != ALONG_S;
  end
  always @(posedge clk) begin
    if (start_i) phase_q <= POWERS;
    else if (drained) phase_q <= phase_q + 2'd1;
    if (!issue_q) step_q <= 6'd0;
    else step_q <= step_q + 6'd1;
  end

  assign read_o        = issue_q && phase_q == ALONG_U;
  assign read_last_o   = read_o && last;
  assign read_source_o = source_i;
  assign read_cell_o   = cell_i;
  assign read_index_o  = {step_q[3:2], step_q[5:4], 2'd0};

  // ---- the step at which operands, sums (two clocks before they come) and results are

  wire       keep_next;
  wire       last_next;
  wire       store;
  wire [5:0] ask_step;  // whose coefficients are asked for
  wire [5:0] fetch_step;
  wire [5:0] near_step;
  wire [5:0] next_step;
  wire [5:0] keep_step;

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(READ_LATENCY + TREE + CONVERT_LATENCY - 1),
    .RESET  (1)
  ) u_keep_next (
    .clk(clk),
    .rst(rst),
    .d_i({issue_q, issue_q && last}),
    .q_o({keep_next, last_next})
  );
  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(1),
    .RESET  (1)
  ) u_store (
    .clk(clk),
    .rst(rst),
    .d_i({keep_next, last_next}),
    .q_o({store, drained})
  );
  ffd_num_delay #(
    .WIDTH  (6),
    .LATENCY(READ_LATENCY - FILE)
  ) u_ask_step (
    .clk(clk),
    .rst(1'b0),
    .d_i(step_q),
    .q_o(ask_step)
  );
  ffd_num_delay #(
    .WIDTH  (6),
    .LATENCY(FILE)
  ) u_fetch_step (
    .clk(clk),
    .rst(1'b0),
    .d_i(ask_step),
    .q_o(fetch_step)
  );
  ffd_num_delay #(
    .WIDTH  (6),
    .LATENCY(TREE - 2 - FILE)
  ) u_near_step (
    .clk(clk),
    .rst(1'b0),
    .d_i(fetch_step),
    .q_o(near_step)
  );
  ffd_num_delay #(
    .WIDTH  (6),
    .LATENCY(CONVERT_LATENCY + 1 + FILE)
  ) u_next_step (
    .clk(clk),
    .rst(1'b0),
    .d_i(near_step),
    .q_o(next_step)
  );
  ffd_num_delay #(
    .WIDTH  (6),
    .LATENCY(1)
  ) u_keep_step (
    .clk(clk),
    .rst(1'b0),
    .d_i(next_step),
    .q_o(keep_step)
  );

  // ---- what is kept: M of a bank, {u, t, s} at row k, and the lanes of phases 1 and 2

  wire [3*POINT_W-1:0]    results;
  wire [4*3*WEIGHT_W-1:0] matrix;
  wire [4*3*POINT_W-1:0]  lanes;

  genvar b;
  generate
    for (b = 0; b < 4; b = b + 1) begin : gen_lane
      localparam [1:0] BANK = b;

      ffd_mem_sdp #(
        .WIDTH       (3 * WEIGHT_W),
        .DEPTH       (4),
        .READ_LATENCY(0)
      ) u_matrix (
        .clk            (clk),
        .write_i        (store && phase_q == POWERS && keep_step[3:2] == BANK),
        .write_address_i(keep_step[1:0]),
        .write_data_i   (results),
        .read_i         (1'b1),
        .read_address_i (fetch_step[1:0]),
        .read_data_o    (matrix[3*b*WEIGHT_W +: 3*WEIGHT_W])
      );

      // Two sets of 16 rows: phase 2 reads those of phase 1 and writes those of phase 3.
      ffd_mem_sdp #(
        .WIDTH       (3 * POINT_W),
        .DEPTH       (32),
        .READ_LATENCY(0)
      ) u_rows (
        .clk            (clk),
        .write_i        (store && (phase_q == ALONG_U || phase_q == ALONG_T) &&
                         keep_step[5:4] == BANK),
        .write_address_i({phase_q == ALONG_T, keep_step[3:0]}),
        .write_data_i   (results),
        .read_i         (1'b1),
        .read_address_i ({phase_q == ALONG_S, fetch_step[5:2]}),
        .read_data_o    (lanes[3*b*POINT_W +: 3*POINT_W])
      );
    end
  endgenerate

  // ---- weights: binom(j, k) / 2^j, or row k of the axis's M

  wire [4*WEIGHT_W-1:0] weights;

  generate
    for (b = 0; b < 4; b = b + 1) begin : gen_weight
      wire [WEIGHT_W-1:0]   binomial;
      wire [3*WEIGHT_W-1:0] own = matrix[3*b*WEIGHT_W +: 3*WEIGHT_W];

      ffd_num_binomial #(
        .FORMAT(FORMAT),
        .POWER (b)
      ) u_binomial (
        .power_i (fetch_step[1:0]),
        .weight_o(binomial)
      );
      assign weights[b*WEIGHT_W +: WEIGHT_W] =
          phase_q == POWERS  ? binomial :
          phase_q == ALONG_U ? own[2*WEIGHT_W +: WEIGHT_W] :
          phase_q == ALONG_T ? own[1*WEIGHT_W +: WEIGHT_W] : own[0 +: WEIGHT_W];
    end
  endgenerate

  // ---- which contractions are halved

  wire [2:0] grows;  // {u, t, s}
  wire       twice  = grows[2] && grows[1];
  wire       halve  = phase_q == ALONG_U ? grows[2] :
                      phase_q == ALONG_T ? grows[1] : grows[0] && !twice;
  assign write_halvings_o = {1'b0, grows[2]} + {1'b0, grows[1]} + {1'b0, grows[0] && !twice};

  // ---- points, a component or in phase 0 an axis at a time; their contraction

  genvar c;
  generate
    for (c = 0; c < 3; c = c + 1) begin : gen_component
      wire [4*WEIGHT_W-1:0] coefficients;
      wire [4*POINT_W-1:0]  points;
      wire [1:0]            shift;
      wire [1:0]            blending      = ask_step[3:2] - cell_i[4*c +: 2];
      wire [1:0]            blending_near = phase_q == POWERS ? near_step[3:2] - cell_i[4*c +: 2]
                                                              : 2'd0;
      wire [SUM_W-1:0]      sum;
      reg        [1:0]      shift_q;
      reg signed [2:0]      scale_q;
      assign grows[c] = shift_q != 2'd0;
      always @(posedge clk) begin
        shift_q <= shift;
        scale_q <= phase_q == POWERS ? {1'b0, shift_q} : {3{halve}};
      end

      ffd_eval_coefficient_file #(
        .FORMAT      (FORMAT),
        .READ_LATENCY(FILE),
        .ADDRESS_W   (`FFD_OWN_W(SPANS))
      ) u_file (
        .clk            (clk),
        .load_i         (load_i && load_axis_i == c),
        .load_address_i (load_address_i),
        .load_entry_i   (load_entry_i),
        .address_i      ({4{bank_i[PLACE_W*c +: PLACE_W], blending}}),
        .coefficient_o  (coefficients),
        .shift_address_i({bank_i[PLACE_W*c +: PLACE_W], blending_near}),
        .shift_o        (shift)
      );

      for (b = 0; b < 4; b = b + 1) begin : gen_point
        assign points[b*POINT_W +: POINT_W] =
            phase_q == POWERS  ? coefficients[b*WEIGHT_W +: WEIGHT_W] :
            phase_q == ALONG_U ? read_points_i[(3*b+c)*POINT_W +: POINT_W] :
                                 lanes[(3*b+c)*POINT_W +: POINT_W];
      end

      ffd_eval_tree #(
        .FORMAT     (FORMAT),
        .N          (4),
        .MUL_LATENCY(MUL_LATENCY),
        .ADD_LATENCY(ADD_LATENCY),
        .FMA_LATENCY(FMA_LATENCY)
      ) u_tree (
        .clk      (clk),
        .weights_i(weights),
        .points_i (points),
        .sum_o    (sum)
      );

      ffd_num_rescale #(
        .FORMAT (FORMAT),
        .LATENCY(CONVERT_LATENCY)
      ) u_rescale (
        .clk    (clk),
        .sum_i  (sum),
        .shift_i(scale_q),
        .point_o(results[c*POINT_W +: POINT_W])
      );
    end
  endgenerate

  assign write_o        = keep_next && phase_q == ALONG_S;
  assign write_index_o  = next_step;
  assign write_vector_o = results;
  assign done_o         = drained && phase_q == ALONG_S;

  wire unused_ok = &{1'b0, near_step[5:4], near_step[1:0], cell_i};
endmodule

`default_nettype wire
