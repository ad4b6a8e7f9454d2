// Ports of an AXI4 master, ADDRESS_WIDTH bits of address and DATA_WIDTH of data, parameters of the
// module, without ID: all reads are in order, and all writes (docs/interface.md section 8). To be
// included as the last of a module's ports.
// SPDX-License-Identifier: Apache-2.0

// Reads: bursts of whole beats at rising addresses.
output wire         m_axi_arvalid,
input  wire         m_axi_arready,
output wire [ADDRESS_WIDTH-1:0] m_axi_araddr,
output wire [7:0]   m_axi_arlen,
output wire [2:0]   m_axi_arsize,
output wire [1:0]   m_axi_arburst,
output wire [3:0]   m_axi_arcache,
output wire [2:0]   m_axi_arprot,
input  wire         m_axi_rvalid,
output wire         m_axi_rready,
input  wire [DATA_WIDTH-1:0] m_axi_rdata,
input  wire [1:0]   m_axi_rresp,
input  wire         m_axi_rlast,

// Writes: the same, each byte of a beat written, or of one of its halves of 16 bytes.
output wire         m_axi_awvalid,
input  wire         m_axi_awready,
output wire [ADDRESS_WIDTH-1:0] m_axi_awaddr,
output wire [7:0]   m_axi_awlen,
output wire [2:0]   m_axi_awsize,
output wire [1:0]   m_axi_awburst,
output wire [3:0]   m_axi_awcache,
output wire [2:0]   m_axi_awprot,
output wire         m_axi_wvalid,
input  wire         m_axi_wready,
output wire [DATA_WIDTH-1:0] m_axi_wdata,
output wire [DATA_WIDTH/8-1:0] m_axi_wstrb,
output wire         m_axi_wlast,
input  wire         m_axi_bvalid,
output wire         m_axi_bready,
input  wire [1:0]   m_axi_bresp
