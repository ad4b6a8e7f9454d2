// ffd_scatter_framer: what each beat is in its packet, and when it goes on
//
//   1  coefficients  12 beats, one a blending function, or 24 with their derivatives
//   10 gradients     count vertices of two beats: the vertex, and its gradient. Of a grid three
//                    beats of its axes, then a beat a vertex: in front of each the vertex is made
//                    here, in a clock without a beat, or with ROWS in the clock of its beat
//   11 collect       nothing
// A beat stays until take_o. A header waits for go_i, the last axis until the grid is checked, and
// a gradient for room.
//
// Bad input:  what header_refused_i or grid_bad_i refuses, and beats after a packet's end, belong
//             to nothing, up to tlast. A tlast between the beats of a vertex drops that vertex.
// Formats:    index {derivative, axis, function}, four bits each, as FFD_FRAME_INDEX.
// Pipeline:   combinational, of a state and the beat; a beat a clock, of a grid one in two clocks,
//             with ROWS in each.
// Freezes:    as above; of any beats none waits for one behind it.
// Parameters: ROWS 0 or 1.
// Model:      golden/include/hwffd/model/scatter_stream.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_scatter_framer #(
  parameter ROWS = 0
) (
  input  wire        clk,
  input  wire        rst,
  input  wire        beat_valid_i,
  input  wire        beat_last_i,
  input  wire [31:0]  count_i,           // of the beat, were it a header
  input  wire        twice_i,
  output wire        take_o,
  output wire        idle_o,            // between packets
  output wire        header_o,          // a header is there
  input  wire        go_i,              // and goes on: what it is
  input  wire        header_refused_i,
  input  wire        coefficients_i,
  input  wire        collect_i,         // else gradients
  input  wire        grid_i,
  input  wire        none_i,
  output wire        function_o,        // a function is taken
  output wire        top_o,             // the last one
  output wire [11:0]  index_o,
  output wire [2:0]   axis_o,            // the beat is that of an axis
  output wire        check_o,           // all three have been
  input  wire        grid_checked_i,
  input  wire        grid_bad_i,
  input  wire        grid_last_i,       // the vertex that is made is the last
  output wire        vertex_o,          // a vertex is there
  output wire        functions_o,       // a beat, were it there, is a function
  output wire        vertices_o,        // the coordinates of a vertex
  output wire        made_o,            // a vertex of a grid is
  input  wire        room_i,
  output wire        finish_o,          // its gradient is
  output wire        full_o,            // it waits for room
  output wire        short_o,           // events
  output wire        long_o,
  output wire        grid_o
);
  // A bit for each state: what follows from it has few inputs.
  localparam [9:0] HEADER   = 10'h001;
  localparam [9:0] FUNCTION = 10'h002;
  localparam [9:0] AXES     = 10'h004;
  localparam [9:0] THIRD    = 10'h008;  // of the axes
  localparam [9:0] VERTEX   = 10'h010;
  localparam [9:0] GRADIENT = 10'h020;
  localparam [9:0] GRID     = 10'h040;  // a vertex is made, without ROWS
  localparam [9:0] WALK     = 10'h080;  // with ROWS: one is, in the clock of its gradient
  localparam [9:0] DONE     = 10'h100;
  localparam [9:0] DROP     = 10'h200;

  reg  [9:0] state_q;
  reg        grid_q;
  wire       in_header, in_function, in_axes, in_third, in_vertex, in_gradient, in_grid;
  wire       in_walk, in_done, in_drop;
  assign {in_drop, in_done, in_walk, in_grid, in_gradient, in_vertex, in_third, in_axes,
          in_function, in_header} = state_q;
  wire       of_gradient = in_gradient || in_walk;
  wire       flows       = in_function || in_axes || in_vertex || in_done || in_drop;
  wire       last        = beat_last_i;
  wire       valid       = beat_valid_i;
  wire       of_function = valid && in_function;
  wire       gradient    = valid && of_gradient;
  // (Only a header goes.)
  wire       ready       = flows || go_i || (in_third && grid_checked_i)
                        || (of_gradient && room_i);
  wire       take        = valid && ready;

  assign take_o      = take;
  assign idle_o      = in_header;
  assign header_o    = valid && in_header;
  assign function_o  = of_function;
  assign functions_o = in_function;
  assign vertices_o  = in_vertex;
  assign made_o      = ROWS == 0 ? in_grid : valid && in_walk && room_i;
  assign vertex_o    = in_grid || (in_vertex && valid && !last);
  assign finish_o    = gradient && room_i;
  assign full_o      = gradient && !room_i;

  // ---- functions: the digits of their place

  reg  [1:0] function_q;
  reg  [1:0] axis_q;
  reg        derivative_q;
  reg        twice_q;
  wire       functions_top = function_q == 2'd3;
  wire       axes_top      = axis_q[1];  // 0, 1 or 2
  wire       axis          = valid && in_axes;
  wire       counts_axes   = (of_function && functions_top) || axis;
  assign top_o   = functions_top && axes_top && derivative_q == twice_q;
  assign index_o = {3'd0, derivative_q, 2'd0, axis_q, 2'd0, function_q};
  always @(posedge clk) begin
    if (header_o) begin
      {function_q, axis_q, derivative_q} <= 5'd0;
      twice_q                            <= twice_i;
    end else begin
      if (of_function) function_q <= function_q + 2'd1;
      if (counts_axes) axis_q <= axes_top ? 2'd0 : axis_q + 2'd1;
      if (of_function && functions_top && axes_top) derivative_q <= 1'b1;
    end
  end

  // ---- axes of a grid: the last one stays until they are checked

  wire third = valid && in_third;
  wire known = third && grid_checked_i;
  reg  third_q;
  reg  checks_q;
  assign axis_o  = {third, {2{axis}} & (2'd1 << axis_q[0])};
  assign check_o = third_q && !checks_q;
  always @(posedge clk) begin
    if (rst) {third_q, checks_q} <= 2'b00;
    else {third_q, checks_q} <= {third && !known, third_q && !known};
  end

  // ---- vertices: the number of the next one, from 1 on, and whether this one is the last

  reg  [31:0] count_q;
  reg  [31:0] next_q;
  reg         final_q;
  wire        final_here = in_walk ? grid_last_i : final_q;
  always @(posedge clk) begin
    if (header_o) begin
      grid_q  <= grid_i;
      count_q <= count_i;
      next_q  <= 32'd2;
      final_q <= count_q == 32'd1;  // a header is there for more than one clock
    end else if (made_o) begin
      final_q <= grid_last_i;
    end else if (finish_o && !grid_q) begin
      next_q  <= next_q + 32'd1;
      final_q <= next_q == count_q;
    end
  end

  // ---- what comes next

  wire [9:0] first = header_refused_i ? DROP : coefficients_i ? FUNCTION : collect_i ? DONE
                   : none_i ? DROP : grid_q ? AXES : VERTEX;
  wire [9:0] next  = !grid_q ? VERTEX : ROWS == 0 ? GRID : WALK;
  always @(posedge clk) begin
    if (rst || (take && last)) state_q <= HEADER;
    else if (take || in_grid) begin
      state_q <= ({10{in_header}} & first)
               | ({10{in_function}} & (top_o ? DONE : FUNCTION))
               | ({10{in_axes}} & (axis_q[0] ? THIRD : AXES))
               | ({10{in_third}} & (grid_bad_i ? DROP : next))
               | ({10{in_vertex || in_grid}} & GRADIENT)
               | ({10{of_gradient}} & (final_here ? DONE : next))
               | ({10{in_done || in_drop}} & DROP);
    end
  end

  // ---- events

  wire headless = go_i && !header_refused_i && !collect_i
               && (last || (!coefficients_i && none_i));
  wire open     = (in_function && !top_o) || in_vertex || (of_gradient && !final_here)
               || in_axes || (in_third && !grid_bad_i);
  assign grid_o  = known && grid_bad_i;
  assign short_o = headless || (take && last && open);
  assign long_o  = valid && in_done;
endmodule

`default_nettype wire
