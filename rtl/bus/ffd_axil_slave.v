// ffd_axil_slave: AXI4-Lite on one side, words that are written and read on the other
//
// A write is handed on in the clock in which m_write_valid is high, a read in that of m_read_valid;
// the word is there a clock before. The other side answers in the same clock (m_write_error;
// m_read_data, m_read_error), and the response is on the bus from the next clock on: what a write
// does and its response appear at the same edge. Address and data of a write come in any order.
// Writes and reads do not wait for each other.
//
// Responses:  OKAY, or SLVERR where the other side says error; the data of such a read is 0. With
//             SECURE_ONLY an access that is not secure (bit 1 of its *prot) is not handed on and
//             answered in the same way.
// Pipeline:   3 clocks from the later of address and data to the response, II 3. One response a
//             request, in order. Ready is 0 in reset and in the first clock after it.
// Freezes:    a channel whose response is not taken; one more request waits in each channel.
// Cuts:       everything: what goes to the bus and to the words leaves a register, and comes from
//             them into one.
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
  output reg                  s_axil_awready,
  input  wire [ADDRESS_W-1:0] s_axil_awaddr,
  input  wire [2:0]           s_axil_awprot,
  input  wire                 s_axil_wvalid,
  output reg                  s_axil_wready,
  input  wire [31:0]          s_axil_wdata,
  input  wire [3:0]           s_axil_wstrb,
  output reg                  s_axil_bvalid,
  input  wire                 s_axil_bready,
  output wire [1:0]           s_axil_bresp,
  input  wire                 s_axil_arvalid,
  output reg                  s_axil_arready,
  input  wire [ADDRESS_W-1:0] s_axil_araddr,
  input  wire [2:0]           s_axil_arprot,
  output reg                  s_axil_rvalid,
  input  wire                 s_axil_rready,
  output reg  [31:0]          s_axil_rdata,
  output wire [1:0]           s_axil_rresp,
  output wire                 m_awake,
  output reg                  m_write_valid,
  output reg  [ADDRESS_W-3:0] m_write_word,
  output reg  [31:0]          m_write_data,
  output reg  [3:0]           m_write_strobe,
  input  wire                 m_write_error,
  output reg                  m_read_valid,
  output reg  [ADDRESS_W-3:0] m_read_word,
  input  wire [31:0]          m_read_data,
  input  wire                 m_read_error
);
  generate
    if (ADDRESS_W < 3 || ADDRESS_W > 64) begin : gen_bad_address
      ERROR_ffd_axil_slave_address_w_must_be_3_to_64 u_error ();
    end
    if (SECURE_ONLY != 0 && SECURE_ONLY != 1) begin : gen_bad_secure_only
      ERROR_ffd_axil_slave_secure_only_must_be_0_or_1 u_error ();
    end
  endgenerate

  // Requests that are inside; in the clock of `act` they are answered.
  reg  aw_held_q;
  reg  w_held_q;
  reg  ar_held_q;
  reg  aw_refused_q;
  reg  ar_refused_q;
  reg  write_act_q;
  reg  read_act_q;
  reg  write_error_q;
  reg  read_error_q;
  wire aw_take = s_axil_awvalid && s_axil_awready;
  wire w_take  = s_axil_wvalid && s_axil_wready;
  wire ar_take = s_axil_arvalid && s_axil_arready;
  wire write   = aw_held_q && w_held_q && !write_act_q && (!s_axil_bvalid || s_axil_bready);
  wire read    = ar_held_q && !read_act_q && (!s_axil_rvalid || s_axil_rready);

  // A request stays until it is answered: its word and its data are those of two clocks.
  wire aw_held_d = aw_take || (aw_held_q && !write_act_q);
  wire w_held_d  = w_take || (w_held_q && !write_act_q);
  wire ar_held_d = ar_take || (ar_held_q && !read_act_q);

  // Something is offered or inside: the clock must not stop.
  assign m_awake = s_axil_awvalid || s_axil_wvalid || s_axil_arvalid || aw_held_q || w_held_q
                || ar_held_q || s_axil_bvalid || s_axil_rvalid;

  always @(posedge clk) begin
    if (rst) begin
      s_axil_awready <= 1'b0;
      s_axil_wready  <= 1'b0;
      s_axil_arready <= 1'b0;
      aw_held_q      <= 1'b0;
      w_held_q       <= 1'b0;
      ar_held_q      <= 1'b0;
      write_act_q    <= 1'b0;
      read_act_q     <= 1'b0;
      m_write_valid  <= 1'b0;
      m_read_valid   <= 1'b0;
    end else begin
      s_axil_awready <= !aw_held_d;
      s_axil_wready  <= !w_held_d;
      s_axil_arready <= !ar_held_d;
      aw_held_q      <= aw_held_d;
      w_held_q       <= w_held_d;
      ar_held_q      <= ar_held_d;
      write_act_q    <= write;
      read_act_q     <= read;
      m_write_valid  <= write && !aw_refused_q;
      m_read_valid   <= read && !ar_refused_q;
    end
  end

  always @(posedge clk) begin
    if (aw_take) {aw_refused_q, m_write_word} <=
      {s_axil_awprot[1] && SECURE_ONLY != 0, s_axil_awaddr[ADDRESS_W-1:2]};
    if (w_take) {m_write_strobe, m_write_data} <= {s_axil_wstrb, s_axil_wdata};
    if (ar_take) {ar_refused_q, m_read_word} <=
      {s_axil_arprot[1] && SECURE_ONLY != 0, s_axil_araddr[ADDRESS_W-1:2]};
  end

  assign s_axil_bresp = {write_error_q, 1'b0};
  assign s_axil_rresp = {read_error_q, 1'b0};

  always @(posedge clk) begin
    if (rst) begin
      s_axil_bvalid <= 1'b0;
      s_axil_rvalid <= 1'b0;
    end else begin
      s_axil_bvalid <= write_act_q || (s_axil_bvalid && !s_axil_bready);
      s_axil_rvalid <= read_act_q || (s_axil_rvalid && !s_axil_rready);
    end
  end

  always @(posedge clk) begin
    if (write_act_q) write_error_q <= m_write_error || aw_refused_q;
    if (read_act_q) begin
      read_error_q <= m_read_error || ar_refused_q;
      s_axil_rdata <= m_read_error || ar_refused_q ? 32'd0 : m_read_data;
    end
  end

  wire unused_ok = &{1'b0, s_axil_awaddr[1:0], s_axil_araddr[1:0], s_axil_awprot, s_axil_arprot};
endmodule

`default_nettype wire
