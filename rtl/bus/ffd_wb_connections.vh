// Ports of a Wishbone slave, each joined with the wire of the same name. To be included in an
// instance, with more to follow.
// SPDX-License-Identifier: Apache-2.0
.s_wb_cyc  (s_wb_cyc),
.s_wb_stb  (s_wb_stb),
.s_wb_we   (s_wb_we),
.s_wb_adr  (s_wb_adr),
.s_wb_dat_w(s_wb_dat_w),
.s_wb_sel  (s_wb_sel),
.s_wb_dat_r(s_wb_dat_r),
.s_wb_ack  (s_wb_ack),
.s_wb_err  (s_wb_err),
