// The multiplier of Gowin GW5A, which multiplier.map names and yosys 0.23 does not have, without what
// is in it.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module MULTALU27X18 (
  input  wire [26:0] A,
  input  wire [26:0] SIA,
  input  wire        ASEL,
  input  wire [25:0] D,
  input  wire        PSEL,
  input  wire        PADDSUB,
  input  wire [17:0] B,
  input  wire [47:0] C,
  input  wire        CSEL,
  input  wire [47:0] CASI,
  input  wire        CASISEL,
  input  wire        ACCSEL,
  input  wire [1:0]  ADDSUB,
  input  wire [1:0]  CLK,
  input  wire [1:0]  CE,
  input  wire [1:0]  RESET,
  output wire [47:0] DOUT,
  output wire [47:0] CASO,
  output wire [26:0] SOA
);
endmodule

`default_nettype wire
