// ffd_board_icebreaker: ffd_board_core behind the serial line of an iCEBreaker (iCE40 UP5K)
//
// Formats:    frames of ffd_board_bridge; 8 data bits, no parity, 1 stop bit.
// Parameters: a row of configurations.csv; AXIS as in ffd_board_core; CLOCKS a bit (12 are 1 Mbaud
//             at 12 MHz), PAUSE_W as in ffd_board_bridge (2^20 clocks are 87 ms).
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/boards.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_eval.vh"

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

  ffd_board_core #(
    .ORG            (ORG),
    .N              (N),
    .FORMAT         (FORMAT),
    .SCHEDULE       (SCHEDULE),
    .EVALUATOR      (EVALUATOR),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (FMA_LATENCY),
    .CONVERT_LATENCY(CONVERT_LATENCY),
    .AXIS           (AXIS)
  ) u_core (
    .clk         (clk),
    .rst         (rst),
    .s_beat_valid(command_valid),
    .s_beat_ready(command_ready),
    .s_beat_data (command_data),
    .s_beat_last (command_last),
    .m_beat_valid(result_valid),
    .m_beat_ready(result_ready),
    .m_beat_data (result_data),
    .m_beat_last (result_last)
  );
endmodule

`default_nettype wire
