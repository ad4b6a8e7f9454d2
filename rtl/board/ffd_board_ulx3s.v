// ffd_board_ulx3s: hwffd_stream behind the serial line of a ULX3S (ECP5-85F)
//
// Formats:    frames of ffd_board_bridge; 8 data bits, no parity, 1 stop bit.
// Parameters: a row of configurations.csv; AXIS and IN_FLIGHT as in hwffd_stream; CLOCKS a bit (25
//             are 1 Mbaud at 25 MHz), PAUSE_W as in ffd_board_bridge (2^20 clocks are 42 ms).
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/boards.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_eval.vh"
`include "ffd_events.vh"

module ffd_board_ulx3s #(
  `include "ffd_row_parameters.vh"
  parameter AXIS            = 16,
  parameter IN_FLIGHT       = 0,
  parameter CLOCKS          = 25,
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
    .DERIVATIVES    (1),
    .DETERMINANT    (1)
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
