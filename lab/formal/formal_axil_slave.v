// formal_axil_slave: ffd_axil_slave between any bus and any words
//
// Each channel is a queue of its own (properties_queue): requests to the clock in which they are
// handed on, and what the words answer to the response on the bus.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_axil_slave #(
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
  input wire                 write_error,
  input wire [31:0]          read_data,
  input wire                 read_error,
  input wire                 follow
);
  wire                 awready;
  wire                 wready;
  wire                 bvalid;
  wire [1:0]           bresp;
  wire                 arready;
  wire                 rvalid;
  wire [31:0]          rdata;
  wire [1:0]           rresp;
  wire                 write;
  wire [ADDRESS_W-3:0] write_word;
  wire [31:0]          write_data;
  wire [3:0]           write_strobe;
  wire                 read;
  wire [ADDRESS_W-3:0] read_word;

  ffd_axil_slave #(
    .ADDRESS_W(ADDRESS_W)
  ) u_dut (
    .clk           (clk),
    .rst           (rst),
    .s_axil_awvalid(awvalid),
    .s_axil_awready(awready),
    .s_axil_awaddr (awaddr),
    .s_axil_awprot (awprot),
    .s_axil_wvalid (wvalid),
    .s_axil_wready (wready),
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
    .m_write_word  (write_word),
    .m_write_data  (write_data),
    .m_write_strobe(write_strobe),
    .m_write_error (write_error),
    .m_read_valid  (read),
    .m_read_word   (read_word),
    .m_read_data   (read_data),
    .m_read_error  (read_error)
  );

  properties_queue #(.WIDTH(ADDRESS_W - 2), .CAPACITY(1), .WAIT(1)) aw (
    .clk(clk), .rst(rst), .follow_i(follow),
    .s_valid(awvalid), .s_ready(awready), .s_data(awaddr[ADDRESS_W-1:2]),
    .m_valid(write), .m_ready(1'b1), .m_data(write_word)
  );

  properties_queue #(.WIDTH(36), .CAPACITY(1), .WAIT(1)) w (
    .clk(clk), .rst(rst), .follow_i(follow),
    .s_valid(wvalid), .s_ready(wready),
    .s_data({wstrb, wdata}),
    .m_valid(write), .m_ready(1'b1), .m_data({write_strobe, write_data})
  );

  properties_queue #(.WIDTH(2), .CAPACITY(1)) b (
    .clk(clk), .rst(rst), .follow_i(follow),
    .s_valid(write), .s_ready(1'b1), .s_data({write_error, 1'b0}),
    .m_valid(bvalid), .m_ready(bready), .m_data(bresp)
  );

  properties_queue #(.WIDTH(ADDRESS_W - 2), .CAPACITY(1), .WAIT(1)) ar (
    .clk(clk), .rst(rst), .follow_i(follow),
    .s_valid(arvalid), .s_ready(arready), .s_data(araddr[ADDRESS_W-1:2]),
    .m_valid(read), .m_ready(1'b1), .m_data(read_word)
  );

  properties_queue #(.WIDTH(34), .CAPACITY(1)) r (
    .clk(clk), .rst(rst), .follow_i(follow),
    .s_valid(read), .s_ready(1'b1),
    .s_data({read_error, 1'b0, read_error ? 32'd0 : read_data}),
    .m_valid(rvalid), .m_ready(rready), .m_data({rresp, rdata})
  );

  // Requests taken and not yet answered on the bus; two at most: one answered, one waiting.
  reg       first_q = 1'b1;
  reg       rst_q;
  reg [2:0] aw_q;
  reg [2:0] w_q;
  reg [2:0] ar_q;
  reg [1:0] write_late_q;    // clocks in which a whole write is inside and no response is there
  reg [1:0] read_late_q;
  wire      written = bvalid && bready;
  wire      was_read = rvalid && rready;
  always @(posedge clk) begin
    first_q <= 1'b0;
    rst_q   <= rst;
    if (rst) begin
      aw_q         <= 0;
      w_q          <= 0;
      ar_q         <= 0;
      write_late_q <= 0;
      read_late_q  <= 0;
    end else begin
      aw_q         <= aw_q + (awvalid && awready) - written;
      w_q          <= w_q + (wvalid && wready) - written;
      ar_q         <= ar_q + (arvalid && arready) - was_read;
      write_late_q <= aw_q == 0 || w_q == 0 || bvalid ? 0 : write_late_q + (write_late_q != 3);
      read_late_q  <= ar_q == 0 || rvalid ? 0 : read_late_q + (read_late_q != 3);
    end
  end

  reg [ADDRESS_W-3:0] write_word_q;
  reg [ADDRESS_W-3:0] read_word_q;
  always @(posedge clk) begin
    write_word_q <= write_word;
    read_word_q  <= read_word;
  end

  always @* if (!first_q && !rst) begin
    early: assert ((!write || write_word == write_word_q) && (!read || read_word == read_word_q));
    write_once: assert (aw_q <= 2 && w_q <= 2 && !(bvalid && (aw_q == 0 || w_q == 0)));
    read_once: assert (ar_q <= 2 && !(rvalid && ar_q == 0));
    write_live: assert (aw_q == 0 || w_q == 0 || bvalid || write_late_q < 2);
    read_live: assert (ar_q == 0 || rvalid || read_late_q < 2);
    separate: assert (!(bresp[0] && bvalid) && !(rresp[0] && rvalid));
  end
  always @* if (!first_q) begin
    closed: assert (!rst_q || (!awready && !wready && !arready && !bvalid && !rvalid));
  end
endmodule

`default_nettype wire
