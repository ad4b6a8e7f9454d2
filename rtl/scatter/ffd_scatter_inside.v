// ffd_scatter_inside: how many vertices are inside, and whether those of a mark still are
//
// With rows, how many rows: one comes with its last vertex.
//
// Vertices keep their order. So those that were inside at a mark have left when as many have left
// as were inside then: what overwrites a bank of coefficients waits for those before the change of
// banks, a collect for those before its header.
//
// Pipeline:   1 clock.  Not checked: a vertex comes with a mark; none does.
// Parameters: MOST >= 1, the most vertices inside.
// Model:      none (order only).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"

module ffd_scatter_inside #(
  parameter MOST = 80
) (
  input  wire clk,
  input  wire rst,
  input  wire come_i,
  input  wire leave_i,
  input  wire bank_i,     // marks
  input  wire collect_i,
  output wire any_o,
  output wire bank_o,     // one of those before that mark is inside
  output wire collect_o
);
  localparam           COUNT_W = $clog2(MOST + 1);
  localparam [COUNT_W-1:0] NONE = {COUNT_W{1'b0}};

  reg  [COUNT_W-1:0] count_q;
  reg  [COUNT_W-1:0] bank_q;
  reg  [COUNT_W-1:0] collect_q;
  wire [COUNT_W-1:0] left = count_q - {{(COUNT_W - 1) {1'b0}}, leave_i};

  always @(posedge clk) begin
    if (rst) count_q <= NONE;
    else if (come_i != leave_i) count_q <= come_i ? count_q + 1'b1 : left;
  end
  always @(posedge clk) begin
    if (rst) bank_q <= NONE;
    else if (bank_i) bank_q <= left;
    else if (leave_i && bank_o) bank_q <= bank_q - 1'b1;
  end
  always @(posedge clk) begin
    if (rst) collect_q <= NONE;
    else if (collect_i) collect_q <= left;
    else if (leave_i && collect_o) collect_q <= collect_q - 1'b1;
  end

  assign any_o     = count_q != NONE;
  assign bank_o    = bank_q != NONE;
  assign collect_o = collect_q != NONE;

  `FFD_ASSERT(more_vertices_have_left_than_came, !leave_i || any_o)
  `FFD_ASSERT(more_vertices_are_inside_than_may_be, count_q <= MOST[COUNT_W-1:0])
  `FFD_ASSERT(a_vertex_comes_with_a_mark, !come_i || !(bank_i || collect_i))
endmodule

`default_nettype wire
