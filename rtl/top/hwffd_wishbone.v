// hwffd_wishbone: hwffd_axi with its registers on Wishbone B4
//
// The registers of docs/registers.md behind ffd_wb_slave; all else is that of hwffd_axi, the AXI4
// master to memory too.
//
// Formats, Pipeline, Cuts, Not checked: as hwffd_axi.
// Parameters: those of hwffd_axi, without SECURE_ONLY.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/bus/wb.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module hwffd_wishbone #(
  parameter ORG               = 1,
  parameter N                 = `FFD_ORG_N(ORG),
  parameter FORMAT            = 18,
  parameter SCHEDULE          = `FFD_SCHEDULE_OVERLAPPED,
  parameter EVALUATOR         = `FFD_EVALUATOR_ITERATIVE,
  parameter MUL_LATENCY       = 2,
  parameter ADD_LATENCY       = 1,
  parameter FMA_LATENCY       = 0,
  parameter CONVERT_LATENCY   = 1,
  parameter AXIS              = 16,
  parameter PAGES             = 2,
  parameter IN_FLIGHT         = 0,
  parameter WAITING           = 16,
  parameter RESIDENT          = 1,
  parameter INTERLEAVED       = 1,
  parameter PAGED             = 0,
  parameter FOURTH            = 0,
  parameter GRIDS             = 0,
  parameter PACKED            = 0,
  parameter MARKS             = 0,
  parameter DERIVATIVES       = 0,
  parameter DETERMINANT       = 0,
  parameter HALVES            = 0,
  parameter SPANS             = 1,
  parameter GRID_LIMIT        = 48,
  parameter MAX_BURST         = 256,
  parameter READ_DEPTH        = 512,
  parameter WRITE_DEPTH       = 512,
  parameter READ_OUTSTANDING  = 8,
  parameter WRITE_OUTSTANDING = 8,
  parameter FLUSH_CLOCKS      = 16,
  parameter COUNT_WIDTH       = 0,
  parameter BUS_TIMEOUT       = 1048576,
  parameter AXI_PROT          = 2,
  parameter AXI_CACHE         = 2,
  parameter ADDRESS_WIDTH     = 64,
  parameter DATA_WIDTH        = 128,
  parameter ID_WIDTH          = 1,
  parameter ID                = 0,
  parameter HARDENED          = 0,
  parameter RESET_REGISTER    = 0
) (
  input  wire         aclk,
  input  wire         aresetn,
  output wire         irq_o,
  output wire         sleep_o,

  input  wire         s_wb_cyc,
  input  wire         s_wb_stb,
  input  wire         s_wb_we,
  input  wire [11:0]  s_wb_adr,
  input  wire [31:0]  s_wb_dat_w,
  input  wire [3:0]   s_wb_sel,
  output wire [31:0]  s_wb_dat_r,
  output wire         s_wb_ack,
  output wire         s_wb_err,

  // The master to memory; one ID for all bursts.
  output wire [ID_WIDTH-1:0] m_axi_arid,
  output wire [ID_WIDTH-1:0] m_axi_awid,

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
  // Registers are read and written in words; not in reset and not while they are cleared.
  wire        clearing;
  wire        awake;
  wire        upset;
  wire        write_valid;
  wire [9:0]  write_word;
  wire [31:0] write_data;
  wire [3:0]  write_strobe;
  wire        write_error;
  wire        read_valid;
  wire [9:0]  read_word;
  wire [31:0] read_data;
  wire        read_error;

  wire rst;
  wire reset_differs;

  ffd_reset_register #(
    .REGISTERED(RESET_REGISTER),
    .HARDENED  (HARDENED)
  ) u_reset (
    .clk      (aclk),
    .resetn_i (aresetn),
    .rst_o    (rst),
    .differs_o(reset_differs)
  );

  ffd_bus_core #(
    .MAX_BURST        (MAX_BURST),
    .READ_DEPTH       (READ_DEPTH),
    .WRITE_DEPTH      (WRITE_DEPTH),
    .READ_OUTSTANDING (READ_OUTSTANDING),
    .WRITE_OUTSTANDING(WRITE_OUTSTANDING),
    .FLUSH_CLOCKS     (FLUSH_CLOCKS),
    .COUNT_WIDTH      (COUNT_WIDTH),
    .BUS_TIMEOUT      (BUS_TIMEOUT),
    .AXI_PROT         (AXI_PROT),
    .AXI_CACHE        (AXI_CACHE),
    .ADDRESS_WIDTH    (ADDRESS_WIDTH),
    .DATA_WIDTH       (DATA_WIDTH),
    .ID_WIDTH         (ID_WIDTH),
    .ID               (ID),
    `include "ffd_stream_arguments.vh"
  ) u_core (
    .aclk          (aclk),
    .aresetn       (!rst),
    .awake_i       (awake),
    .upset_i       (upset),
    .sleep_o       (sleep_o),
    .irq_o         (irq_o),
    .s_clearing    (clearing),
    .s_write_valid (write_valid),
    .s_write_word  (write_word),
    .s_write_data  (write_data),
    .s_write_strobe(write_strobe),
    .s_write_error (write_error),
    .s_read_valid  (read_valid),
    .s_read_word   (read_word),
    .s_read_data   (read_data),
    .s_read_error  (read_error),
    .m_axi_arid    (m_axi_arid),
    .m_axi_awid    (m_axi_awid),
    .m_axi_araddr  (m_axi_araddr),
    .m_axi_arcache (m_axi_arcache),
    .m_axi_arprot  (m_axi_arprot),
    .m_axi_awaddr  (m_axi_awaddr),
    .m_axi_awcache (m_axi_awcache),
    .m_axi_awprot  (m_axi_awprot),
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
  );

  assign upset = reset_differs;  // there is one slave only

  ffd_wb_slave #(
    .ADDRESS_W(12)
  ) u_slave (
    .clk           (aclk),
    .rst           (clearing),
    .s_wb_cyc  (s_wb_cyc),
    .s_wb_stb  (s_wb_stb),
    .s_wb_we   (s_wb_we),
    .s_wb_adr  (s_wb_adr),
    .s_wb_dat_w(s_wb_dat_w),
    .s_wb_sel  (s_wb_sel),
    .s_wb_dat_r(s_wb_dat_r),
    .s_wb_ack  (s_wb_ack),
    .s_wb_err  (s_wb_err),
    .m_awake       (awake),
    .m_write_valid (write_valid),
    .m_write_word  (write_word),
    .m_write_data  (write_data),
    .m_write_strobe(write_strobe),
    .m_write_error (write_error),
    .m_read_valid  (read_valid),
    .m_read_word   (read_word),
    .m_read_data   (read_data),
    .m_read_error  (read_error)
  );
endmodule

`default_nettype wire
