// ffd_dma_read: the read half of an AXI4 master: requests become bursts, their data a stream
//
// A request is {address, length, fetch}. With fetch its one beat, a descriptor, goes to fetched_o;
// without, its beats go to the stream, `last` on the last one, and finished_o says that all came;
// finished_mark_o (with MARKS), that it had s_request_mark.
// Addresses are checked and cut by ffd_dma_address. An address goes out only when the FIFO has room
// for the whole burst, so m_axi_rready is 1 from the second clock after reset on. One ID: answers
// come in order; a queue of OUTSTANDING bursts says what each is.
//
// Bus error: error_o with code (6 SLVERR, 7 DECERR) and address of the burst. From fault_o on, a
// clock after the answer, no address is raised (one that waits for arready must stay), the request
// is forgotten and all data to come is dropped. The packet ends with the last good beat before,
// marked `last`; had it none, it leaves no trace. So each beat is held until the next one is seen
// to be good. start_i, given when quiet_o is 1, ends this state.
// A request with s_request_check is checked, and asks for nothing.
// Of the bus this module sees beats of 16 bytes, whatever its width; only m_axi_arlen is in beats
// of DATA_WIDTH bits. asked_o tells ffd_dma_width_read of a burst in the clock before its address,
// with the halves of a beat of 256 bits that it begins (asked_first_o) and ends with (asked_last_o;
// 1 is the upper half).
// soft_i (level): no new address, data dropped, stream empty; quiet_o when all has been answered.
// hold_i (level): no new address, nothing lost. open_o: a burst is not wholly answered.
//
// Pipeline:   4 clocks request to burst; data 5 clocks from bus to stream, II 1. No path from an
//             input to an output of the bus: AR, rready and the stream come from registers.
// Parameters: FIFO_DEPTH a power of two >= 2 * MAX_BURST, OUTSTANDING a power of two >= 2,
//             MARKS 0 or 1; MAX_BURST, DATA_WIDTH and HARDENED as in ffd_dma_address.
// Not checked: rlast is trusted; data without a burst is ignored.
// Model:      none (transport only).  Test: tests/bus/dma.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"

