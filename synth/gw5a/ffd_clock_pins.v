// ffd_clock_pins: the chain of registers of `make pnr` (tools/synth/scan_chain.py) on a Gowin GW5A.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_clock_pins (
  input  wire clk_i,
  input  wire scan_i,
  output wire scan_o
);
  wire clk;
  wire scan;
  wire folded;

  (* BEL = "X61Y108/IOBA" *) IBUF u_clock (
    .I(clk_i),
    .O(clk)
  );

  (* BEL = "X98Y108/IOBA" *) IBUF u_scan (
    .I(scan_i),
    .O(scan)
  );

  (* BEL = "X98Y108/IOBB" *) OBUF u_folded (
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
