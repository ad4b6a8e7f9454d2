// ffd_reset_register: the reset of a core, with a register of its own or without
//
// A register drives the many flip-flops that are reset, so that the wire which brings aresetn need
// not: reset begins and ends a clock later. In the clock behind the first edge the core still works
// and may hand over a beat, so reset must last two edges then; without the register one is enough.
//
// With HARDENED the register is held three times, so that no flip resets the core; differs_o: one
// of the three differs.
//
// Pipeline:   REGISTERED clocks.
// Parameters: REGISTERED 0 or 1; HARDENED 0 or 1.
// Model:      none.  Test: tests/random, tests/bus/axi (axi_wide).
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_reset_register #(
  parameter REGISTERED = 0,
  parameter HARDENED   = 0
) (
  input  wire clk,
  input  wire resetn_i,
  output wire rst_o,
  output wire differs_o
);
  generate
    if (REGISTERED != 0 && REGISTERED != 1) begin : gen_bad_registered
      ERROR_ffd_reset_register_registered_must_be_0_or_1 u_error ();
    end
    if (REGISTERED == 0) begin : gen_wire
      assign rst_o     = !resetn_i;
      assign differs_o = 1'b0;
      wire unused_ok = &{1'b0, clk};
    end else if (HARDENED == 0) begin : gen_register
      reg rst_q;
      always @(posedge clk) rst_q <= !resetn_i;
      assign rst_o     = rst_q;
      assign differs_o = 1'b0;
    end else begin : gen_three
      ffd_hard_triple #(
        .WIDTH(1)
      ) u_reset (
        .clk      (clk),
        .d_i      (!resetn_i),
        .q_o      (rst_o),
        .differs_o(differs_o)
      );
    end
  endgenerate
endmodule

`default_nettype wire
