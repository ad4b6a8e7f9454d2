// Ports of the registers: a Wishbone B4 slave, classic standard cycles, 4 KB, 32 bits of data with
// granularity 8 (docs/registers.md). To be included in the list of a module's ports, more of which
// follow. Addresses are those of bytes.
// SPDX-License-Identifier: Apache-2.0
input  wire         s_wb_cyc,
input  wire         s_wb_stb,
input  wire         s_wb_we,
input  wire [11:0]  s_wb_adr,
input  wire [31:0]  s_wb_dat_w,
input  wire [3:0]   s_wb_sel,
output wire [31:0]  s_wb_dat_r,
output wire         s_wb_ack,
output wire         s_wb_err,
