// ffd_dma_ring: walks a ring of descriptors and asks for the packets they name
//
// A descriptor is 16 bytes, little-endian: {flags[31:0], length[31:0], address[63:0]}, flags 0;
// with MARKS flag 0 asks for an interrupt (m_request_mark).
// Entry k lies at base_i + 16 k; base_i is a multiple of the ring's size, so that no address needs
// an adder and none wraps. The ring is empty where head_i == tail_o: one entry stays unused, so a
// ring of one entry would hold nothing.
// Descriptors from tail to head are fetched, DESCRIPTORS ahead at most, and asked for in order.
//
// A start is refused, with code and base_i, where base_i is not aligned (2), the ring has one entry
// only, or head_i is none of its entries (8), and where the ring is not wholly inside the window
// (4): for that the reader is asked first, to check it and no more. Later the first fault stops it:
// a request refused (refused_i), flags that are unknown (code 5), a head_i that is none of the
// entries (8, with base_i), a bus error (stop_i). error_o is a pulse with code and address of the
// descriptor for all but the last, which the reader reports. Earlier packets end as they should,
// then running_o falls. start_i begins at tail_o; it is taken where nothing runs or nothing is
// left, checks ring and head anew, and is ignored else. Only rst sets tail_o to 0.
//
// Pipeline:   a start and a head act a clock later, when all of their bits have been looked at,
//             and what to ask next is decided in the clock before it is asked; a request every five
//             clocks, fetches included, the first for a packet or a descriptor five after the
//             check.
// Parameters: DESCRIPTORS a power of two, 2 to 256: those fetched and not yet requested. MARKS 0
//             or 1.
// Not checked: base_i, entries_log2_i and the window are to be held from start_i on while entries
//             are left; every address is still checked by the reader.
// Model:      none (control only).  Test: tests/bus/dma.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_dma_ring #(
  parameter DESCRIPTORS = 4,
  parameter MARKS       = 0
) (
  input  wire         clk,
  input  wire         rst,
  input  wire         start_i,
  input  wire [63:0]  base_i,
  input  wire [3:0]   entries_log2_i,
  input  wire [15:0]  head_i,
  output wire [15:0]  tail_o,
  output wire         running_o,
  output wire         empty_o,
  output reg          m_request_valid,
  input  wire         m_request_ready,
  output reg  [63:0]  m_request_address,
  output reg  [31:0]  m_request_length,
  output reg          m_request_fetch,
  output reg          m_request_check,
  output wire         m_request_mark,
  input  wire         refused_i,
  input  wire [2:0]   refused_code_i,
  input  wire         fetched_i,
  input  wire [127:0] fetched_data_i,
  input  wire         finished_i,
  input  wire         stop_i,
  input  wire         quiet_i,
  output wire         started_o,
  output reg          error_o,
  output reg  [3:0]   error_code_o,
  output reg  [63:0]  error_address_o
);
  generate
    if (DESCRIPTORS < 2 || DESCRIPTORS > 256) begin : gen_bad_descriptors
      ERROR_ffd_dma_ring_descriptors_must_be_2_to_256 u_error ();
    end
  endgenerate

  localparam [3:0] MISALIGNED = 4'd2;
  localparam [3:0] FLAGS = 4'd5;
  localparam [3:0] RING = 4'd8;
  localparam DESCRIPTOR_W = 64 + 32 + 1 + MARKS;
  localparam AHEAD_W = $clog2(DESCRIPTORS);

  reg         start_q;
  reg         beyond_q;
  reg         misaligned_q;
  reg  [14:0] mask_q;     // bits of an entry's number
  reg  [14:0] head_q;     // one of the ring's entries, unless beyond_q
  reg         running_q;
  reg         stop_q;
  reg         check_q;    // the ring itself has not been asked for
  reg  [14:0] fetch_q;    // next to be fetched
  reg  [14:0] next_q;     // next to be requested
  reg  [14:0] tail_q;     // next to be finished
  reg  [14:0] entry_q;    // that of the request that is offered: no fetch is refused
  reg  [14:0] asked_q;    // that of the request that was taken last
  reg  [AHEAD_W:0] ahead_q;    // from next to fetch: DESCRIPTORS at most

  wire [15:0] above      = 16'hFFFF << entries_log2_i;    // bits that no entry's number has
  wire [14:0] mask       = ~above[14:0];
  wire [19:0] bytes      = {{mask_q, 1'b1} & ~{1'b0, mask_q}, 4'd0};    // of the ring
  wire        legal      = !misaligned_q && !beyond_q && mask_q[0];
  // Nothing was left a clock ago; what a head brings in that clock is asked for later.
  reg         over_q;
  wire        over       = over_q && !stop_q && !m_request_valid;
  wire        accept     = start_q && (!running_q || over);

  assign running_o = running_q;
  assign tail_o    = {1'b0, tail_q};
  assign empty_o   = !running_q || (tail_q == head_q && !check_q && !m_request_valid);
  assign started_o = accept && legal;

  always @(posedge clk) begin
    over_q       <= empty_o && !stop_q && quiet_i && !accept && !rst;
    start_q      <= start_i && !rst;
    mask_q       <= mask;
    head_q       <= head_i[14:0];
    beyond_q     <= (head_i & above) != 16'd0;
    misaligned_q <= (base_i[18:0] & {mask, 4'hF}) != 19'd0;
  end

  // Descriptors that have come.
  wire        queue_ready;
  wire        head_valid;
  wire        head_pop;
  wire [DESCRIPTOR_W-1:0] head_word;
  wire        head_bad = head_word[96];
  wire [63:0] head_address = head_word[63:0];
  wire [31:0] head_length  = head_word[95:64];
  wire        marked = fetched_data_i[96];
  wire        bad    = fetched_data_i[127:97] != 31'd0 || (marked && MARKS == 0);
  wire [97:0] fetched_word = {marked, bad, fetched_data_i[95:0]};

  ffd_stream_fifo #(
    .WIDTH(DESCRIPTOR_W),
    .DEPTH(DESCRIPTORS)
  ) u_queue (
    .clk         (clk),
    .rst         (rst || accept),
    .s_word_valid(fetched_i),
    .s_word_ready(queue_ready),
    .s_word_data (fetched_word[DESCRIPTOR_W-1:0]),
    .m_word_valid(head_valid),
    .m_word_ready(head_pop),
    .m_word_data (head_word)
  );

  // What to ask next: the ring, then descriptors first, since packets wait for them. Decided in the
  // clock before it is asked, and not in that in which something is. While the ring does not run
  // nothing is planned.
  reg         plan_check_q;
  reg         plan_fetch_q;
  reg         plan_data_q;
  wire        planned   = plan_check_q || plan_fetch_q || plan_data_q;
  wire        fetch     = fetch_q != head_q && !ahead_q[AHEAD_W];
  wire        allowed   = !stop_q && !refused_i && !stop_i && !beyond_q;
  wire        free      = !m_request_valid || m_request_ready;
  wire        bad_head  = head_valid && head_bad;
  // Not before the reader is done with the request before: that one is still to be read.
  wire        bad_flags = allowed && bad_head && !planned && !m_request_valid && m_request_ready;
  wire        ask       = allowed && free && planned;
  wire        ask_check = ask && plan_check_q;
  wire        ask_fetch = ask && plan_fetch_q;
  wire        ask_data  = ask && plan_data_q;

  assign head_pop = ask_data;

  always @(posedge clk) begin
    if (rst || accept || ask || !running_q) begin
      plan_check_q <= 1'b0;
      plan_fetch_q <= 1'b0;
      plan_data_q  <= 1'b0;
    end else begin
      plan_check_q <= check_q;
      plan_fetch_q <= !check_q && fetch && !bad_head;
      plan_data_q  <= !check_q && !fetch && head_valid && !head_bad;
    end
  end

  always @(posedge clk) begin
    if (rst) begin
      running_q <= 1'b0;
      stop_q    <= 1'b0;
      check_q   <= 1'b0;
    end else if (accept) begin
      running_q <= legal;
      stop_q    <= 1'b0;
      check_q   <= legal;
    end else begin
      if (ask_check) check_q <= 1'b0;
      if (stop_q && quiet_i && !m_request_valid) running_q <= 1'b0;
      if (running_q && (refused_i || stop_i || bad_flags || beyond_q)) stop_q <= 1'b1;
    end
  end

  always @(posedge clk) begin
    if (rst) begin
      fetch_q <= 15'd0;
      next_q  <= 15'd0;
      tail_q  <= 15'd0;
      ahead_q <= {(AHEAD_W + 1) {1'b0}};
    end else if (accept) begin
      fetch_q <= 15'd0;     // the ring begins there, which is checked
      next_q  <= tail_q & mask_q;
      tail_q  <= tail_q & mask_q;
      ahead_q <= {(AHEAD_W + 1) {1'b0}};
    end else begin
      if (ask_check) fetch_q <= tail_q;
      else if (ask_fetch) fetch_q <= (fetch_q + 1'b1) & mask_q;
      if (ask_data) next_q <= (next_q + 1'b1) & mask_q;
      if (finished_i) tail_q <= (tail_q + 1'b1) & mask_q;
      if (ask_fetch) ahead_q <= ahead_q + 1'b1;
      else if (ask_data) ahead_q <= {1'b0, ahead_q[AHEAD_W-1:0] - 1'b1};
    end
  end

  always @(posedge clk) begin
    if (rst || !allowed) m_request_valid <= 1'b0;
    else if (free) m_request_valid <= ask;
  end

  always @(posedge clk) begin
    if (free) begin
      m_request_check   <= plan_check_q;
      m_request_fetch   <= plan_fetch_q;
      m_request_length  <= plan_data_q ? head_length : plan_check_q ? {12'd0, bytes} : 32'd16;
      m_request_address <= plan_data_q ? head_address
                                       : {base_i[63:19], base_i[18:0] | {fetch_q, 4'd0}};
      entry_q           <= plan_check_q ? 15'd0 : next_q;
    end
    if (m_request_valid && m_request_ready) asked_q <= entry_q;
  end

  generate
    if (MARKS != 0) begin : gen_marks
      reg mark_q;
      always @(posedge clk) if (free) mark_q <= plan_data_q && head_word[97];
      assign m_request_mark = mark_q;
    end else begin : gen_no_marks
      assign m_request_mark = 1'b0;
    end
  endgenerate

  wire        wrong  = running_q && !stop_q && !stop_i && (refused_i || bad_flags || beyond_q);
  wire        error  = !rst && ((accept && !legal) || wrong);
  wire [14:0] guilty = refused_i ? asked_q : bad_flags && !beyond_q ? next_q : 15'd0;

  always @(posedge clk) begin
    error_o         <= error;
    error_code_o    <= accept ? (misaligned_q ? MISALIGNED : RING)
                              : refused_i ? {1'b0, refused_code_i} : beyond_q ? RING : FLAGS;
    error_address_o <= {base_i[63:19], base_i[18:0] | {guilty, 4'd0}};
  end

  wire unused_ok = &{1'b0, queue_ready, fetched_word};
endmodule

`default_nettype wire
