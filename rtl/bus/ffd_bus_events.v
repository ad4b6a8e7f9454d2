// ffd_bus_events: what went wrong in the core and in the DMA, as events of the registers
//
// Bits 0 to 9 and from 24 on are the core's events (ffd_events.vh), 10 to 14 the DMA's refusals
// (its codes 1 to 5, of either half), 15 and 16 the bus's answer to a read and to a write (codes 6
// and 7), 17 a result that the area has no room for, once a run, 18 a ring refused for its size or
// head (code 8), 19 to 23 channels that waited too long. rtl/bus/registers.csv names them. Packet
// and beat are those of the lowest bit: the core's, or 0 where it is one of 10 to 23; the address
// is that of the DMA's lowest bit. error_any_o: whether there is an event.
//
// Pipeline:   2 clocks, overflow and channels 1.  Freezes: never.
// Cuts:       every output leaves a register.
// Model:      none.  Test: tests/bus/axil/events_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_events.vh"

module ffd_bus_events (
  input  wire        clk,
  input  wire        rst,
  input  wire [`FFD_EVENTS-1:0] core_event_i,
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
  output reg         error_any_o,
  output reg  [`FFD_ERRORS-1:0] error_event_o,
  output reg  [31:0] error_packet_o,
  output reg  [31:0] error_beat_o,
  output reg         error_address_valid_o,
  output reg  [63:0] error_address_o
);
  localparam [2:0] SLAVE_ERROR = 3'd6;
  localparam [3:0] RING = 4'd8;

  // Once more in a register on their way here, with what is to be known of them.
  reg        core_q;         // there is an event
  reg        core_first_q;   // below those of the DMA
  reg [`FFD_EVENTS-1:0] core_event_q;
  reg [31:0] core_packet_q;
  reg [31:0] core_beat_q;
  reg [8:1]  read_codes_q;   // bit c: an error of code c
  reg [7:1]  write_codes_q;
  reg        dma_q;          // there is one
  reg        write_first_q;
  reg [63:0] read_address_q;
  reg [63:0] write_address_q;

  wire [8:0] read_codes  = read_error_i ? 9'd1 << read_error_code_i : 9'd0;
  wire [7:0] write_codes = write_error_i ? 8'd1 << write_error_code_i : 8'd0;
  wire       write_first = write_error_i && (!read_error_i || read_error_code_i == RING
                           || (write_error_code_i < SLAVE_ERROR
                               && {1'b0, write_error_code_i} < read_error_code_i));
  reg        overflow_q;
  wire       overflow    = result_overflow_i && !overflow_q;
  wire       of_dma      = dma_q || overflow || timeout_i != 5'd0;
  wire       of_core     = core_first_q || (core_q && !of_dma);    // the lowest is

  always @(posedge clk) begin
    if (rst) begin
      overflow_q            <= 1'b0;
      core_q                <= 1'b0;
      core_first_q          <= 1'b0;
      core_event_q          <= {`FFD_EVENTS{1'b0}};
      read_codes_q          <= 8'd0;
      write_codes_q         <= 7'd0;
      dma_q                 <= 1'b0;
      error_any_o           <= 1'b0;
      error_event_o         <= {`FFD_ERRORS{1'b0}};
      error_address_valid_o <= 1'b0;
    end else begin
      overflow_q            <= result_overflow_i;
      core_q                <= |core_event_i;
      core_first_q          <= |core_event_i[`FFD_EVENT_SATURATED:0];
      core_event_q          <= core_event_i;
      read_codes_q          <= read_codes[8:1];
      write_codes_q         <= write_codes[7:1];
      dma_q                 <= read_error_i || write_error_i;
      error_any_o           <= core_q || of_dma;
      error_event_o         <= {core_event_q[`FFD_EVENTS-1:`FFD_EVENT_SATURATED+1], timeout_i,
                                read_codes_q[8], overflow, |write_codes_q[7:6],
                                |read_codes_q[7:6], read_codes_q[5:1] | write_codes_q[5:1],
                                core_event_q[`FFD_EVENT_SATURATED:0]};
      error_address_valid_o <= dma_q;
    end
  end

  always @(posedge clk) begin
    core_packet_q   <= core_packet_i;
    core_beat_q     <= core_beat_i;
    error_packet_o  <= of_core ? core_packet_q : 32'd0;
    error_beat_o    <= of_core ? core_beat_q : 32'd0;
    write_first_q   <= write_first;
    read_address_q  <= read_error_address_i;
    write_address_q <= write_error_address_i;
    error_address_o <= write_first_q ? write_address_q : read_address_q;
  end

  wire unused_ok = &{1'b0, read_codes[0], write_codes[0]};
endmodule

`default_nettype wire
