// formal_dma_ring: ffd_dma_ring with any ring, any window, any driver that adds entries, and any
// reader that answers what was asked
//
// The reader takes one request at a time and refuses it or lets it in; a fetch comes back as
// fetched_i, a packet as finished_i, at any time, or not at all after an error. The ring and the
// window are held while it runs, and the head never goes back or round past the tail.
//
// `range` and `room` are inductive: tail <= next <= fetch <= head round the ring, and what lies
// between them is with the reader, on the way to it or in the queue.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_dma_ring #(
  parameter DESCRIPTORS = 2
) (
  input wire         clk,
  input wire         rst,
  input wire         start,
  input wire [63:0]  window_first,
  input wire [63:0]  window_last,
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
  wire        is_fetch;

  reg         taken_q;     // a request that is neither refused nor let in
  reg         kind_q;
  reg  [15:0] fetches_q;
  reg  [15:0] packets_q;
  wire        ready    = want_ready && !taken_q;
  wire        take     = valid && ready;
  wire        refused  = taken_q && want_refused;
  wire        enter    = taken_q && want_in && !want_refused;
  wire        fetched  = want_fetched && fetches_q != 0;
  wire        finished = want_finished && packets_q != 0;
  wire        quiet    = fetches_q == 0 && packets_q == 0 && !taken_q;

  ffd_dma_ring #(
    .DESCRIPTORS(DESCRIPTORS)
  ) u_dut (
    .clk              (clk),
    .rst              (rst),
    .start_i          (start),
    .window_first_i   (window_first),
    .window_last_i    (window_last),
    .base_i           (base),
    .entries_log2_i   (entries_log2),
    .head_i           (head),
    .tail_o           (tail),
    .running_o        (running),
    .m_request_valid  (valid),
    .m_request_ready  (ready),
    .m_request_address(address),
    .m_request_fetch  (is_fetch),
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
  (* hierconn *) wire [14:0] \u_dut.fetch_q ;
  (* hierconn *) wire [14:0] \u_dut.next_q ;
  (* hierconn *) wire        \u_dut.queue_ready ;
  (* hierconn *) wire [$clog2(DESCRIPTORS):0] \u_dut.u_queue.write_q ;
  (* hierconn *) wire [$clog2(DESCRIPTORS):0] \u_dut.u_queue.read_q ;
  wire [$clog2(DESCRIPTORS):0] queued = \u_dut.u_queue.write_q - \u_dut.u_queue.read_q ;

  wire        beyond = (head >> entries_log2) != 0;
  reg         beyond_q;        // seen since the last start
  wire        gone = \u_dut.stop_q && forget;    // the reader drops what is left after an error
  reg         first_q = 1'b1;
  reg  [63:0] base_q;
  reg  [3:0]  entries_log2_q;
  reg  [14:0] head_q;
  reg  [14:0] expected_q;      // the entry that is to be fetched next
  wire [14:0] mask     = ~(15'h7FFF << entries_log2);
  wire [14:0] to_next  = (\u_dut.next_q - tail[14:0]) & mask;
  wire [14:0] to_fetch = (\u_dut.fetch_q - tail[14:0]) & mask;
  wire [14:0] to_head  = (head[14:0] - tail[14:0]) & mask;
  wire [14:0] to_old   = (head_q - tail[14:0]) & mask;
  always @(posedge clk) begin
    first_q        <= 1'b0;
    base_q         <= base;
    entries_log2_q <= entries_log2;
    head_q         <= head[14:0];
    beyond_q       <= !rst && !started && (beyond_q || (running && beyond));
    if (rst) begin
      taken_q   <= 1'b0;
      fetches_q <= 0;
      packets_q <= 0;
    end else begin
      taken_q   <= take || (taken_q && !refused && !enter && !gone);
      fetches_q <= gone ? 0 : fetches_q + (enter && kind_q) - fetched;
      packets_q <= gone ? 0 : packets_q + (enter && !kind_q) - finished;
    end
    if (take) kind_q <= is_fetch;
    if (started) expected_q <= tail[14:0] & mask;
    else if (take && is_fetch) expected_q <= (expected_q + 1'b1) & mask;
  end
  always @* begin
    if (first_q) assume (rst);
    else if (running) assume (base == base_q && entries_log2 == entries_log2_q
                              && to_head >= to_old);
  end

  wire [16:0] fetches = fetches_q + (taken_q && kind_q) + (valid && is_fetch) + queued;
  wire [16:0] packets = packets_q + (taken_q && !kind_q) + (valid && !is_fetch);
  wire [14:0] ahead   = to_fetch - to_next;
  wire [14:0] entry   = address[18:4] & mask;
  wire        ordered = running
                     ? to_next <= to_fetch && to_fetch <= to_head && ahead <= DESCRIPTORS
                       && ((tail[14:0] | \u_dut.next_q | \u_dut.fetch_q ) & ~mask) == 0
                       && (base[18:0] & {mask, 4'hF}) == 0 && queued <= DESCRIPTORS
                       && fetches <= ahead && packets <= to_next
                       && (\u_dut.stop_q || (fetches == ahead && packets == to_next
                           && expected_q == ((\u_dut.fetch_q - (valid && is_fetch)) & mask)))
                       && (!\u_dut.stop_q || !valid)
                     : quiet && !valid;
  wire        between = !(valid && is_fetch)
                     || (address == (base | {entry, 4'd0}) && entry == expected_q
                         && ((entry - tail[14:0]) & mask) < to_head);

  always @* if (!first_q && !rst) begin
    range: assert (ordered && between);
    size: assert (!running || entries_log2_q != 0);
    head_fits: assert (!beyond_q || ((!running || \u_dut.stop_q ) && !valid));
    room: assert (ordered && (!fetched || \u_dut.queue_ready ));
  end
endmodule

`default_nettype wire
