// hwffd_axi: the core in a system: commands from memory, results to memory, registers on AXI4-Lite
//
// The registers of docs/registers.md behind ffd_axil_slave; they start runs of the DMA
// (docs/interface.md section 8), which feeds hwffd_stream and writes down what comes out.
//
// Formats:    as hwffd_stream; addresses of ADDRESS_WIDTH bits, data of DATA_WIDTH.
// Pipeline:   as hwffd_stream behind the DMA's queues.
// Cuts:       every output leaves a register, with HARDENED gates behind some, or is a constant.
// Clock:      it may stop where sleep_o is 1 and no request is offered (docs/interface.md).
// Not checked: nothing on a bus can hang it but a slave that does not answer, and that only for
//             BUS_TIMEOUT clocks.
// Parameters: as in hwffd_stream, IN_FLIGHT below 65536 (register LIMITS);
//             MAX_BURST to FLUSH_CLOCKS as in ffd_dma_engine; BUS_TIMEOUT as in ffd_dma_watch;
//             AXI_PROT and AXI_CACHE, what the master drives on *prot (010: not secure) and *cache
//             (0010: normal, not cacheable, not bufferable); ADDRESS_WIDTH 32 to 64, an address
//             beyond being outside of every window; DATA_WIDTH 64, 128 or 256; ID_WIDTH 1 to 16
//             and ID, what the master drives on *id. SECURE_ONLY as in ffd_axil_slave. HARDENED 0,
//             or 1: bits that flip do no more than docs/assurance.md says.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/bus/axi.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module hwffd_axi #(
  parameter SECURE_ONLY       = 0,
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

  ffd_channel_check #(
    .WIDTH(15)
  ) u_check_aw (
    .clk      (aclk),
    .rst      (rst),
    .valid_i  (s_axil_awvalid),
    .ready_i  (s_axil_awready),
    .payload_i({s_axil_awprot, s_axil_awaddr})
  );

  ffd_channel_check #(
    .WIDTH(36)
  ) u_check_w (
    .clk      (aclk),
    .rst      (rst),
    .valid_i  (s_axil_wvalid),
    .ready_i  (s_axil_wready),
    .payload_i({s_axil_wstrb, s_axil_wdata})
  );

  ffd_channel_check #(
    .WIDTH(15)
  ) u_check_ar (
    .clk      (aclk),
    .rst      (rst),
    .valid_i  (s_axil_arvalid),
    .ready_i  (s_axil_arready),
    .payload_i({s_axil_arprot, s_axil_araddr})
  );

  ffd_channel_check #(
    .WIDTH(DATA_WIDTH + 3)
  ) u_check_r (
    .clk      (aclk),
    .rst      (rst),
    .valid_i  (m_axi_rvalid),
    .ready_i  (m_axi_rready),
    .payload_i({m_axi_rlast, m_axi_rresp, m_axi_rdata})
  );

  ffd_channel_check #(
    .WIDTH(2)
  ) u_check_b (
    .clk      (aclk),
    .rst      (rst),
    .valid_i  (m_axi_bvalid),
    .ready_i  (m_axi_bready),
    .payload_i(m_axi_bresp)
  );

  ffd_axil_voted #(
    .ADDRESS_W  (12),
    .SECURE_ONLY(SECURE_ONLY),
    .HARDENED   (HARDENED)
  ) u_slave (
    .clk           (aclk),
    .rst           (clearing),
    .differs_o     (upset),
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
    .upset_i       (upset || reset_differs),
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
endmodule

`default_nettype wire
