// ffd_stream_framer: what each beat is in its packet
//
// In front of the first register of the stream, so that what lies behind finds every beat decided:
// what it is, which place of the payload it has, and whether something ends with it. A packet is a
// header beat and its payload, ended by tlast (docs/interface.md section 2):
//   1 coefficients   12 beats, one a blending function, or 24 with their derivatives
//   2 lattice        a beat a control point
//   3 vertices       count beats, one a vertex of the resident lattice
//   4 interleaved    count vertices of 49 beats: the vertex, then its 64 points
//   5 page           as a lattice
//   6 points         count of a page, from the place on that place_i says
//   7 of a page      as vertices; or as many as come
//   9 spans          count spans of 4 beats, or of 8 with their derivatives
// The place is a number of three digits, each with a last value of its own: function, axis and
// derivative of coefficients; function and derivative of a span; k, j and i of a lattice; three
// beats in sixteen groups of points.
//
// Of a beat that ffd_stream_expand made, as_i says more.
//
// Bad input:  an unknown opcode or kind of results, bad dimensions, spans beyond SPANS, and beats
//             after a packet's end belong to nothing, up to tlast. A tlast inside a vertex ends it.
//             With refuse_i the packet whose header is held belongs to nothing either. Whether such
//             a header is too short is known there. With BESIDE 1 gradients and collects are those
//             of a scatter core on the same stream: they belong to nothing, and are no event.
// Formats:    frame_o as FFD_FRAME_* in ffd_fields.vh.
// Pipeline:   frame_o in the clock of its beat; taken is the clock in which it goes on.
// Parameters: those of ffd_stream_header.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_stream.vh"

