// ffd_bus_reset: the reset inside, a clock longer than outside
//
// rst_o is high in reset and in the clock after. With HARDENED its register is held three times, so
// that no flip resets the registers; differs_o: one of the three differs.
//
// Pipeline:   rst_o in the clock of aresetn, and until the clock after.
// Parameters: HARDENED 0 or 1.
// Model:      none (control only).  Test: tests/bus/axi.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_bus_reset #(
  parameter HARDENED = 0
) (
  input  wire clk,
  input  wire aresetn,
  output wire rst_o,
  output wire differs_o
);
  wire reset_q;
  assign rst_o = !aresetn || reset_q;

  generate
    if (HARDENED == 0) begin : gen_single
      reg own_q;
      always @(posedge clk) own_q <= !aresetn;
      assign reset_q   = own_q;
      assign differs_o = 1'b0;
    end else begin : gen_three
      ffd_hard_triple #(
        .WIDTH(1)
      ) u_reset (
        .clk      (clk),
        .d_i      (!aresetn),
        .q_o      (reset_q),
        .differs_o(differs_o)
      );
    end
  endgenerate
endmodule

`default_nettype wire
