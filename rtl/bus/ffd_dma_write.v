// ffd_dma_write: the write half of an AXI4 master: a stream of beats into one area of memory
//
// start_i takes the area {base_i, size_i bytes}; ffd_dma_address checks it against the window and
// cuts it. Beats go to consecutive addresses. A burst goes out when the FIFO holds all of its data:
// a full one while beats keep coming; a short one after a beat with `last`, or when none has come
// for FLUSH_CLOCKS. So nothing stays behind, and write data never waits for the stream. Beats past
// the area are dropped and set overflow_o (until start_i). count_o, from the second clock after
// start_i on: beats acknowledged since then.
//
// Bus error: error_o with code (6 SLVERR, 7 DECERR) and address of the burst. From fault_o on, a
// clock after the answer, no address is raised, started bursts get their data, then running_o
// falls. What was in no burst waits in the FIFO for the next start_i; count_o stays at the beats
// before the failed burst. An area that is refused: error_o with code (1 to 4) and its base.
// start_i is ignored while busy_o is 1 (bursts out, or stopping).
// soft_i (level, until rst, which empties the FIFO): no new address, no beat taken; started bursts
// get their data; busy_o falls.
// marked_o (with MARKS), a pulse with the count: a beat with s_result_mark is in memory.
// hold_i (level): no new address from the clock after next on, nothing lost.
// Write data leaves in beats of 16 bytes, whatever the bus; only m_axi_awlen is in beats of
// DATA_WIDTH bits. upper_o: the beat is the upper half of one of 256 bits.
//
// Pipeline:   a beat takes 6 clocks at least from stream to bus; II 1. No path from an input to an
//             output of the bus: AW, W, bready come from registers.
// Parameters: FIFO_DEPTH a power of two >= 2 * MAX_BURST, OUTSTANDING one >= 2, FLUSH_CLOCKS 1 to
//             65535, MARKS 0 or 1; MAX_BURST, DATA_WIDTH and HARDENED as in ffd_dma_address.
// Model:      none (transport only).  Test: tests/bus/dma.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"

