// formal_dma_read: ffd_dma_read at its bus, with any requests, any window, and any memory that
// answers what was asked
//
// The memory answers bursts in order with as many beats as were asked, at any time, with any
// response. The window is any pair of addresses, held from reset on. A soft reset lasts until rst, as
// the engine has it.
//
// Not in the table, because pdr decides neither in 40 s: `room` (no run breaks it in 11 clocks) and
// `live` (17 clocks).
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_dma_read #(
  parameter MAX_BURST   = 2,
  parameter FIFO_DEPTH  = 4,
  parameter OUTSTANDING = 2,
  parameter CLOCKS      = 8
) (
  input wire         clk,
  input wire         rst,
  input wire         start,
  input wire         soft,
  input wire         hold,
  input wire [63:0]  window_first,
  input wire [63:0]  window_last,
  input wire         s_valid,
  input wire [63:0]  s_address,
  input wire [31:0]  s_length,
  input wire         s_fetch,
  input wire         arready,
  input wire         want_answer,
  input wire [127:0] rdata,
  input wire [1:0]   rresp,
  input wire         m_ready
);
  wire        s_ready;
  wire        refused;
  wire        arvalid;
  wire [63:0] araddr;
  wire [7:0]  arlen;
  wire        rvalid;
  wire        rready;
  wire        rlast;
  wire        m_valid;
  wire        m_last;
  wire        fault;
  wire        quiet;
  wire        empty;

  ffd_dma_read #(
    .MAX_BURST  (MAX_BURST),
    .FIFO_DEPTH (FIFO_DEPTH),
    .OUTSTANDING(OUTSTANDING)
  ) u_dut (
    .clk              (clk),
    .rst              (rst),
    .start_i          (start),
    .soft_i           (soft),
    .hold_i           (hold),
    .window_first_i   (window_first),
    .window_last_i    (window_last),
    .s_request_valid  (s_valid),
    .s_request_ready  (s_ready),
    .s_request_address(s_address),
    .s_request_length (s_length),
    .s_request_fetch  (s_fetch),
    .refused_o        (refused),
    .m_axi_arvalid    (arvalid),
    .m_axi_arready    (arready),
    .m_axi_araddr     (araddr),
    .m_axi_arlen      (arlen),
    .m_axi_rvalid     (rvalid),
    .m_axi_rready     (rready),
    .m_axi_rdata      (rdata),
    .m_axi_rresp      (rresp),
    .m_axi_rlast      (rlast),
    .m_packet_valid   (m_valid),
    .m_packet_ready   (m_ready),
    .m_packet_last    (m_last),
    .fault_o          (fault),
    .quiet_o          (quiet),
    .empty_o          (empty)
  );

  reg        first_q = 1'b1;
  reg [63:0] window_first_q;
  reg [63:0] window_last_q;
  reg        soft_q = 1'b0;
  reg        wait_q;
  reg [63:0] wait_address_q;
  reg [7:0]  wait_len_q;
  always @(posedge clk) begin
    first_q        <= 1'b0;
    window_first_q <= window_first;
    window_last_q  <= window_last;
    wait_q         <= arvalid && !arready && !rst;
    wait_address_q <= araddr;
    wait_len_q     <= arlen;
    soft_q         <= soft && !rst;
  end
  always @* begin
    if (first_q) assume (rst);
    else assume (window_first == window_first_q && window_last == window_last_q);
    if (soft_q) assume (soft || rst);
  end

  // ---- the memory: bursts taken and not yet answered, the oldest first
  localparam MOST = 4;
  reg  [2:0]  count_q;
  reg  [31:0] lens_q;      // of MOST bursts, 8 bits each
  reg  [7:0]  beat_q;
  wire        asked  = arvalid && arready;
  wire        answer = rvalid && rready;
  wire        done   = answer && rlast;
  assign rvalid = want_answer && count_q != 0;
  assign rlast  = beat_q == lens_q[7:0];
  wire [2:0]  place = count_q - done;
  wire [31:0] rest  = done ? {8'd0, lens_q[31:8]} : lens_q;
  always @(posedge clk) begin
    if (rst) begin
      count_q <= 0;
      beat_q  <= 0;
    end else begin
      count_q <= count_q + asked - done;
      if (answer) beat_q <= rlast ? 0 : beat_q + 1'b1;
      lens_q <= rest;
      if (asked && place < MOST) lens_q[8*place[1:0] +: 8] <= arlen;
    end
  end

  reg        failed_q;

  // ---- liveness: a packet's beats and a request, with the bus and the stream willing
  reg  [4:0] stuck_q;
  wire       willing = arready && (want_answer || count_q == 0) && m_ready && !hold && !soft
                    && !fault && !failed_q && !refused;
  always @(posedge clk) begin
    if (rst || !willing || arvalid || answer || m_valid || s_ready) stuck_q <= 0;
    else stuck_q <= stuck_q + (stuck_q != 31);
  end

  // ---- no address after an error, except one that waits already
  reg        raised_q;
  always @(posedge clk) begin
    failed_q <= !rst && (fault || (failed_q && !start));
    raised_q <= arvalid && !arready;
  end

  // ---- what the address generator holds; once in BURST: first <= next <= last <= window's last
  (* hierconn *) wire [59:0] \u_dut.u_address.next_q ;
  (* hierconn *) wire [59:0] \u_dut.u_address.last_q ;
  (* hierconn *) wire [27:0] \u_dut.u_address.beats_q ;
  (* hierconn *) wire        \u_dut.u_address.misaligned_q ;
  (* hierconn *) wire        \u_dut.u_address.wraps_q ;
  (* hierconn *) wire [1:0]  \u_dut.u_address.state_q ;
  (* hierconn *) wire        \u_dut.release_held ;
  (* hierconn *) wire        \u_dut.fifo_ready ;
  wire [60:0] next  = {1'b0, \u_dut.u_address.next_q };
  wire [60:0] last  = {1'b0, \u_dut.u_address.last_q };
  wire        sum   = {\u_dut.u_address.wraps_q , \u_dut.u_address.last_q }
                      == next + \u_dut.u_address.beats_q - 61'd1;
  wire        fits  = {next, 4'h0} >= {1'b0, window_first} && next <= last
                   && {last, 4'hf} <= {1'b0, window_last};
  wire [64:0] end_of = {1'b0, araddr} + {53'd0, arlen, 4'd15};
  wire        ar_fits = araddr >= window_first && end_of <= {1'b0, window_last};
  wire        ar_page = {1'b0, araddr[11:0]} + {1'b0, arlen, 4'd15} < 13'd4096;

  always @* if (!first_q && !rst) begin
    window: assert ((!arvalid || (ar_fits && ar_page && arlen < MAX_BURST && araddr[3:0] == 0))
                    && (\u_dut.u_address.state_q != 2'd2 || \u_dut.u_address.misaligned_q
                        || \u_dut.u_address.beats_q == 0 || sum)
                    && (\u_dut.u_address.state_q != 2'd3 || fits));
    stable: assert (!wait_q || (arvalid && araddr == wait_address_q && arlen == wait_len_q));
    outstanding: assert (count_q + arvalid <= OUTSTANDING);
    room: assert (!\u_dut.release_held || \u_dut.fifo_ready );
    answered: assert (!rvalid || rready);
    silent: assert (!failed_q || !arvalid || raised_q);
    quiet_means: assert (!quiet || (count_q == 0 && !arvalid));
    live: assert (stuck_q < CLOCKS);
  end
endmodule

`default_nettype wire
