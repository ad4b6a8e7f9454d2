// DP16KD: the block memory of Lattice ECP5, as yosys uses it
//
// 512 rows of four bytes of nine bits. Port A writes and port B reads, each 9, 18 or 36 bits wide, or
// both 1, 2 or 4, which leave the ninth bits alone: the address counts bits, a nine-bit byte as eight
// of them. An 18-bit port has its byte enables on address
// pins 1 and 0, one of 36 bits on 3 to 0; that width takes the data pins of both ports, A's the low
// half. Read data is registered. Bytes that are read in the clock in which they are written are x, as
// yosys may not count on them; so are rows that port B writes, read data after a reset, and what port A
// reads.
//
// Pipeline:   the read register. LATENCY 1; CEB holds it.
// Parameters: others than these do not elaborate, nor do other values than those guarded below.
//             Contents start at x, which is stricter than the zeros of INITVAL.
// Not checked: CLKA and CLKB are one clock; OCEA and OCEB mean nothing without an output register.
// Test:       the tests netlist.ecp5.* (tests/system).
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module DP16KD #(
  parameter DATA_WIDTH_A = 18,
  parameter DATA_WIDTH_B = 18,
  parameter REGMODE_A = "NOREG",
  parameter REGMODE_B = "NOREG",
  parameter CSDECODE_A = "0b000",
  parameter CSDECODE_B = "0b000",
  parameter CLKAMUX = "CLKA",
  parameter CLKBMUX = "CLKB",
  parameter WRITEMODE_A = "NORMAL",
  parameter WRITEMODE_B = "NORMAL",
  parameter RESETMODE = "SYNC",
  parameter ASYNC_RESET_RELEASE = "SYNC",
  parameter GSR = "ENABLED",
  parameter [319:0] INITVAL_00 = 320'd0, INITVAL_01 = 320'd0, INITVAL_02 = 320'd0, INITVAL_03 =
    320'd0, INITVAL_04 = 320'd0, INITVAL_05 = 320'd0, INITVAL_06 = 320'd0, INITVAL_07 = 320'd0,
    INITVAL_08 = 320'd0, INITVAL_09 = 320'd0, INITVAL_0A = 320'd0, INITVAL_0B = 320'd0, INITVAL_0C
    = 320'd0, INITVAL_0D = 320'd0, INITVAL_0E = 320'd0, INITVAL_0F = 320'd0, INITVAL_10 = 320'd0,
    INITVAL_11 = 320'd0, INITVAL_12 = 320'd0, INITVAL_13 = 320'd0, INITVAL_14 = 320'd0, INITVAL_15
    = 320'd0, INITVAL_16 = 320'd0, INITVAL_17 = 320'd0, INITVAL_18 = 320'd0, INITVAL_19 = 320'd0,
    INITVAL_1A = 320'd0, INITVAL_1B = 320'd0, INITVAL_1C = 320'd0, INITVAL_1D = 320'd0, INITVAL_1E
    = 320'd0, INITVAL_1F = 320'd0, INITVAL_20 = 320'd0, INITVAL_21 = 320'd0, INITVAL_22 = 320'd0,
    INITVAL_23 = 320'd0, INITVAL_24 = 320'd0, INITVAL_25 = 320'd0, INITVAL_26 = 320'd0, INITVAL_27
    = 320'd0, INITVAL_28 = 320'd0, INITVAL_29 = 320'd0, INITVAL_2A = 320'd0, INITVAL_2B = 320'd0,
    INITVAL_2C = 320'd0, INITVAL_2D = 320'd0, INITVAL_2E = 320'd0, INITVAL_2F = 320'd0, INITVAL_30
    = 320'd0, INITVAL_31 = 320'd0, INITVAL_32 = 320'd0, INITVAL_33 = 320'd0, INITVAL_34 = 320'd0,
    INITVAL_35 = 320'd0, INITVAL_36 = 320'd0, INITVAL_37 = 320'd0, INITVAL_38 = 320'd0, INITVAL_39
    = 320'd0, INITVAL_3A = 320'd0, INITVAL_3B = 320'd0, INITVAL_3C = 320'd0, INITVAL_3D = 320'd0,
    INITVAL_3E = 320'd0, INITVAL_3F = 320'd0
) (
  input wire DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7, DIA6, DIA5,
    DIA4, DIA3, DIA2, DIA1, DIA0,
  input wire DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7, DIB6, DIB5,
    DIB4, DIB3, DIB2, DIB1, DIB0,
  input wire ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4, ADA3, ADA2, ADA1,
    ADA0,
  input wire ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4, ADB3, ADB2, ADB1,
    ADB0,
  input wire CLKA, CEA, OCEA, WEA, RSTA, CSA2, CSA1, CSA0,
  input wire CLKB, CEB, OCEB, WEB, RSTB, CSB2, CSB1, CSB0,
  output wire DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6,
    DOA5, DOA4, DOA3, DOA2, DOA1, DOA0,
  output wire DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6,
    DOB5, DOB4, DOB3, DOB2, DOB1, DOB0
);
  localparam NARROW = DATA_WIDTH_A == 1 || DATA_WIDTH_A == 2 || DATA_WIDTH_A == 4;
  localparam CONTENTS = |{INITVAL_00, INITVAL_01, INITVAL_02, INITVAL_03, INITVAL_04, INITVAL_05,
    INITVAL_06, INITVAL_07, INITVAL_08, INITVAL_09, INITVAL_0A, INITVAL_0B, INITVAL_0C,
    INITVAL_0D, INITVAL_0E, INITVAL_0F, INITVAL_10, INITVAL_11, INITVAL_12, INITVAL_13,
    INITVAL_14, INITVAL_15, INITVAL_16, INITVAL_17, INITVAL_18, INITVAL_19, INITVAL_1A,
    INITVAL_1B, INITVAL_1C, INITVAL_1D, INITVAL_1E, INITVAL_1F, INITVAL_20, INITVAL_21,
    INITVAL_22, INITVAL_23, INITVAL_24, INITVAL_25, INITVAL_26, INITVAL_27, INITVAL_28,
    INITVAL_29, INITVAL_2A, INITVAL_2B, INITVAL_2C, INITVAL_2D, INITVAL_2E, INITVAL_2F,
    INITVAL_30, INITVAL_31, INITVAL_32, INITVAL_33, INITVAL_34, INITVAL_35, INITVAL_36,
    INITVAL_37, INITVAL_38, INITVAL_39, INITVAL_3A, INITVAL_3B, INITVAL_3C, INITVAL_3D,
    INITVAL_3E, INITVAL_3F};
  generate
    if ((DATA_WIDTH_A != 9 && DATA_WIDTH_A != 18 && DATA_WIDTH_A != 36 && !NARROW)
        || (DATA_WIDTH_B != 9 && DATA_WIDTH_B != 18 && DATA_WIDTH_B != 36 && !NARROW)
        || (NARROW && DATA_WIDTH_A != DATA_WIDTH_B)) begin : gen_bad_width
      ERROR_DP16KD_widths_must_be_9_18_or_36_or_both_1_2_or_4 u_error ();
    end
    if (REGMODE_A != "NOREG" || REGMODE_B != "NOREG") begin : gen_bad_register
      ERROR_DP16KD_the_model_has_no_output_register u_error ();
    end
    if (CSDECODE_A != "0b000" || CSDECODE_B != "0b000") begin : gen_bad_select
      ERROR_DP16KD_the_model_is_selected_by_zeros u_error ();
    end
    if (CLKAMUX != "CLKA" || CLKBMUX != "CLKB") begin : gen_bad_clock
      ERROR_DP16KD_the_model_has_rising_edges_only u_error ();
    end
    if (CONTENTS) begin : gen_bad_contents
      ERROR_DP16KD_the_model_has_no_initial_contents u_error ();
    end
  endgenerate

  reg [35:0] memory_q [0:511];

  wire [13:0] address_a = {ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4, ADA3,
    ADA2, ADA1, ADA0};
  wire [13:0] address_b = {ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4, ADB3,
    ADB2, ADB1, ADB0};
  wire [35:0] written = {DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7,
    DIB6, DIB5, DIB4, DIB3, DIB2, DIB1, DIB0, DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11,
    DIA10, DIA9, DIA8, DIA7, DIA6, DIA5, DIA4, DIA3, DIA2, DIA1, DIA0};

  // The first byte of a port in its row.
  wire [1:0] lane_a = DATA_WIDTH_A == 36 ? 2'd0 :
                      DATA_WIDTH_A == 18 ? {address_a[4], 1'b0} : address_a[4:3];
  wire [1:0] lane_b = DATA_WIDTH_B == 36 ? 2'd0 :
                      DATA_WIDTH_B == 18 ? {address_b[4], 1'b0} : address_b[4:3];
  wire [3:0] enabled_a = DATA_WIDTH_A == 36 ? address_a[3:0] :
                         DATA_WIDTH_A == 18 ? {2'd0, address_a[1:0]} : 4'd1;

  wire       write = CEA && WEA && {CSA2, CSA1, CSA0} == 3'd0;
  wire [3:0] bytes = write ? enabled_a << lane_a : 4'd0;
  // Of a narrow port the bits of its byte that it has.
  wire [2:0] bit_a = NARROW ? address_a[2:0] : 3'd0;
  wire [2:0] bit_b = NARROW ? address_b[2:0] : 3'd0;
  wire [8:0] wide = NARROW ? ((9'd1 << DATA_WIDTH_A) - 9'd1) << bit_a : 9'h1FF;
  wire [35:0] mask = {wide & {9{bytes[3]}}, wide & {9{bytes[2]}}, wide & {9{bytes[1]}},
                      wide & {9{bytes[0]}}};
  wire [35:0] shifted = written << (9 * lane_a + bit_a);
  always @(posedge CLKA) begin
    if (write) memory_q[address_a[13:5]] <= memory_q[address_a[13:5]] & ~mask | shifted & mask;
    if (CEB && WEB) memory_q[address_b[13:5]] <= 36'bx;
  end

  wire [35:0] clash = address_a[13:5] == address_b[13:5] ? mask : 36'd0;
  wire [35:0] row = memory_q[address_b[13:5]] & ~clash | 36'bx & clash;
  reg  [35:0] read_q;
  always @(posedge CLKB) begin
    if (RSTB) read_q <= 36'bx;
    else if (CEB && {CSB2, CSB1, CSB0} == 3'd0) read_q <= row >> (9 * lane_b + bit_b);
  end

  assign {DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6, DOA5,
    DOA4, DOA3, DOA2, DOA1, DOA0} = DATA_WIDTH_B == 36 ? read_q[17:0] : 18'bx;
  assign {DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6, DOB5,
    DOB4, DOB3, DOB2, DOB1, DOB0} = DATA_WIDTH_B == 36 ? read_q[35:18] : read_q[17:0];
endmodule

`default_nettype wire
