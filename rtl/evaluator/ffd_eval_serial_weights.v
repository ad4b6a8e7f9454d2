// ffd_eval_serial_weights: the nine weights of a vertex, one polynomial after the other
//
// Those of u come first, of each axis those of banks 0, 1 and 2, one in every third clock, into one
// of two sets in turn; meanwhile those of the vertex before are read from the other.
//
// Pipeline:   begin_i: a vertex is there in the next clock and stays for 25 | its first weight can
//             be read from the second clock after FFD_POLY_LATENCY on, the others every 3 clocks
//             later; a read takes a clock. Vertices 64 clocks apart or more; never frozen.
// Parameters: those of ffd_eval_serial.
// Not checked: that a set has been read when it is filled again.
// Model:      golden/include/hwffd/model/org_affine.hpp.  Test: tests/evaluator.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_serial_weights #(
  parameter FORMAT          = 17,
  parameter EVALUATOR       = `FFD_EVALUATOR_ITERATIVE,
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 1,
  parameter SPANS           = 1
) (
  input  wire                                            clk,
  input  wire                                            rst,
  input  wire                                            load_i,
  input  wire [1:0]                                      load_axis_i,
  input  wire [`FFD_OWN_W(SPANS)-1:0]                    load_address_i,
  input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,
  input  wire                                            begin_i,
  input  wire [3*`FFD_WEIGHT_W(FORMAT)-1:0]              coordinates_i,
  input  wire [11:0]                                     cell_i,
  input  wire [3*`FFD_PLACE_W(SPANS)-1:0]                bank_i,
  input  wire [4:0]                                      read_i,         // {set, axis, bank}
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]                weight_o
);
  localparam WEIGHT_W     = `FFD_WEIGHT_W(FORMAT);
  localparam PLACE_W      = `FFD_PLACE_W(SPANS);
  localparam SELECT_W     = `FFD_SHARED_W(SPANS);
  localparam STEP_LATENCY = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);
  localparam FILE_LATENCY = `FFD_FILE_LATENCY(`FFD_SCHEDULE_OVERLAPPED, EVALUATOR);
  localparam POLY_LATENCY = `FFD_POLY_LATENCY(EVALUATOR, FILE_LATENCY, STEP_LATENCY,
                                              CONVERT_LATENCY);

  reg                 filling_q;
  reg  [1:0]          third_q;
  reg  [3:0]          fill_q;  // {axis, bank}
  wire                fill     = filling_q && third_q == 2'd0;
  wire [1:0]          axis     = fill_q[3:2];
  wire [WEIGHT_W-1:0] coordinate;
  wire [1:0]          residue;
  wire [PLACE_W-1:0]  place;
  wire [SELECT_W-1:0] select;
  wire [SELECT_W-1:0] load_select;
  wire [1:0]          blending = fill_q[1:0] - residue;
  wire                weight_valid;
  wire [WEIGHT_W-1:0] weight;

  localparam [3:0] FIRST_FILL = {2'd2, 2'd0};
  localparam [3:0] LAST_FILL  = {2'd0, 2'd2};

  function [3:0] following;
    input [3:0] at;
    following = at == LAST_FILL ? FIRST_FILL : at[1] ? {at[3:2] - 2'd1, 2'd0} : at + 4'd1;
  endfunction

  always @(posedge clk) begin
    if (rst) filling_q <= 1'b0;
    else if (begin_i) filling_q <= 1'b1;
    else if (fill && fill_q == LAST_FILL) filling_q <= 1'b0;
    if (rst) fill_q <= FIRST_FILL;
    else if (fill) fill_q <= following(fill_q);
    if (!filling_q || third_q == 2'd2) third_q <= 2'd0;
    else third_q <= third_q + 1'b1;
  end

  assign coordinate = axis[1] ? coordinates_i[2*WEIGHT_W +: WEIGHT_W] :
                      axis[0] ? coordinates_i[1*WEIGHT_W +: WEIGHT_W] :
                                coordinates_i[0*WEIGHT_W +: WEIGHT_W];
  assign residue    = axis[1] ? cell_i[9:8] : axis[0] ? cell_i[5:4] : cell_i[1:0];
  assign place      = axis[1] ? bank_i[2*PLACE_W +: PLACE_W] :
                      axis[0] ? bank_i[1*PLACE_W +: PLACE_W] : bank_i[0*PLACE_W +: PLACE_W];

  ffd_eval_address #(
    .SPANS(SPANS)
  ) u_load_select (
    .axis_i   (load_axis_i),
    .place_i  (load_address_i),
    .address_o(load_select)
  );

  ffd_eval_address #(
    .SPANS(SPANS)
  ) u_select (
    .axis_i   (axis),
    .place_i  ({place, blending}),
    .address_o(select)
  );

  ffd_eval_poly #(
    .FORMAT         (FORMAT),
    .EVALUATOR      (EVALUATOR),
    .FILE_LATENCY   (FILE_LATENCY),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (FMA_LATENCY),
    .CONVERT_LATENCY(CONVERT_LATENCY),
    .ADDRESS_W      (SELECT_W)
  ) u_poly (
    .clk           (clk),
    .load_i        (load_i),
    .load_address_i(load_select),
    .load_entry_i  (load_entry_i),
    .start_i       (fill),
    .coordinate_i  (coordinate),
    .address_i     (select),
    .weight_o      (weight)
  );

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(POLY_LATENCY),
    .RESET  (1)
  ) u_weight_valid (
    .clk(clk),
    .rst(rst),
    .d_i(fill),
    .q_o(weight_valid)
  );

  // They come in the same order.
  reg        write_set_q;
  reg  [3:0] write_q;
  always @(posedge clk) begin
    if (rst) begin
      write_set_q <= 1'b0;
      write_q     <= FIRST_FILL;
    end else if (weight_valid) begin
      write_set_q <= write_set_q ^ (write_q == LAST_FILL);
      write_q     <= following(write_q);
    end
  end

  ffd_mem_sdp #(
    .WIDTH       (WEIGHT_W),
    .DEPTH       (32),
    .READ_LATENCY(1)
  ) u_sets (
    .clk            (clk),
    .write_i        (weight_valid),
    .write_address_i({write_set_q, write_q}),
    .write_data_i   (weight),
    .read_i         (1'b1),
    .read_address_i (read_i),
    .read_data_o    (weight_o)
  );

  wire unused_ok = &{1'b0, cell_i};
endmodule

`default_nettype wire
