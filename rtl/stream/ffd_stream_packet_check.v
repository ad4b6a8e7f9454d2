// ffd_stream_packet_check: whether whoever is connected sends packets that are well formed
//
// Where a simulator defines FFD_PACKET_ASSERTIONS, it ends at the first event of a packet that is
// wrong, and says which packet, beat and event (docs/interface.md section 5). What only a
// computation tells, a result that saturates, a coordinate that is clamped, a page of sums that may
// have overflowed, is none; nor is the first event of a grid behind grid_stop_i, which ended it.
// Elsewhere the module is empty and costs nothing.
//
// Pipeline:   none.
// Model:      none.  Test: tests/lint/test_channel_check.py.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_events.vh"

module ffd_stream_packet_check (
  input wire                   clk,
  input wire                   rst,
  input wire                   grid_stop_i,
  input wire [`FFD_EVENTS-1:0] event_i,
  input wire [31:0]            packet_i,
  input wire [31:0]            beat_i
);
`ifdef FFD_PACKET_ASSERTIONS
  localparam [`FFD_EVENTS-1:0] COMPUTED = 1 << `FFD_EVENT_SATURATED
                                        | 1 << `FFD_EVENT_COORDINATE_OUTSIDE
                                        | 1 << `FFD_STREAM_EVENT(`FFD_EVENT_PAGE_OVERFLOWED);
  localparam GRID = `FFD_STREAM_EVENT(`FFD_EVENT_GRID_COUNT);
  reg stopped;  // the next event of a grid comes of a stop
  always @(posedge clk) stopped <= !rst && (grid_stop_i || stopped && !event_i[GRID]);

  integer number;
  always @(posedge clk) begin
    for (number = 0; number < `FFD_EVENTS; number = number + 1) begin
      if (rst === 1'b0 && event_i[number] === 1'b1 && !COMPUTED[number]
          && !(number == GRID && stopped)) begin
        $display("bad packet %0d, beat %0d: event %0d, %m", packet_i, beat_i, number);
        $stop;
      end
    end
  end
`else
  wire unused_ok = &{1'b0, clk, rst, grid_stop_i, event_i, packet_i, beat_i};
`endif
endmodule

`default_nettype wire