module ffd_dma_read #(
  parameter MAX_BURST   = 256,
  parameter FIFO_DEPTH  = 512,
  parameter OUTSTANDING = 8,
  parameter DATA_WIDTH  = 128,
  parameter MARKS       = 0,
  parameter HARDENED    = 0
) (
  input  wire         clk,
  input  wire         rst,
  input  wire         start_i,
  input  wire         soft_i,
  input  wire         hold_i,
  input  wire [63:0]  window_first_i,
  input  wire [63:0]  window_last_i,
  input  wire         s_request_valid,
  output wire         s_request_ready,
  input  wire [63:0]  s_request_address,
  input  wire [31:0]  s_request_length,
  input  wire         s_request_fetch,
  input  wire         s_request_check,
  input  wire         s_request_mark,
  output wire         refused_o,
  output wire [2:0]   refused_code_o,
  output reg          m_axi_arvalid,
  input  wire         m_axi_arready,
  output reg  [63:0]  m_axi_araddr,
  output reg  [7:0]   m_axi_arlen,
  output wire         asked_o,
  output wire         asked_first_o,
  output wire         asked_last_o,
  input  wire         m_axi_rvalid,
  output reg          m_axi_rready,
  input  wire [127:0] m_axi_rdata,
  input  wire [1:0]   m_axi_rresp,
  input  wire         m_axi_rlast,
  output wire         m_packet_valid,
  input  wire         m_packet_ready,
  output wire [127:0] m_packet_data,
  output wire         m_packet_last,
  output reg          fetched_o,
  output reg  [127:0] fetched_data_o,
  output reg          finished_o,
  output wire         finished_mark_o,
  output wire         fault_o,
  output wire         upset_o,
  output reg          error_o,
  output reg  [2:0]   error_code_o,
  output reg  [63:0]  error_address_o,
  output wire         quiet_o,
  output wire         open_o,
  output wire         empty_o
);
  generate
    if (FIFO_DEPTH < 2 * MAX_BURST) begin : gen_bad_depth
      ERROR_ffd_dma_read_fifo_depth_must_hold_two_bursts u_error ();
    end
    if (OUTSTANDING < 2) begin : gen_bad_outstanding
      ERROR_ffd_dma_read_outstanding_must_be_at_least_2 u_error ();
    end
  endgenerate

  localparam BURST_W = $clog2(MAX_BURST);
  localparam COUNT_W = $clog2(FIFO_DEPTH) + 1;
  localparam [2:0] SLAVE_ERROR = 3'd6;
  localparam [2:0] DECODE_ERROR = 3'd7;

  // ---- requests to bursts
  reg         stop_q;
  wire        discard = stop_q || soft_i;
  wire        burst_valid;
  wire        burst_ready;
  wire [63:0] burst_address;
  wire [BURST_W-1:0] burst_len;
  wire        burst_last;
  wire [7:0]  bus_len;
  wire [BURST_W-1:0] unused_offer;
  wire        address_ready;
  reg         fetch_q;
  reg         mark_q;

  assign s_request_ready = address_ready && !discard;

  ffd_dma_address #(
    .ADDRESS_W (64),
    .LENGTH_W  (32),
    .MAX_BURST (MAX_BURST),
    .DATA_WIDTH(DATA_WIDTH),
    .HARDENED  (HARDENED)
  ) u_address (
    .clk              (clk),
    .rst              (rst || discard),
    .window_first_i   (window_first_i),
    .window_last_i    (window_last_i),
    .s_request_valid  (s_request_valid),
    .s_request_ready  (address_ready),
    .s_request_address(s_request_address),
    .s_request_length (s_request_length),
    .s_request_check  (s_request_check),
    .refused_o        (refused_o),
    .refused_code_o   (refused_code_o),
    .upset_o          (upset_o),
    .m_burst_valid    (burst_valid),
    .m_burst_ready    (burst_ready),
    .m_burst_address  (burst_address),
    .m_burst_len      (burst_len),
    .m_burst_last     (burst_last),
    .m_bus_len        (bus_len),
    .m_bus_upper      (asked_last_o),
    .offer_o          (unused_offer),
    .limited_i        (1'b0),
    .limit_i          ({BURST_W {1'b0}})
  );

  always @(posedge clk) begin
    if (s_request_valid && s_request_ready) fetch_q <= s_request_fetch;
    if (s_request_valid && s_request_ready) mark_q <= s_request_mark;
  end

  // ---- outstanding bursts: {its request's mark, last of its request, fetch, address in beats}
  wire        queue_ready;
  wire        queue_valid;
  wire [62:0] asked = {mark_q, burst_last, fetch_q, burst_address[63:4]};
  wire [61+MARKS:0] owner;
  wire        owner_last  = owner[61];
  wire        owner_fetch = owner[60];
  wire [59:0] owner_beat  = owner[59:0];
  wire        beat   = m_axi_rvalid && m_axi_rready && queue_valid;
  wire        done   = beat && m_axi_rlast;
  wire        failed = m_axi_rresp != 2'b00;
  // Beats that were taken in the clock before, and of what.
  reg         good_q;
  reg         bad_q;
  reg         fetched_q;
  reg         end_q;       // of its request
  reg         decode_q;    // its code is DECODE_ERROR
  reg [59:0]  beat_q;
  reg [127:0] data_q;

  ffd_stream_fifo #(
    .WIDTH(62 + MARKS),
    .DEPTH(OUTSTANDING)
  ) u_outstanding (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(burst_valid && burst_ready),
    .s_word_ready(queue_ready),
    .s_word_data (asked[61+MARKS:0]),
    .m_word_valid(queue_valid),
    .m_word_ready(done),
    .m_word_data (owner)
  );

  assign open_o  = queue_valid || good_q || bad_q;
  assign quiet_o = !open_o && address_ready && !refused_o;

  // ---- answers
  wire bad     = bad_q && !discard;
  wire good    = good_q && !discard;
  wire arrives = good && !fetched_q;
  wire dropped = (bad_q || (good_q && discard)) && !fetched_q;

  always @(posedge clk) begin
    good_q <= beat && !failed && !rst;
    bad_q  <= beat && failed && !rst;
  end

  always @(posedge clk) begin
    end_q     <= owner_last && m_axi_rlast;
    fetched_q <= owner_fetch;
    decode_q  <= m_axi_rresp == 2'b11;
    beat_q    <= owner_beat;
    data_q    <= m_axi_rdata;
  end

  generate
    if (MARKS != 0) begin : gen_marks
      reg owner_q;
      reg finished_q;
      always @(posedge clk) owner_q <= owner[62];
      always @(posedge clk) finished_q <= arrives && end_q && owner_q && !rst;
      assign finished_mark_o = finished_q;
    end else begin : gen_no_marks
      assign finished_mark_o = 1'b0;
    end
  endgenerate

  assign fault_o = bad;

  always @(posedge clk) begin
    if (rst) begin
      m_axi_rready <= 1'b0;
      stop_q       <= 1'b0;
      error_o      <= 1'b0;
      fetched_o    <= 1'b0;
      finished_o   <= 1'b0;
    end else begin
      m_axi_rready <= 1'b1;
      stop_q       <= bad || (stop_q && !start_i);
      error_o      <= bad;
      fetched_o    <= good && fetched_q;
      finished_o   <= arrives && end_q;
    end
  end

  always @(posedge clk) begin
    fetched_data_o  <= data_q;
    error_code_o    <= decode_q ? DECODE_ERROR : SLAVE_ERROR;
    error_address_o <= {beat_q, 4'd0};
  end

  // ---- the beat that is held: only the next one tells whether it is the packet's last
  reg          held_q;
  reg          held_last_q;
  reg  [127:0] held_data_q;
  wire         release_held = held_q && (held_last_q || arrives || bad);
  wire         fifo_ready;    // room is counted below

  always @(posedge clk) begin
    if (rst || soft_i) held_q <= 1'b0;
    else held_q <= arrives || (held_q && !release_held);
  end

  always @(posedge clk) begin
    if (arrives) begin
      held_data_q <= data_q;
      held_last_q <= end_q;
    end
  end

  ffd_stream_queue #(
    .WIDTH  (129),
    .DEPTH  (FIFO_DEPTH),
    .BLOCK  (1),
    .COUNTED(1)
  ) u_fifo (
    .clk         (clk),
    .rst         (rst || soft_i),
    .s_word_valid(release_held),
    .s_word_ready(fifo_ready),
    .s_word_data ({held_last_q || bad, held_data_q}),
    .m_word_valid(m_packet_valid),
    .m_word_ready(m_packet_ready),
    .m_word_data ({m_packet_last, m_packet_data})
  );

  // ---- room: what is neither in the FIFO nor promised to a burst
  reg  [COUNT_W-1:0] room_q;
  // Counted a clock after it happened: a burst was taken (len_q), a beat dropped, one has left. The
  // next burst is looked at four clocks after one was taken.
  reg  [BURST_W-1:0] len_q;
  reg                taken_q;
  reg                dropped_q;
  reg                left_q;
  wire               enough = room_q > {{(COUNT_W - BURST_W) {1'b0}}, burst_len};
  // No beat is dropped in a clock in which a burst is taken. The sum is one chain of carries: less
  // the burst's beats, or one more, and one more for a beat that left.
  wire [COUNT_W-1:0] more   = taken_q ? {{(COUNT_W - BURST_W) {1'b1}}, ~len_q}
                                      : {{(COUNT_W - 1) {1'b0}}, dropped_q};
  wire [COUNT_W:0]   rooms  = {room_q, 1'b1} + {more, left_q};

  always @(posedge clk) begin
    if (rst) begin
      room_q    <= FIFO_DEPTH[COUNT_W-1:0];
      taken_q   <= 1'b0;
      dropped_q <= 1'b0;
      left_q    <= 1'b0;
    end else begin
      room_q    <= rooms[COUNT_W:1];
      taken_q   <= burst_valid && burst_ready && !fetch_q;
      dropped_q <= dropped;
      left_q    <= m_packet_valid && m_packet_ready;
    end
  end

  assign empty_o = room_q == FIFO_DEPTH[COUNT_W-1:0];

  // ---- the address channel
  assign asked_o       = burst_valid && burst_ready;
  assign asked_first_o = burst_address[4];
  assign burst_ready = (!m_axi_arvalid || m_axi_arready) && queue_ready && !hold_i && !discard
                    && !bad && (fetch_q || enough);

  always @(posedge clk) begin
    if (rst) m_axi_arvalid <= 1'b0;
    else if (!m_axi_arvalid || m_axi_arready) m_axi_arvalid <= burst_valid && burst_ready;
  end

  always @(posedge clk) begin
    if (burst_valid && burst_ready) begin
      m_axi_araddr <= burst_address;
      m_axi_arlen  <= bus_len;
      len_q        <= burst_len;
    end
  end

  wire unused_ok = &{1'b0, unused_offer, burst_address[3:0], fifo_ready, rooms[0], asked};

  `FFD_ASSERT(a_burst_is_asked_and_too_many_are_open,
              !(burst_valid && burst_ready) || queue_ready)
endmodule

`default_nettype wire
