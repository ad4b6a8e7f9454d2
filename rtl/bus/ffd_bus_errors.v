// ffd_bus_errors: the record of the first error, and how many there were
//
// event_i has a bit a kind of error; its number is the code; any_i is 1 where one of them is, so
// that nothing waits for them all to be looked at. An event is recorded, with packet and
// beat of the same clock, unless held_i says that the record is in use; of several in one clock the
// lowest code. address_valid_i says that an event of this clock has an address: the first since the
// record began is kept, so that an error without one does not hide it; 0 while there is none.
// count_o counts every event, several in one clock too, and stays at its largest value. clear_i
// sets it to 0; events of the same clock are then counted a clock later.
//
// Pipeline:   1 clock, count_o 2.  Freezes: the record while held_i is high.
// Parameters: CODES 1 to 32.
// Model:      tests/bus/axil/register_model.hpp.  Test: tests/bus/axil.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_bus_errors #(
  parameter CODES = 16
) (
  input  wire             clk,
  input  wire             rst,
  input  wire             any_i,
  input  wire [CODES-1:0] event_i,
  input  wire [31:0]      packet_i,
  input  wire [31:0]      beat_i,
  input  wire             address_valid_i,
  input  wire [63:0]      address_i,
  input  wire             held_i,
  input  wire             clear_i,
  output reg  [31:0]      count_o,
  output reg  [4:0]       code_o,
  output reg  [31:0]      packet_o,
  output reg  [31:0]      beat_o,
  output reg  [63:0]      address_o
);
  generate
    if (CODES < 1 || CODES > 32) begin : gen_bad_codes
      ERROR_ffd_bus_errors_codes_must_be_1_to_32 u_error ();
    end
  endgenerate

  integer   i;
  reg [4:0] lowest;
  reg [5:0] events;
  reg [5:0] events_q;
  reg       address_held_q;
  wire      record = !held_i && any_i;
  wire      locate = address_valid_i && !(held_i && address_held_q);

  always @* begin
    lowest = 5'd0;
    events = 6'd0;
    for (i = CODES - 1; i >= 0; i = i - 1) begin
      if (event_i[i]) lowest = i[4:0];
      events = events + {5'd0, event_i[i]};
    end
  end

  // 33 bits: the carry says that the count is full.
  wire [32:0] sum = {1'b0, count_o} + {27'd0, events_q};

  always @(posedge clk) begin
    if (rst) events_q <= 6'd0;
    else events_q <= events;
  end

  always @(posedge clk) begin
    if (rst || clear_i) count_o <= 32'd0;
    else count_o <= sum[32] ? 32'hffff_ffff : sum[31:0];
  end

  always @(posedge clk) begin
    if (rst) begin
      code_o    <= 5'd0;
      packet_o  <= 32'd0;
      beat_o    <= 32'd0;
      address_o <= 64'd0;
      address_held_q <= 1'b0;
    end else begin
      if (record) begin
        code_o   <= lowest;
        packet_o <= packet_i;
        beat_o   <= beat_i;
      end
      if (record || locate) begin
        address_o      <= address_valid_i ? address_i : 64'd0;
        address_held_q <= address_valid_i;
      end
    end
  end
endmodule

`default_nettype wire
