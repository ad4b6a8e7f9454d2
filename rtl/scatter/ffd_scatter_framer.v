// ffd_scatter_framer: what each beat is in its packet, and when it goes on
//
//   1  coefficients  12 beats, one a blending function, or 24 with their derivatives
//   10 gradients     count vertices of two beats: the vertex, and its gradient. Of a grid three
//                    beats of its axes, then a beat a vertex: in front of each the vertex is made
//                    here, in a clock without a beat
//   11 collect       nothing
// A beat stays until take_o. A header waits for go_i, the last axis until the grid is checked, and
// a gradient for room.
//
// Bad input:  what header_refused_i or grid_bad_i refuses, and beats after a packet's end, belong
//             to nothing, up to tlast. A tlast between the beats of a vertex drops that vertex.
// Formats:    index {derivative, axis, function}, four bits each, as FFD_FRAME_INDEX.
// Pipeline:   combinational, of a state and the beat; a beat a clock, of a grid one in two clocks.
// Freezes:    as above; of any beats none waits for one behind it.
// Model:      golden/include/hwffd/model/scatter_stream.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_scatter_framer (
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
  output wire        made_o,            // of a grid
  input  wire        room_i,
  output wire        finish_o,          // its gradient is
  output wire        full_o,            // it waits for room
  output wire        short_o,           // events
  output wire        long_o,
  output wire        grid_o
);
  localparam [2:0] HEADER   = 3'd0;
  localparam [2:0] FUNCTION = 3'd1;
  localparam [2:0] AXES     = 3'd2;
  localparam [2:0] VERTEX   = 3'd3;
  localparam [2:0] GRADIENT = 3'd4;
  localparam [2:0] DONE     = 3'd5;
  localparam [2:0] DROP     = 3'd6;

  reg  [2:0] state_q;
  reg        grid_q;
  wire       third;     // of the axes
  wire       last        = beat_last_i;
  wire       valid       = beat_valid_i;
  wire       of_function = valid && state_q == FUNCTION;
  wire       gradient    = valid && state_q == GRADIENT;
  reg        ready;
  always @* begin
    case (state_q)
      HEADER:   ready = go_i;
      AXES:     ready = !third || grid_checked_i;
      VERTEX:   ready = !grid_q;
      GRADIENT: ready = room_i;
      default:  ready = 1'b1;
    endcase
  end
  wire take = valid && ready;

  assign take_o     = take;
  assign idle_o     = state_q == HEADER;
  assign header_o   = valid && state_q == HEADER;
  assign function_o = of_function;
  assign made_o     = state_q == VERTEX && grid_q;
  assign vertex_o   = state_q == VERTEX && (grid_q || (valid && !last));
  assign finish_o   = gradient && room_i;
  assign full_o     = gradient && !room_i;

  // ---- functions: the digits of their place

  reg  [1:0] function_q;
  reg  [1:0] axis_q;
  reg        derivative_q;
  reg        twice_q;
  wire       functions_top = function_q == 2'd3;
  wire       axes_top      = axis_q == 2'd2;
  wire       counts_axes   = take && ((of_function && functions_top) || state_q == AXES);
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

  wire axis = valid && state_q == AXES;
  reg  third_q;
  reg  checks_q;
  assign third   = axes_top;
  assign axis_o  = {3{axis}} & (3'd1 << axis_q);
  assign check_o = third_q && !checks_q;
  always @(posedge clk) begin
    if (rst) {third_q, checks_q} <= 2'b00;
    else {third_q, checks_q} <= {axis && third && !take, axis && third_q && !take};
  end

  // ---- vertices: the number of the next one, from 1 on, and whether this one is the last

  reg  [31:0] count_q;
  reg  [31:0] next_q;
  reg         final_q;
  always @(posedge clk) begin
    if (header_o) begin
      grid_q  <= grid_i;
      count_q <= count_i;
      next_q  <= 32'd2;
      final_q <= count_i == 32'd1;
    end else if (made_o) begin
      final_q <= grid_last_i;
    end else if (finish_o && !grid_q) begin
      next_q  <= next_q + 32'd1;
      final_q <= next_q == count_q;
    end
  end

  // ---- what comes next

  wire [2:0] first = header_refused_i ? DROP : coefficients_i ? FUNCTION : collect_i ? DONE
                   : none_i ? DROP : grid_q ? AXES : VERTEX;
  always @(posedge clk) begin
    if (rst || (take && last)) state_q <= HEADER;
    else if (made_o) state_q <= GRADIENT;
    else if (take) begin
      case (state_q)
        HEADER:   state_q <= first;
        FUNCTION: state_q <= top_o ? DONE : FUNCTION;
        AXES:     state_q <= !third ? AXES : grid_bad_i ? DROP : VERTEX;
        VERTEX:   state_q <= GRADIENT;
        GRADIENT: state_q <= final_q ? DONE : VERTEX;
        default:  state_q <= DROP;
      endcase
    end
  end

  // ---- events

  wire headless = take && state_q == HEADER && !header_refused_i && !collect_i
               && (last || (!coefficients_i && none_i));
  wire open     = (state_q == FUNCTION && !top_o) || state_q == VERTEX
               || (state_q == GRADIENT && !final_q) || (state_q == AXES && !grid_o);
  assign grid_o  = take && state_q == AXES && third && grid_bad_i;
  assign short_o = headless || (take && last && open);
  assign long_o  = take && state_q == DONE;
endmodule

`default_nettype wire
