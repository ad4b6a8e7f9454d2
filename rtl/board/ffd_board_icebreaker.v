// ffd_board_icebreaker: hwffd_stream behind the serial line of an iCEBreaker (iCE40 UP5K)
//
// What fits the chip: positions of vertices in resident lattices of 4 points an axis. It has no
// memory that is read at once, so vertices wait in flip-flops, two of them, and IN_FLIGHT is the
// smallest whose queues are in block memory.
//
// Formats:    frames of ffd_board_bridge; 8 data bits, no parity, 1 stop bit.
// Parameters: a row of configurations.csv; AXIS, IN_FLIGHT, WAITING as in hwffd_stream; CLOCKS a
//             bit (12 are 1 Mbaud at 12 MHz), PAUSE_W as in ffd_board_bridge (2^20 clocks are
//             87 ms).
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/boards.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_eval.vh"
`include "ffd_events.vh"

module ffd_board_icebreaker #(
  parameter ORG             = 0,
  parameter N               = 1,
  parameter FORMAT          = 16,
  parameter SCHEDULE        = `FFD_SCHEDULE_OVERLAPPED,
  parameter EVALUATOR       = `FFD_EVALUATOR_ITERATIVE,
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 1,
  parameter AXIS            = 4,
  parameter IN_FLIGHT       = 32,
  parameter WAITING         = 2,
  parameter CLOCKS          = 12,
  parameter PAUSE_W         = 20
) (
  input  wire clk,
  input  wire uart_rx_i,
  output wire uart_tx_o
);
  wire         rst;
  wire         command_valid;
  wire         command_ready;
  wire [127:0] command_data;
  wire         command_last;
  wire         result_valid;
  wire         result_ready;
  wire [127:0] result_data;
  wire         result_last;
  wire [`FFD_EVENTS-1:0] events;
  wire [31:0]  event_packet;
  wire [31:0]  event_beat;
  wire         vertex;
  wire [1:0]   second;
  wire [2:0]   waits;
  wire         idle;
  wire         upset;
  wire         user;

  ffd_board_reset u_reset (
    .clk  (clk),
    .rst_o(rst)
  );

  ffd_board_bridge #(
    .CLOCKS (CLOCKS),
    .PAUSE_W(PAUSE_W)
  ) u_bridge (
    .clk         (clk),
    .rst         (rst),
    .uart_rx_i   (uart_rx_i),
    .uart_tx_o   (uart_tx_o),
    .m_beat_valid(command_valid),
    .m_beat_ready(command_ready),
    .m_beat_data (command_data),
    .m_beat_last (command_last),
    .s_beat_valid(result_valid),
    .s_beat_ready(result_ready),
    .s_beat_data (result_data),
    .s_beat_last (result_last)
  );

  hwffd_stream #(
    `include "ffd_row_arguments.vh"
    .AXIS           (AXIS),
    .IN_FLIGHT      (IN_FLIGHT),
    .WAITING        (WAITING),
    .INTERLEAVED    (0)
  ) u_core (
    .aclk          (clk),
    .aresetn       (!rst),
    .s_axis_tvalid (command_valid),
    .s_axis_tready (command_ready),
    .s_axis_tdata  (command_data),
    .s_axis_tlast  (command_last),
    .m_axis_tvalid (result_valid),
    .m_axis_tready (result_ready),
    .m_axis_tdata  (result_data),
    .m_axis_tlast  (result_last),
    .m_axis_tuser  (user),
    .grid_stop_i   (1'b0),
    .event_o       (events),
    .event_packet_o(event_packet),
    .event_beat_o  (event_beat),
    .vertex_o      (vertex),
    .second_o      (second),
    .wait_o        (waits),
    .idle_o        (idle),
    .upset_o       (upset)
  );

  wire unused_ok = &{1'b0, events, event_packet, event_beat, vertex, second, waits, idle, user,
                     upset};
endmodule

`default_nettype wire
