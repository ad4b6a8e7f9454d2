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
  `include "ffd_axil_ports.vh"
  `include "ffd_axi_ports.vh"
);
  hwffd_axi #(
    .ORG            (0),
    .N              (1),
    .FORMAT         (18),
    .MUL_LATENCY    (2),
    .ADD_LATENCY    (1),
    .CONVERT_LATENCY(1),
    .ADDRESS_WIDTH  (ADDRESS_WIDTH),
    .DATA_WIDTH     (DATA_WIDTH)
  ) u_core (
    .aclk          (aclk),
    .aresetn       (aresetn),
    .irq_o         (irq_o),
    .sleep_o       (sleep_o),
    .m_axi_arid    (m_axi_arid),
    .m_axi_awid    (m_axi_awid),
    `include "ffd_axil_connections.vh"
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
