// ffd_eval_axis_weights: the four weights of an axis by bank
//
// Bank b has the weight of the local function (b - cell) mod 4: the evaluator of each bank is
// addressed with its function, so no weight is moved; those from powers are turned.
//
// AFFINE 1:   bank 3 has no evaluator. Its weight is what the others leave, and in its place stands
//             what they leave it of: 1, of a derivative 0.
// SHARED 1:   the axis is chosen with each coordinate, and a file has the functions of all.
//
// Pipeline:   coordinate | SHARED | FFD_POLY_LATENCY: weights. II 1, never frozen.
// Parameters: SHARED, AFFINE 0 or 1, AFFINE in fixed point only; EVALUATOR not iterative; the
//             others as in every organization.
// Model:      golden/include/hwffd/model/organization.hpp (weights_of).  Test: tests/evaluator.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_axis_weights #(
  parameter SHARED          = 0,
  parameter AFFINE          = 0,
  parameter FORMAT          = 18,
  parameter EVALUATOR       = `FFD_EVALUATOR_PIPELINED,
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 1,
  parameter SPANS           = 1
) (
  input  wire                                            clk,
  input  wire                                            load_i,
  input  wire [1:0]                                      load_axis_i,
  input  wire [`FFD_OWN_W(SPANS)-1:0]                    load_address_i,
  input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,
  input  wire                                            start_i,
  input  wire [1:0]                                      axis_i,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]                coordinate_i,
  input  wire [1:0]                                      residue_i,  // of the cell, modulo 4
  input  wire [`FFD_PLACE_W(SPANS)-1:0]                  bank_i,
  output wire [4*`FFD_WEIGHT_W(FORMAT)-1:0]              weights_o
);
  localparam WEIGHT_W     = `FFD_WEIGHT_W(FORMAT);
  localparam STEP_LATENCY = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);
  localparam FILE_LATENCY = `FFD_FILE_LATENCY(`FFD_SCHEDULE_OVERLAPPED, EVALUATOR);
  localparam POLY_LATENCY = `FFD_POLY_LATENCY(EVALUATOR, FILE_LATENCY, STEP_LATENCY,
                                              CONVERT_LATENCY);
  localparam EVALUATED    = AFFINE == 0 ? 4 : 3;  // of the banks
  localparam ADDRESS_W    = SHARED == 0 ? `FFD_OWN_W(SPANS) : `FFD_SHARED_W(SPANS);

  generate
    if (EVALUATOR == `FFD_EVALUATOR_ITERATIVE) begin : gen_bad_evaluator
      ERROR_ffd_eval_axis_weights_evaluator_must_not_be_iterative u_error ();
    end
  endgenerate

  wire [WEIGHT_W-1:0]  chosen;
  wire [ADDRESS_W-1:0] load_address;

  ffd_num_delay #(
    .WIDTH  (WEIGHT_W),
    .LATENCY(SHARED)
  ) u_chosen (
    .clk(clk),
    .rst(1'b0),
    .d_i(coordinate_i),
    .q_o(chosen)
  );

  genvar b;
  generate
    if (SHARED == 0) begin : gen_own_load
      assign load_address = load_address_i;
      wire unused_axis = &{1'b0, load_axis_i, axis_i};
    end else begin : gen_shared_load
      ffd_eval_address #(
        .SPANS(SPANS)
      ) u_load_address (
        .axis_i   (load_axis_i),
        .place_i  (load_address_i),
        .address_o(load_address)
      );
    end

    if (EVALUATOR == `FFD_EVALUATOR_POWERS) begin : gen_powers
      wire [2:0]            kind;
      wire [4*WEIGHT_W-1:0] of_bank;

      ffd_num_delay #(
        .WIDTH  (3),
        .LATENCY(SHARED)
      ) u_kind (
        .clk(clk),
        .rst(1'b0),
        .d_i({bank_i[1], residue_i}),
        .q_o(kind)
      );

      ffd_eval_powers #(
        .FORMAT         (FORMAT),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY)
      ) u_powers (
        .clk         (clk),
        .coordinate_i(chosen),
        .residue_i   (kind[1:0]),
        .derivative_i(kind[2]),
        .weights_o   (of_bank)
      );
      `FFD_ASSERT_TAKES(u_powers, POLY_LATENCY)

      assign weights_o[EVALUATED*WEIGHT_W-1:0] = of_bank[EVALUATED*WEIGHT_W-1:0];
      wire unused_ok = &{1'b0, of_bank, bank_i, axis_i, start_i, load_i, load_address,
                         load_entry_i};
    end else begin : gen_polynomials
      for (b = 0; b < EVALUATED; b = b + 1) begin : gen_bank
        localparam [1:0] BANK = b;
        wire [1:0]           blending = BANK - residue_i;
        wire [ADDRESS_W-1:0] address;
        wire                 start;
        wire [ADDRESS_W-1:0] chosen_address;

        if (SHARED == 0) begin : gen_own_file
          assign address = {bank_i, blending};
        end else begin : gen_three_files
          ffd_eval_address #(
            .SPANS(SPANS)
          ) u_file_address (
            .axis_i   (axis_i),
            .place_i  ({bank_i, blending}),
            .address_o(address)
          );
        end

        ffd_num_delay #(
          .WIDTH  (1 + ADDRESS_W),
          .LATENCY(SHARED)
        ) u_address (
          .clk(clk),
          .rst(1'b0),
          .d_i({start_i, address}),
          .q_o({start, chosen_address})
        );

        ffd_eval_poly #(
          .FORMAT         (FORMAT),
          .EVALUATOR      (EVALUATOR),
          .FILE_LATENCY   (FILE_LATENCY),
          .MUL_LATENCY    (MUL_LATENCY),
          .ADD_LATENCY    (ADD_LATENCY),
          .FMA_LATENCY    (FMA_LATENCY),
          .CONVERT_LATENCY(CONVERT_LATENCY),
          .ADDRESS_W      (ADDRESS_W)
        ) u_poly (
          .clk           (clk),
          .load_i        (load_i),
          .load_address_i(load_address),
          .load_entry_i  (load_entry_i),
          .start_i       (start),
          .coordinate_i  (chosen),
          .address_i     (chosen_address),
          .weight_o      (weights_o[b*WEIGHT_W +: WEIGHT_W])
        );
      end
    end

    if (AFFINE != 0) begin : gen_rest
      wire derivative;
      ffd_num_delay #(
        .WIDTH  (1),
        .LATENCY(SHARED + POLY_LATENCY)
      ) u_derivative (
        .clk(clk),
        .rst(1'b0),
        .d_i(bank_i[1]),
        .q_o(derivative)
      );
      localparam [WEIGHT_W-1:0] ONE = 1;
      assign weights_o[3*WEIGHT_W +: WEIGHT_W] =
          derivative ? {WEIGHT_W{1'b0}} : ONE << (`FFD_FIXED_W(FORMAT) - 2);
    end
  endgenerate
endmodule

`default_nettype wire
