// ffd_eval_trivariate: a vertex within a cell, from the 64 coefficient vectors of the cell
//
//   q = sum_i sigma^i (sum_j tau^j (sum_k upsilon^k c_ijk)),  sigma = 2s - 1, tau, upsilon likewise
//
// by Horner's rule, upsilon first: 16 cubics, then 4, then 1, which is 63 steps a component. A
// cubic starts when its successor wants its value (ffd_eval_horner), so only coordinates are
// delayed, once for all units. The coefficients stand still while a vertex is inside.
//
// A step computes 3 / FOLD components of a vertex. Folded by three, a vertex is three steps one
// after the other, x first.
//
// Formats:    coefficients and values are points, halved as often as write_halvings_i says (fxW);
//             the steps take them for weights. Rounding: docs/numerics.md section 4.
// Pipeline:   step | ADD_LATENCY: centred | 9 FFD_STEP_LATENCY: sum. II 1 step.
//             A vector comes a clock behind its write_i.
// Freezes:    never.
// Not checked: that no vertex is inside when a coefficient is written.
// Parameters: FOLD 1 or 3; the others as in every organization.
// Model:      golden/include/hwffd/model/org_nested.hpp.  Test: tests/evaluator.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_eval_trivariate #(
  parameter FOLD        = 1,
  parameter FORMAT      = 18,
  parameter MUL_LATENCY = 2,
  parameter ADD_LATENCY = 1,
  parameter FMA_LATENCY = 0
) (
  input  wire                                clk,
  input  wire                                rst,
  input  wire                                write_i,
  input  wire [5:0]                          write_index_i,
  input  wire [3*`FFD_POINT_W(FORMAT)-1:0]   write_vector_i,
  input  wire [1:0]                          write_halvings_i,
  input  wire                                step_valid_i,
  input  wire                                step_last_i,
  input  wire [1:0]                          step_component_i,
  input  wire [3*`FFD_WEIGHT_W(FORMAT)-1:0]  step_coordinates_i,
  output wire                                result_valid_o,
  output wire [3*`FFD_SUM_W(FORMAT)-1:0]     result_sum_o
);
  localparam WEIGHT_W   = `FFD_WEIGHT_W(FORMAT);
  localparam SUM_W      = `FFD_SUM_W(FORMAT);
  localparam COMPONENTS = 3 / FOLD;
  localparam STEP       = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);
  localparam JOIN       = `FFD_STEP_JOIN(MUL_LATENCY, FMA_LATENCY);
  localparam LATENCY    = 9 * STEP;  // from the centred coordinates on
  localparam LINE_W     = 2 + 3 * WEIGHT_W;

  generate
    if (FOLD != 1 && FOLD != 3) begin : gen_bad_fold
      ERROR_ffd_eval_trivariate_fold_must_be_1_or_3 u_error ();
    end
  endgenerate

  // ---- the coefficients of the cell: (i, j, k) at index 16 k + 4 j + i

  genvar e;
  generate
    for (e = 0; e < 64; e = e + 1) begin : gen_coefficient
      localparam [5:0] INDEX = e;
      reg                  write_q;
      reg [3*WEIGHT_W-1:0] vector_q;
      always @(posedge clk) begin
        write_q <= write_i && write_index_i == INDEX;
        if (write_q) vector_q <= write_vector_i;
      end
    end
  endgenerate

  reg [1:0] halvings_q;
  always @(posedge clk) begin
    if (write_i) halvings_q <= write_halvings_i;
  end

  // ---- coordinates, and which component, at every clock in which a unit wants them

  wire [3*WEIGHT_W-1:0] centred;
  wire [1:0]            early_component;
  reg  [1:0]            step_component;

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      ffd_num_centre #(
        .FORMAT (FORMAT),
        .LATENCY(ADD_LATENCY)
      ) u_centre (
        .clk         (clk),
        .coordinate_i(step_coordinates_i[a*WEIGHT_W +: WEIGHT_W]),
        .centred_o   (centred[a*WEIGHT_W +: WEIGHT_W])
      );
    end
  endgenerate

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(ADD_LATENCY - 1)
  ) u_component (
    .clk(clk),
    .rst(1'b0),
    .d_i(step_component_i),
    .q_o(early_component)
  );
  always @(posedge clk) step_component <= early_component;

  genvar t;
  generate
    for (t = 0; t < LATENCY; t = t + 1) begin : gen_after
      wire [1:0]          component;
      wire [WEIGHT_W-1:0] sigma;
      wire [WEIGHT_W-1:0] tau;
      wire [WEIGHT_W-1:0] upsilon;
      if (t == 0) begin : gen_now
        assign {component, upsilon, tau, sigma} = {step_component, centred};
      end else begin : gen_later
        reg [LINE_W-1:0] line_q;
        always @(posedge clk) begin
          line_q <= {gen_after[t-1].component, gen_after[t-1].upsilon, gen_after[t-1].tau,
                     gen_after[t-1].sigma};
        end
        assign {component, upsilon, tau, sigma} = line_q;
      end
      wire unused_ok = &{1'b0, component, sigma, tau, upsilon};
    end
  endgenerate

  // ---- 16 cubics in upsilon, 4 in tau, 1 in sigma. Cubic p of four is wanted at
  //      (p == 3 ? 0 : (2 - p) STEP + JOIN) after the one that takes their values has started.

  wire [COMPONENTS*SUM_W-1:0] sums;

  genvar c;
  genvar i;
  genvar j;
  genvar k;
  generate
    for (c = 0; c < COMPONENTS; c = c + 1) begin : gen_component
      wire [4*WEIGHT_W-1:0] of_sigma;
      wire [WEIGHT_W-1:0]   value;

      for (i = 0; i < 4; i = i + 1) begin : gen_i
        localparam START_I = i == 3 ? 0 : (2 - i) * STEP + JOIN;
        localparam TAU     = START_I + 3 * STEP;
        wire [4*WEIGHT_W-1:0] of_tau;

        for (j = 0; j < 4; j = j + 1) begin : gen_j
          localparam START = START_I + (j == 3 ? 0 : (2 - j) * STEP + JOIN);
          wire [4*WEIGHT_W-1:0] of_upsilon;

          for (k = 0; k < 4; k = k + 1) begin : gen_k
            localparam AT = START + (k == 3 ? 0 : (2 - k) * STEP + JOIN);
            if (FOLD == 1) begin : gen_own
              assign of_upsilon[k*WEIGHT_W +: WEIGHT_W] =
                  gen_coefficient[16*k+4*j+i].vector_q[c*WEIGHT_W +: WEIGHT_W];
            end else begin : gen_in_turn
              // Chosen a clock before it is wanted.
              wire [3*WEIGHT_W-1:0] vector = gen_coefficient[16*k+4*j+i].vector_q;
              wire [1:0]            component;
              reg  [WEIGHT_W-1:0]   own_q;
              if (AT == 0) begin : gen_at_once
                assign component = early_component;
              end else begin : gen_later
                assign component = gen_after[AT-1].component;
              end
              always @(posedge clk) begin
                own_q <= component == 2'd0 ? vector[0*WEIGHT_W +: WEIGHT_W] :
                         component == 2'd1 ? vector[1*WEIGHT_W +: WEIGHT_W] :
                                             vector[2*WEIGHT_W +: WEIGHT_W];
              end
              assign of_upsilon[k*WEIGHT_W +: WEIGHT_W] = own_q;
            end
          end

          ffd_eval_horner #(
            .FORMAT     (FORMAT),
            .MUL_LATENCY(MUL_LATENCY),
            .ADD_LATENCY(ADD_LATENCY),
            .FMA_LATENCY(FMA_LATENCY)
          ) u_upsilon (
            .clk           (clk),
            .coefficients_i(of_upsilon),
            .coordinate_i  ({gen_after[START+2*STEP].upsilon, gen_after[START+STEP].upsilon,
                             gen_after[START].upsilon}),
            .value_o       (of_tau[j*WEIGHT_W +: WEIGHT_W])
          );
        end

        ffd_eval_horner #(
          .FORMAT     (FORMAT),
          .MUL_LATENCY(MUL_LATENCY),
          .ADD_LATENCY(ADD_LATENCY),
          .FMA_LATENCY(FMA_LATENCY)
        ) u_tau (
          .clk           (clk),
          .coefficients_i(of_tau),
          .coordinate_i  ({gen_after[TAU+2*STEP].tau, gen_after[TAU+STEP].tau,
                           gen_after[TAU].tau}),
          .value_o       (of_sigma[i*WEIGHT_W +: WEIGHT_W])
        );
      end

      ffd_eval_horner #(
        .FORMAT     (FORMAT),
        .MUL_LATENCY(MUL_LATENCY),
        .ADD_LATENCY(ADD_LATENCY),
        .FMA_LATENCY(FMA_LATENCY)
      ) u_sigma (
        .clk           (clk),
        .coefficients_i(of_sigma),
        .coordinate_i  ({gen_after[8*STEP].sigma, gen_after[7*STEP].sigma,
                         gen_after[6*STEP].sigma}),
        .value_o       (value)
      );

      ffd_num_widen #(
        .FORMAT(FORMAT)
      ) u_widen (
        .point_i(value),
        .shift_i(halvings_q),
        .sum_o  (sums[c*SUM_W +: SUM_W])
      );
    end
  endgenerate

  // ---- the result

  wire sum_valid;
  wire sum_last;

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(ADD_LATENCY + LATENCY),
    .RESET  (1)
  ) u_sum_valid (
    .clk(clk),
    .rst(rst),
    .d_i({step_valid_i, step_last_i}),
    .q_o({sum_valid, sum_last})
  );

  generate
    if (FOLD == 1) begin : gen_whole
      assign result_sum_o = sums;
    end else begin : gen_collect
      reg [2*SUM_W-1:0] before_q;
      always @(posedge clk) before_q <= {sums, before_q[SUM_W +: SUM_W]};
      assign result_sum_o = {sums, before_q};
    end
  endgenerate

  assign result_valid_o = sum_valid && sum_last;
endmodule

`default_nettype wire
