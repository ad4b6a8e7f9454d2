// formal_dma_ring: ffd_dma_ring with any ring, any window, any driver that adds entries, and any
// reader that answers what was asked
//
// The reader takes one request at a time and refuses it or lets it in; a fetch comes back as
// fetched_i, a packet as finished_i, at any time, or not at all after an error. What is only to be
// checked is refused or let in, no more. The ring is held from the start on while it runs, and the
// head never goes back or round past the tail.
//
// `range`, `room` and `live` are inductive: tail <= next <= fetch <= head round the ring, and what lies
// between them is with the reader, on the way to it or in the queue.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_dma_ring #(
  parameter DESCRIPTORS = 2
) (
  input wire         clk,
  input wire         rst,
  input wire         start,
  input wire [63:0]  base,
  input wire [3:0]   entries_log2,
  input wire [15:0]  head,
  input wire         want_ready,
  input wire         want_in,
  input wire         want_refused,
  input wire         want_fetched,
  input wire         want_finished,
  input wire         forget,
  input wire [127:0] data,
  input wire         stop
);
  wire [15:0] tail;
  wire        running;
  wire        started;
  wire        valid;
  wire [63:0] address;
  wire [31:0] length;
  wire        is_fetch;
  wire        is_check;

  reg         taken_q;     // a request that is neither refused nor let in
  reg         kind_q;
  reg         checks_q;
  reg  [15:0] fetches_q;
  reg  [15:0] packets_q;
  wire        ready    = want_ready && !taken_q;
  wire        take     = valid && ready;
  wire        refused  = taken_q && want_refused;
  wire        leave    = taken_q && want_in && !want_refused;
  wire        enter    = leave && !checks_q;
  wire        fetched  = want_fetched && fetches_q != 0;
  wire        finished = want_finished && packets_q != 0;
  wire        quiet    = fetches_q == 0 && packets_q == 0 && !taken_q;

  ffd_dma_ring #(
    .DESCRIPTORS(DESCRIPTORS)
  ) u_dut (
    .clk              (clk),
    .rst              (rst),
    .start_i          (start),
    .base_i           (base),
    .entries_log2_i   (entries_log2),
    .head_i           (head),
    .tail_o           (tail),
    .running_o        (running),
    .m_request_valid  (valid),
    .m_request_ready  (ready),
    .m_request_address(address),
    .m_request_length (length),
    .m_request_fetch  (is_fetch),
    .m_request_check  (is_check),
    .refused_i        (refused),
    .refused_code_i   (3'd4),
    .fetched_i        (fetched),
    .fetched_data_i   (data),
    .finished_i       (finished),
    .stop_i           (stop),
    .quiet_i          (quiet),
    .started_o        (started)
  );

  (* hierconn *) wire        \u_dut.stop_q ;
  (* hierconn *) wire        \u_dut.check_q ;
  (* hierconn *) wire        \u_dut.start_q ;
  (* hierconn *) wire [14:0] \u_dut.mask_q ;
  (* hierconn *) wire [14:0] \u_dut.head_q ;
  (* hierconn *) wire [$clog2(DESCRIPTORS):0] \u_dut.ahead_q ;
  (* hierconn *) wire        \u_dut.beyond_q ;
  (* hierconn *) wire        \u_dut.misaligned_q ;
  (* hierconn *) wire [14:0] \u_dut.fetch_q ;
  (* hierconn *) wire [14:0] \u_dut.next_q ;
  (* hierconn *) wire        \u_dut.queue_ready ;
  (* hierconn *) wire [$clog2(DESCRIPTORS):0] \u_dut.u_queue.write_q ;
  (* hierconn *) wire [$clog2(DESCRIPTORS):0] \u_dut.u_queue.read_q ;
  (* hierconn *) wire        \u_dut.over_q ;
  (* hierconn *) wire        \u_dut.planned ;
  (* hierconn *) wire        \u_dut.plan_check_q ;
  (* hierconn *) wire        \u_dut.plan_fetch_q ;
  (* hierconn *) wire        \u_dut.plan_data_q ;
  wire [$clog2(DESCRIPTORS):0] queued = \u_dut.u_queue.write_q - \u_dut.u_queue.read_q ;

  wire        beyond = (head >> entries_log2) != 0;
  reg         beyond_q;        // seen since the last start
  reg         stopped_q;       // and a clock before
  reg         seen_q;          // the check of the ring since the last start
  wire        gone = \u_dut.stop_q && forget;    // the reader drops what is left after an error
  reg         first_q = 1'b1;
  reg  [63:0] base_q;
  reg  [3:0]  entries_log2_q;
  reg  [15:0] head_q;
  reg  [14:0] expected_q;      // the entry that is to be fetched next
  wire [14:0] mask     = ~(15'h7FFF << entries_log2);
  wire [14:0] to_next  = (\u_dut.next_q - tail[14:0]) & mask;
  // Until the ring is asked for, fetch_q is its first entry; it is the tail from then on.
  wire [14:0] fetch    = \u_dut.check_q ? tail[14:0] : \u_dut.fetch_q ;
  wire [14:0] to_fetch = (fetch - tail[14:0]) & mask;
  wire [14:0] to_head  = (head[14:0] - tail[14:0]) & mask;
  wire [14:0] to_limit = (\u_dut.head_q - tail[14:0]) & mask;    // of the head that is known
  wire [14:0] to_old   = (head_q[14:0] - tail[14:0]) & mask;
  // What is looked at a clock later.
  wire [14:0] mask_old = ~(15'h7FFF << entries_log2_q);
  wire        looked   = \u_dut.mask_q == mask_old && \u_dut.head_q == head_q[14:0]
                      && \u_dut.beyond_q == ((head_q >> entries_log2_q) != 0)
                      && \u_dut.misaligned_q == ((base_q[18:0] & {mask_old, 4'hF}) != 0);
  always @(posedge clk) begin
    first_q        <= 1'b0;
    base_q         <= base;
    entries_log2_q <= entries_log2;
    head_q         <= head;
    stopped_q      <= !rst && !started && beyond_q;
    seen_q         <= !started && (seen_q || (valid && is_check));
    beyond_q       <= !rst && !started && (beyond_q || (running && beyond));
    if (rst) begin
      taken_q   <= 1'b0;
      fetches_q <= 0;
      packets_q <= 0;
    end else begin
      taken_q   <= take || (taken_q && !refused && !leave && !gone);
      fetches_q <= gone ? 0 : fetches_q + (enter && kind_q) - fetched;
      packets_q <= gone ? 0 : packets_q + (enter && !kind_q) - finished;
    end
    if (take) kind_q <= is_fetch;
    if (take) checks_q <= is_check;
    if (started) expected_q <= tail[14:0] & mask;
    else if (take && is_fetch) expected_q <= (expected_q + 1'b1) & mask;
  end
  always @* begin
    if (first_q) assume (rst);
    else if (running || \u_dut.start_q ) assume (base == base_q && entries_log2 == entries_log2_q
                              && to_head >= to_old);
  end

  wire        asks    = valid && !is_check;
  wire        asked   = taken_q && !checks_q;
  wire [16:0] fetches = fetches_q + (asked && kind_q) + (asks && is_fetch) + queued;
  wire [16:0] packets = packets_q + (asked && !kind_q) + (asks && !is_fetch);
  wire [14:0] ahead   = to_fetch - to_next;
  wire [14:0] entry   = address[18:4] & mask;
  // What was decided a clock before can still be asked.
  wire        planned = (\u_dut.check_q || !\u_dut.plan_check_q )
                     && !(\u_dut.check_q && (\u_dut.plan_fetch_q || \u_dut.plan_data_q ))
                     && !(\u_dut.plan_fetch_q && \u_dut.plan_data_q )
                     && (!\u_dut.plan_fetch_q || \u_dut.stop_q || (to_fetch < to_limit && ahead < DESCRIPTORS))
                     && (!\u_dut.plan_data_q || queued != 0);
  wire        ordered = running
                     ? \u_dut.mask_q == mask
                       && (\u_dut.beyond_q || (\u_dut.head_q & ~mask) == 0)
                       && (to_limit <= to_head)
                       && to_next <= to_fetch && to_fetch <= to_limit
                       && ahead == \u_dut.ahead_q && ahead <= DESCRIPTORS
                       && ((tail[14:0] | \u_dut.next_q | fetch) & ~mask) == 0
                       && (!\u_dut.check_q || (\u_dut.fetch_q == 0 && !valid && !seen_q
                           && fetches == 0 && packets == 0 && !taken_q))
                       && (!valid || !is_check || !is_fetch)
                       && (\u_dut.check_q || seen_q || valid && is_check || \u_dut.stop_q )
                       && (base[18:0] & {mask, 4'hF}) == 0 && queued <= DESCRIPTORS
                       && fetches <= ahead && packets <= to_next
                       && (\u_dut.stop_q || (fetches == ahead && packets == to_next
                           && expected_q == ((fetch - (asks && is_fetch)) & mask)))
                       && (!\u_dut.stop_q || !valid) && planned
                       && (!\u_dut.over_q || (!\u_dut.check_q && !taken_q && !valid && ahead == 0
                           && fetches == 0 && packets == 0 && !\u_dut.planned ))
                     : quiet && !valid && (!\u_dut.planned || \u_dut.stop_q );
  wire        between = !(asks && is_fetch)
                     || (address == (base | {entry, 4'd0}) && entry == expected_q
                         && ((entry - tail[14:0]) & mask) < to_limit);
  wire [19:0] bytes   = 20'd16 << entries_log2;

  // Clocks in which the reader is free, entries are left and nothing is asked for.
  localparam MOST_IDLE = 2;
  reg  [2:0]  idle_q;
  wire        inside  = running && !\u_dut.stop_q && (\u_dut.check_q || to_limit != 0);
  always @(posedge clk) begin
    if (rst || started || valid || !inside || !quiet) idle_q <= 0;
    else if (ready) idle_q <= idle_q + 1'b1;
  end

  always @* if (!first_q && !rst) begin
    live: assert (looked && ordered && between && idle_q <= MOST_IDLE
                  && (idle_q == 0 || \u_dut.planned || valid || !inside)
                  && (idle_q < MOST_IDLE || valid || !inside));
    range: assert (looked && ordered && between);
    size: assert (looked && (!running || entries_log2_q != 0));
    checked: assert (looked && ordered && (!valid || (is_check ? address == base && length == bytes : seen_q)));
    head_fits: assert (looked && ordered && (!beyond_q || stopped_q || \u_dut.beyond_q )
                      && (!stopped_q || ((!running || \u_dut.stop_q ) && !valid)));
    room: assert (looked && ordered && (!fetched || \u_dut.queue_ready ));
  end
endmodule

`default_nettype wire
