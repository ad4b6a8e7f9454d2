// ffd_clock_pins: the chain of registers of `make pnr` (tools/synth/scan_chain.py) on a Cologne Chip
// GateMate.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_clock_pins (
  input  wire clk_i,
  input  wire scan_i,
  output wire scan_o
);
  wire pad;
  wire clk;
  wire scan;
  wire folded;

  CC_IBUF #(
    .PIN_NAME("IO_SB_A8")
  ) u_pad (
    .I(clk_i),
    .Y(pad)
  );

  CC_BUFG u_clock (
    .I(pad),
    .O(clk)
  );

  CC_IBUF #(
    .PIN_NAME("IO_SB_B3")
  ) u_scan (
    .I(scan_i),
    .Y(scan)
  );

  CC_OBUF #(
    .PIN_NAME("IO_EB_B1")
  ) u_folded (
    .A(folded),
    .O(scan_o)
  );

  ffd_clock_chain u_chain (
    .clk   (clk),
    .scan_i(scan),
    .scan_o(folded)
  );
endmodule

`default_nettype wire