module ffd_stream_framer #(
  parameter AXIS     = 16,
  parameter FEATURES = `FFD_FEATURES_USUAL,
  parameter SPANS    = 1,
  parameter BESIDE   = 0
) (
  input  wire                      clk,
  input  wire                      rst,
  input  wire                      take_i,
  input  wire [127:0]              data_i,
  input  wire [`FFD_PACKET_W-1:0]  packet_i,  // of a header
  input  wire                      last_i,
  input  wire [2:0]                as_i,      // FFD_AS_*
  output wire [`FFD_FRAME_W-1:0]   frame_o,
  // Behind the header of a page, before its next beat can come.
  input  wire                      refuse_i,
  input  wire                      place_valid_i,
  input  wire [3*`FFD_AXIS_W(AXIS)-1:0] place_i,  // {i, j, k}
  input  wire [3*`FFD_AXIS_W(AXIS)-1:0] tops_i,
  output wire                      claims_o,  // a slot for its points
  output wire                      expects_o, // a vertex
  output wire                      idle_o
);
  generate
    if (BESIDE != 0 && BESIDE != 1) begin : gen_bad_beside
      ERROR_ffd_stream_framer_beside_must_be_0_or_1 u_error ();
    end
  endgenerate

  localparam AXIS_W      = `FFD_AXIS_W(AXIS);
  localparam PAGES       = `FFD_FEATURE_PAGES(FEATURES);
  localparam INTERLEAVED = `FFD_FEATURE_INTERLEAVED(FEATURES);

  wire [2:0] as      = as_i & {3{`FFD_FEATURE_EXPANDED(FEATURES)}};
  wire       no_grid = as == `FFD_AS_NO_GRID;
  wire       behind  = as == `FFD_AS_NOTHING;
  wire [`FFD_KIND_W-1:0] kind;

  ffd_stream_header #(
    .AXIS    (AXIS),
    .FEATURES(FEATURES),
    .SPANS   (SPANS),
    .BESIDE  (BESIDE)
  ) u_header (
    .data_i  (data_i),
    .packet_i(packet_i),
    .grid_i  (as == `FFD_AS_GRID),
    .kind_o  (kind)
  );

  wire is_coefficients = kind[`FFD_KIND_COEFFICIENTS];
  wire is_lattice      = kind[`FFD_KIND_LATTICE];
  wire good_lattice    = is_lattice && kind[`FFD_KIND_DIMENSIONS];
  wire is_vertices     = kind[`FFD_KIND_VERTICES];
  wire is_interleaved  = kind[`FFD_KIND_INTERLEAVED];
  wire of_vertices     = is_vertices || is_interleaved;
  wire none            = kind[`FFD_KIND_NONE];
  wire is_part         = kind[`FFD_KIND_PART];
  wire of_page         = PAGES != 0 && (is_lattice || is_vertices || is_part);
  wire is_spans        = kind[`FFD_KIND_SPANS];
  wire good_spans      = is_spans && !kind[`FFD_KIND_BEYOND];

  // What the next beat is: one of these, or none up to tlast.
  reg  header_q;
  reg  function_q;
  reg  point_q;
  reg  vertex_q;
  reg  points_q;
  reg  done;      // the first one behind the payload

  reg  own_q;        // vertices with points of their own
  reg  part_q;       // points are counted
  reg  every_q;      // vertices are not
  reg  spans_q;      // functions are those of so many spans
  reg  number_last;  // of them, points or spans: the number is that of the last
  wire top;
  wire own          = INTERLEAVED != 0 && own_q;
  wire final_item          = every_q ? last_i : number_last;  // it is the last
  wire vertex       = vertex_q && !no_grid && as != `FFD_AS_SHORT && !behind;
  wire vertex_done  = (vertex && !own) || (points_q && top);
  wire point_done   = point_q && (part_q ? final_item : top);
  wire functions    = top && (!spans_q || final_item);
  wire payload_done = (function_q && functions) || point_done || (vertex_done && final_item);

  always @(posedge clk) begin
    if (rst) header_q <= 1'b1;
    else if (take_i) header_q <= last_i;
  end
  always @(posedge clk) begin
    if (rst || refuse_i) begin
      {function_q, point_q, vertex_q, points_q, done} <= 5'd0;
    end else if (take_i) begin
      function_q <= !last_i && (header_q ? is_coefficients || (good_spans && !none)
                                         : function_q && !functions);
      point_q    <= !last_i && (header_q ? good_lattice || (is_part && !none)
                                         : point_q && !point_done);
      vertex_q   <= !last_i && (header_q ? of_vertices && !none : vertex_done && !final_item);
      points_q   <= !last_i && ((vertex_q && own) || (points_q && own && !top));
      done       <= !last_i && (payload_done || (done && behind));
    end
  end

  // What a header says is read in every clock in which the next beat is one: the last of these is
  // that of the beat. So it waits for no handshake.

  // ---- how many vertices, points or spans are left of a packet, with the next one, and whether
  // that is the last.

  reg  [31:0] left_q;
  wire        counted = vertex_done || point_q || (function_q && spans_q && top);
  always @(posedge clk) begin
    if (header_q) begin
      own_q   <= is_interleaved;
      part_q  <= is_part;
      every_q <= kind[`FFD_KIND_EVERY];
    end
    if (SPANS == 1) spans_q <= 1'b0;
    else if (header_q) spans_q <= is_spans;
  end
  always @(posedge clk) begin
    if (header_q) begin
      left_q      <= data_i[63:32];
      number_last <= data_i[63:32] == 32'd1;
    end else if (take_i && counted) begin
      left_q      <= left_q - 32'd1;
      number_last <= left_q == 32'd2;
    end
  end

  // ---- the place

  localparam [17:0] POINTS_TOP    = {6'd0, 6'd15, 6'd2};
  localparam [11:0] FUNCTIONS_TOP = {6'd2, 6'd3};

  wire        counts  = function_q || point_q || points_q;
  wire [2:0]  at_top;
  wire [2:0]  step    = {at_top[1] && at_top[0], at_top[0], 1'b1};
  wire [11:0] index;
  wire [5:0]  high;
  wire [17:0] derivatives_top = {5'd0, data_i[95], FUNCTIONS_TOP};
  wire [17:0] spans_top       = {6'd0, 5'd0, data_i[95], FUNCTIONS_TOP[5:0]};

  genvar d;
  generate
    for (d = 0; d < 3; d = d + 1) begin : gen_digit
      // Digit 0 of a lattice is k, the third axis.
      wire [AXIS_W-1:0] points = data_i[64+8*(2-d) +: AXIS_W];
      wire [5:0]        digit;
      reg  [AXIS_W-1:0] top_q;
      reg  [AXIS_W-1:0] digit_q;
      assign digit           = {{(6 - AXIS_W) {1'b0}}, digit_q};
      assign at_top[d]       = digit_q == top_q;
      assign index[4*d +: 4] = digit[3:0];
      assign high[2*d +: 2]  = digit[5:4];
      always @(posedge clk) begin
        if (header_q) begin
          top_q <= is_coefficients ? derivatives_top[6*d +: AXIS_W]
                 : is_spans        ? spans_top[6*d +: AXIS_W]
                 : is_lattice      ? points - 1'b1 : POINTS_TOP[6*d +: AXIS_W];
        end else if (PAGES != 0 && place_valid_i) begin
          top_q <= tops_i[AXIS_W*d +: AXIS_W];
        end
        if (!counts) digit_q <= {AXIS_W{1'b0}};
        else if (take_i && step[d]) digit_q <= at_top[d] ? {AXIS_W{1'b0}} : digit_q + 1'b1;
        else if (PAGES != 0 && place_valid_i) digit_q <= place_i[AXIS_W*d +: AXIS_W];
      end
    end
  endgenerate

  assign top = &at_top;

  // ---- the frame

  wire payload = function_q || point_q || vertex_q || points_q;
  wire refused = !(is_coefficients || good_lattice || of_vertices || is_part || good_spans);
  wire other   = BESIDE != 0 && (packet_i[`FFD_PACKET_GRADIENTS] || packet_i[`FFD_PACKET_COLLECT]);
  wire nothing = (of_vertices || is_part || is_spans) && none;
  wire finish  = (vertex && (!own || last_i)) || (points_q && (top || last_i));

  assign frame_o[`FFD_FRAME_INDEX]    = index;
  assign frame_o[`FFD_FRAME_TOP]      = top;
  assign frame_o[`FFD_FRAME_HEADER]   = header_q;
  assign frame_o[`FFD_FRAME_BANK]     = header_q && (is_coefficients || good_spans);
  assign frame_o[`FFD_FRAME_BUFFER]   = header_q && good_lattice && PAGES == 0;
  assign frame_o[`FFD_FRAME_FUNCTION] = function_q;
  assign frame_o[`FFD_FRAME_POINT]    = point_q;
  assign frame_o[`FFD_FRAME_VERTEX]   = vertex;
  assign frame_o[`FFD_FRAME_POINTS]   = points_q;
  assign frame_o[`FFD_FRAME_FINISH]   = finish;
  assign frame_o[`FFD_FRAME_FINAL]    = final_item || (last_i && !(spans_q && function_q));
  assign frame_o[`FFD_FRAME_UNKNOWN]  = header_q && refused && !is_lattice && !is_spans && !other;
  assign frame_o[`FFD_FRAME_SHORT]    = (payload && last_i && !payload_done && !no_grid)
                                     || (header_q && !of_page && !refused && (last_i || nothing));
  assign frame_o[`FFD_FRAME_LONG]     = (done && !behind) || (vertex_q && as == `FFD_AS_LONG);
  assign frame_o[`FFD_FRAME_SIZE]     = header_q && is_lattice && !good_lattice;
  assign frame_o[`FFD_FRAME_HIGH]     = high;
  assign frame_o[`FFD_FRAME_PAGE]     = header_q && of_page;
  assign frame_o[`FFD_FRAME_SPAN]     = header_q && is_spans && !good_spans;
  assign frame_o[`FFD_FRAME_REFUSED]  = vertex_q && (as == `FFD_AS_REFUSED || no_grid);
  assign frame_o[`FFD_FRAME_STOPPED]  = vertex_q && as == `FFD_AS_STOPPED;
  assign frame_o[`FFD_FRAME_PACKET]   = packet_i;
  assign claims_o                     = vertex_q && own;
  assign expects_o                    = vertex_q;
  assign idle_o                       = header_q;

  wire unused_ok = &{1'b0, place_valid_i, place_i, tops_i, derivatives_top, spans_top};
endmodule

`default_nettype wire
