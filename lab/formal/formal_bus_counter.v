// formal_bus_counter: ffd_bus_counter from any count on, with any events and any reset
//
// No reset is assumed at the start: the count begins anywhere, so that every carry is seen.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_bus_counter #(
  parameter WIDTH = 64
) (
  input wire clk,
  input wire rst,
  input wire event_in,
  input wire clear,
  input wire latch
);
  wire [31:0] low;
  wire [31:0] high;

  ffd_bus_counter #(
    .WIDTH(WIDTH)
  ) u_dut (
    .clk    (clk),
    .rst    (rst),
    .event_i(event_in),
    .second_i(1'b0),
    .clear_i(clear),
    .latch_i(latch),
    .low_o  (low),
    .high_o (high)
  );

  (* hierconn *) wire [WIDTH-1:0] \u_dut.count_q ;
  (* hierconn *) wire             \u_dut.event_q ;
  wire [WIDTH-1:0] count = \u_dut.count_q ;

  reg              first_q = 1'b1;
  reg              rst_q;
  reg              event_q;
  reg              before_q;    // the event that was counted last
  reg              clear_q;
  reg              latch_q;
  reg [WIDTH-1:0]  count_q;
  reg [31:0]       high_q;
  always @(posedge clk) begin
    first_q <= 1'b0;
    rst_q   <= rst;
    event_q <= event_in && !rst;
    before_q <= \u_dut.event_q ;
    clear_q <= clear;
    latch_q <= latch;
    count_q <= count;
    high_q  <= high;
  end

  always @* if (!first_q) begin
    counts: assert (count == (rst_q || clear_q ? {WIDTH {1'b0}} : count_q + before_q)
                   && \u_dut.event_q == event_q && low == count[31:0]);
    latched: assert (high == (rst_q ? 32'd0 : latch_q ? count_q[WIDTH-1:32] : high_q));
  end
endmodule

`default_nettype wire
