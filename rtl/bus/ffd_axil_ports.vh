// Ports of the registers: an AXI4-Lite slave of 4 KB, 32 bits of data (docs/registers.md). To be
// included in the list of a module's ports, more of which follow. Addresses are those of bytes; of
// prot, bit 1 (not secure) is looked at where only secure masters may come.
// SPDX-License-Identifier: Apache-2.0

// Writes: address, data with a strobe for each byte, response.
input  wire         s_axil_awvalid,
output wire         s_axil_awready,
input  wire [11:0]  s_axil_awaddr,
input  wire [2:0]   s_axil_awprot,
input  wire         s_axil_wvalid,
output wire         s_axil_wready,
input  wire [31:0]  s_axil_wdata,
input  wire [3:0]   s_axil_wstrb,
output wire         s_axil_bvalid,
input  wire         s_axil_bready,
output wire [1:0]   s_axil_bresp,

// Reads: address, data with a response.
input  wire         s_axil_arvalid,
output wire         s_axil_arready,
input  wire [11:0]  s_axil_araddr,
input  wire [2:0]   s_axil_arprot,
output wire         s_axil_rvalid,
input  wire         s_axil_rready,
output wire [31:0]  s_axil_rdata,
output wire [1:0]   s_axil_rresp,
