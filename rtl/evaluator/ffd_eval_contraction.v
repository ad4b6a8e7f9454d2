// ffd_eval_contraction: from blending weights to the vertex, one axis at a time: 64 -> 16 -> 4 -> 1
//
//   q = sum_l B_l(s) (sum_m B_m(t) (sum_n B_n(u) P_lmn))
//
// 84 multiplications a component in place of 64 and the products of weights. u comes first: its
// banks run fastest, so the points of one sum lie side by side and all additions are those of a
// tree of 64, pair by pair. Between contractions a sum becomes a point again (ffd_num_narrow).
//
// Unfolded, a step takes the 64 points of a vertex. Folded by three, it takes a component of them,
// x first; the points are read once, and y and z wait here. With N 32 they are read in two halves,
// the banks of s that come last first, and what is done with the second half is a clock behind
// until both meet along s: so a store of 32 banks is enough, which is read in two of three clocks.
// Folded by two, it takes 32 of the
// banks, those of s that come last first, and the last sum of four is made in halves
// (ffd_eval_halves). Folded by six, it is both, x, y and z of a half one after the other. Folded by
// four, it takes 16 of the banks, from the last of s to the first, and the last sum is made one
// term after the other (ffd_eval_quarters).
//
// With the Jacobian there are derivative weights too, and a pass gives four sums: q, dq/ds, dq/dt
// and dq/du. They share what they have in common: along u there are two sums of each four points,
// along t three, along s four. Chain 0 is that of q, whose every sum has a companion with the
// derivative weights; that is the next axis' chain 1, whose sums are the next axis' chain 2.
//
// Formats, rounding: those of the number layer; docs/numerics.md section 4.
// Pipeline:   step: the read | READ_LATENCY: points, weights of u | FFD_CONTRACT_LATENCY: weights
//             of t | FFD_CONTRACT_LATENCY: weights of s | FFD_TREE_LATENCY: sum. II 1 step. Read in
//             halves, a clock more.
// Freezes:    never.
// Parameters: FOLD 1, 2, 3, 4 or 6; AFFINE 1: by differences (ffd_eval_affine), the weights
//             ADD_LATENCY clocks after the points, FOLD 4 only so; JACOBIAN 1: four sums, FOLD 1 or
//             3; N 64 / FFD_FOLD_PARTS, of FOLD 3 also 32; the others as in every organization.
// Model:      golden/include/hwffd/model/org_factored.hpp, org_affine.hpp.  Test: tests/evaluator.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_contraction #(
  parameter FOLD            = 1,
  parameter AFFINE          = 0,
  parameter JACOBIAN        = 0,
  parameter FORMAT          = 18,
  parameter N               = 64 / `FFD_FOLD_PARTS(FOLD),
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 1,
  parameter READ_LATENCY    = 2,
  parameter SOURCE_W        = 2
) (
  input  wire                                    clk,
  input  wire                                    rst,
  input  wire                                    step_valid_i,
  input  wire                                    step_reads_i,  // and last: only of valid steps
  input  wire                                    step_last_i,
  input  wire [1:0]                              step_part_i,   // of the banks of s; 0 comes last
  input  wire [SOURCE_W-1:0]                     step_source_i,
  input  wire [11:0]                             step_cell_i,
  input  wire [3*4*`FFD_WEIGHT_W(FORMAT)-1:0]    weights_i,
  input  wire [3*4*`FFD_WEIGHT_W(FORMAT)-1:0]    slopes_i,       // those of the derivatives
  output wire                                    read_o,
  output wire                                    read_last_o,
  output wire [SOURCE_W-1:0]                     read_source_o,
  output wire [11:0]                             read_cell_o,
  output wire [5:0]                              read_index_o,
  input  wire [N*3*`FFD_POINT_W(FORMAT)-1:0]     read_points_i,
  output wire                                    result_valid_o,
  output wire [3*`FFD_RESULTS(JACOBIAN)*`FFD_SUM_W(FORMAT)-1:0] result_sums_o
);
  localparam WEIGHT_W   = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W    = `FFD_POINT_W(FORMAT);
  localparam SUM_W      = `FFD_SUM_W(FORMAT);
  localparam TURNS      = `FFD_FOLD_TURNS(FOLD);
  localparam PARTS      = `FFD_FOLD_PARTS(FOLD);
  localparam RESULTS    = `FFD_RESULTS(JACOBIAN);
  localparam CHAINED    = JACOBIAN != 0 && PARTS == 1;  // else refused, or without
  localparam COMPONENTS = 3 / TURNS;
  localparam CONTRACT   = `FFD_CONTRACT_LATENCY(AFFINE, MUL_LATENCY, ADD_LATENCY, FMA_LATENCY,
                                                CONVERT_LATENCY);
  localparam HALVES     = `FFD_READ_HALVES(FOLD, N);
  localparam LATENCY    = READ_LATENCY + 3 * CONTRACT - CONVERT_LATENCY + HALVES;  // a sum is last

  generate
    if (`FFD_FOLD_BAD(FOLD)) begin : gen_bad_fold
      ERROR_ffd_eval_contraction_fold_must_be_1_2_3_4_or_6 u_error ();
    end
    if (PARTS == 4 && AFFINE == 0) begin : gen_bad_affine
      ERROR_ffd_eval_contraction_folded_by_four_must_be_affine u_error ();
    end
    if (JACOBIAN != 0 && PARTS != 1) begin : gen_bad_jacobian
      ERROR_ffd_eval_contraction_jacobian_wants_whole_cells u_error ();
    end
  endgenerate

  assign read_o        = step_reads_i;
  assign read_last_o   = step_reads_i && step_part_i == 2'd0;
  assign read_index_o  = PARTS == 4 ? {step_part_i, 4'd0} : {step_part_i[0], 5'd0};
  assign read_source_o = step_source_i;
  assign read_cell_o   = step_cell_i;

  wire sum_valid;
  wire sum_last;

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(LATENCY),
    .RESET  (1)
  ) u_sum_valid (
    .clk(clk),
    .rst(rst),
    .d_i({step_valid_i, step_last_i}),
    .q_o({sum_valid, sum_last})
  );

  wire [1:0] first;  // of the steps of what is read, of the lower and the upper half: it is here

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(READ_LATENCY)
  ) u_first (
    .clk(clk),
    .rst(rst),
    .d_i({step_reads_i && (HALVES == 0 || step_part_i[0]),
          step_reads_i && (HALVES == 0 || !step_part_i[0])}),
    .q_o(first)
  );

  // Of the half that is a clock behind, and of what comes after both have met.
  wire [3*4*WEIGHT_W-1:0] late_weights;
  wire [3*4*WEIGHT_W-1:0] late_slopes;

  ffd_num_delay #(
    .WIDTH  (2*3*4*WEIGHT_W),
    .LATENCY(HALVES)
  ) u_late (
    .clk(clk),
    .rst(1'b0),
    .d_i({slopes_i, weights_i}),
    .q_o({late_slopes, late_weights})
  );

  wire [1:0] part;  // along s

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(READ_LATENCY + 2 * CONTRACT)
  ) u_part (
    .clk(clk),
    .rst(1'b0),
    .d_i(step_part_i),
    .q_o(part)
  );

  wire [RESULTS*COMPONENTS*SUM_W-1:0] sums;

  genvar c;
  genvar stage;
  genvar g;
  genvar b;
  genvar n;
  generate
    for (c = 0; c < COMPONENTS; c = c + 1) begin : gen_component
      for (stage = 0; stage < 3; stage = stage + 1) begin : gen_stage
        localparam AXIS = 2 - stage;
        localparam BANKS  = stage == 2 ? 4 / PARTS : 4;
        localparam GROUPS = stage == 2 ? 1 : (16 >> 2 * stage) / PARTS;  // of a chain
        localparam CHAINS = CHAINED ? stage + 1 : 1;
        for (g = 0; g < CHAINS * GROUPS; g = g + 1) begin : gen_group
          localparam CHAIN = g / GROUPS;
          localparam SUMS  = CHAINED && CHAIN == 0 ? 2 : 1;
          // It contracts sums of the axis before: of its chain 0, of chain 1 their companions, of
          // chain 2 those of chain 1.
          localparam BEFORE    = 4 * g - (CHAIN > 0 ? 4 * GROUPS : 0);
          localparam COMPANION = CHAIN == 1 ? 1 : 0;
          // Whether it is of the half that is read first.
          localparam UPPER     = stage < 2 && g % GROUPS >= GROUPS / 2 ? 1 : 0;
          wire [BANKS*POINT_W-1:0] points;
          wire [SUMS*SUM_W-1:0]    sum;
          wire [8*WEIGHT_W-1:0]    weights = UPPER
            ? {slopes_i[4*AXIS*WEIGHT_W +: 4*WEIGHT_W], weights_i[4*AXIS*WEIGHT_W +: 4*WEIGHT_W]}
            : {late_slopes[4*AXIS*WEIGHT_W +: 4*WEIGHT_W],
               late_weights[4*AXIS*WEIGHT_W +: 4*WEIGHT_W]};

          for (b = 0; b < BANKS; b = b + 1) begin : gen_bank
            localparam FIRST = 3 * ((4 * g + b) % N);  // of the components of a point
            // Along s the banks of the half that came first wait for the others.
            localparam WAITS = stage == 2 && b >= 2 ? HALVES : 0;
            wire [POINT_W-1:0] point;
            if (stage > 0) begin : gen_narrow
              wire [POINT_W-1:0] narrowed;
              ffd_num_delay #(
                .WIDTH  (POINT_W),
                .LATENCY(WAITS)
              ) u_point (
                .clk(clk),
                .rst(1'b0),
                .d_i(narrowed),
                .q_o(point)
              );
              ffd_num_narrow #(
                .FORMAT (FORMAT),
                .LATENCY(CONVERT_LATENCY)
              ) u_narrow (
                .clk    (clk),
                .sum_i  (gen_stage[stage-1].gen_group[BEFORE+b].sum[COMPANION*SUM_W +: SUM_W]),
                .point_o(narrowed)
              );
            end else if (TURNS == 1) begin : gen_own
              assign point = read_points_i[(FIRST+c)*POINT_W +: POINT_W];
            end else begin : gen_in_turn
              reg  [2*POINT_W-1:0] rest_q;
              wire [3*POINT_W-1:0] left = first[UPPER] ? read_points_i[FIRST*POINT_W +: 3*POINT_W]
                                                       : {{POINT_W{1'b0}}, rest_q};
              always @(posedge clk) rest_q <= left[3*POINT_W-1:POINT_W];
              assign point = left[POINT_W-1:0];
            end
            assign points[b*POINT_W +: POINT_W] = point;
          end

          if (BANKS == 1) begin : gen_quarters
            ffd_eval_quarters #(
              .FORMAT     (FORMAT),
              .MUL_LATENCY(MUL_LATENCY),
              .ADD_LATENCY(ADD_LATENCY)
            ) u_quarters (
              .clk      (clk),
              .bank_i   (part),
              .weights_i(weights[0 +: 4*WEIGHT_W]),
              .point_i  (points),
              .sum_o    (sum)
            );
            `FFD_ASSERT_TAKES(u_quarters, CONTRACT - CONVERT_LATENCY)
          end else if (BANKS == 2) begin : gen_halves
            ffd_eval_halves #(
              .TURNS      (TURNS),
              .AFFINE     (AFFINE),
              .FORMAT     (FORMAT),
              .MUL_LATENCY(MUL_LATENCY),
              .ADD_LATENCY(ADD_LATENCY),
              .FMA_LATENCY(FMA_LATENCY)
            ) u_halves (
              .clk      (clk),
              .low_i    (part == 2'd0),
              .weights_i(weights[0 +: 4*WEIGHT_W]),
              .points_i (points),
              .sum_o    (sum)
            );
            `FFD_ASSERT_TAKES(u_halves, CONTRACT - CONVERT_LATENCY)
          end else if (AFFINE == 0) begin : gen_trees
            for (n = 0; n < SUMS; n = n + 1) begin : gen_tree
              ffd_eval_tree #(
                .FORMAT     (FORMAT),
                .N          (4),
                .MUL_LATENCY(MUL_LATENCY),
                .ADD_LATENCY(ADD_LATENCY),
                .FMA_LATENCY(FMA_LATENCY)
              ) u_tree (
                .clk      (clk),
                .weights_i(weights[n*4*WEIGHT_W +: 4*WEIGHT_W]),
                .points_i (points),
                .sum_o    (sum[n*SUM_W +: SUM_W])
              );
              `FFD_ASSERT_TAKES(u_tree, CONTRACT - CONVERT_LATENCY)
            end
          end else begin : gen_affine
            ffd_eval_affine #(
              .FORMAT     (FORMAT),
              .SUMS       (SUMS),
              .MUL_LATENCY(MUL_LATENCY),
              .ADD_LATENCY(ADD_LATENCY)
            ) u_affine (
              .clk      (clk),
              .weights_i(weights[0 +: SUMS*4*WEIGHT_W]),
              .points_i (points),
              .sums_o   (sum)
            );
            `FFD_ASSERT_TAKES(u_affine, CONTRACT - CONVERT_LATENCY)
          end
          wire unused_ok = &{1'b0, weights};
        end
      end

      assign sums[c*SUM_W +: SUM_W] = gen_stage[2].gen_group[0].sum[0 +: SUM_W];
      if (CHAINED) begin : gen_jacobian
        assign sums[(1*COMPONENTS+c)*SUM_W +: SUM_W] =
          gen_stage[2].gen_group[0].sum[SUM_W +: SUM_W];
        assign sums[(2*COMPONENTS+c)*SUM_W +: SUM_W] = gen_stage[2].gen_group[1].sum;
        assign sums[(3*COMPONENTS+c)*SUM_W +: SUM_W] = gen_stage[2].gen_group[2].sum;
      end
    end
  endgenerate

  generate
    if (TURNS == 1) begin : gen_whole
      assign result_sums_o = sums;
      wire unused_ok = &{1'b0, first};
    end else begin : gen_collect
      for (n = 0; n < RESULTS; n = n + 1) begin : gen_result
        wire [SUM_W-1:0]  sum = sums[n*SUM_W +: SUM_W];
        reg [2*SUM_W-1:0] before_q;
        always @(posedge clk) before_q <= {sum, before_q[SUM_W +: SUM_W]};
        assign result_sums_o[3*n*SUM_W +: 3*SUM_W] = {sum, before_q};
      end
    end
  endgenerate

  assign result_valid_o = sum_last;  // no step is the last that is none
  wire unused_ok = &{1'b0, part, weights_i, slopes_i, sum_valid};
endmodule

`default_nettype wire
