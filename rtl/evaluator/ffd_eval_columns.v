// ffd_eval_columns: three columns that come at once go on one a clock
//
// Between an organization that gives the Jacobian in one pass and ffd_eval_determinant.
//
// Formats:    columns {u, t, s} of {z, y, x}; the exponent of their points with each.
// Pipeline:   combinational for s; t and u 1 and 2 clocks later. II 3.
// Freezes:    never.
// Parameters: WIDTH of a column, EXPONENT_W >= 1.
// Not checked: columns that come sooner.
// Model:      none (order only).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_eval_columns #(
  parameter WIDTH      = 96,
  parameter EXPONENT_W = 10
) (
  input  wire                  clk,
  input  wire                  rst,
  input  wire                  valid_i,
  input  wire [3*WIDTH-1:0]    columns_i,
  input  wire [EXPONENT_W-1:0] exponent_i,
  output wire                  column_valid_o,
  output wire                  column_last_o,
  output wire [WIDTH-1:0]      column_o,
  output wire [EXPONENT_W-1:0] exponent_o
);
  reg [1:0]            left_q;  // t and u, u
  reg [2*WIDTH-1:0]    columns_q;
  reg [EXPONENT_W-1:0] exponent_q;

  always @(posedge clk) begin
    if (rst) left_q <= 2'd0;
    else if (valid_i) left_q <= 2'd2;
    else if (left_q != 2'd0) left_q <= left_q - 2'd1;
  end
  always @(posedge clk) begin
    columns_q <= valid_i ? columns_i[3*WIDTH-1:WIDTH] : {columns_q[WIDTH-1:0],
                                                         columns_q[2*WIDTH-1:WIDTH]};
    if (valid_i) exponent_q <= exponent_i;
  end

  assign column_valid_o = valid_i || left_q != 2'd0;
  assign column_last_o  = left_q == 2'd1;
  assign column_o       = valid_i ? columns_i[WIDTH-1:0] : columns_q[WIDTH-1:0];
  assign exponent_o     = valid_i ? exponent_i : exponent_q;
endmodule

`default_nettype wire
