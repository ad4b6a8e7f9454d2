// ffd_eval_poly_bspline: the pipelined evaluator with the uniform cubic B-spline wired in
//
// What the paper's section 3.3.3 starts from: a predetermined evaluator. It stands beside the
// general one so that the price of generality can be measured. What is loaded is ignored; the bits
// are those of ffd_eval_poly_pipelined with the watertight B-spline and its derivative loaded.
//
// Formats, rounding: those of ffd_num_step; the shift is 0, so there is none of ffd_num_scale.
// Pipeline:   3 steps + CONVERT_LATENCY, II 1, never frozen; no file is read. step_k holds power
//             2 - k and needs its coefficient k steps after the start.
// Parameters: FORMAT as in ffd_num.vh, latencies >= 1 (CONVERT_LATENCY >= 0), ADDRESS_W >= 4: the
//             low four bits of an address are {derivative, bank, function}.
// Model:      golden/include/hwffd/model/hard_wired.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_poly_bspline #(
  parameter FORMAT          = 18,
  parameter MUL_LATENCY     = 1,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 0,
  parameter ADDRESS_W       = 4
) (
  input  wire                                            clk,
  input  wire                                            load_i,
  input  wire [ADDRESS_W-1:0]                            load_address_i,
  input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]                coordinate_i,
  input  wire [ADDRESS_W-1:0]                            address_i,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]                weight_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam STEP     = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);

  wire [WEIGHT_W-1:0] leading;

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : gen_step
      wire [WEIGHT_W-1:0] coordinate;
      wire [WEIGHT_W-1:0] coefficient;
      wire [2:0]          blending;  // {derivative, function}
      wire [WEIGHT_W-1:0] weight;
      wire [WEIGHT_W-1:0] weight_next;

      if (k == 0) begin : gen_first
        assign coordinate = coordinate_i;
        assign blending   = {address_i[3], address_i[1:0]};
        assign weight     = leading;
      end else begin : gen_next
        assign weight = gen_step[k-1].weight_next;
        ffd_num_delay #(
          .WIDTH  (WEIGHT_W),
          .LATENCY(STEP)
        ) u_coordinate (
          .clk(clk),
          .rst(1'b0),
          .d_i(gen_step[k-1].coordinate),
          .q_o(coordinate)
        );
        ffd_num_delay #(
          .WIDTH  (3),
          .LATENCY(STEP)
        ) u_blending (
          .clk(clk),
          .rst(1'b0),
          .d_i(gen_step[k-1].blending),
          .q_o(blending)
        );
      end

      ffd_num_bspline #(
        .FORMAT(FORMAT),
        .POWER (2 - k)
      ) u_coefficient (
        .derivative_i (blending[2]),
        .function_i   (blending[1:0]),
        .coefficient_o(coefficient)
      );

      ffd_num_step #(
        .FORMAT     (FORMAT),
        .MUL_LATENCY(MUL_LATENCY),
        .ADD_LATENCY(ADD_LATENCY),
        .FMA_LATENCY(FMA_LATENCY)
      ) u_step (
        .clk          (clk),
        .coefficient_i(coefficient),
        .coordinate_i (coordinate),
        .weight_i     (weight),
        .weight_o     (weight_next)
      );
    end
  endgenerate

  ffd_num_bspline #(
    .FORMAT(FORMAT),
    .POWER (3)
  ) u_leading (
    .derivative_i (address_i[3]),
    .function_i   (address_i[1:0]),
    .coefficient_o(leading)
  );

  ffd_num_delay #(
    .WIDTH  (WEIGHT_W),
    .LATENCY(CONVERT_LATENCY)
  ) u_convert (
    .clk(clk),
    .rst(1'b0),
    .d_i(gen_step[2].weight_next),
    .q_o(weight_o)
  );

  wire unused_ok = &{1'b0, load_i, load_address_i, load_entry_i, address_i};
endmodule

`default_nettype wire
