// ffd_axil_voted: ffd_axil_slave, once, or three times with a vote
//
// With HARDENED 0 it is ffd_axil_slave. With 1 there are three of them, and what two of them say is
// what goes to the bus and to the words: a bit that flips in one loses no request and gives no
// response too many. One whose handshakes differ is reset when nothing is under way, and does as
// the others do from then on. differs_o: a pulse for each such reset.
//
// Responses, Pipeline, Freezes, Not checked: as ffd_axil_slave.
// Cuts:       as ffd_axil_slave; with HARDENED a majority's gates are behind its registers.
// Parameters: as ffd_axil_slave; HARDENED 0 or 1.
// Model:      tests/bus/axil/register_model.hpp.  Test: tests/bus/axil, tests/bus/axi.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

// Ports of a copy: all that it drives is the vector out.
`define FFD_AXIL_COPY \
  .clk           (clk), \
  .rst           (rst || again[k]), \
  .s_axil_awvalid(s_axil_awvalid), \
  .s_axil_awready(out[1]), \
  .s_axil_awaddr (s_axil_awaddr), \
  .s_axil_awprot (s_axil_awprot), \
  .s_axil_wvalid (s_axil_wvalid), \
  .s_axil_wready (out[2]), \
  .s_axil_wdata  (s_axil_wdata), \
  .s_axil_wstrb  (s_axil_wstrb), \
  .s_axil_bvalid (out[3]), \
  .s_axil_bready (s_axil_bready), \
  .s_axil_bresp  (out[SHAKES +: 2]), \
  .s_axil_arvalid(s_axil_arvalid), \
  .s_axil_arready(out[4]), \
  .s_axil_araddr (s_axil_araddr), \
  .s_axil_arprot (s_axil_arprot), \
  .s_axil_rvalid (out[5]), \
  .s_axil_rready (s_axil_rready), \
  .s_axil_rdata  (out[SHAKES + 4 +: 32]), \
  .s_axil_rresp  (out[SHAKES + 2 +: 2]), \
  .m_awake       (out[0]), \
  .m_write_valid (out[6]), \
  .m_write_word  (out[SHAKES + 72 +: ADDRESS_W - 2]), \
  .m_write_data  (out[SHAKES + 36 +: 32]), \
  .m_write_strobe(out[SHAKES + 68 +: 4]), \
  .m_write_error (m_write_error), \
  .m_read_valid  (out[7]), \
  .m_read_word   (out[SHAKES + 72 + ADDRESS_W - 2 +: ADDRESS_W - 2]), \
  .m_read_data   (m_read_data), \
  .m_read_error  (m_read_error)

module ffd_axil_voted #(
  parameter ADDRESS_W   = 12,
  parameter SECURE_ONLY = 0,
  parameter HARDENED    = 0
) (
  input  wire                 clk,
  input  wire                 rst,
  output wire                 differs_o,
  input  wire                 s_axil_awvalid,
  output wire                 s_axil_awready,
  input  wire [ADDRESS_W-1:0] s_axil_awaddr,
  input  wire [2:0]           s_axil_awprot,
  input  wire                 s_axil_wvalid,
  output wire                 s_axil_wready,
  input  wire [31:0]          s_axil_wdata,
  input  wire [3:0]           s_axil_wstrb,
  output wire                 s_axil_bvalid,
  input  wire                 s_axil_bready,
  output wire [1:0]           s_axil_bresp,
  input  wire                 s_axil_arvalid,
  output wire                 s_axil_arready,
  input  wire [ADDRESS_W-1:0] s_axil_araddr,
  input  wire [2:0]           s_axil_arprot,
  output wire                 s_axil_rvalid,
  input  wire                 s_axil_rready,
  output wire [31:0]          s_axil_rdata,
  output wire [1:0]           s_axil_rresp,
  output wire                 m_awake,
  output wire                 m_write_valid,
  output wire [ADDRESS_W-3:0] m_write_word,
  output wire [31:0]          m_write_data,
  output wire [3:0]           m_write_strobe,
  input  wire                 m_write_error,
  output wire                 m_read_valid,
  output wire [ADDRESS_W-3:0] m_read_word,
  input  wire [31:0]          m_read_data,
  input  wire                 m_read_error
);
  generate
    if (HARDENED != 0 && HARDENED != 1) begin : gen_bad_hardened
      ERROR_ffd_axil_voted_hardened_must_be_0_or_1 u_error ();
    end
  endgenerate

  localparam COPIES = HARDENED != 0 ? 3 : 1;
  // {data, handshakes}, the least of them awake
  localparam SHAKES = 8;
  localparam ALL_W  = SHAKES + 2 + 2 + 32 + 32 + 4 + 2 * (ADDRESS_W - 2);
  wire [COPIES*ALL_W-1:0] copies;
  wire [COPIES-1:0]       again;    // is reset to do as the others

  genvar k;
  generate
    for (k = 0; k < COPIES; k = k + 1) begin : gen_slave
      wire [ALL_W-1:0] out;
      assign copies[k*ALL_W +: ALL_W] = out;

      // Tools for synthesis would take three for one.
      if (COPIES == 1) begin : gen_only
        ffd_axil_slave #(
          .ADDRESS_W  (ADDRESS_W),
          .SECURE_ONLY(SECURE_ONLY)
        ) u_slave (
          `FFD_AXIL_COPY
        );
      end else begin : gen_plain
        (* keep_hierarchy = "yes", dont_touch = "yes", syn_hier = "hard" *)
        ffd_axil_slave #(
          .ADDRESS_W  (ADDRESS_W),
          .SECURE_ONLY(SECURE_ONLY)
        ) u_slave (
          `FFD_AXIL_COPY
        );
      end
    end
  endgenerate

  wire [ALL_W-1:0] all;
  assign m_awake        = all[0];
  assign s_axil_awready = all[1];
  assign s_axil_wready  = all[2];
  assign s_axil_bvalid  = all[3];
  assign s_axil_arready = all[4];
  assign s_axil_rvalid  = all[5];
  assign m_write_valid  = all[6];
  assign m_read_valid   = all[7];
  assign s_axil_bresp   = all[SHAKES +: 2];
  assign s_axil_rresp   = all[SHAKES + 2 +: 2];
  assign s_axil_rdata   = all[SHAKES + 4 +: 32];
  assign m_write_data   = all[SHAKES + 36 +: 32];
  assign m_write_strobe = all[SHAKES + 68 +: 4];
  assign m_write_word   = all[SHAKES + 72 +: ADDRESS_W - 2];
  assign m_read_word    = all[SHAKES + 72 + ADDRESS_W - 2 +: ADDRESS_W - 2];

  generate
    if (HARDENED == 0) begin : gen_single
      assign all       = copies;
      assign again     = 1'b0;
      assign differs_o = 1'b0;
    end else begin : gen_vote
      wire [ALL_W-1:0] a = copies[0 +: ALL_W];
      wire [ALL_W-1:0] b = copies[ALL_W +: ALL_W];
      wire [ALL_W-1:0] c = copies[2*ALL_W +: ALL_W];
      assign all = (a & b) | (a & c) | (b & c);

      // Its readies come back two clocks after a reset: it is not looked at again before.
      reg  [2:0] again_q;
      reg  [2:0] before_q;
      reg  [2:0] earlier_q;
      wire [2:0] differ = {c[SHAKES-1:0] != all[SHAKES-1:0], b[SHAKES-1:0] != all[SHAKES-1:0],
                           a[SHAKES-1:0] != all[SHAKES-1:0]};
      always @(posedge clk) begin
        again_q   <= rst || m_awake || again_q != 3'd0 ? 3'd0 : differ & ~before_q & ~earlier_q;
        before_q  <= again_q;
        earlier_q <= before_q;
      end
      assign again     = again_q;
      assign differs_o = again_q != 3'd0;
    end
  endgenerate
endmodule

`undef FFD_AXIL_COPY

`default_nettype wire
