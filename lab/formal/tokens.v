// tokens: what stands in for the arithmetic where proofs follow which numbers meet
//
// Modules with the names, ports and latencies of the arithmetic units. A number is a token that
// says what it is made of, and one that is made of what does not belong together is bad:
//
//   coordinate  {residue of its cell[1:0], axis[1:0], colour} lowest
//   weight      {good, colour, whole, ...}: whole, the banks {l, m, n} of a product of three; else
//               {kind, banks}, the kind an axis, or 3 the product of s and t
//   point       {picked, colour, -, bank[5:0]}
//   sum         {bad, picked, colour, length[6:0], first[5:0]}: a row of banks, 0 of none. Only
//               rows that meet are added, the left one first.
//
// A function stands for the bank (function + cell) mod 4.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_poly #(
  parameter FORMAT          = 8,
  parameter EVALUATOR       = 0,
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
  input  wire [8:0]                                      coordinate_i,
  input  wire [ADDRESS_W-1:0]                            address_i,
  output wire [8:0]                                      weight_o
);
  localparam STEP = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);

  // An iterative evaluator wants its starts on a grid of its interval, the others in any clock.
  wire on_grid;
  generate
    if (`FFD_POLY_INTERVAL(EVALUATOR) == 1) begin : gen_any_clock
      assign on_grid = 1'b1;
    end else begin : gen_grid
      reg [1:0] since_q;  // a start, modulo 3
      reg       ever_q = 1'b0;
      always @(posedge clk) begin
        since_q <= start_i ? 2'd1 : since_q == 2'd2 ? 2'd0 : since_q + 2'd1;
        ever_q  <= ever_q || start_i;
      end
      assign on_grid = !ever_q || since_q == 2'd0;
    end
  endgenerate

  // The place is {2{colour}}, and where one file has the functions of all axes the axis is right.
  wire own_axis;
  generate
    if (ADDRESS_W > 4) begin : gen_all_axes
      assign own_axis = address_i[5:4] == coordinate_i[2:1];
    end else begin : gen_own_axis
      assign own_axis = 1'b1;
    end
  endgenerate
  wire       good = start_i && on_grid && own_axis && address_i[3:2] == {2{coordinate_i[0]}};
  wire [1:0] bank = address_i[1:0] + coordinate_i[4:3];

  ffd_num_delay #(
    .WIDTH  (9),
    .LATENCY(`FFD_POLY_LATENCY(EVALUATOR, FILE_LATENCY, STEP, CONVERT_LATENCY))
  ) u_weight (
    .clk(clk),
    .rst(1'b0),
    .d_i({good, coordinate_i[0], 1'b0, coordinate_i[2:1], 2'd0, bank}),
    .q_o(weight_o)
  );
endmodule

module ffd_num_mul #(
  parameter FORMAT  = 8,
  parameter LATENCY = 1
) (
  input  wire       clk,
  input  wire [8:0] a_i,
  input  wire [8:0] b_i,
  output wire [8:0] product_o
);
  wire belong = a_i[8] && b_i[8] && a_i[7] == b_i[7] && !a_i[6] && !b_i[6];
  wire two    = a_i[5:4] == 2'd0 && b_i[5:4] == 2'd1;
  wire three  = a_i[5:4] == 2'd3 && b_i[5:4] == 2'd2;

  ffd_num_delay #(
    .WIDTH  (9),
    .LATENCY(LATENCY)
  ) u_product (
    .clk(clk),
    .rst(1'b0),
    .d_i({belong && (two || three), a_i[7], three,
          three ? {a_i[3:0], b_i[1:0]} : {2'd3, a_i[1:0], b_i[1:0]}}),
    .q_o(product_o)
  );
endmodule

module ffd_num_term #(
  parameter FORMAT  = 8,
  parameter LATENCY = 1
) (
  input  wire        clk,
  input  wire [8:0]  weight_i,
  input  wire [8:0]  point_i,
  output wire [22:0] term_o
);
  wire belong = weight_i[8] && weight_i[6] && weight_i[7] == point_i[7]
              && weight_i[5:0] == point_i[5:0];

  ffd_num_delay #(
    .WIDTH  (23),
    .LATENCY(LATENCY)
  ) u_term (
    .clk(clk),
    .rst(1'b0),
    .d_i({7'd0, !belong, point_i[8:7], 7'd1, point_i[5:0]}),
    .q_o(term_o)
  );
endmodule

module ffd_num_add #(
  parameter FORMAT  = 8,
  parameter LATENCY = 1,
  parameter OPEN    = 0
) (
  input  wire        clk,
  input  wire [22:0] a_i,
  input  wire [22:0] b_i,
  output wire [22:0] sum_o
);
  wire       none   = a_i == 23'd0;
  wire [6:0] behind = {1'b0, a_i[5:0]} + a_i[12:6];
  wire       belong = !a_i[15] && !b_i[15] && a_i[14:13] == b_i[14:13] && behind == {1'b0, b_i[5:0]};

  ffd_num_delay #(
    .WIDTH  (23),
    .LATENCY(LATENCY - OPEN)
  ) u_sum (
    .clk(clk),
    .rst(1'b0),
    .d_i(none ? b_i : {7'd0, !belong, a_i[14:13], a_i[12:6] + b_i[12:6], a_i[5:0]}),
    .q_o(sum_o)
  );
endmodule

// A place for what the harness wants of this file.
module tokens (
  input  wire       read_i,
  input  wire [5:0] bank_i,
  input  wire       source_i,
  input  wire       cell_colour_i,
  input  wire       picked_i,
  input  wire [8:0] other_i,
  output wire [8:0] point_o
);
  // The point that is read; any other where none is, or where source and cell are of two vertices.
  assign point_o = read_i && source_i == cell_colour_i ? {picked_i, source_i, 1'b0, bank_i} : other_i;
endmodule

`default_nettype wire
