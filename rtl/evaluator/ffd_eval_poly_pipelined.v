// ffd_eval_poly_pipelined: weight = ((c3 x + c2) x + c1) x + c0, one a clock
//
// The general polynomial evaluator of the paper's section 3.3.3 with its loop unrolled: three steps
// in a row.
//
// Formats, rounding: those of ffd_num_step and ffd_num_scale.
// Pipeline:   the address | FILE_LATENCY: the coordinate | 3 steps | CONVERT_LATENCY:
//             FFD_POLY_LATENCY in all, II 1, never frozen; step_k holds power 2 - k and needs its
//             coefficients k steps after the start.
// Parameters: FORMAT as in ffd_num.vh; FILE_LATENCY 0 or 1, CONVERT_LATENCY >= 0, others >= 1;
//             ADDRESS_W >= 3: the address of a blending function in this evaluator's file.
// Model:      golden/include/hwffd/model/coefficients.hpp (polynomial).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_poly_pipelined #(
  parameter FORMAT          = 18,
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
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]                coordinate_i,
  input  wire [ADDRESS_W-1:0]                            address_i,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]                weight_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam STEP     = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);

  wire [4*ADDRESS_W-1:0] addresses;
  wire [4*WEIGHT_W-1:0]  coefficients;
  wire [1:0]             shift;

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : gen_step
      wire [WEIGHT_W-1:0]  coordinate;
      wire [ADDRESS_W-1:0] address;
      wire [WEIGHT_W-1:0]  weight;
      wire [WEIGHT_W-1:0]  weight_next;
      wire [ADDRESS_W-1:0] address_next;

      if (k == 0) begin : gen_first
        assign coordinate = coordinate_i;
        assign address    = address_i;
        assign weight     = coefficients[3*WEIGHT_W +: WEIGHT_W];
      end else begin : gen_next
        assign address = gen_step[k-1].address_next;
        assign weight  = gen_step[k-1].weight_next;
        ffd_num_delay #(
          .WIDTH  (WEIGHT_W),
          .LATENCY(STEP)
        ) u_coordinate (
          .clk(clk),
          .rst(1'b0),
          .d_i(gen_step[k-1].coordinate),
          .q_o(coordinate)
        );
      end

      assign addresses[(2-k)*ADDRESS_W +: ADDRESS_W] = address;

      ffd_num_step #(
        .FORMAT     (FORMAT),
        .MUL_LATENCY(MUL_LATENCY),
        .ADD_LATENCY(ADD_LATENCY),
        .FMA_LATENCY(FMA_LATENCY)
      ) u_step (
        .clk          (clk),
        .coefficient_i(coefficients[(2-k)*WEIGHT_W +: WEIGHT_W]),
        .coordinate_i (coordinate),
        .weight_i     (weight),
        .weight_o     (weight_next)
      );

      ffd_num_delay #(
        .WIDTH  (ADDRESS_W),
        .LATENCY(STEP)
      ) u_address (
        .clk(clk),
        .rst(1'b0),
        .d_i(address),
        .q_o(address_next)
      );
    end
  endgenerate

  assign addresses[3*ADDRESS_W +: ADDRESS_W] = address_i;

  ffd_eval_coefficient_file #(
    .FORMAT      (FORMAT),
    .READ_LATENCY(FILE_LATENCY),
    .ADDRESS_W   (ADDRESS_W)
  ) u_file (
    .clk            (clk),
    .load_i         (load_i),
    .load_address_i (load_address_i),
    .load_entry_i   (load_entry_i),
    .address_i      (addresses),
    .coefficient_o  (coefficients),
    .shift_address_i(gen_step[2].address_next),
    .shift_o        (shift)
  );

  ffd_num_scale #(
    .FORMAT (FORMAT),
    .LATENCY(CONVERT_LATENCY)
  ) u_scale (
    .clk     (clk),
    .weight_i(gen_step[2].weight_next),
    .shift_i (shift),
    .weight_o(weight_o)
  );
endmodule

`default_nettype wire
