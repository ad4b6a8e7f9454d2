// Ports of an AXI4 master that are joined with the wire of the same name wherever the master is
// handed on, addresses and constants apart. To be included in an instance, as the last of its
// ports.
// SPDX-License-Identifier: Apache-2.0
.m_axi_arvalid (m_axi_arvalid),
.m_axi_arready (m_axi_arready),
.m_axi_arlen   (m_axi_arlen),
.m_axi_arsize  (m_axi_arsize),
.m_axi_arburst (m_axi_arburst),
.m_axi_rvalid  (m_axi_rvalid),
.m_axi_rready  (m_axi_rready),
.m_axi_rdata   (m_axi_rdata),
.m_axi_rresp   (m_axi_rresp),
.m_axi_rlast   (m_axi_rlast),
.m_axi_awvalid (m_axi_awvalid),
.m_axi_awready (m_axi_awready),
.m_axi_awlen   (m_axi_awlen),
.m_axi_awsize  (m_axi_awsize),
.m_axi_awburst (m_axi_awburst),
.m_axi_wvalid  (m_axi_wvalid),
.m_axi_wready  (m_axi_wready),
.m_axi_wdata   (m_axi_wdata),
.m_axi_wstrb   (m_axi_wstrb),
.m_axi_wlast   (m_axi_wlast),
.m_axi_bvalid  (m_axi_bvalid),
.m_axi_bready  (m_axi_bready),
.m_axi_bresp   (m_axi_bresp)
