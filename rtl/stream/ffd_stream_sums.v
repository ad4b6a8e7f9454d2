// ffd_stream_sums: whether the four functions of an axis sum to 1, or derivatives to 0
//
// Their coefficients of 1 must sum to 1 and those of each higher power to 0, as the words say it,
// each of which is rounded: fault_o where a sum is less by more than SLACK units of a word, or more
// by SLACK of them. Sums begin at SLACK less what is wanted, so that only their high bits count.
//
// Formats:    words Q2.30 times 2^-shift, the coefficients of 1, x, x^2, x^3; those above the
//             degree count as 0.
// Overflow:   none: four words and 1 are within [-2^33 - 2^30, 2^33 + 2^30), in 35 bits.
// Pipeline:   LATENCY from the fourth function, one of them behind the sums. A function that is no
//             first one adds to those before it.
// Parameters: LATENCY >= 1.
// Model:      golden/include/hwffd/model/function_sums.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_stream_sums #(
  parameter LATENCY = 1
) (
  input  wire         clk,
  input  wire         rst,
  input  wire         take_i,
  input  wire [127:0] words_i,
  input  wire [1:0]   function_i,
  input  wire [1:0]   degree_i,
  input  wire [1:0]   shift_i,
  input  wire         derivative_i,
  output wire         fault_o
);
  localparam        SUM_W   = 35;
  localparam        SLACK_W = 2;
  localparam [34:0] SLACK   = 1 << SLACK_W;
  localparam [34:0] ONE     = 1 << 30;

  wire [3:0] off;

  genvar w;
  generate
    for (w = 0; w < 4; w = w + 1) begin : gen_power
      localparam [3:0] ABOVE = (1 << w) - 1;  // the degrees that this power is above
      wire [31:0]      word   = words_i[32*w +: 32] & {32{!ABOVE[degree_i]}};
      wire [SUM_W-1:0] wanted = w == 0 && !derivative_i ? ONE >> shift_i : {SUM_W{1'b0}};
      reg  [SUM_W-1:0] sum_q;
      always @(posedge clk) begin
        if (take_i) sum_q <= (function_i == 2'd0 ? SLACK - wanted : sum_q)
                           + {{(SUM_W - 32) {word[31]}}, word};
      end
      assign off[w] = sum_q[SUM_W-1:SLACK_W+1] != {(SUM_W - SLACK_W - 1) {1'b0}};
    end
  endgenerate

  reg whole_q;
  always @(posedge clk) whole_q <= take_i && function_i == 2'd3 && !rst;

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(LATENCY - 1),
    .RESET  (1)
  ) u_fault (
    .clk(clk),
    .rst(rst),
    .d_i(whole_q && off != 4'd0),
    .q_o(fault_o)
  );
endmodule

`default_nettype wire
