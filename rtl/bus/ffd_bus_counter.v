// ffd_bus_counter: a count of clocks, wider than the bus that reads it
//
// Counts the clocks in which event_i is high, and once more those in which second_i is, modulo
// 2^WIDTH. latch_i, the read of the low half,
// keeps the high half of the same clock, so that two reads make one number. clear_i sets the count
// to 0, and an event of the same clock makes it 1 a clock later; what is latched stays.
//
// Pipeline:   2 clocks from event_i to low_o: nothing but a register lies before the count.
// Freezes:    never.
// Parameters: WIDTH 33 to 64.
// Model:      tests/bus/axil/register_model.hpp.  Test: tests/bus/axil.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_bus_counter #(
  parameter WIDTH = 64
) (
  input  wire        clk,
  input  wire        rst,
  input  wire        event_i,
  input  wire        second_i,
  input  wire        clear_i,
  input  wire        latch_i,
  output wire [31:0] low_o,
  output wire [31:0] high_o
);
  generate
    if (WIDTH < 33 || WIDTH > 64) begin : gen_bad_width
      ERROR_ffd_bus_counter_width_must_be_33_to_64 u_error ();
    end
  endgenerate

  reg  [WIDTH-1:0]  count_q;
  reg  [WIDTH-33:0] high_q;
  reg               event_q;
  reg               second_q;

  always @(posedge clk) begin
    if (rst || clear_i) count_q <= {WIDTH{1'b0}};
    else if (second_q) count_q <= count_q + {{(WIDTH - 2) {1'b0}}, event_q, !event_q};
    else count_q <= count_q + {{(WIDTH - 1) {1'b0}}, event_q};
  end

  always @(posedge clk) begin
    if (rst) begin
      event_q  <= 1'b0;
      second_q <= 1'b0;
      high_q  <= {(WIDTH - 32) {1'b0}};
    end else begin
      event_q  <= event_i;
      second_q <= second_i;
      if (latch_i) high_q <= count_q[WIDTH-1:32];
    end
  end

  wire [63:0] high = {{(96 - WIDTH) {1'b0}}, high_q};

  assign low_o  = count_q[31:0];
  assign high_o = high[31:0];

  wire unused_ok = &{1'b0, high[63:32]};
endmodule

`default_nettype wire
