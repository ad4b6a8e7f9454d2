// ffd_eval_poly: the polynomial evaluator: pipelined or iterative
//
// Pipeline:   FFD_POLY_LATENCY; starts are FFD_POLY_INTERVAL clocks apart, or a multiple of it. All
//             but the iterative form need no start and give a weight for every clock.
// Parameters: EVALUATOR as in ffd_eval.vh; FILE_LATENCY 0 or 1, clocks of reading a coefficient,
//             iterative also 2; the others as in each form.
// Model:      golden/include/hwffd/model/coefficients.hpp (polynomial).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_poly #(
  parameter FORMAT          = 18,
  parameter EVALUATOR       = `FFD_EVALUATOR_PIPELINED,
  parameter FILE_LATENCY    = 0,
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
  input  wire                                            start_i,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]                coordinate_i,
  input  wire [ADDRESS_W-1:0]                            address_i,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]                weight_o
);
  generate
    if (EVALUATOR != `FFD_EVALUATOR_PIPELINED && EVALUATOR != `FFD_EVALUATOR_ITERATIVE)
    begin : gen_bad_evaluator
      ERROR_ffd_eval_poly_evaluator_must_be_0_or_1 u_error ();
    end
    if (FILE_LATENCY < 0 || FILE_LATENCY > (EVALUATOR == `FFD_EVALUATOR_ITERATIVE ? 2 : 1))
    begin : gen_bad_file_latency
      ERROR_ffd_eval_poly_file_latency_must_be_0_or_1_iterative_2 u_error ();
    end
  endgenerate

  // The coordinate waits for the first coefficients.
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  wire [WEIGHT_W-1:0] coordinate;

  ffd_num_delay #(
    .WIDTH  (WEIGHT_W),
    .LATENCY(FILE_LATENCY)
  ) u_coordinate (
    .clk(clk),
    .rst(1'b0),
    .d_i(coordinate_i),
    .q_o(coordinate)
  );

  generate
    if (EVALUATOR == `FFD_EVALUATOR_ITERATIVE) begin : gen_iterative
      ffd_eval_poly_iterative #(
        .FORMAT         (FORMAT),
        .FILE_LATENCY   (FILE_LATENCY),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .ADDRESS_W      (ADDRESS_W)
      ) u_poly (
        .clk           (clk),
        .load_i        (load_i),
        .load_address_i(load_address_i),
        .load_entry_i  (load_entry_i),
        .start_i       (start_i),
        .coordinate_i  (coordinate),
        .address_i     (address_i),
        .weight_o      (weight_o)
      );
    end else begin : gen_pipelined
      ffd_eval_poly_pipelined #(
        .FORMAT         (FORMAT),
        .FILE_LATENCY   (FILE_LATENCY),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .ADDRESS_W      (ADDRESS_W)
      ) u_poly (
        .clk           (clk),
        .load_i        (load_i),
        .load_address_i(load_address_i),
        .load_entry_i  (load_entry_i),
        .coordinate_i  (coordinate),
        .address_i     (address_i),
        .weight_o      (weight_o)
      );
      wire unused_ok = &{1'b0, start_i};
    end
  endgenerate
endmodule

`default_nettype wire
