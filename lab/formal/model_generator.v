// model_generator: in the place of the combination generator: the weights of its step, as tokens
//
// That the generator gives these is what formal_cg_weights proves.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_eval_generator #(
  parameter WEIGHT_W = 9,
  parameter SIZE     = 1,
  parameter SETS     = 3,
  parameter FORWARD  = 0,
  parameter SET_W    = $clog2(SETS)
) (
  input  wire                     clk,
  input  wire                     weight_valid_i,
  input  wire [SET_W-1:0]         weight_set_i,
  input  wire [SIZE*4-1:0]        weight_places_i,
  input  wire [SIZE*WEIGHT_W-1:0] weights_i,
  input  wire [SET_W-1:0]         step_set_i,
  input  wire [11:0]              step_cell_i,
  input  wire [5:0]               step_i,
  output reg  [3*WEIGHT_W-1:0]    combination_o
);
  wire colour = step_cell_i[2];

  always @(posedge clk) begin
    combination_o <= {1'b1, colour, 1'b0, 2'd2, 2'd0, step_i[1:0],
                      1'b1, colour, 1'b0, 2'd1, 2'd0, step_i[3:2],
                      1'b1, colour, 1'b0, 2'd0, 2'd0, step_i[5:4]};
  end
endmodule

`default_nettype wire
