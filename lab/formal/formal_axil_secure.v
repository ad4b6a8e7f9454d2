// formal_axil_secure: ffd_axil_slave with SECURE_ONLY between any bus and words that take all
//
// The words say no error, so that each error on the bus is the slave's own: bit 1 of a request's
// protection must be bit 1 of its response.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_axil_secure #(
  parameter ADDRESS_W = 6
) (
  input wire                 clk,
  input wire                 rst,
  input wire                 awvalid,
  input wire [ADDRESS_W-1:0] awaddr,
  input wire [2:0]           awprot,
  input wire                 wvalid,
  input wire [31:0]          wdata,
  input wire [3:0]           wstrb,
  input wire                 bready,
  input wire                 arvalid,
  input wire [ADDRESS_W-1:0] araddr,
  input wire [2:0]           arprot,
  input wire                 rready,
  input wire [31:0]          read_data
);
  wire        awready;
  wire        bvalid;
  wire [1:0]  bresp;
  wire        arready;
  wire        rvalid;
  wire [31:0] rdata;
  wire [1:0]  rresp;
  wire        write;
  wire        read;

  ffd_axil_slave #(
    .ADDRESS_W  (ADDRESS_W),
    .SECURE_ONLY(1)
  ) u_dut (
    .clk           (clk),
    .rst           (rst),
    .s_axil_awvalid(awvalid),
    .s_axil_awready(awready),
    .s_axil_awaddr (awaddr),
    .s_axil_awprot (awprot),
    .s_axil_wvalid (wvalid),
    .s_axil_wdata  (wdata),
    .s_axil_wstrb  (wstrb),
    .s_axil_bvalid (bvalid),
    .s_axil_bready (bready),
    .s_axil_bresp  (bresp),
    .s_axil_arvalid(arvalid),
    .s_axil_arready(arready),
    .s_axil_araddr (araddr),
    .s_axil_arprot (arprot),
    .s_axil_rvalid (rvalid),
    .s_axil_rready (rready),
    .s_axil_rdata  (rdata),
    .s_axil_rresp  (rresp),
    .m_write_valid (write),
    .m_write_error (1'b0),
    .m_read_valid  (read),
    .m_read_data   (read_data),
    .m_read_error  (1'b0)
  );

  reg first_q = 1'b1;
  reg write_q;        // handed on in the clock before
  reg read_q;
  reg answered_q;     // a write response was taken in the clock before, or none was there
  reg read_answered_q;
  always @(posedge clk) begin
    first_q         <= 1'b0;
    write_q         <= write && !rst;
    read_q          <= read && !rst;
    answered_q      <= !bvalid || bready || rst;
    read_answered_q <= !rvalid || rready || rst;
  end
  always @* if (first_q) assume (rst);

  // Requests that were taken and not answered: the oldest first, two at most.
  reg [2:0] aw_q;
  reg [2:0] ar_q;
  reg [1:0] aw_count_q;
  reg [1:0] ar_count_q;
  wire      aw   = awvalid && awready;
  wire      ar   = arvalid && arready;
  wire      b    = bvalid && bready;
  wire      r    = rvalid && rready;
  wire [1:0] aw_at = aw_count_q - b;
  wire [1:0] ar_at = ar_count_q - r;
  always @(posedge clk) begin
    if (rst) begin
      aw_count_q <= 0;
      ar_count_q <= 0;
    end else begin
      aw_count_q <= aw_at + aw;
      ar_count_q <= ar_at + ar;
    end
    aw_q <= b ? aw_q >> 1 : aw_q;
    ar_q <= r ? ar_q >> 1 : ar_q;
    if (aw) aw_q[aw_at] <= awprot[1];
    if (ar) ar_q[ar_at] <= arprot[1];
  end

  always @* if (!first_q && !rst) begin
    secure_write: assert (!bvalid || bresp == {aw_q[0], 1'b0});
    secure_read: assert (!rvalid || (rresp == {ar_q[0], 1'b0} && (!ar_q[0] || rdata == 0)));
    handed: assert (write_q == (bvalid && answered_q && !aw_q[0])
                    && read_q == (rvalid && read_answered_q && !ar_q[0]));
  end
endmodule

`default_nettype wire
