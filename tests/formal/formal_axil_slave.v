// formal_axil_slave: ffd_axil_slave between any bus and any port
//
// Each channel is a queue of its own (properties_queue): requests to the clock in which the port
// sees their word, from there to the clock in which they are handed on, and what the port answers
// to the response on the bus.
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
  wire                 write_next;
  wire [ADDRESS_W-3:0] write_next_word;
  wire                 write;
  wire [ADDRESS_W-3:0] write_word;
  wire [31:0]          write_data;
  wire [31:0]          write_mask;
  wire                 read_next;
  wire [ADDRESS_W-3:0] read_next_word;
  wire                 read;
  wire [ADDRESS_W-3:0] read_word;

  ffd_axil_slave #(
    .ADDRESS_W(ADDRESS_W)
  ) u_dut (
    .clk              (clk),
    .rst              (rst),
    .s_axil_awvalid   (awvalid),
    .s_axil_awready   (awready),
    .s_axil_awaddr    (awaddr),
    .s_axil_awprot    (awprot),
    .s_axil_wvalid    (wvalid),
    .s_axil_wready    (wready),
    .s_axil_wdata     (wdata),
    .s_axil_wstrb     (wstrb),
    .s_axil_bvalid    (bvalid),
    .s_axil_bready    (bready),
    .s_axil_bresp     (bresp),
    .s_axil_arvalid   (arvalid),
    .s_axil_arready   (arready),
    .s_axil_araddr    (araddr),
    .s_axil_arprot    (arprot),
    .s_axil_rvalid    (rvalid),
    .s_axil_rready    (rready),
    .s_axil_rdata     (rdata),
    .s_axil_rresp     (rresp),
    .write_next_o     (write_next),
    .write_next_word_o(write_next_word),
    .write_o          (write),
    .write_word_o     (write_word),
    .write_data_o     (write_data),
    .write_mask_o     (write_mask),
    .write_error_i    (write_error),
    .read_next_o      (read_next),
    .read_next_word_o (read_next_word),
    .read_o           (read),
    .read_word_o      (read_word),
    .read_data_i      (read_data),
    .read_error_i     (read_error)
  );

  properties_queue #(.WIDTH(ADDRESS_W - 2), .CAPACITY(2), .WAIT(1)) aw (
    .clk(clk), .rst(rst), .follow_i(follow),
    .s_valid(awvalid), .s_ready(awready), .s_data(awaddr[ADDRESS_W-1:2]),
    .m_valid(write_next), .m_ready(1'b1), .m_data(write_next_word)
  );

  properties_queue #(.WIDTH(ADDRESS_W - 2), .CAPACITY(1)) write_stage (
    .clk(clk), .rst(rst), .follow_i(follow),
    .s_valid(write_next), .s_ready(1'b1), .s_data(write_next_word),
    .m_valid(write), .m_ready(1'b1), .m_data(write_word)
  );

  properties_queue #(.WIDTH(64), .CAPACITY(3)) w (
    .clk(clk), .rst(rst), .follow_i(follow),
    .s_valid(wvalid), .s_ready(wready),
    .s_data({{8{wstrb[3]}}, {8{wstrb[2]}}, {8{wstrb[1]}}, {8{wstrb[0]}}, wdata}),
    .m_valid(write), .m_ready(1'b1), .m_data({write_mask, write_data})
  );

  properties_queue #(.WIDTH(1), .CAPACITY(2), .WAIT(1)) w_skid (
    .clk(clk), .rst(rst), .follow_i(follow),
    .s_valid(wvalid), .s_ready(wready), .s_data(1'b0),
    .m_valid(write_next), .m_ready(1'b1), .m_data(1'b0)
  );

  properties_queue #(.WIDTH(2), .CAPACITY(1)) b (
    .clk(clk), .rst(rst), .follow_i(follow),
    .s_valid(write), .s_ready(1'b1), .s_data({write_error, 1'b0}),
    .m_valid(bvalid), .m_ready(bready), .m_data(bresp)
  );

  properties_queue #(.WIDTH(ADDRESS_W - 2), .CAPACITY(2), .WAIT(1)) ar (
    .clk(clk), .rst(rst), .follow_i(follow),
    .s_valid(arvalid), .s_ready(arready), .s_data(araddr[ADDRESS_W-1:2]),
    .m_valid(read_next), .m_ready(1'b1), .m_data(read_next_word)
  );

  properties_queue #(.WIDTH(ADDRESS_W - 2), .CAPACITY(1)) read_stage (
    .clk(clk), .rst(rst), .follow_i(follow),
    .s_valid(read_next), .s_ready(1'b1), .s_data(read_next_word),
    .m_valid(read), .m_ready(1'b1), .m_data(read_word)
  );

  properties_queue #(.WIDTH(34), .CAPACITY(1)) r (
    .clk(clk), .rst(rst), .follow_i(follow),
    .s_valid(read), .s_ready(1'b1),
    .s_data({read_error, 1'b0, read_error ? 32'd0 : read_data}),
    .m_valid(rvalid), .m_ready(rready), .m_data({rresp, rdata})
  );

  // Requests taken and not yet answered on the bus; four at most: one answered, three waiting.
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

  always @* if (!first_q && !rst) begin
    write_once: assert (aw_q <= 4 && w_q <= 4 && !(bvalid && (aw_q == 0 || w_q == 0)));
    read_once: assert (ar_q <= 4 && !(rvalid && ar_q == 0));
    write_live: assert (aw_q == 0 || w_q == 0 || bvalid || write_late_q < 2);
    read_live: assert (ar_q == 0 || rvalid || read_late_q < 2);
    separate: assert (!(bresp[0] && bvalid) && !(rresp[0] && rvalid));
  end
  always @* if (!first_q) begin
    closed: assert (!rst_q || (!awready && !wready && !arready && !bvalid && !rvalid));
  end
endmodule

`default_nettype wire
