// domain: ffd_bus_events with the codes that reads have, from 0 to 8
// SPDX-License-Identifier: Apache-2.0
module domain (
  input  wire        clk,
  input  wire        rst,
  input  wire [14:0] core_event_i,
  input  wire [31:0] core_packet_i,
  input  wire [31:0] core_beat_i,
  input  wire        read_error_i,
  input  wire [3:0]  read_error_code_i,
  input  wire [63:0] read_error_address_i,
  input  wire        write_error_i,
  input  wire [2:0]  write_error_code_i,
  input  wire [63:0] write_error_address_i,
  input  wire        result_overflow_i,
  input  wire [4:0]  timeout_i,
  output wire        error_any_o,
  output wire [28:0] error_event_o,
  output wire [31:0] error_packet_o,
  output wire [31:0] error_beat_o,
  output wire        error_address_valid_o,
  output wire [63:0] error_address_o
);
  wire [3:0] code = read_error_code_i > 4'd8 ? 4'd8 : read_error_code_i;
  ffd_bus_events u_events (
    .clk                  (clk),
    .rst                  (rst),
    .core_event_i         (core_event_i),
    .core_packet_i        (core_packet_i),
    .core_beat_i          (core_beat_i),
    .read_error_i         (read_error_i),
    .read_error_code_i    (code),
    .read_error_address_i (read_error_address_i),
    .write_error_i        (write_error_i),
    .write_error_code_i   (write_error_code_i),
    .write_error_address_i(write_error_address_i),
    .result_overflow_i    (result_overflow_i),
    .timeout_i            (timeout_i),
    .error_any_o          (error_any_o),
    .error_event_o        (error_event_o),
    .error_packet_o       (error_packet_o),
    .error_beat_o         (error_beat_o),
    .error_address_valid_o(error_address_valid_o),
    .error_address_o      (error_address_o)
  );
endmodule