module ffd_dma_write #(
  parameter MAX_BURST    = 256,
  parameter FIFO_DEPTH   = 512,
  parameter OUTSTANDING  = 8,
  parameter FLUSH_CLOCKS = 16,
  parameter DATA_WIDTH   = 128,
  parameter MARKS        = 0,
  parameter HARDENED     = 0
) (
  input  wire         clk,
  input  wire         rst,
  input  wire         start_i,
  input  wire         soft_i,
  input  wire         hold_i,
  input  wire [63:0]  window_first_i,
  input  wire [63:0]  window_last_i,
  input  wire [63:0]  base_i,
  input  wire [31:0]  size_i,
  input  wire         s_result_valid,
  output wire         s_result_ready,
  input  wire [127:0] s_result_data,
  input  wire         s_result_last,
  input  wire         s_result_mark,
  output reg          m_axi_awvalid,
  input  wire         m_axi_awready,
  output reg  [63:0]  m_axi_awaddr,
  output reg  [7:0]   m_axi_awlen,
  output reg          m_axi_wvalid,
  input  wire         m_axi_wready,
  output reg  [127:0] m_axi_wdata,
  output reg          m_axi_wlast,
  output reg          upper_o,
  input  wire         m_axi_bvalid,
  output reg          m_axi_bready,
  input  wire [1:0]   m_axi_bresp,
  output wire         started_o,
  output reg          running_o,
  output wire         busy_o,
  output wire         empty_o,
  output wire [31:0]  count_o,
  output reg          overflow_o,
  output wire         marked_o,
  output wire         fault_o,
  output wire         upset_o,
  output reg          error_o,
  output reg  [2:0]   error_code_o,
  output reg  [63:0]  error_address_o
);
  generate
    if (FIFO_DEPTH < 2 * MAX_BURST) begin : gen_bad_depth
      ERROR_ffd_dma_write_fifo_depth_must_hold_two_bursts u_error ();
    end
    if (OUTSTANDING < 2) begin : gen_bad_outstanding
      ERROR_ffd_dma_write_outstanding_must_be_at_least_2 u_error ();
    end
    if (FLUSH_CLOCKS < 1 || FLUSH_CLOCKS > 65535) begin : gen_bad_flush
      ERROR_ffd_dma_write_flush_clocks_must_be_1_to_65535 u_error ();
    end
  endgenerate

  localparam BURST_W = $clog2(MAX_BURST);
  localparam COUNT_W = $clog2(FIFO_DEPTH) + 1;
  localparam QUIET_W = FLUSH_CLOCKS < 2 ? 1 : $clog2(FLUSH_CLOCKS);
  localparam LAST_QUIET = FLUSH_CLOCKS - 1;
  localparam [2:0] SLAVE_ERROR = 3'd6, DECODE_ERROR = 3'd7;

  // ---- the area
  reg         stop_q;
  reg         asking_q;    // an area goes to be checked, for which all is ready after accept
  reg         full_q;      // its last address is out
  reg  [63:0] base_q;
  reg  [31:0] size_q;
  wire        accept = start_i && !busy_o && !soft_i;
  wire        unused_ready;
  wire        refused;
  wire [2:0]  refused_code;
  wire        burst_valid;
  wire        burst_ready;
  wire [63:0] burst_address;
  wire [BURST_W-1:0] burst_len;
  wire        burst_last;
  wire [7:0]  bus_len;
  wire        bus_upper;
  wire [BURST_W-1:0] offer;
  reg         limited_q;   // the burst is shorter than what is offered
  reg  [BURST_W-1:0] limit_q;
  wire        step = burst_valid && burst_ready;
  wire        bad;
  wire        bursts_out;

  assign started_o = accept;
  assign busy_o    = asking_q || bursts_out || stop_q;

  ffd_dma_address #(
    .ADDRESS_W (64),
    .LENGTH_W  (32),
    .MAX_BURST (MAX_BURST),
    .DATA_WIDTH(DATA_WIDTH),
    .HARDENED  (HARDENED)
  ) u_address (
    .clk              (clk),
    .rst              (rst || accept || soft_i || stop_q),
    .window_first_i   (window_first_i),
    .window_last_i    (window_last_i),
    .s_request_valid  (asking_q),
    .s_request_ready  (unused_ready),
    .s_request_address(base_q),
    .s_request_length (size_q),
    .s_request_check  (1'b0),
    .refused_o        (refused),
    .refused_code_o   (refused_code),
    .upset_o          (upset_o),
    .m_burst_valid    (burst_valid),
    .m_burst_ready    (burst_ready),
    .m_burst_address  (burst_address),
    .m_burst_len      (burst_len),
    .m_burst_last     (burst_last),
    .m_bus_len        (bus_len),
    .m_bus_upper      (bus_upper),
    .offer_o          (offer),
    .limited_i        (limited_q),
    .limit_i          (limit_q)
  );

  always @(posedge clk) begin
    if (rst) begin
      asking_q  <= 1'b0;
      running_o <= 1'b0;
      stop_q    <= 1'b0;
      full_q    <= 1'b0;
    end else begin
      asking_q  <= accept;
      running_o <= accept || (running_o && !refused && !(stop_q && !bursts_out));
      stop_q    <= bad || (stop_q && bursts_out);
      full_q    <= !accept && !bad && (full_q || (step && burst_last));
    end
  end

  always @(posedge clk) if (start_i && !asking_q) {base_q, size_q} <= {base_i, size_i};

  // ---- beats in, and those of them that no burst has taken yet
  wire         fifo_ready;
  wire         fifo_valid;
  wire         fifo_pop;
  wire [128:0] fifo_in = {s_result_mark, s_result_data};
  wire [127+MARKS:0] fifo_word;
  wire [127:0] fifo_data = fifo_word[127:0];
  wire         drop;
  wire         push = s_result_valid && s_result_ready;

  assign s_result_ready = fifo_ready && !soft_i;

  ffd_stream_deep_fifo #(
    .WIDTH(128 + MARKS),
    .DEPTH(FIFO_DEPTH),
    .EARLY(1)
  ) u_fifo (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(s_result_valid),
    .s_word_ready(fifo_ready),
    .s_word_data (fifo_in[127+MARKS:0]),
    .m_word_valid(fifo_valid),
    .m_word_ready(fifo_pop),
    .m_word_data (fifo_word)
  );

  localparam [COUNT_W-1:0] NONE = {COUNT_W {1'b0}}, ONE = {{(COUNT_W - 1) {1'b0}}, 1'b1};
  reg  [COUNT_W-1:0] pending_q;
  reg                flush_q;
  reg  [QUIET_W-1:0] quiet_q;     // clocks without a beat
  reg                late_q;      // they are FLUSH_CLOCKS or more
  // A burst is made of the beats that were there two clocks ago. First behind_q and flush_q are of
  // one clock; then go_q, and with it the length. What is there only grows while a burst waits, and
  // the next burst comes four clocks later. So does what has room for its address.
  reg  [COUNT_W-1:0] behind_q;    // those beats less one
  reg                some_q;
  reg                all_q;       // the burst takes all of them
  reg                go_q;
  reg                marked_q;    // a beat with `last` was taken: a clock ago
  reg                mark_q;      // two clocks ago
  wire [COUNT_W-1:0] offered = {{(COUNT_W - BURST_W) {1'b0}}, offer};
  wire               whole   = behind_q >= offered;
  wire               none    = pending_q == NONE;
  wire               late    = late_q && !none;
  // One chain of carries: less the burst's beats or a beat that is dropped, one more for a push.
  wire [COUNT_W-1:0] more    = step ? {{(COUNT_W - BURST_W) {1'b1}}, ~burst_len} : {COUNT_W {drop}};
  wire [COUNT_W:0]   sum     = {pending_q, 1'b1} + {more, push};
  wire               room;

  always @(posedge clk) begin
    if (rst) begin
      pending_q <= NONE;
      flush_q   <= 1'b0;
      some_q    <= 1'b0;
      go_q      <= 1'b0;
      marked_q  <= 1'b0;
      mark_q    <= 1'b0;
    end else begin
      pending_q <= sum[COUNT_W:1];
      some_q    <= !none && !step;
      go_q      <= burst_valid && some_q && (whole || flush_q) && !step && room && !hold_i;
      marked_q  <= push && s_result_last;
      flush_q   <= marked_q || mark_q || ((flush_q || late) && !(step && all_q));
      mark_q    <= marked_q;
    end
  end

  always @(posedge clk) begin
    behind_q  <= pending_q - ONE;
    all_q     <= behind_q <= offered;
    limited_q <= !whole;
    limit_q   <= behind_q[BURST_W-1:0];
    if (push || none) {late_q, quiet_q} <= {(QUIET_W + 1) {1'b0}};
    else {late_q, quiet_q} <= {late_q || quiet_q == LAST_QUIET[QUIET_W-1:0], quiet_q + 1'b1};
  end

  // ---- bursts: address channel, lengths for the data channel, outstanding ones
  wire        aw_free = !m_axi_awvalid || m_axi_awready;
  wire        lengths_ready;
  wire        length_valid;
  wire        length_pop;
  wire [BURST_W-1:0] length;
  wire        outstanding_ready;
  wire        out_valid;
  wire [BURST_W-1:0] out_len;
  wire [59:0] out_beat;
  wire        answer = m_axi_bvalid && m_axi_bready && out_valid;
  // The answer that was taken in the clock before.
  reg         good_q;
  reg         bad_q;
  reg         decode_q;    // its code is DECODE_ERROR
  reg         started_q;   // start_i was
  reg  [BURST_W-1:0] len_q;
  reg  [59:0] beat_q;

  assign bursts_out  = out_valid || good_q || bad_q;
  assign room        = aw_free && lengths_ready && outstanding_ready;
  assign burst_ready = go_q && !soft_i && !stop_q && !bad_q;

  always @(posedge clk) begin
    if (rst) m_axi_awvalid <= 1'b0;
    else if (aw_free) m_axi_awvalid <= step;
  end

  always @(posedge clk) if (step) {m_axi_awlen, m_axi_awaddr} <= {bus_len, burst_address};

  ffd_stream_fifo #(
    .WIDTH(BURST_W),
    .DEPTH(OUTSTANDING)
  ) u_lengths (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(step),
    .s_word_ready(lengths_ready),
    .s_word_data (burst_len),
    .m_word_valid(length_valid),
    .m_word_ready(length_pop),
    .m_word_data (length)
  );

  ffd_stream_fifo #(
    .WIDTH(60 + BURST_W),
    .DEPTH(OUTSTANDING)
  ) u_outstanding (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(step),
    .s_word_ready(outstanding_ready),
    .s_word_data ({burst_len, burst_address[63:4]}),
    .m_word_valid(out_valid),
    .m_word_ready(answer),
    .m_word_data ({out_len, out_beat})
  );

  // ---- the data channel: an active burst's next beat is there, since all were when it began
  reg        active_q;
  reg  [BURST_W-1:0] left_q;    // beats of the burst after this one
  wire       w_free = !m_axi_wvalid || m_axi_wready;
  wire       move  = active_q && w_free;
  wire       last  = left_q == {BURST_W {1'b0}};
  wire       ended = move && last;

  // All data of the area has left: what comes behind it is dropped, until the next start.
  reg        past_q;
  always @(posedge clk) past_q <= full_q && !active_q && !length_valid && !accept && !bad && !rst;

  assign length_pop = !active_q || ended;
  assign drop       = past_q && fifo_valid && !soft_i;
  assign fifo_pop   = move || drop;
  assign empty_o    = none;

  always @(posedge clk) begin
    if (rst) active_q <= 1'b0;
    else if (length_pop) active_q <= length_valid;
  end

  always @(posedge clk) begin
    if (length_pop) left_q <= length;
    else if (move) left_q <= left_q - 1'b1;
  end

  always @(posedge clk) begin
    if (rst) m_axi_wvalid <= 1'b0;
    else if (w_free) m_axi_wvalid <= active_q;
  end

  always @(posedge clk) if (w_free) {m_axi_wlast, m_axi_wdata} <= {last, fifo_data};

  ffd_dma_marks #(
    .OUTSTANDING(OUTSTANDING),
    .MARKS      (MARKS)
  ) u_marks (
    .clk      (clk),
    .rst      (rst),
    .beat_i   (move),
    .mark_i   (fifo_word[127+MARKS]),
    .last_i   (ended),
    .answer_i (answer),
    .counted_i(good_q && !stop_q && !soft_i),
    .marked_o (marked_o)
  );

  // Beats of an area follow each other in memory.
  reg        upper_q;
  always @(posedge clk) begin
    if (accept) upper_q <= base_i[4];
    else if (move) upper_q <= !upper_q;
    if (w_free) upper_o <= upper_q;
  end

  // ---- answers
  reg  [27:0] count_q;     // an area has less than 2^28 beats
  assign count_o = {4'd0, count_q};
  assign bad     = bad_q && !stop_q && !soft_i;
  assign fault_o = bad;

  always @(posedge clk) begin
    started_q <= accept;
    good_q    <= answer && m_axi_bresp == 2'b00 && !rst;
    bad_q     <= answer && m_axi_bresp != 2'b00 && !rst;
    decode_q  <= m_axi_bresp == 2'b11;
    len_q     <= out_len;
    beat_q    <= out_beat;
  end

  always @(posedge clk) begin
    if (rst) begin
      m_axi_bready <= 1'b0;
      error_o      <= 1'b0;
      overflow_o   <= 1'b0;
      count_q      <= 28'd0;
    end else begin
      m_axi_bready <= 1'b1;
      error_o      <= bad || refused;
      overflow_o   <= drop || (overflow_o && !accept);
      if (started_q) count_q <= 28'd0;
      else if (good_q && !stop_q && !soft_i)
        count_q <= count_q + {{(28 - BURST_W) {1'b0}}, len_q} + 28'd1;
    end
  end

  always @(posedge clk) begin
    error_code_o    <= refused ? refused_code : decode_q ? DECODE_ERROR : SLAVE_ERROR;
    error_address_o <= refused ? base_q : {beat_q, 4'd0};
  end

  wire unused_ok = &{1'b0, unused_ready, burst_address[3:0], bus_upper, sum[0], fifo_in};

  `FFD_ASSERT(a_burst_is_made_and_too_many_are_open,
              !step || (lengths_ready && outstanding_ready))
endmodule

`default_nettype wire
