// ffd_clock_pins: the chain of registers of `make pnr` (tools/synth/scan_chain.py) on a CrossLink-NX, clocked
// by the oscillator of the chip: the router takes no clock from a pin.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_clock_pins (
  input  wire scan_i,
  output wire scan_o
);
  wire clk;
  wire scan;
  wire folded;

  OSCA #(
    .HF_CLK_DIV("1")
  ) u_clock (
    .HFOUTEN (1'b1),
    .HFCLKOUT(clk)
  );

  (* LOC = "E17" *) IB u_scan (
    .I(scan_i),
    .O(scan)
  );

  (* LOC = "F13" *) OB u_folded (
    .I(folded),
    .O(scan_o)
  );

  ffd_clock_chain u_chain (
    .clk   (clk),
    .scan_i(scan),
    .scan_o(folded)
  );
endmodule

`default_nettype wire
