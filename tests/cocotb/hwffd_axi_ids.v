// hwffd_axi_ids: hwffd_axi with the signals that cocotbext-axi wants of a bus: IDs
//
// IDs are 0 and answers' are not looked at.
//
// Test: tests/cocotb.
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ns
`default_nettype none

module hwffd_axi_ids #(
  parameter ADDRESS_WIDTH = 64,
  parameter DATA_WIDTH    = 128
) (
  input  wire         aclk,
  input  wire         aresetn,
  output wire         irq_o,
  output wire         sleep_o,
  output wire [0:0]   m_axi_arid,
  input  wire [0:0]   m_axi_rid,
  output wire [0:0]   m_axi_awid,
  input  wire [0:0]   m_axi_bid,
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
);
  hwffd_axi #(
    .ORG            (0),
    .N              (1),
    .FORMAT         (18),
    .MUL_LATENCY    (2),
    .ADD_LATENCY    (1),
    .CONVERT_LATENCY(1),
    .DERIVATIVES    (1),
    .DETERMINANT    (1),
    .ADDRESS_WIDTH  (ADDRESS_WIDTH),
    .DATA_WIDTH     (DATA_WIDTH)
  ) u_core (
    .aclk          (aclk),
    .aresetn       (aresetn),
    .irq_o         (irq_o),
    .sleep_o       (sleep_o),
    .m_axi_arid    (m_axi_arid),
    .m_axi_awid    (m_axi_awid),
    .s_axil_awvalid(s_axil_awvalid),
    .s_axil_awready(s_axil_awready),
    .s_axil_awaddr (s_axil_awaddr),
    .s_axil_awprot (s_axil_awprot),
    .s_axil_wvalid (s_axil_wvalid),
    .s_axil_wready (s_axil_wready),
    .s_axil_wdata  (s_axil_wdata),
    .s_axil_wstrb  (s_axil_wstrb),
    .s_axil_bvalid (s_axil_bvalid),
    .s_axil_bready (s_axil_bready),
    .s_axil_bresp  (s_axil_bresp),
    .s_axil_arvalid(s_axil_arvalid),
    .s_axil_arready(s_axil_arready),
    .s_axil_araddr (s_axil_araddr),
    .s_axil_arprot (s_axil_arprot),
    .s_axil_rvalid (s_axil_rvalid),
    .s_axil_rready (s_axil_rready),
    .s_axil_rdata  (s_axil_rdata),
    .s_axil_rresp  (s_axil_rresp),
    .m_axi_arvalid (m_axi_arvalid),
    .m_axi_arready (m_axi_arready),
    .m_axi_araddr  (m_axi_araddr),
    .m_axi_arlen   (m_axi_arlen),
    .m_axi_arsize  (m_axi_arsize),
    .m_axi_arburst (m_axi_arburst),
    .m_axi_arcache (m_axi_arcache),
    .m_axi_arprot  (m_axi_arprot),
    .m_axi_rvalid  (m_axi_rvalid),
    .m_axi_rready  (m_axi_rready),
    .m_axi_rdata   (m_axi_rdata),
    .m_axi_rresp   (m_axi_rresp),
    .m_axi_rlast   (m_axi_rlast),
    .m_axi_awvalid (m_axi_awvalid),
    .m_axi_awready (m_axi_awready),
    .m_axi_awaddr  (m_axi_awaddr),
    .m_axi_awlen   (m_axi_awlen),
    .m_axi_awsize  (m_axi_awsize),
    .m_axi_awburst (m_axi_awburst),
    .m_axi_awcache (m_axi_awcache),
    .m_axi_awprot  (m_axi_awprot),
    .m_axi_wvalid  (m_axi_wvalid),
    .m_axi_wready  (m_axi_wready),
    .m_axi_wdata   (m_axi_wdata),
    .m_axi_wstrb   (m_axi_wstrb),
    .m_axi_wlast   (m_axi_wlast),
    .m_axi_bvalid  (m_axi_bvalid),
    .m_axi_bready  (m_axi_bready),
    .m_axi_bresp   (m_axi_bresp)
  );

  wire unused_ok = &{1'b0, m_axi_rid, m_axi_bid};
endmodule

`default_nettype wire
