// ffd_reset: the reset of a core, with a register of its own or without
//
// A register drives the many flip-flops that are reset, so that the wire which brings aresetn need
// not: reset begins and ends a clock later. One edge is enough either way.
//
// Pipeline:   REGISTERED clocks.
// Parameters: REGISTERED 0 or 1.
// Model:      none.  Test: tests/random, tests/bus/axi (axi_wide).
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_reset #(
  parameter REGISTERED = 0
) (
  input  wire clk,
  input  wire resetn_i,
  output wire rst_o
);
  generate
    if (REGISTERED != 0 && REGISTERED != 1) begin : gen_bad_registered
      ERROR_ffd_reset_registered_must_be_0_or_1 u_error ();
    end
    if (REGISTERED != 0) begin : gen_register
      reg rst_q;
      always @(posedge clk) rst_q <= !resetn_i;
      assign rst_o = rst_q;
    end else begin : gen_wire
      assign rst_o = !resetn_i;
      wire unused_ok = &{1'b0, clk};
    end
  endgenerate
endmodule

`default_nettype wire
