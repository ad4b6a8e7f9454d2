// ffd_channel_check: whether whoever is connected keeps the rules of valid and ready
//
// Where a simulator defines FFD_ASSERTIONS, it ends and names the instance at the first clock out
// of reset in which valid is not known, or ready where valid is high, valid falls before ready has
// come, or what stands beside valid changes meanwhile. Elsewhere the module is empty and costs
// nothing.
//
// Pipeline:   none.
// Parameters: WIDTH >= 1, bits of what stands beside valid.
// Model:      none.  Test: tests/lint/test_channel_check.py.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"

module ffd_channel_check #(
  parameter WIDTH = 1
) (
  input wire             clk,
  input wire             rst,
  input wire             valid_i,
  input wire             ready_i,
  input wire [WIDTH-1:0] payload_i
);
`ifdef FFD_ASSERTIONS
  reg             waits_q;
  reg [WIDTH-1:0] payload_q;
  always @(posedge clk) begin
    waits_q   <= !rst && valid_i && !ready_i;
    payload_q <= payload_i;
  end
  `FFD_ASSERT(valid_is_unknown, (valid_i ^ valid_i) === 1'b0)
  `FFD_ASSERT(ready_is_unknown, !valid_i || (ready_i ^ ready_i) === 1'b0)
  `FFD_ASSERT(valid_falls_before_ready, !waits_q || valid_i)
  `FFD_ASSERT(payload_changes_before_ready, !waits_q || payload_i === payload_q)
`else
  wire unused_ok = &{1'b0, clk, rst, valid_i, ready_i, payload_i};
`endif
endmodule

`default_nettype wire
