// ffd_stream_sideband: what goes beside the numbers of a beat
//
// While the words of a beat are converted, where they go is delayed: to which function of the
// coefficients, to which point of which page, into which slot, or that they are a vertex. So are
// the events of the beat's place in its packet, whose number and place are counted here.
//
// Formats:    frame as FFD_FRAME_*; verdict as FFD_PAGE_* and empty, of a header of a page; at
//             {k, j, i}.
// Pipeline:   LATENCY; moving: something is on its way, or was in the clock before.
// Parameters: LATENCY >= 1; AXIS as in ffd_stream_header; PAGE_W >= 1; PAIRS 0, or 1: a beat may be
//             one of two vertices, which count as two, and its events are of the second one.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_stream.vh"

module ffd_stream_sideband #(
  parameter LATENCY = 1,
  parameter AXIS    = 16,
  parameter PAGE_W  = 1,
  parameter PAIRS   = 0
) (
  input  wire                             clk,
  input  wire                             rst,
  input  wire                             take_i,
  input  wire                             last_i,
  input  wire [`FFD_FRAME_W-1:0]          frame_i,
  input  wire [`FFD_PAGE_W-1:0]           verdict_i,
  input  wire                             empty_i,
  input  wire [PAGE_W-1:0]                page_i,
  input  wire                             fourth_i,
  input  wire                             pair_i,
  output wire                             load_o,
  output wire [11:0]                      place_o,   // as FFD_FRAME_INDEX
  output wire                             lattice_write_o,
  output wire [PAGE_W-1:0]                lattice_page_o,
  output wire [3*`FFD_AXIS_W(AXIS)-1:0]   lattice_at_o,
  output wire                             lattice_fourth_o,
  output wire                             slot_write_o,
  output wire [3:0]                       slot_group_o,
  output wire [1:0]                       slot_phase_o,
  output wire                             vertex_o,
  output wire                             finish_o,
  output wire                             top_o,     // the last point of a vertex
  output wire                             final_o,
  output wire                             moving_o,
  output reg  [`FFD_EVENTS-1:0]           event_o,
  output wire [31:0]                      event_packet_o,
  output wire [31:0]                      event_beat_o
);
  localparam AXIS_W = `FFD_AXIS_W(AXIS);

  // A header of a page that is refused has no other fault.
  wire                   of_page = frame_i[`FFD_FRAME_PAGE];
  wire [`FFD_PAGE_W-1:0] verdict = verdict_i & {`FFD_PAGE_W{of_page}};
  wire                   stunted = of_page && verdict_i == {`FFD_PAGE_W{1'b0}}
                                && (last_i || empty_i);
  wire [7:0] raised = {frame_i[`FFD_FRAME_SPAN], verdict[`FFD_PAGE_FOURTH],
                      verdict[`FFD_PAGE_POINTS], verdict[`FFD_PAGE_BEYOND],
                      of_page ? verdict[`FFD_PAGE_SIZE] : frame_i[`FFD_FRAME_SIZE],
                      frame_i[`FFD_FRAME_LONG],
                      frame_i[`FFD_FRAME_SHORT] || stunted,
                      frame_i[`FFD_FRAME_UNKNOWN] || verdict[`FFD_PAGE_UNKNOWN]};
  wire [4:0] kinds = {frame_i[`FFD_FRAME_FUNCTION], frame_i[`FFD_FRAME_POINT],
                      frame_i[`FFD_FRAME_POINTS], frame_i[`FFD_FRAME_VERTEX],
                      frame_i[`FFD_FRAME_FINISH]};
  wire       points_top = frame_i[`FFD_FRAME_POINTS] && frame_i[`FFD_FRAME_TOP];

  wire        refused;  // or a grid is stopped
  wire        taken;
  wire        taken_last;
  wire [7:0]  framing;
  wire [5:0]  high;

  ffd_num_delay #(
    .WIDTH  (15),
    .LATENCY(LATENCY),
    .RESET  (1)
  ) u_taken (
    .clk(clk),
    .rst(rst),
    .d_i({15{take_i}} & {frame_i[`FFD_FRAME_REFUSED] || frame_i[`FFD_FRAME_STOPPED], 1'b1, kinds,
                         raised}),
    .q_o({refused, taken, load_o, lattice_write_o, slot_write_o, vertex_o, finish_o, framing})
  );

  ffd_num_delay #(
    .WIDTH  (3 + 12),
    .LATENCY(LATENCY)
  ) u_place (
    .clk(clk),
    .rst(1'b0),
    .d_i({last_i, points_top, frame_i[`FFD_FRAME_FINAL], frame_i[`FFD_FRAME_INDEX]}),
    .q_o({taken_last, top_o, final_o, place_o})
  );

  ffd_num_delay #(
    .WIDTH  (PAGE_W + 1 + 6),
    .LATENCY(LATENCY)
  ) u_page (
    .clk(clk),
    .rst(1'b0),
    .d_i({page_i, fourth_i, frame_i[`FFD_FRAME_HIGH]}),
    .q_o({lattice_page_o, lattice_fourth_o, high})
  );

  assign slot_group_o = place_o[7:4];
  assign slot_phase_o = place_o[1:0];

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      // Digits of a lattice are k, j, i from the lowest on.
      wire [5:0] digit = {high[2*(2-a) +: 2], place_o[4*(2-a) +: 4]};
      assign lattice_at_o[AXIS_W*a +: AXIS_W] = digit[AXIS_W-1:0];
      wire unused_ok = &{1'b0, digit};
    end
  endgenerate

  always @* begin
    event_o                                            = {`FFD_EVENTS{1'b0}};
    event_o[`FFD_EVENT_UNKNOWN_OPCODE]                 = framing[0];
    event_o[`FFD_EVENT_PACKET_SHORT]                   = framing[1];
    event_o[`FFD_EVENT_PACKET_LONG]                    = framing[2];
    event_o[`FFD_EVENT_LATTICE_SIZE]                   = framing[3];
    event_o[`FFD_EVENT_NO_LATTICE]                     = framing[4];
    event_o[`FFD_STREAM_EVENT(`FFD_EVENT_PAGE_POINTS)] = framing[5];
    event_o[`FFD_STREAM_EVENT(`FFD_EVENT_NO_FOURTH)]   = framing[6];
    event_o[`FFD_STREAM_EVENT(`FFD_EVENT_SPAN_BEYOND)] = framing[7];
    event_o[`FFD_STREAM_EVENT(`FFD_EVENT_GRID_COUNT)]  = refused;
  end

  wire [31:0] beat;
  ffd_stream_place u_event_place (
    .clk     (clk),
    .rst     (rst),
    .take_i  (taken),
    .last_i  (taken_last),
    .packet_o(event_packet_o),
    .beat_o  (beat)
  );

  generate
    if (PAIRS != 0) begin : gen_pairs
      reg  [31:0] seconds_q;  // vertices of the packet that came with another one
      wire        taken_pair;
      wire [31:0] seconds = seconds_q + {31'd0, taken_pair};
      ffd_num_delay #(
        .WIDTH  (1),
        .LATENCY(LATENCY)
      ) u_pair (
        .clk(clk),
        .rst(1'b0),
        .d_i(pair_i),
        .q_o(taken_pair)
      );
      always @(posedge clk) begin
        if (rst || (taken && taken_last)) seconds_q <= 32'd0;
        else if (taken) seconds_q <= seconds;
      end
      assign event_beat_o = beat + seconds;
    end else begin : gen_no_pairs
      assign event_beat_o = beat;
      wire unused_pair = &{1'b0, pair_i};
    end
  endgenerate

  // What has been taken is known behind the converters.
  reg  [LATENCY-1:0] moving_q;
  wire [LATENCY:0]   moving = {moving_q, take_i};
  always @(posedge clk) moving_q <= rst ? {LATENCY {1'b0}} : moving[LATENCY-1:0];
  assign moving_o = moving_q != {LATENCY {1'b0}};

  wire unused_ok = &{1'b0, frame_i, moving[LATENCY]};
endmodule

`default_nettype wire
