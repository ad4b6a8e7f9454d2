// ffd_dma_guard: keeps the bus of the DMA right when a bit inside has flipped
//
// With HARDENED 0 nothing but wires. With 1 it stands between the DMA's halves and the bus, and
// knows by itself, in registers that are held three times, what is open there: bursts that were
// raised and not answered, and beats that the burst under way still owes. So
//   no address leaves the windows, whatever becomes of the registers before it (ffd_dma_gate);
//   a burst has as many beats as its address said. Where the DMA ends it early or late, or is reset
//     in its midst, it is completed with beats of zeros of which no byte is written (wstrb 0);
//   answers that nobody waits for are taken and not handed on.
// Where the first two come about there is a fault: fault_o, until the soft reset, and no further
// address. While flush_i is 1 (a soft reset) the same holds, and quiet_read_o and quiet_write_o say
// when nothing is open: then the DMA may be reset, whatever it believes. The windows that the
// halves check against are those of the gates.
// window_o, burst_o, copy_o: pulses for an address that was refused, a burst that was completed, a
// copy that was outvoted.
//
// Pipeline:   addresses as in ffd_dma_gate; data and answers pass in the same clock. A burst of
//             writes is raised when the one before it has all its data.
// Parameters: HARDENED 0 or 1; DATA_WIDTH 64, 128 or 256; READS and WRITES, the most bursts that
//             are open each way.
// Not checked: data; beats of a read, of which rlast is trusted.
// Model:      none (control only).  Test: tests/bus/dma, tests/bus/axi.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_dma_guard #(
  parameter HARDENED   = 0,
  parameter DATA_WIDTH = 128,
  parameter READS      = 8,
  parameter WRITES     = 8
) (
  input  wire        clk,
  input  wire        rst,
  input  wire        halves_rst_i,
  input  wire        flush_i,
  input  wire        locked_i,
  input  wire [63:0] read_first_i,
  input  wire [63:0] read_last_i,
  input  wire [63:0] write_first_i,
  input  wire [63:0] write_last_i,
  output wire [63:0] read_first_o,
  output wire [63:0] read_last_o,
  output wire [63:0] write_first_o,
  output wire [63:0] write_last_o,
  output wire        quiet_read_o,
  output wire        quiet_write_o,
  output wire        fault_o,
  output wire        window_o,
  output wire        burst_o,
  output wire        copy_o,
  // the DMA's halves
  input  wire        s_ar_valid,
  output wire        s_ar_ready,
  input  wire [63:0] s_ar_address,
  input  wire [7:0]  s_ar_len,
  output wire        s_r_valid,
  input  wire        s_r_ready,
  input  wire        s_aw_valid,
  output wire        s_aw_ready,
  input  wire [63:0] s_aw_address,
  input  wire [7:0]  s_aw_len,
  input  wire        s_w_valid,
  output wire        s_w_ready,
  input  wire [DATA_WIDTH-1:0]   s_w_data,
  input  wire [DATA_WIDTH/8-1:0] s_w_strobe,
  input  wire        s_w_last,
  output wire        s_b_valid,
  input  wire        s_b_ready,
  // the bus
  output wire        m_axi_arvalid,
  input  wire        m_axi_arready,
  output wire [63:0] m_axi_araddr,
  output wire [7:0]  m_axi_arlen,
  input  wire        m_axi_rvalid,
  output wire        m_axi_rready,
  input  wire        m_axi_rlast,
  output wire        m_axi_awvalid,
  input  wire        m_axi_awready,
  output wire [63:0] m_axi_awaddr,
  output wire [7:0]  m_axi_awlen,
  output wire        m_axi_wvalid,
  input  wire        m_axi_wready,
  output wire [DATA_WIDTH-1:0]   m_axi_wdata,
  output wire [DATA_WIDTH/8-1:0] m_axi_wstrb,
  output wire        m_axi_wlast,
  input  wire        m_axi_bvalid,
  output wire        m_axi_bready
);
  generate
    if (HARDENED != 0 && HARDENED != 1) begin : gen_bad_hardened
      ERROR_ffd_dma_guard_hardened_must_be_0_or_1 u_error ();
    end
    if (HARDENED == 0) begin : gen_wires
      assign m_axi_arvalid = s_ar_valid;
      assign s_ar_ready    = m_axi_arready;
      assign m_axi_araddr  = s_ar_address;
      assign m_axi_arlen   = s_ar_len;
      assign s_r_valid     = m_axi_rvalid;
      assign m_axi_rready  = s_r_ready;
      assign m_axi_awvalid = s_aw_valid;
      assign s_aw_ready    = m_axi_awready;
      assign m_axi_awaddr  = s_aw_address;
      assign m_axi_awlen   = s_aw_len;
      assign m_axi_wvalid  = s_w_valid;
      assign s_w_ready     = m_axi_wready;
      assign m_axi_wdata   = s_w_data;
      assign m_axi_wstrb   = s_w_strobe;
      assign m_axi_wlast   = s_w_last;
      assign s_b_valid     = m_axi_bvalid;
      assign m_axi_bready  = s_b_ready;
      assign read_first_o  = read_first_i;
      assign read_last_o   = read_last_i;
      assign write_first_o = write_first_i;
      assign write_last_o  = write_last_i;
      assign quiet_read_o  = 1'b1;
      assign quiet_write_o = 1'b1;
      assign fault_o       = 1'b0;
      assign window_o      = 1'b0;
      assign burst_o       = 1'b0;
      assign copy_o        = 1'b0;
      wire unused_ok = &{1'b0, clk, rst, halves_rst_i, flush_i, locked_i, m_axi_rlast};
    end else begin : gen_guard
      localparam READ_W  = $clog2(READS + 1);
      localparam WRITE_W = $clog2(WRITES + 1);
      localparam [READ_W-1:0]  NO_READ   = {READ_W {1'b0}};
      localparam [WRITE_W-1:0] NO_WRITE  = {WRITE_W {1'b0}};
      localparam [READ_W-1:0]  ALL_READS = READS[READ_W-1:0];
      localparam [WRITE_W-1:0] ALL_WRITES = WRITES[WRITE_W-1:0];

      // ---- what is open: {fault, beats that are owed, writes, reads}
      wire               fault;
      wire [8:0]         owed;
      wire [WRITE_W-1:0] writes;
      wire [READ_W-1:0]  reads;
      wire               open_differs;
      wire               fault_d;
      wire [8:0]         owed_d;
      wire [WRITE_W-1:0] writes_d;
      wire [READ_W-1:0]  reads_d;

      ffd_hard_triple #(
        .WIDTH(10 + WRITE_W + READ_W)
      ) u_open (
        .clk      (clk),
        .d_i      ({fault_d, owed_d, writes_d, reads_d}),
        .q_o      ({fault, owed, writes, reads}),
        .differs_o(open_differs)
      );

      wire stop = fault || flush_i;

      // ---- addresses
      wire read_refused, read_differs, write_refused, write_differs;
      wire read_raise, write_raise;
      ffd_dma_gate #(
        .DATA_WIDTH(DATA_WIDTH)
      ) u_read (
        .clk            (clk),
        .rst            (rst),
        .stop_i         (stop),
        .go_i           (reads != ALL_READS),
        .locked_i       (locked_i),
        .window_first_i (read_first_i),
        .window_last_i  (read_last_i),
        .window_first_o (read_first_o),
        .window_last_o  (read_last_o),
        .s_burst_valid  (s_ar_valid),
        .s_burst_ready  (s_ar_ready),
        .s_burst_address(s_ar_address),
        .s_burst_len    (s_ar_len),
        .m_burst_valid  (m_axi_arvalid),
        .m_burst_ready  (m_axi_arready),
        .m_burst_address(m_axi_araddr),
        .m_burst_len    (m_axi_arlen),
        .raise_o        (read_raise),
        .refused_o      (read_refused),
        .differs_o      (read_differs)
      );
      ffd_dma_gate #(
        .DATA_WIDTH(DATA_WIDTH)
      ) u_write (
        .clk            (clk),
        .rst            (rst),
        .stop_i         (stop),
        .go_i           (owed == 9'd0 && writes != ALL_WRITES),
        .locked_i       (locked_i),
        .window_first_i (write_first_i),
        .window_last_i  (write_last_i),
        .window_first_o (write_first_o),
        .window_last_o  (write_last_o),
        .s_burst_valid  (s_aw_valid),
        .s_burst_ready  (s_aw_ready),
        .s_burst_address(s_aw_address),
        .s_burst_len    (s_aw_len),
        .m_burst_valid  (m_axi_awvalid),
        .m_burst_ready  (m_axi_awready),
        .m_burst_address(m_axi_awaddr),
        .m_burst_len    (m_axi_awlen),
        .raise_o        (write_raise),
        .refused_o      (write_refused),
        .differs_o      (write_differs)
      );

      // ---- reads: counted from the raise on, so that what waits for arready is open, too
      wire read_open = reads != NO_READ;
      wire read_end  = m_axi_rvalid && m_axi_rready && m_axi_rlast && read_open;
      assign s_r_valid    = m_axi_rvalid && read_open && !stop;
      assign m_axi_rready = s_r_ready || stop;
      assign reads_d      = rst ? NO_READ : reads + {{(READ_W - 1) {1'b0}}, read_raise}
                                          - {{(READ_W - 1) {1'b0}}, read_end};
      assign quiet_read_o = !read_open;

      // ---- writes. A beat that waits stays as it is, though a fault comes meanwhile.
      reg  waits_q;
      reg  own_q;                            // it is a beat without a byte
      wire write_open = writes != NO_WRITE;
      wire owes       = owed != 9'd0;
      wire own        = waits_q ? own_q : stop;
      wire beat       = m_axi_wvalid && m_axi_wready;
      wire write_end  = m_axi_bvalid && m_axi_bready && write_open;
      assign m_axi_wvalid  = owes && (s_w_valid || own);
      assign m_axi_wlast   = owed == 9'd1;
      assign m_axi_wdata   = own ? {DATA_WIDTH {1'b0}} : s_w_data;
      assign m_axi_wstrb   = own ? {(DATA_WIDTH / 8) {1'b0}} : s_w_strobe;
      assign s_w_ready     = owes && !own && m_axi_wready;
      assign s_b_valid     = m_axi_bvalid && write_open && !stop;
      assign m_axi_bready  = s_b_ready || stop;
      assign owed_d        = rst ? 9'd0 : write_raise ? {1'b0, m_axi_awlen} + 9'd1
                                        : owed - {8'd0, beat};
      assign writes_d      = rst ? NO_WRITE : writes + {{(WRITE_W - 1) {1'b0}}, write_raise}
                                            - {{(WRITE_W - 1) {1'b0}}, write_end};
      assign quiet_write_o = !write_open && !owes;
      always @(posedge clk) begin
        waits_q <= m_axi_wvalid && !m_axi_wready && !rst;
        own_q   <= own;
      end

      // ---- faults
      reg  reset_q;
      wire open_now = read_open || write_open || owes;
      wire lost     = halves_rst_i && !flush_i && !reset_q && open_now;
      wire unlike   = owes && s_w_valid && !stop && s_w_last != m_axi_wlast;
      always @(posedge clk) reset_q <= rst;
      assign fault_d  = !rst && (fault || read_refused || write_refused || unlike || lost);
      assign fault_o  = fault;
      assign window_o = read_refused || write_refused;
      assign burst_o  = unlike || lost;
      assign copy_o   = open_differs || read_differs || write_differs;
    end
  endgenerate
endmodule

`default_nettype wire
