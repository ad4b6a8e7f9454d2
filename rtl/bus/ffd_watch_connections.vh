// Ports of ffd_dma_watch that look at the bus. To be included in an instance, with more to follow.
// SPDX-License-Identifier: Apache-2.0
.arvalid_i(m_axi_arvalid),
.arready_i(m_axi_arready),
.rvalid_i (m_axi_rvalid),
.rready_i (m_axi_rready),
.rlast_i  (m_axi_rlast),
.awvalid_i(m_axi_awvalid),
.awready_i(m_axi_awready),
.wvalid_i (m_axi_wvalid),
.wready_i (m_axi_wready),
.wlast_i  (m_axi_wlast),
.bvalid_i (m_axi_bvalid),
.bready_i (m_axi_bready),
