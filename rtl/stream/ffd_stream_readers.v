// ffd_stream_readers: which of two banks is still read by a vertex inside
//
// Counts the vertices of either bank from the clock in which they leave the decoder until their
// result has left. A bank may be overwritten when it has none.
//
// Pipeline:   busy_o is a register, a clock behind the count: a bank that has come into use is not
//             asked about for a packet's length.
// Parameters: MOST >= 1, the most vertices inside.
// Model:      none (order only).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_stream_readers #(
  parameter MOST = 16
) (
  input  wire       clk,
  input  wire       rst,
  input  wire       enter_i,
  input  wire       enter_bank_i,
  input  wire       leave_i,
  input  wire       leave_bank_i,
  output reg  [1:0] busy_o
);
  localparam COUNT_W = $clog2(MOST + 1);

  genvar b;
  generate
    for (b = 0; b < 2; b = b + 1) begin : gen_bank
      localparam [0:0] BANK = b;
      reg  [COUNT_W-1:0] inside_q;
      wire               enter = enter_i && enter_bank_i == BANK;
      wire               leave = leave_i && leave_bank_i == BANK;
      always @(posedge clk) begin
        if (rst) inside_q <= {COUNT_W{1'b0}};
        else if (enter && !leave) inside_q <= inside_q + 1'b1;
        else if (leave && !enter) inside_q <= inside_q - 1'b1;
      end
      always @(posedge clk) busy_o[b] <= !rst && inside_q != {COUNT_W{1'b0}};
    end
  endgenerate
endmodule

`default_nettype wire
