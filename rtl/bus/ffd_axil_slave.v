// ffd_axil_slave: AXI4-Lite on one side, a write port and a read port of one clock on the other
//
// A write is handed on in the clock in which write_o is high, with the bits that its strobes allow;
// a read in the clock of read_o. The port answers in the same clock (write_error_i; read_data_i,
// read_error_i), and the response is on the bus from the next clock on: what a write does and its
// response appear at the same edge. Address and data of a write come in any order. Writes and reads
// do not wait for each other; in the same clock a read sees what was there before the write.
// What is handed on stands in a register for a clock at least. In the clock before, write_next_o
// and read_next_o, the port sees its word, and may keep what it decodes of it beside that register.
//
// Responses:  OKAY, or SLVERR where the port says error; the data of such a read is 0. With
//             SECURE_ONLY an access that is not secure (bit 1 of its *prot) is not handed on and
//             answered in the same way.
// Pipeline:   3 clocks from the later of address and data to the response, II 1. One response a
//             request, in order. Ready is 0 in reset and in the first clock after it.
// Freezes:    a channel whose response is not taken; up to three requests wait in each channel.
// Cuts:       every output to the bus leaves a register. write_o and read_o do not: they follow
//             s_axil_bready and s_axil_rready.
// Not checked: the two low bits of an address (every access is a word; strobes name the bytes); the
//             other bits of *prot.
// Parameters: ADDRESS_W 3 to 64, the bits of a byte address; SECURE_ONLY 0 or 1.
// Model:      tests/bus/axil/register_model.hpp.  Test: tests/bus/axil.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_axil_slave #(
  parameter ADDRESS_W   = 12,
  parameter SECURE_ONLY = 0
) (
  input  wire                 clk,
  input  wire                 rst,
  input  wire                 s_axil_awvalid,
  output wire                 s_axil_awready,
  input  wire [ADDRESS_W-1:0] s_axil_awaddr,
  input  wire [2:0]           s_axil_awprot,
  input  wire                 s_axil_wvalid,
  output wire                 s_axil_wready,
  input  wire [31:0]          s_axil_wdata,
  input  wire [3:0]           s_axil_wstrb,
  output reg                  s_axil_bvalid,
  input  wire                 s_axil_bready,
  output wire [1:0]           s_axil_bresp,
  input  wire                 s_axil_arvalid,
  output wire                 s_axil_arready,
  input  wire [ADDRESS_W-1:0] s_axil_araddr,
  input  wire [2:0]           s_axil_arprot,
  output reg                  s_axil_rvalid,
  input  wire                 s_axil_rready,
  output reg  [31:0]          s_axil_rdata,
  output wire [1:0]           s_axil_rresp,
  output wire                 write_next_o,
  output wire [ADDRESS_W-3:0] write_next_word_o,
  output wire                 write_o,
  output reg  [ADDRESS_W-3:0] write_word_o,
  output reg  [31:0]          write_data_o,
  output wire [31:0]          write_mask_o,
  input  wire                 write_error_i,
  output wire                 read_next_o,
  output wire [ADDRESS_W-3:0] read_next_word_o,
  output wire                 read_o,
  output reg  [ADDRESS_W-3:0] read_word_o,
  input  wire [31:0]          read_data_i,
  input  wire                 read_error_i
);
  generate
    if (ADDRESS_W < 3 || ADDRESS_W > 64) begin : gen_bad_address
      ERROR_ffd_axil_slave_address_w_must_be_3_to_64 u_error ();
    end
    if (SECURE_ONLY != 0 && SECURE_ONLY != 1) begin : gen_bad_secure_only
      ERROR_ffd_axil_slave_secure_only_must_be_0_or_1 u_error ();
    end
  endgenerate

  wire        aw_valid;
  wire        w_valid;
  wire        ar_valid;
  wire        aw_refused;
  wire        ar_refused;
  wire [31:0] data;
  wire [3:0]  strobe;
  reg         write_q;      // a request is in the register
  reg         read_q;
  reg  [3:0]  strobe_q;
  reg         write_refused_q;
  reg         read_refused_q;
  reg         write_error_q;
  reg         read_error_q;

  wire write      = write_q && (!s_axil_bvalid || s_axil_bready);
  wire read       = read_q && (!s_axil_rvalid || s_axil_rready);
  wire write_next = aw_valid && w_valid && (write || !write_q);
  wire read_next  = ar_valid && (read || !read_q);

  assign write_o      = write && !write_refused_q;
  assign read_o       = read && !read_refused_q;
  assign write_next_o = write_next;
  assign read_next_o  = read_next;

  ffd_stream_skid #(
    .WIDTH(ADDRESS_W - 1)
  ) u_aw (
    .clk         (clk),
    .rst         (rst),
    .s_beat_valid(s_axil_awvalid),
    .s_beat_ready(s_axil_awready),
    .s_beat_data ({s_axil_awprot[1] && SECURE_ONLY != 0, s_axil_awaddr[ADDRESS_W-1:2]}),
    .m_beat_valid(aw_valid),
    .m_beat_ready(write_next),
    .m_beat_data ({aw_refused, write_next_word_o})
  );

  ffd_stream_skid #(
    .WIDTH(36)
  ) u_w (
    .clk         (clk),
    .rst         (rst),
    .s_beat_valid(s_axil_wvalid),
    .s_beat_ready(s_axil_wready),
    .s_beat_data ({s_axil_wstrb, s_axil_wdata}),
    .m_beat_valid(w_valid),
    .m_beat_ready(write_next),
    .m_beat_data ({strobe, data})
  );

  ffd_stream_skid #(
    .WIDTH(ADDRESS_W - 1)
  ) u_ar (
    .clk         (clk),
    .rst         (rst),
    .s_beat_valid(s_axil_arvalid),
    .s_beat_ready(s_axil_arready),
    .s_beat_data ({s_axil_arprot[1] && SECURE_ONLY != 0, s_axil_araddr[ADDRESS_W-1:2]}),
    .m_beat_valid(ar_valid),
    .m_beat_ready(read_next),
    .m_beat_data ({ar_refused, read_next_word_o})
  );

  assign write_mask_o = {{8{strobe_q[3]}}, {8{strobe_q[2]}},
                         {8{strobe_q[1]}}, {8{strobe_q[0]}}};
  assign s_axil_bresp = {write_error_q, 1'b0};
  assign s_axil_rresp = {read_error_q, 1'b0};

  always @(posedge clk) begin
    if (rst) begin
      write_q       <= 1'b0;
      read_q        <= 1'b0;
      s_axil_bvalid <= 1'b0;
      s_axil_rvalid <= 1'b0;
    end else begin
      write_q       <= write_next || (write_q && !write);
      read_q        <= read_next || (read_q && !read);
      s_axil_bvalid <= write || (s_axil_bvalid && !s_axil_bready);
      s_axil_rvalid <= read || (s_axil_rvalid && !s_axil_rready);
    end
  end

  always @(posedge clk) begin
    if (write_next) begin
      {write_refused_q, write_word_o} <= {aw_refused, write_next_word_o};
      {strobe_q, write_data_o}        <= {strobe, data};
    end
    if (read_next) {read_refused_q, read_word_o} <= {ar_refused, read_next_word_o};
  end

  always @(posedge clk) begin
    if (write) write_error_q <= write_error_i || write_refused_q;
    if (read) begin
      read_error_q <= read_error_i || read_refused_q;
      s_axil_rdata <= read_error_i || read_refused_q ? 32'd0 : read_data_i;
    end
  end

  wire unused_ok = &{1'b0, s_axil_awaddr[1:0], s_axil_araddr[1:0], s_axil_awprot, s_axil_arprot};
endmodule

`default_nettype wire
