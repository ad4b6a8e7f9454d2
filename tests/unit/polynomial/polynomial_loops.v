// polynomial_loops: iterative evaluators with steps of LEAST to MOST clocks side by side
//
// All have the same inputs; the coordinate comes with the address. Beside the weights stand what
// the evaluators promise of themselves: clocks between polynomials, and clocks of each.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module polynomial_loops #(
  parameter FORMAT   = 18,
  parameter LEAST    = 2,
  parameter MOST     = 17,
  parameter WEIGHT_W = `FFD_WEIGHT_W(FORMAT)
) (
  input  wire                                clk,
  input  wire                                load_i,
  input  wire [3:0]                          load_address_i,
  input  wire [`FFD_ENTRY_W(WEIGHT_W)-1:0]   load_entry_i,
  input  wire                                start_i,
  input  wire [WEIGHT_W-1:0]                 coordinate_i,
  input  wire [3:0]                          address_i,
  output wire [7:0]                          interval_o,
  output wire [8*(MOST-LEAST+1)-1:0]         latency_o,
  output wire [WEIGHT_W*(MOST-LEAST+1)-1:0]  weight_o
);
  localparam       FILE     = `FFD_FILE_LATENCY(`FFD_SCHEDULE_OVERLAPPED, `FFD_EVALUATOR_ITERATIVE);
  localparam [7:0] INTERVAL = `FFD_POLY_INTERVAL(`FFD_EVALUATOR_ITERATIVE);

  assign interval_o = INTERVAL;

  genvar i;
  generate
    for (i = 0; i <= MOST - LEAST; i = i + 1) begin : gen_loop
      localparam       STEP    = LEAST + i;
      localparam [7:0] LATENCY = `FFD_POLY_LATENCY(`FFD_EVALUATOR_ITERATIVE, FILE, STEP, 0);
      assign latency_o[8*i +: 8] = LATENCY;

      ffd_eval_poly #(
        .FORMAT      (FORMAT),
        .EVALUATOR   (`FFD_EVALUATOR_ITERATIVE),
        .FILE_LATENCY(FILE),
        .MUL_LATENCY (STEP - 1)
      ) u_poly (
        .clk           (clk),
        .start_i       (start_i),
        .coordinate_i  (coordinate_i),
        .address_i     (address_i),
        .weight_o      (weight_o[WEIGHT_W*i +: WEIGHT_W]),
        .load_i        (load_i),
        .load_address_i(load_address_i),
        .load_entry_i  (load_entry_i)
      );
    end
  endgenerate
endmodule

`default_nettype wire
