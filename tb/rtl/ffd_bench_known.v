// ffd_bench_known: tells when a value is X at a rising edge at which it must be known
//
// Only the first time, as `unknown NAME clock N`; clocks are counted from the first edge on.
//
// Parameters: WIDTH of the value; its NAME.
// Test:       tests/random.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_bench_known #(
  parameter WIDTH = 1,
  parameter NAME  = ""
) (
  input wire             clk,
  input wire             must_i,
  input wire [WIDTH-1:0] value_i
);
  integer clocks;
  reg     reported;

  initial {clocks, reported} = {32'd0, 1'b0};

  always @(posedge clk) begin
    clocks <= clocks + 1;
    if (must_i && !reported && ^value_i === 1'bx) begin
      reported <= 1'b1;
      $display("unknown %0s clock %0d", NAME, clocks);
    end
  end
endmodule

`default_nettype wire
