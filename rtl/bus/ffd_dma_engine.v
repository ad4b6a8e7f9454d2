// ffd_dma_engine: command packets from memory to a stream, results from a stream to memory
//
// Reads along a ring of descriptors (ffd_dma_ring, ffd_dma_read) and writes one area
// (ffd_dma_write), both at once, as one AXI4 master without IDs: INCR bursts at multiples of 16
// bytes, whose beats have DATA_WIDTH bits (ffd_dma_width_read, ffd_dma_width_write).
// docs/interface.md has the descriptor, the ring, the area and the codes of errors.
//
// A bus error on either half raises no further address on both, from the fourth clock after it on.
// The half that failed stops, the other is held, with nothing lost, until the half that failed is
// started again. halted_o: the half that failed has ended, no burst is open, and such a start is
// waited for.
// A channel that waits TIMEOUT clocks for the slave (timeout_o, a pulse a channel: bit 0 AR, 1 R,
// 2 AW, 3 W, 4 B) stops both halves, too, and only a soft reset ends that; halted_o does not wait
// for bursts whose channel is late. fault_o: a bus error or a time-out.
// soft_reset_i, a pulse: addresses already on the bus get their data and answers, data read is
// dropped, results not in a burst too; then all is as after rst, windows apart, which are inputs.
// A half with a channel that is late is given up: its valids fall unanswered, and an answer that
// comes later is ignored where no burst is open, and else taken for that burst's.
// clearing_o is 1 meanwhile: packets end without `last` and results are not taken, so whoever uses
// both streams is to be reset with it. ring_start_i and result_start_i are ignored then.
// idle_o: nothing outstanding or queued, nothing left in the ring.
//
// With HARDENED a guard stands between the halves and the bus (ffd_dma_guard). Its fault is one
// more after which only a soft reset helps, and a soft reset waits for the bus, not for the halves.
// After a bus error two addresses a half, which it has taken by then, may still go out.
//
// Pipeline:   see the halves; read and write at 16 bytes a clock each, or a beat of 8.
// Parameters: as in the halves, MAX_BURST in 16 bytes, and taken for 128 where 256 of them would be
//             too many beats of DATA_WIDTH 64; READ_OUTSTANDING and WRITE_OUTSTANDING bursts, at
//             least 2; TIMEOUT as in ffd_dma_watch, HARDENED in ffd_dma_guard.
// Model:      tests/bus/dma.  Test: tests/bus/dma.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_dma_engine #(
  parameter MAX_BURST         = 256,
  parameter READ_DEPTH        = 512,
  parameter WRITE_DEPTH       = 512,
  parameter READ_OUTSTANDING  = 8,
  parameter WRITE_OUTSTANDING = 8,
  parameter DESCRIPTORS       = 4,
  parameter FLUSH_CLOCKS      = 16,
  parameter TIMEOUT           = 0,
  parameter DATA_WIDTH        = 128,
  parameter MARKS             = 0,
  parameter HARDENED          = 0
) (
  input  wire         clk,
  input  wire         rst,
  input  wire         soft_reset_i,
  output wire         clearing_o,
  output wire         idle_o,
  output wire         halted_o,
  output wire         fault_o,
  output wire [4:0]   timeout_o,
  input  wire         windows_locked_i,
  output wire [3:0]   upset_o,       // {copy, burst, window, state}, pulses

  input  wire [63:0]  read_first_i,
  input  wire [63:0]  read_last_i,
  input  wire         ring_start_i,
  input  wire [63:0]  ring_base_i,
  input  wire [3:0]   ring_entries_log2_i,
  input  wire [15:0]  ring_head_i,
  output wire [15:0]  ring_tail_o,
  output wire         ring_running_o,
  output wire         ring_marked_o,
  output wire         read_error_o,
  output wire [3:0]   read_error_code_o,
  output wire [63:0]  read_error_address_o,

  input  wire [63:0]  write_first_i,
  input  wire [63:0]  write_last_i,
  input  wire         result_start_i,
  input  wire [63:0]  result_base_i,
  input  wire [31:0]  result_size_i,
  output wire         result_running_o,
  output wire         result_busy_o,
  output wire [31:0]  result_count_o,
  output wire         result_overflow_o,
  output wire         result_marked_o,
  output wire         write_error_o,
  output wire [2:0]   write_error_code_o,
  output wire [63:0]  write_error_address_o,

  output wire         m_packet_valid,
  input  wire         m_packet_ready,
  output wire [127:0] m_packet_data,
  output wire         m_packet_last,

  input  wire         s_result_valid,
  output wire         s_result_ready,
  input  wire [127:0] s_result_data,
  input  wire         s_result_last,
  input  wire         s_result_mark,

  output wire         m_axi_arvalid,
  input  wire         m_axi_arready,
  output wire [63:0]  m_axi_araddr,
  output wire [7:0]   m_axi_arlen,
  output wire [2:0]   m_axi_arsize,
  output wire [1:0]   m_axi_arburst,
  input  wire         m_axi_rvalid,
  output wire         m_axi_rready,
  input  wire [DATA_WIDTH-1:0] m_axi_rdata,
  input  wire [1:0]   m_axi_rresp,
  input  wire         m_axi_rlast,

  output wire         m_axi_awvalid,
  input  wire         m_axi_awready,
  output wire [63:0]  m_axi_awaddr,
  output wire [7:0]   m_axi_awlen,
  output wire [2:0]   m_axi_awsize,
  output wire [1:0]   m_axi_awburst,
  output wire         m_axi_wvalid,
  input  wire         m_axi_wready,
  output wire [DATA_WIDTH-1:0] m_axi_wdata,
  output wire [DATA_WIDTH/8-1:0] m_axi_wstrb,
  output wire         m_axi_wlast,
  input  wire         m_axi_bvalid,
  output wire         m_axi_bready,
  input  wire [1:0]   m_axi_bresp
);
  localparam BURST = DATA_WIDTH == 64 && MAX_BURST > 128 ? 128 : MAX_BURST;
  localparam [2:0] SIZE = DATA_WIDTH == 64 ? 3'd3 : DATA_WIDTH == 256 ? 3'd5 : 3'd4;
  assign {m_axi_arsize, m_axi_awsize}   = {2 {SIZE}};
  assign {m_axi_arburst, m_axi_awburst} = {2 {2'b01}};    // INCR

  // ---- soft reset, and holding one half while the other is in error, or both
  wire clearing;
  wire half_rst;
  wire hold_read;
  wire hold_write;
  wire read_quiet;
  wire read_open;
  wire read_empty;
  wire read_fault;
  wire write_busy;
  wire write_empty;
  wire write_fault;
  wire write_started;
  wire ring_empty;
  wire ring_started;
  wire guard_rst;
  wire guard_quiet_read;
  wire guard_quiet_write;
  wire guard_fault;
  wire [4:0] late;
  assign clearing_o    = clearing;
  assign result_busy_o = write_busy;

  ffd_dma_halt #(
    .HARDENED(HARDENED)
  ) u_halt (
    .clk                (clk),
    .rst                (rst),
    .soft_reset_i       (soft_reset_i),
    .read_quiet_i       (read_quiet),
    .read_open_i        (read_open),
    .read_empty_i       (read_empty),
    .read_fault_i       (read_fault),
    .write_busy_i       (write_busy),
    .write_empty_i      (write_empty),
    .write_fault_i      (write_fault),
    .write_started_i    (write_started),
    .ring_empty_i       (ring_empty),
    .ring_started_i     (ring_started),
    .ring_running_i     (ring_running_o),
    .result_running_i   (result_running_o),
    .late_i             (late),
    .timeout_i          (timeout_o),
    .guard_quiet_read_i (guard_quiet_read),
    .guard_quiet_write_i(guard_quiet_write),
    .guard_fault_i      (guard_fault),
    .guard_rst_o        (guard_rst),
    .soft_o             (clearing),
    .half_rst_o         (half_rst),
    .hold_read_o        (hold_read),
    .hold_write_o       (hold_write),
    .fault_o            (fault_o),
    .idle_o             (idle_o),
    .halted_o           (halted_o)
  );

  // ---- the ring, whose errors never come with one of the bus; addresses are 0 but with an error
  wire         request_valid;
  wire         request_ready;
  wire [63:0]  request_address;
  wire [31:0]  request_length;
  wire         request_fetch;
  wire         request_check;
  wire         request_mark;
  wire         refused;
  wire [2:0]   refused_code;
  wire         fetched;
  wire [127:0] fetched_data;
  wire         finished;
  wire         ring_error;
  wire [3:0]   ring_error_code;
  wire [63:0]  ring_error_address;
  wire         bus_error;
  wire [2:0]   bus_error_code;
  wire [63:0]  bus_error_address;

  assign read_error_o         = ring_error || bus_error;
  assign read_error_code_o    = bus_error ? {1'b0, bus_error_code} : ring_error_code;
  assign read_error_address_o = bus_error ? bus_error_address : ring_error_address;

  ffd_dma_ring #(
    .DESCRIPTORS(DESCRIPTORS),
    .MARKS      (MARKS)
  ) u_ring (
    .clk              (clk),
    .rst              (half_rst || clearing),
    .start_i          (ring_start_i),
    .base_i           (ring_base_i),
    .entries_log2_i   (ring_entries_log2_i),
    .head_i           (ring_head_i),
    .tail_o           (ring_tail_o),
    .running_o        (ring_running_o),
    .empty_o          (ring_empty),
    .m_request_valid  (request_valid),
    .m_request_ready  (request_ready),
    .m_request_address(request_address),
    .m_request_length (request_length),
    .m_request_fetch  (request_fetch),
    .m_request_check  (request_check),
    .m_request_mark   (request_mark),
    .refused_i        (refused),
    .refused_code_i   (refused_code),
    .fetched_i        (fetched),
    .fetched_data_i   (fetched_data),
    .finished_i       (finished),
    .stop_i           (read_fault),
    .quiet_i          (read_quiet),
    .started_o        (ring_started),
    .error_o          (ring_error),
    .error_code_o     (ring_error_code),
    .error_address_o  (ring_error_address)
  );

  // ---- the halves
  wire         asked;
  wire         asked_first;
  wire         asked_last;
  wire         beat_valid;
  wire         beat_ready;
  wire [127:0] beat_data;
  wire [1:0]   beat_response;
  wire         beat_last;
  wire         read_upset;
  wire         write_upset;
  wire        ar_valid;
  wire        ar_ready;
  wire [63:0] ar_address;
  wire [7:0]  ar_len;
  wire        r_valid;
  wire        r_ready;
  wire        aw_valid;
  wire        aw_ready;
  wire [63:0] aw_address;
  wire [7:0]  aw_len;
  wire        w_valid;
  wire        w_ready;
  wire [DATA_WIDTH-1:0] w_data;
  wire [DATA_WIDTH/8-1:0] w_strobe;
  wire        w_last;
  wire        b_valid;
  wire        b_ready;
  wire [63:0] read_first;
  wire [63:0] read_last;
  wire [63:0] write_first;
  wire [63:0] write_last;
  wire         out_valid;
  wire         out_ready;
  wire [127:0] out_data;
  wire         out_last;
  wire         out_upper;

  ffd_dma_read #(
    .MAX_BURST  (BURST),
    .FIFO_DEPTH (READ_DEPTH),
    .OUTSTANDING(READ_OUTSTANDING),
    .DATA_WIDTH (DATA_WIDTH),
    .MARKS      (MARKS),
    .HARDENED   (HARDENED)
  ) u_read (
    .clk              (clk),
    .rst              (half_rst),
    .start_i          (ring_started),
    .soft_i           (clearing),
    .hold_i           (hold_read),
    .window_first_i   (read_first),
    .window_last_i    (read_last),
    .s_request_valid  (request_valid),
    .s_request_ready  (request_ready),
    .s_request_address(request_address),
    .s_request_length (request_length),
    .s_request_fetch  (request_fetch),
    .s_request_check  (request_check),
    .s_request_mark   (request_mark),
    .refused_o        (refused),
    .refused_code_o   (refused_code),
    .m_axi_arvalid    (ar_valid),
    .m_axi_arready    (ar_ready),
    .m_axi_araddr     (ar_address),
    .m_axi_arlen      (ar_len),
    .asked_o          (asked),
    .asked_first_o    (asked_first),
    .asked_last_o     (asked_last),
    .m_axi_rvalid     (beat_valid),
    .m_axi_rready     (beat_ready),
    .m_axi_rdata      (beat_data),
    .m_axi_rresp      (beat_response),
    .m_axi_rlast      (beat_last),
    .m_packet_valid   (m_packet_valid),
    .m_packet_ready   (m_packet_ready),
    .m_packet_data    (m_packet_data),
    .m_packet_last    (m_packet_last),
    .fetched_o        (fetched),
    .fetched_data_o   (fetched_data),
    .finished_o       (finished),
    .finished_mark_o  (ring_marked_o),
    .fault_o          (read_fault),
    .upset_o          (read_upset),
    .error_o          (bus_error),
    .error_code_o     (bus_error_code),
    .error_address_o  (bus_error_address),
    .quiet_o          (read_quiet),
    .open_o           (read_open),
    .empty_o          (read_empty)
  );

  ffd_dma_width_read #(
    .DATA_WIDTH (DATA_WIDTH),
    .OUTSTANDING(READ_OUTSTANDING)
  ) u_width_read (
    .clk            (clk),
    .rst            (half_rst),
    .asked_i        (asked),
    .asked_first_i  (asked_first),
    .asked_last_i   (asked_last),
    .m_axi_rvalid   (r_valid),
    .m_axi_rready   (r_ready),
    .m_axi_rdata    (m_axi_rdata),
    .m_axi_rresp    (m_axi_rresp),
    .m_axi_rlast    (m_axi_rlast),
    .m_beat_valid   (beat_valid),
    .m_beat_ready   (beat_ready),
    .m_beat_data    (beat_data),
    .m_beat_response(beat_response),
    .m_beat_last    (beat_last)
  );

  ffd_dma_write #(
    .MAX_BURST   (BURST),
    .FIFO_DEPTH  (WRITE_DEPTH),
    .OUTSTANDING (WRITE_OUTSTANDING),
    .FLUSH_CLOCKS(FLUSH_CLOCKS),
    .DATA_WIDTH  (DATA_WIDTH),
    .MARKS       (MARKS),
    .HARDENED    (HARDENED)
  ) u_write (
    .clk            (clk),
    .rst            (half_rst),
    .start_i        (result_start_i),
    .soft_i         (clearing),
    .hold_i         (hold_write),
    .window_first_i (write_first),
    .window_last_i  (write_last),
    .base_i         (result_base_i),
    .size_i         (result_size_i),
    .s_result_valid (s_result_valid),
    .s_result_ready (s_result_ready),
    .s_result_data  (s_result_data),
    .s_result_last  (s_result_last),
    .s_result_mark  (s_result_mark),
    .m_axi_awvalid  (aw_valid),
    .m_axi_awready  (aw_ready),
    .m_axi_awaddr   (aw_address),
    .m_axi_awlen    (aw_len),
    .m_axi_wvalid   (out_valid),
    .m_axi_wready   (out_ready),
    .m_axi_wdata    (out_data),
    .m_axi_wlast    (out_last),
    .upper_o        (out_upper),
    .m_axi_bvalid   (b_valid),
    .m_axi_bready   (b_ready),
    .m_axi_bresp    (m_axi_bresp),
    .started_o      (write_started),
    .running_o      (result_running_o),
    .busy_o         (write_busy),
    .empty_o        (write_empty),
    .count_o        (result_count_o),
    .overflow_o     (result_overflow_o),
    .marked_o       (result_marked_o),
    .fault_o        (write_fault),
    .upset_o        (write_upset),
    .error_o        (write_error_o),
    .error_code_o   (write_error_code_o),
    .error_address_o(write_error_address_o)
  );

  ffd_dma_width_write #(
    .DATA_WIDTH(DATA_WIDTH)
  ) u_width_write (
    .clk         (clk),
    .rst         (half_rst),
    .s_beat_valid(out_valid),
    .s_beat_ready(out_ready),
    .s_beat_data (out_data),
    .s_beat_last (out_last),
    .s_beat_upper(out_upper),
    .m_axi_wvalid(w_valid),
    .m_axi_wready(w_ready),
    .m_axi_wdata (w_data),
    .m_axi_wstrb (w_strobe),
    .m_axi_wlast (w_last)
  );

  ffd_dma_guard #(
    .HARDENED  (HARDENED),
    .DATA_WIDTH(DATA_WIDTH),
    .READS     (READ_OUTSTANDING),
    .WRITES    (WRITE_OUTSTANDING)
  ) u_guard (
    .clk          (clk),
    .rst          (guard_rst),
    .halves_rst_i (half_rst),
    .flush_i      (clearing),
    .locked_i     (windows_locked_i),
    .read_first_i (read_first_i),
    .read_last_i  (read_last_i),
    .write_first_i(write_first_i),
    .write_last_i (write_last_i),
    .read_first_o (read_first),
    .read_last_o  (read_last),
    .write_first_o(write_first),
    .write_last_o (write_last),
    .quiet_read_o (guard_quiet_read),
    .quiet_write_o(guard_quiet_write),
    .fault_o      (guard_fault),
    .window_o     (upset_o[1]),
    .burst_o      (upset_o[2]),
    .copy_o       (upset_o[3]),
    .s_ar_valid   (ar_valid),
    .s_ar_ready   (ar_ready),
    .s_ar_address (ar_address),
    .s_ar_len     (ar_len),
    .s_r_valid    (r_valid),
    .s_r_ready    (r_ready),
    .s_aw_valid   (aw_valid),
    .s_aw_ready   (aw_ready),
    .s_aw_address (aw_address),
    .s_aw_len     (aw_len),
    .s_w_valid    (w_valid),
    .s_w_ready    (w_ready),
    .s_w_data     (w_data),
    .s_w_strobe   (w_strobe),
    .s_w_last     (w_last),
    .s_b_valid    (b_valid),
    .s_b_ready    (b_ready),
    .m_axi_arvalid(m_axi_arvalid),
    .m_axi_arready(m_axi_arready),
    .m_axi_araddr (m_axi_araddr),
    .m_axi_arlen  (m_axi_arlen),
    .m_axi_rvalid (m_axi_rvalid),
    .m_axi_rready (m_axi_rready),
    .m_axi_rlast  (m_axi_rlast),
    .m_axi_awvalid(m_axi_awvalid),
    .m_axi_awready(m_axi_awready),
    .m_axi_awaddr (m_axi_awaddr),
    .m_axi_awlen  (m_axi_awlen),
    .m_axi_wvalid (m_axi_wvalid),
    .m_axi_wready (m_axi_wready),
    .m_axi_wdata  (m_axi_wdata),
    .m_axi_wstrb  (m_axi_wstrb),
    .m_axi_wlast  (m_axi_wlast),
    .m_axi_bvalid (m_axi_bvalid),
    .m_axi_bready (m_axi_bready)
  );
  assign upset_o[0] = read_upset || write_upset;

  ffd_dma_watch #(
    .TIMEOUT(TIMEOUT),
    .READS  (READ_OUTSTANDING),
    .WRITES (WRITE_OUTSTANDING)
  ) u_watch (
    .clk      (clk),
    .rst      (half_rst),
    .arvalid_i(m_axi_arvalid),
    .arready_i(m_axi_arready),
    .rvalid_i (m_axi_rvalid),
    .rready_i (m_axi_rready),
    .rlast_i  (m_axi_rlast),
    .awvalid_i(m_axi_awvalid),
    .awready_i(m_axi_awready),
    .wvalid_i (m_axi_wvalid),
    .wready_i (m_axi_wready),
    .wlast_i  (m_axi_wlast),
    .bvalid_i (m_axi_bvalid),
    .bready_i (m_axi_bready),
    .late_o   (late),
    .timeout_o(timeout_o)
  );
endmodule

`default_nettype wire
