// ffd_hard_copy: a register that stays a register of its own
//
// q_o(t) = d_i(t - 1). Tools for synthesis take registers with the same input for one. Each has
// words of its own that forbid it: yosys keeps the border of this module by keep_hierarchy, unless
// it is told to flatten all the same; Vivado takes that too, and dont_touch of the register;
// Quartus takes preserve and dont_merge, Synplify and what follows it syn_preserve. Others have to
// be told by their scripts, and a netlist is to be looked at: three registers for each bit of a
// ffd_hard_triple (synth.copies does so with yosys).
//
// Pipeline:   1 register, never frozen.  Reset: none; whoever needs one has it in d_i.
// Parameters: WIDTH >= 1.
// Model:      none (storage only).  Test: tests/bus/axi.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

(* keep_hierarchy = "yes" *)
module ffd_hard_copy #(
  parameter WIDTH = 1
) (
  input  wire             clk,
  input  wire [WIDTH-1:0] d_i,
  (* dont_touch = "yes", preserve, dont_merge, syn_preserve = 1 *)
  output reg  [WIDTH-1:0] q_o
);
  always @(posedge clk) q_o <= d_i;
endmodule

`default_nettype wire
