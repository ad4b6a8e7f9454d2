// ffd_hard_copy: a register that stays a register of its own
//
// q_o(t) = d_i(t - 1). Tools for synthesis take registers with the same input for one; not across
// the border of this module, which they are told to keep.
//
// Pipeline:   1 register, never frozen.  Reset: none; whoever needs one has it in d_i.
// Parameters: WIDTH >= 1.
// Model:      none (storage only).  Test: tests/bus/axi.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

(* keep_hierarchy *)
module ffd_hard_copy #(
  parameter WIDTH = 1
) (
  input  wire             clk,
  input  wire [WIDTH-1:0] d_i,
  output reg  [WIDTH-1:0] q_o
);
  always @(posedge clk) q_o <= d_i;
endmodule

`default_nettype wire
