// two_clocks: hwffd_axi with a clock of its own, beside that of the bus
//
// Each channel of both buses crosses in a queue (async_fifo). The registers and the memory work with
// aclk, the core with core_clk, which may be faster or slower and need not have anything to do with it.
//
// Pipeline:   an access to a register takes some ten clocks more; bursts come at full speed of the
//             slower side, with the latency of the queues.
// Reset:      aresetn is synchronous to aclk and core_resetn to core_clk; hold both at once for some
//             clocks of either.
// Parameters: set those of hwffd_axi here; widths of the memory's bus are passed on.
// Test:       tests/standalone/test_two_clocks.py
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module two_clocks #(
  parameter ADDRESS_WIDTH = 64,
  parameter DATA_WIDTH    = 128,
  parameter ID_WIDTH      = 1
) (
  input  wire         core_clk,
  input  wire         core_resetn,
  input  wire         aclk,
  input  wire         aresetn,
  output wire         irq_o,
  output wire         sleep_o,
  input  wire s_axil_awvalid,
  output wire s_axil_awready,
  input  wire [11:0] s_axil_awaddr,
  input  wire [2:0] s_axil_awprot,
  input  wire s_axil_wvalid,
  output wire s_axil_wready,
  input  wire [31:0] s_axil_wdata,
  input  wire [3:0] s_axil_wstrb,
  output wire s_axil_bvalid,
  input  wire s_axil_bready,
  output wire [1:0] s_axil_bresp,
  input  wire s_axil_arvalid,
  output wire s_axil_arready,
  input  wire [11:0] s_axil_araddr,
  input  wire [2:0] s_axil_arprot,
  output wire s_axil_rvalid,
  input  wire s_axil_rready,
  output wire [31:0] s_axil_rdata,
  output wire [1:0] s_axil_rresp,
  output wire m_axi_arvalid,
  input  wire m_axi_arready,
  output wire [ID_WIDTH-1:0] m_axi_arid,
  output wire [ADDRESS_WIDTH-1:0] m_axi_araddr,
  output wire [7:0] m_axi_arlen,
  output wire [2:0] m_axi_arsize,
  output wire [1:0] m_axi_arburst,
  output wire [3:0] m_axi_arcache,
  output wire [2:0] m_axi_arprot,
  input  wire m_axi_rvalid,
  output wire m_axi_rready,
  input  wire [DATA_WIDTH-1:0] m_axi_rdata,
  input  wire [1:0] m_axi_rresp,
  input  wire m_axi_rlast,
  output wire m_axi_awvalid,
  input  wire m_axi_awready,
  output wire [ID_WIDTH-1:0] m_axi_awid,
  output wire [ADDRESS_WIDTH-1:0] m_axi_awaddr,
  output wire [7:0] m_axi_awlen,
  output wire [2:0] m_axi_awsize,
  output wire [1:0] m_axi_awburst,
  output wire [3:0] m_axi_awcache,
  output wire [2:0] m_axi_awprot,
  output wire m_axi_wvalid,
  input  wire m_axi_wready,
  output wire [DATA_WIDTH-1:0] m_axi_wdata,
  output wire [DATA_WIDTH/8-1:0] m_axi_wstrb,
  output wire m_axi_wlast,
  input  wire m_axi_bvalid,
  output wire m_axi_bready,
  input  wire [1:0] m_axi_bresp
);
  // The names of the core's side have core_ in front.
  wire core_s_axil_awvalid, core_s_axil_awready;
  wire [11:0] core_s_axil_awaddr;
  wire [2:0] core_s_axil_awprot;
  wire core_s_axil_wvalid, core_s_axil_wready;
  wire [31:0] core_s_axil_wdata;
  wire [3:0] core_s_axil_wstrb;
  wire core_s_axil_bvalid, core_s_axil_bready;
  wire [1:0] core_s_axil_bresp;
  wire core_s_axil_arvalid, core_s_axil_arready;
  wire [11:0] core_s_axil_araddr;
  wire [2:0] core_s_axil_arprot;
  wire core_s_axil_rvalid, core_s_axil_rready;
  wire [31:0] core_s_axil_rdata;
  wire [1:0] core_s_axil_rresp;
  wire core_m_axi_arvalid, core_m_axi_arready;
  wire [ID_WIDTH-1:0] core_m_axi_arid;
  wire [ADDRESS_WIDTH-1:0] core_m_axi_araddr;
  wire [7:0] core_m_axi_arlen;
  wire [2:0] core_m_axi_arsize;
  wire [1:0] core_m_axi_arburst;
  wire [3:0] core_m_axi_arcache;
  wire [2:0] core_m_axi_arprot;
  wire core_m_axi_rvalid, core_m_axi_rready;
  wire [DATA_WIDTH-1:0] core_m_axi_rdata;
  wire [1:0] core_m_axi_rresp;
  wire core_m_axi_rlast;
  wire core_m_axi_awvalid, core_m_axi_awready;
  wire [ID_WIDTH-1:0] core_m_axi_awid;
  wire [ADDRESS_WIDTH-1:0] core_m_axi_awaddr;
  wire [7:0] core_m_axi_awlen;
  wire [2:0] core_m_axi_awsize;
  wire [1:0] core_m_axi_awburst;
  wire [3:0] core_m_axi_awcache;
  wire [2:0] core_m_axi_awprot;
  wire core_m_axi_wvalid, core_m_axi_wready;
  wire [DATA_WIDTH-1:0] core_m_axi_wdata;
  wire [DATA_WIDTH/8-1:0] core_m_axi_wstrb;
  wire core_m_axi_wlast;
  wire core_m_axi_bvalid, core_m_axi_bready;
  wire [1:0] core_m_axi_bresp;

  async_fifo #(
    .WIDTH     (15),
    .DEPTH_LOG2(3)
  ) u_s_axil_aw (
    .write_clk    (aclk),
    .write_rst    (!aresetn),
    .write_valid_i(s_axil_awvalid),
    .write_ready_o(s_axil_awready),
    .write_data_i ({s_axil_awaddr, s_axil_awprot}),
    .read_clk     (core_clk),
    .read_rst     (!core_resetn),
    .read_valid_o (core_s_axil_awvalid),
    .read_ready_i (core_s_axil_awready),
    .read_data_o  ({core_s_axil_awaddr, core_s_axil_awprot})
  );

  async_fifo #(
    .WIDTH     (36),
    .DEPTH_LOG2(3)
  ) u_s_axil_w (
    .write_clk    (aclk),
    .write_rst    (!aresetn),
    .write_valid_i(s_axil_wvalid),
    .write_ready_o(s_axil_wready),
    .write_data_i ({s_axil_wdata, s_axil_wstrb}),
    .read_clk     (core_clk),
    .read_rst     (!core_resetn),
    .read_valid_o (core_s_axil_wvalid),
    .read_ready_i (core_s_axil_wready),
    .read_data_o  ({core_s_axil_wdata, core_s_axil_wstrb})
  );

  async_fifo #(
    .WIDTH     (2),
    .DEPTH_LOG2(3)
  ) u_s_axil_b (
    .write_clk    (core_clk),
    .write_rst    (!core_resetn),
    .write_valid_i(core_s_axil_bvalid),
    .write_ready_o(core_s_axil_bready),
    .write_data_i (core_s_axil_bresp),
    .read_clk     (aclk),
    .read_rst     (!aresetn),
    .read_valid_o (s_axil_bvalid),
    .read_ready_i (s_axil_bready),
    .read_data_o  (s_axil_bresp)
  );

  async_fifo #(
    .WIDTH     (15),
    .DEPTH_LOG2(3)
  ) u_s_axil_ar (
    .write_clk    (aclk),
    .write_rst    (!aresetn),
    .write_valid_i(s_axil_arvalid),
    .write_ready_o(s_axil_arready),
    .write_data_i ({s_axil_araddr, s_axil_arprot}),
    .read_clk     (core_clk),
    .read_rst     (!core_resetn),
    .read_valid_o (core_s_axil_arvalid),
    .read_ready_i (core_s_axil_arready),
    .read_data_o  ({core_s_axil_araddr, core_s_axil_arprot})
  );

  async_fifo #(
    .WIDTH     (34),
    .DEPTH_LOG2(3)
  ) u_s_axil_r (
    .write_clk    (core_clk),
    .write_rst    (!core_resetn),
    .write_valid_i(core_s_axil_rvalid),
    .write_ready_o(core_s_axil_rready),
    .write_data_i ({core_s_axil_rdata, core_s_axil_rresp}),
    .read_clk     (aclk),
    .read_rst     (!aresetn),
    .read_valid_o (s_axil_rvalid),
    .read_ready_i (s_axil_rready),
    .read_data_o  ({s_axil_rdata, s_axil_rresp})
  );

  async_fifo #(
    .WIDTH     (ID_WIDTH + ADDRESS_WIDTH + 20),
    .DEPTH_LOG2(3)
  ) u_m_axi_ar (
    .write_clk    (core_clk),
    .write_rst    (!core_resetn),
    .write_valid_i(core_m_axi_arvalid),
    .write_ready_o(core_m_axi_arready),
    .write_data_i ({core_m_axi_arid, core_m_axi_araddr, core_m_axi_arlen, core_m_axi_arsize, core_m_axi_arburst, core_m_axi_arcache, core_m_axi_arprot}),
    .read_clk     (aclk),
    .read_rst     (!aresetn),
    .read_valid_o (m_axi_arvalid),
    .read_ready_i (m_axi_arready),
    .read_data_o  ({m_axi_arid, m_axi_araddr, m_axi_arlen, m_axi_arsize, m_axi_arburst, m_axi_arcache, m_axi_arprot})
  );

  async_fifo #(
    .WIDTH     (DATA_WIDTH + 3),
    .DEPTH_LOG2(4)
  ) u_m_axi_r (
    .write_clk    (aclk),
    .write_rst    (!aresetn),
    .write_valid_i(m_axi_rvalid),
    .write_ready_o(m_axi_rready),
    .write_data_i ({m_axi_rdata, m_axi_rresp, m_axi_rlast}),
    .read_clk     (core_clk),
    .read_rst     (!core_resetn),
    .read_valid_o (core_m_axi_rvalid),
    .read_ready_i (core_m_axi_rready),
    .read_data_o  ({core_m_axi_rdata, core_m_axi_rresp, core_m_axi_rlast})
  );

  async_fifo #(
    .WIDTH     (ID_WIDTH + ADDRESS_WIDTH + 20),
    .DEPTH_LOG2(3)
  ) u_m_axi_aw (
    .write_clk    (core_clk),
    .write_rst    (!core_resetn),
    .write_valid_i(core_m_axi_awvalid),
    .write_ready_o(core_m_axi_awready),
    .write_data_i ({core_m_axi_awid, core_m_axi_awaddr, core_m_axi_awlen, core_m_axi_awsize, core_m_axi_awburst, core_m_axi_awcache, core_m_axi_awprot}),
    .read_clk     (aclk),
    .read_rst     (!aresetn),
    .read_valid_o (m_axi_awvalid),
    .read_ready_i (m_axi_awready),
    .read_data_o  ({m_axi_awid, m_axi_awaddr, m_axi_awlen, m_axi_awsize, m_axi_awburst, m_axi_awcache, m_axi_awprot})
  );

  async_fifo #(
    .WIDTH     (DATA_WIDTH + DATA_WIDTH/8 + 1),
    .DEPTH_LOG2(4)
  ) u_m_axi_w (
    .write_clk    (core_clk),
    .write_rst    (!core_resetn),
    .write_valid_i(core_m_axi_wvalid),
    .write_ready_o(core_m_axi_wready),
    .write_data_i ({core_m_axi_wdata, core_m_axi_wstrb, core_m_axi_wlast}),
    .read_clk     (aclk),
    .read_rst     (!aresetn),
    .read_valid_o (m_axi_wvalid),
    .read_ready_i (m_axi_wready),
    .read_data_o  ({m_axi_wdata, m_axi_wstrb, m_axi_wlast})
  );

  async_fifo #(
    .WIDTH     (2),
    .DEPTH_LOG2(3)
  ) u_m_axi_b (
    .write_clk    (aclk),
    .write_rst    (!aresetn),
    .write_valid_i(m_axi_bvalid),
    .write_ready_o(m_axi_bready),
    .write_data_i (m_axi_bresp),
    .read_clk     (core_clk),
    .read_rst     (!core_resetn),
    .read_valid_o (core_m_axi_bvalid),
    .read_ready_i (core_m_axi_bready),
    .read_data_o  (core_m_axi_bresp)
  );

  // Two levels, each through two flip-flops.
  wire       core_irq, core_sleep;
  (* ASYNC_REG = "TRUE" *) reg [1:0] levels_q [0:1];
  assign {irq_o, sleep_o} = levels_q[1];
  always @(posedge aclk) begin
    levels_q[0] <= {core_irq, core_sleep};
    levels_q[1] <= levels_q[0];
    if (!aresetn) begin
      levels_q[0] <= 2'b00;
      levels_q[1] <= 2'b00;
    end
  end

  hwffd_axi #(
    .ADDRESS_WIDTH(ADDRESS_WIDTH),
    .DATA_WIDTH   (DATA_WIDTH),
    .ID_WIDTH     (ID_WIDTH)
  ) u_core (
    .aclk          (core_clk),
    .aresetn       (core_resetn),
    .irq_o         (core_irq),
    .sleep_o       (core_sleep),
    .s_axil_awvalid(core_s_axil_awvalid),
    .s_axil_awready(core_s_axil_awready),
    .s_axil_awaddr (core_s_axil_awaddr),
    .s_axil_awprot (core_s_axil_awprot),
    .s_axil_wvalid (core_s_axil_wvalid),
    .s_axil_wready (core_s_axil_wready),
    .s_axil_wdata  (core_s_axil_wdata),
    .s_axil_wstrb  (core_s_axil_wstrb),
    .s_axil_bvalid (core_s_axil_bvalid),
    .s_axil_bready (core_s_axil_bready),
    .s_axil_bresp  (core_s_axil_bresp),
    .s_axil_arvalid(core_s_axil_arvalid),
    .s_axil_arready(core_s_axil_arready),
    .s_axil_araddr (core_s_axil_araddr),
    .s_axil_arprot (core_s_axil_arprot),
    .s_axil_rvalid (core_s_axil_rvalid),
    .s_axil_rready (core_s_axil_rready),
    .s_axil_rdata  (core_s_axil_rdata),
    .s_axil_rresp  (core_s_axil_rresp),
    .m_axi_arvalid (core_m_axi_arvalid),
    .m_axi_arready (core_m_axi_arready),
    .m_axi_arid    (core_m_axi_arid),
    .m_axi_araddr  (core_m_axi_araddr),
    .m_axi_arlen   (core_m_axi_arlen),
    .m_axi_arsize  (core_m_axi_arsize),
    .m_axi_arburst (core_m_axi_arburst),
    .m_axi_arcache (core_m_axi_arcache),
    .m_axi_arprot  (core_m_axi_arprot),
    .m_axi_rvalid  (core_m_axi_rvalid),
    .m_axi_rready  (core_m_axi_rready),
    .m_axi_rdata   (core_m_axi_rdata),
    .m_axi_rresp   (core_m_axi_rresp),
    .m_axi_rlast   (core_m_axi_rlast),
    .m_axi_awvalid (core_m_axi_awvalid),
    .m_axi_awready (core_m_axi_awready),
    .m_axi_awid    (core_m_axi_awid),
    .m_axi_awaddr  (core_m_axi_awaddr),
    .m_axi_awlen   (core_m_axi_awlen),
    .m_axi_awsize  (core_m_axi_awsize),
    .m_axi_awburst (core_m_axi_awburst),
    .m_axi_awcache (core_m_axi_awcache),
    .m_axi_awprot  (core_m_axi_awprot),
    .m_axi_wvalid  (core_m_axi_wvalid),
    .m_axi_wready  (core_m_axi_wready),
    .m_axi_wdata   (core_m_axi_wdata),
    .m_axi_wstrb   (core_m_axi_wstrb),
    .m_axi_wlast   (core_m_axi_wlast),
    .m_axi_bvalid  (core_m_axi_bvalid),
    .m_axi_bready  (core_m_axi_bready),
    .m_axi_bresp   (core_m_axi_bresp)
  );
endmodule

`default_nettype wire
