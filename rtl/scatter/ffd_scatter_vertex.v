// ffd_scatter_vertex: numbers of a vertex and of its gradient become what the core takes
//
// The coordinates come first and wait for the gradient; both together wait in a queue for the core.
// With made_i they are those of a grid; such may come with the gradient, too.
//
// Formats:    coordinates {u, t, s} as weights, gradient {z, y, x} as points, cell {k, j, i}; bank
//             of each axis {derivative, bank}; along 0 for the position, 1 to 3 for the derivative
//             along s, t, u, which takes the derivatives of that axis's functions.
// Pipeline:   cell_i, page_i, along_i, bank_i and last_i with finish_i, made_i with that or with
//             vertex_i, numbers LATENCY clocks behind them; a vertex is offered 2 clocks behind
//             those of its gradient, with WAITING above 16 in 3.
// Freezes:    room_o is 0 while WAITING vertices are between finish_i and the core.
// Parameters: FORMAT fixed point, AXIS as in ffd_scatter_header, PAGE_W >= 1, LATENCY >= 1, WAITING
//             a power of two >= 2.
// Model:      golden/include/hwffd/model/scatter_stream.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module ffd_scatter_vertex #(
  parameter FORMAT  = 17,
  parameter AXIS    = 16,
  parameter PAGE_W  = 1,
  parameter LATENCY = 2,
  parameter WAITING = 16,
  parameter PLACE_W = 3 * `FFD_AXIS_W(AXIS)
) (
  input  wire                               clk,
  input  wire                               rst,
  input  wire                               vertex_i,
  input  wire                               finish_i,
  input  wire                               made_i,
  input  wire                               last_i,       // of its row
  input  wire [PLACE_W-1:0]                 cell_i,
  input  wire [PAGE_W-1:0]                  page_i,
  input  wire [1:0]                         along_i,
  input  wire                               bank_i,
  input  wire [3*`FFD_POINT_W(FORMAT)-1:0]  numbers_i,
  input  wire [3*`FFD_WEIGHT_W(FORMAT)-1:0] made_numbers_i,
  output wire                               room_o,
  output wire                               m_vertex_valid,
  input  wire                               m_vertex_ready,
  output wire [3*`FFD_WEIGHT_W(FORMAT)-1:0] m_vertex_coordinates,
  output wire [PLACE_W-1:0]                 m_vertex_cell,
  output wire [3*`FFD_PLACE_W(1)-1:0]       m_vertex_bank,
  output wire [1:0]                         m_vertex_along,
  output wire [PAGE_W-1:0]                  m_vertex_page,
  output wire [3*`FFD_POINT_W(FORMAT)-1:0]  m_vertex_gradient,
  output wire                               m_vertex_saturated,
  output wire                               m_vertex_last
);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam COUNT_W  = $clog2(WAITING) + 1;

  // ---- room

  reg  [COUNT_W-1:0] waiting_q;
  wire               leave = m_vertex_valid && m_vertex_ready;
  assign room_o = !waiting_q[COUNT_W-1];
  always @(posedge clk) begin
    if (rst) waiting_q <= {COUNT_W{1'b0}};
    else if (finish_i && !leave) waiting_q <= waiting_q + 1'b1;
    else if (leave && !finish_i) waiting_q <= waiting_q - 1'b1;
  end

  // ---- what belongs to the numbers

  wire               vertex_there;
  wire               finish_there;
  wire               made_there;
  wire               last_there;
  wire [PLACE_W-1:0] cell_there;
  wire [PAGE_W-1:0]  page_there;
  wire [1:0]         along_there;
  wire               bank_there;
  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(LATENCY),
    .RESET  (1)
  ) u_there (
    .clk(clk),
    .rst(rst),
    .d_i({vertex_i, finish_i}),
    .q_o({vertex_there, finish_there})
  );
  ffd_num_delay #(
    .WIDTH  (2 + PAGE_W + 2 + 1 + PLACE_W),
    .LATENCY(LATENCY)
  ) u_vertex (
    .clk(clk),
    .rst(1'b0),
    .d_i({made_i, last_i, page_i, along_i, bank_i, cell_i}),
    .q_o({made_there, last_there, page_there, along_there, bank_there, cell_there})
  );

  wire [3*WEIGHT_W-1:0] coordinates;
  wire [3*WEIGHT_W-1:0] coordinates_there;
  wire [2:0]            coordinate_saturated;
  wire [2:0]            gradient_saturated;
  reg  [3*WEIGHT_W-1:0] coordinates_q;
  wire [3*`FFD_PLACE_W(1)-1:0] bank;
  always @(posedge clk) begin
    if (vertex_there) coordinates_q <= made_there ? made_numbers_i : coordinates;
  end
  assign coordinates_there = made_there ? made_numbers_i : coordinates_q;

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      localparam [1:0] ALONG = a + 1;
      assign coordinates[a*WEIGHT_W +: WEIGHT_W] = numbers_i[a*POINT_W +: WEIGHT_W];
      assign coordinate_saturated[a]             = coordinates_there[(a+1)*WEIGHT_W-1];
      assign gradient_saturated[a]               = numbers_i[(a+1)*POINT_W-1];
      assign bank[a*`FFD_PLACE_W(1) +: `FFD_PLACE_W(1)] = {along_there == ALONG, bank_there};
    end
  endgenerate
  wire saturated = |{coordinate_saturated, gradient_saturated};

  // ---- the queue

  localparam VERTEX_W = 2 + PAGE_W + 2 + 3 * `FFD_PLACE_W(1) + PLACE_W + 3 * (POINT_W + WEIGHT_W);
  wire queue_ready;
  ffd_stream_queue #(
    .WIDTH(VERTEX_W),
    .DEPTH(WAITING)
  ) u_queue (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(finish_there),
    .s_word_ready(queue_ready),
    .s_word_data ({last_there, saturated, page_there, along_there, bank, cell_there, numbers_i,
                   coordinates_there}),
    .m_word_valid(m_vertex_valid),
    .m_word_ready(m_vertex_ready),
    .m_word_data ({m_vertex_last, m_vertex_saturated, m_vertex_page, m_vertex_along, m_vertex_bank,
                   m_vertex_cell, m_vertex_gradient, m_vertex_coordinates})
  );

  wire unused_ok = &{1'b0, queue_ready};

  `FFD_ASSERT(a_vertex_is_whole_and_the_queue_is_full, !finish_there || queue_ready)
  `FFD_ASSERT(more_vertices_have_left_than_came, !leave || waiting_q != {COUNT_W{1'b0}})
endmodule

`default_nettype wire
