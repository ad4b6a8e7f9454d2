// hwffd_adjoint: an evaluator and its transpose between two AXI4-Streams
//
// All packets of hwffd_stream, and gradients and collects as hwffd_scatter takes them, with the
// same functions: docs/interface.md. Results are in the order of the packets. One half works at a
// time: where a packet is the other half's, it waits until all that is before it has left.
//
// Formats:    128-bit beats, four little-endian words; fixed-point words (interface.md section 3).
// Pipeline:   ffd_scatter_fork, then both halves, which see; two clocks more than the evaluator,
//             one more than the scatter core.
// Freezes:    a stalled output holds back what the half that it comes from holds back.
// Bad input:  nothing can hang it; see the decoders. event_o and its place are those of both, of
//             which the evaluator tells of coefficients; wait_o also has a header that waits for a
//             half in bit 0; idle_o: both halves are, and no packet is under way.
//             vertex_o, second_o and upset_o are the evaluator's.
// Parameters: those of hwffd_stream but SPANS, of which there is one, and SCATTER_PAGES, those of
//             sums, 1 to 256; ROWS as in hwffd_scatter. What one half refuses, this does: FORMAT
//             12 to 18, EVALUATOR pipelined or powers, AXIS 4 to 32. WAITING is of each half,
//             HARDENED of points.
// Model:      golden/include/hwffd/model/stream_model.hpp, scatter_stream.hpp.
// Test:       tests/system/adjoint_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module hwffd_adjoint #(
  parameter ORG             = 22,
  parameter N               = `FFD_ORG_N(ORG),
  parameter FORMAT          = 17,
  parameter SCHEDULE        = `FFD_SCHEDULE_OVERLAPPED,
  parameter EVALUATOR       = `FFD_EVALUATOR_PIPELINED,
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 1,
  parameter AXIS            = 16,
  parameter PAGES           = 2,
  parameter SCATTER_PAGES   = 2,
  parameter ROWS            = 0,
  parameter IN_FLIGHT       = 0,
  parameter WAITING         = 16,
  parameter RESIDENT        = 1,
  parameter INTERLEAVED     = 0,
  parameter PAGED           = 0,
  parameter FOURTH          = 0,
  parameter GRIDS           = 1,
  parameter PACKED          = 0,
  parameter MARKS           = 0,
  parameter DERIVATIVES     = 0,
  parameter DETERMINANT     = 0,
  parameter HALVES          = 0,
  parameter GRID_LIMIT      = 48,
  parameter HARDENED        = 0,
  parameter RESET_REGISTER  = 0
) (
  input  wire         aclk,
  input  wire         aresetn,
  input  wire         s_axis_tvalid,
  output wire         s_axis_tready,
  input  wire [127:0] s_axis_tdata,
  input  wire         s_axis_tlast,
  output wire         m_axis_tvalid,
  input  wire         m_axis_tready,
  output wire [127:0] m_axis_tdata,
  output wire         m_axis_tlast,
  output wire         m_axis_tuser,  // with the last beat of a packet with the flag I
  input  wire         grid_stop_i,   // ends a grid of the evaluator that is under way
  output wire [`FFD_EVENTS-1:0] event_o,
  output wire [31:0]  event_packet_o,
  output wire [31:0]  event_beat_o,
  output wire         vertex_o,
  output wire [1:0]   second_o,
  output wire [2:0]   wait_o,
  output wire         idle_o,
  output wire         upset_o
);
  localparam SPANS = 1;  // of the transpose, too

  wire clk = aclk;
  wire rst;
  wire unused_differs;  // 0: its register is not held three times

  ffd_reset_register #(
    .REGISTERED(RESET_REGISTER),
    .HARDENED  (0)
  ) u_reset (
    .clk      (aclk),
    .resetn_i (aresetn),
    .rst_o    (rst),
    .differs_o(unused_differs)
  );

  wire [127:0] evaluator_in_data,   scatter_in_data;
  wire         evaluator_in_last,   scatter_in_last;
  wire         in_idle;
  wire         in_waits;
  wire         of_scatter;
  wire         evaluator_in_valid,  scatter_in_valid;
  wire         evaluator_in_ready,  scatter_in_ready;
  wire         evaluator_idle,      scatter_idle;
  wire         evaluator_out_valid, scatter_out_valid;
  wire [127:0] evaluator_out_data,  scatter_out_data;
  wire         evaluator_out_last,  scatter_out_last;
  wire         evaluator_out_user,  scatter_out_user;
  wire [`FFD_EVENTS-1:0] evaluator_event, scatter_event;
  wire [31:0]  evaluator_packet,    scatter_packet;
  wire [31:0]  evaluator_beat,      scatter_beat;
  wire [2:0]   evaluator_wait,      scatter_wait;

  ffd_scatter_fork u_fork (
    .clk              (clk),
    .rst              (rst),
    .s_beat_valid     (s_axis_tvalid),
    .s_beat_ready     (s_axis_tready),
    .s_beat_data      (s_axis_tdata),
    .s_beat_last      (s_axis_tlast),
    .m_evaluator_valid(evaluator_in_valid),
    .m_evaluator_ready(evaluator_in_ready),
    .m_scatter_valid  (scatter_in_valid),
    .m_scatter_ready  (scatter_in_ready),
    .m_evaluator_data (evaluator_in_data),
    .m_evaluator_last (evaluator_in_last),
    .m_scatter_data   (scatter_in_data),
    .m_scatter_last   (scatter_in_last),
    .evaluator_idle_i (evaluator_idle),
    .scatter_idle_i   (scatter_idle),
    .scatter_o        (of_scatter),
    .waits_o          (in_waits),
    .idle_o           (in_idle)
  );

  hwffd_stream #(
    .BESIDE           (1),
    `include "ffd_stream_arguments.vh"
  ) u_evaluator (
    .aclk          (aclk),
    .aresetn       (!rst),
    .s_axis_tvalid (evaluator_in_valid),
    .s_axis_tready (evaluator_in_ready),
    .s_axis_tdata  (evaluator_in_data),
    .s_axis_tlast  (evaluator_in_last),
    .m_axis_tvalid (evaluator_out_valid),
    .m_axis_tready (m_axis_tready),
    .m_axis_tdata  (evaluator_out_data),
    .m_axis_tlast  (evaluator_out_last),
    .m_axis_tuser  (evaluator_out_user),
    .grid_stop_i   (grid_stop_i),
    .event_o       (evaluator_event),
    .event_packet_o(evaluator_packet),
    .event_beat_o  (evaluator_beat),
    .vertex_o      (vertex_o),
    .second_o      (second_o),
    .wait_o        (evaluator_wait),
    .idle_o        (evaluator_idle),
    .upset_o       (upset_o)
  );

  hwffd_scatter #(
    .FORMAT     (FORMAT),
    .EVALUATOR  (EVALUATOR),
    .MUL_LATENCY(MUL_LATENCY),
    .ADD_LATENCY(ADD_LATENCY),
    .AXIS       (AXIS),
    .PAGES      (SCATTER_PAGES),
    .WAITING    (WAITING),
    .ROWS       (ROWS),
    .BESIDE     (1)
  ) u_scatter (
    .aclk          (aclk),
    .aresetn       (!rst),
    .s_axis_tvalid (scatter_in_valid),
    .s_axis_tready (scatter_in_ready),
    .s_axis_tdata  (scatter_in_data),
    .s_axis_tlast  (scatter_in_last),
    .m_axis_tvalid (scatter_out_valid),
    .m_axis_tready (m_axis_tready),
    .m_axis_tdata  (scatter_out_data),
    .m_axis_tlast  (scatter_out_last),
    .m_axis_tuser  (scatter_out_user),
    .event_o       (scatter_event),
    .event_packet_o(scatter_packet),
    .event_beat_o  (scatter_beat),
    .wait_o        (scatter_wait),
    .idle_o        (scatter_idle)
  );

  // ---- one of them has results, and tells events

  assign m_axis_tvalid = evaluator_out_valid || scatter_out_valid;
  assign m_axis_tdata  = scatter_out_valid ? scatter_out_data : evaluator_out_data;
  assign m_axis_tlast  = scatter_out_valid ? scatter_out_last : evaluator_out_last;
  assign m_axis_tuser  = scatter_out_valid ? scatter_out_user : evaluator_out_user;

  assign event_o        = evaluator_event | scatter_event;
  assign event_packet_o = of_scatter ? scatter_packet : evaluator_packet;
  assign event_beat_o   = of_scatter ? scatter_beat : evaluator_beat;

  assign wait_o = evaluator_wait | scatter_wait | {2'b00, in_waits};
  assign idle_o = evaluator_idle && scatter_idle && in_idle;

  `FFD_ASSERT(results_come_from_the_half_that_does_not_work,
              of_scatter ? !evaluator_out_valid : !scatter_out_valid)
  `FFD_ASSERT(an_event_comes_from_the_half_that_does_not_work,
              of_scatter ? evaluator_event == 0 : scatter_event == 0)
endmodule

`default_nettype wire
