// Cells of Gowin GW2A that blocks.map names and yosys 0.23 does not have, without what is in them.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module MULT18X18 #(
  parameter AREG            = 1'b0,
  parameter BREG            = 1'b0,
  parameter OUT_REG         = 1'b0,
  parameter PIPE_REG        = 1'b0,
  parameter ASIGN_REG       = 1'b0,
  parameter BSIGN_REG       = 1'b0,
  parameter SOA_REG         = 1'b0,
  parameter MULT_RESET_MODE = "SYNC"
) (
  input  wire [17:0] A,
  input  wire [17:0] SIA,
  input  wire [17:0] B,
  input  wire [17:0] SIB,
  input  wire        ASIGN,
  input  wire        BSIGN,
  input  wire        ASEL,
  input  wire        BSEL,
  input  wire        CE,
  input  wire        CLK,
  input  wire        RESET,
  output wire [35:0] DOUT,
  output wire [17:0] SOA,
  output wire [17:0] SOB
);
endmodule

module SDPB #(
  parameter READ_MODE   = 1'b0,
  parameter BIT_WIDTH_0 = 32,
  parameter BIT_WIDTH_1 = 32,
  parameter BLK_SEL_0   = 3'b000,
  parameter BLK_SEL_1   = 3'b000,
  parameter RESET_MODE  = "SYNC",
  parameter INIT_RAM_00 = 256'd0
) (
  input  wire        CLKA,
  input  wire        CEA,
  input  wire [2:0]  BLKSELA,
  input  wire [13:0] ADA,
  input  wire [31:0] DI,
  input  wire        CLKB,
  input  wire        CEB,
  input  wire        OCE,
  input  wire        RESET,
  input  wire [2:0]  BLKSELB,
  input  wire [13:0] ADB,
  output wire [31:0] DO
);
endmodule

module SDPX9B #(
  parameter READ_MODE   = 1'b0,
  parameter BIT_WIDTH_0 = 36,
  parameter BIT_WIDTH_1 = 36,
  parameter BLK_SEL_0   = 3'b000,
  parameter BLK_SEL_1   = 3'b000,
  parameter RESET_MODE  = "SYNC",
  parameter INIT_RAM_00 = 288'd0
) (
  input  wire        CLKA,
  input  wire        CEA,
  input  wire [2:0]  BLKSELA,
  input  wire [13:0] ADA,
  input  wire [35:0] DI,
  input  wire        CLKB,
  input  wire        CEB,
  input  wire        OCE,
  input  wire        RESET,
  input  wire [2:0]  BLKSELB,
  input  wire [13:0] ADB,
  output wire [35:0] DO
);
endmodule

`default_nettype wire
