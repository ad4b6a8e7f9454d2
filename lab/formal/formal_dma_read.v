// formal_dma_read: ffd_dma_read at its bus, with any requests, any window, and any memory that
// answers what was asked
//
// The memory answers bursts in order with as many beats as were asked, at any time, with any
// response. The window is any pair of addresses, held from reset on. A soft reset lasts until rst, as
// the engine has it.
//
// `outstanding`, `room` and `live` are inductive: each says besides how the module's registers and a list of open
// bursts that is kept here belong together.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_dma_read #(
  parameter MAX_BURST   = 2,
  parameter FIFO_DEPTH  = 4,
  parameter OUTSTANDING = 2
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
  input wire         s_check,
  input wire         arready,
  input wire         want_answer,
  input wire [127:0] rdata,
  input wire [1:0]   rresp,
  input wire         m_ready,
  input wire         follow
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
  wire        fetched;
  wire        finished;
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
    .s_request_check  (s_check),
    .s_request_mark   (1'b0),
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
    .fetched_o        (fetched),
    .finished_o       (finished),
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
    assume (!s_fetch || s_length == 16);
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

  // ---- no address after an error, except one that waits already
  reg        failed_q;
  reg        raised_q;
  always @(posedge clk) begin
    failed_q <= !rst && (fault || (failed_q && !start));
    raised_q <= arvalid && !arready;
  end

  // ---- what the address generator holds; once in BURST: first <= next <= last <= window's last
  localparam BURST_W = $clog2(MAX_BURST);
  (* hierconn *) wire [59:0] \u_dut.u_address.next_q ;
  (* hierconn *) wire [59:0] \u_dut.u_address.last_q ;
  (* hierconn *) wire [27:0] \u_dut.u_address.more_q ;
  (* hierconn *) wire        \u_dut.u_address.misaligned_q ;
  (* hierconn *) wire        \u_dut.u_address.none_q ;
  (* hierconn *) wire        \u_dut.u_address.wraps_q ;
  (* hierconn *) wire        \u_dut.u_address.below_q ;
  (* hierconn *) wire        \u_dut.u_address.above_q ;
  (* hierconn *) wire        \u_dut.u_address.same_q ;
  (* hierconn *) wire [BURST_W-1:0] \u_dut.u_address.left_q ;
  (* hierconn *) wire [BURST_W-1:0] \u_dut.u_address.offer_q ;
  (* hierconn *) wire [2:0]  \u_dut.u_address.state_q ;
  wire        holds;
  wire        ar_fits;
  wire        ar_page;
  properties_burst #(
    .MAX_BURST(MAX_BURST)
  ) burst (
    .state_i       (\u_dut.u_address.state_q ),
    .next_i        (\u_dut.u_address.next_q ),
    .last_i        (\u_dut.u_address.last_q ),
    .more_i        (\u_dut.u_address.more_q ),
    .misaligned_i  (\u_dut.u_address.misaligned_q ),
    .none_i        (\u_dut.u_address.none_q ),
    .wraps_i       (\u_dut.u_address.wraps_q ),
    .below_i       (\u_dut.u_address.below_q ),
    .above_i       (\u_dut.u_address.above_q ),
    .same_i        (\u_dut.u_address.same_q ),
    .left_i        (\u_dut.u_address.left_q ),
    .offer_i       (\u_dut.u_address.offer_q ),
    .window_first_i(window_first),
    .window_last_i (window_last),
    .address_i     (araddr),
    .len_i         (arlen),
    .holds_o       (holds),
    .inside_o      (ar_fits),
    .page_o        (ar_page)
  );

  // ---- open bursts, the oldest first: those of the memory, then the one on the address channel
  localparam PLACE_W = $clog2(OUTSTANDING);
  localparam LEVEL_W = $clog2(FIFO_DEPTH);
  localparam ROOM_W  = LEVEL_W + 1;
  (* hierconn *) wire               \u_dut.burst_valid ;
  (* hierconn *) wire               \u_dut.burst_ready ;
  (* hierconn *) wire [BURST_W-1:0] \u_dut.burst_len ;
  (* hierconn *) wire               \u_dut.burst_last ;
  (* hierconn *) wire               \u_dut.fetch_q ;
  (* hierconn *) wire               \u_dut.end_q ;
  (* hierconn *) wire               \u_dut.stop_q ;
  (* hierconn *) wire [61:0]        \u_dut.u_outstanding.u_memory.gen_slice[0].memory_q[0] ;
  (* hierconn *) wire [61:0]        \u_dut.u_outstanding.u_memory.gen_slice[0].memory_q[1] ;
  (* hierconn *) wire [PLACE_W:0]   \u_dut.u_outstanding.write_q ;
  (* hierconn *) wire [PLACE_W:0]   \u_dut.u_outstanding.read_q ;
  (* hierconn *) wire [LEVEL_W:0]   \u_dut.u_fifo.gen_block.u_fifo.write_q ;
  (* hierconn *) wire [LEVEL_W:0]   \u_dut.u_fifo.gen_block.u_fifo.read_q ;
  (* hierconn *) wire               \u_dut.u_fifo.stored_valid ;
  (* hierconn *) wire               \u_dut.good_q ;
  (* hierconn *) wire               \u_dut.bad_q ;
  (* hierconn *) wire               \u_dut.fetched_q ;
  (* hierconn *) wire [ROOM_W-1:0]  \u_dut.room_q ;
  (* hierconn *) wire               \u_dut.left_q ;
  (* hierconn *) wire               \u_dut.taken_q ;
  (* hierconn *) wire               \u_dut.dropped_q ;
  (* hierconn *) wire               \u_dut.held_q ;
  (* hierconn *) wire               \u_dut.release_held ;
  reg  [MOST-1:0]  fetch_q;
  reg  [MOST-1:0]  last_q;
  wire             step   = \u_dut.burst_valid && \u_dut.burst_ready ;
  wire [2:0]       total  = count_q + arvalid;
  wire [2:0]       behind = total - done;
  wire [PLACE_W:0] open   = \u_dut.u_outstanding.write_q - \u_dut.u_outstanding.read_q ;
  wire [LEVEL_W:0] level  = \u_dut.u_fifo.gen_block.u_fifo.write_q - \u_dut.u_fifo.gen_block.u_fifo.read_q ;
  wire             stored = \u_dut.u_fifo.stored_valid ;
  wire             came   = \u_dut.good_q || \u_dut.bad_q ;
  wire             data   = came && !\u_dut.fetched_q ;
  always @(posedge clk) begin
    fetch_q <= done ? fetch_q >> 1 : fetch_q;
    last_q  <= done ? last_q >> 1 : last_q;
    if (step && behind < MOST) begin
      fetch_q[behind[1:0]] <= \u_dut.fetch_q ;
      last_q[behind[1:0]]  <= \u_dut.burst_last ;
    end
  end

  // ---- one request, chosen freely, is followed until it is answered
  wire        stalled = (arvalid && !arready) || (count_q != 0 && !want_answer)
                     || (m_valid && !m_ready) || hold;
  reg         follow_q;
  reg         inside_q;     // in the address generator
  reg         due_q;        // its last beat was taken in the clock before
  reg         answer_due_q; // two clocks before
  reg         is_fetch_q;
  reg  [1:0]  place_q;      // of its last burst
  reg  [27:0] left_q;       // beats that are in no burst yet
  reg  [33:0] budget_q;     // clocks that are left
  wire        accept = s_valid && s_ready && follow && !follow_q && !s_check;
  always @(posedge clk) begin
    due_q        <= 1'b0;
    answer_due_q <= due_q && follow_q && !rst && !soft && !fault;
    if (rst || soft || fault) follow_q <= 1'b0;
    else if (accept) follow_q <= 1'b1;
    else if (refused && inside_q) follow_q <= 1'b0;
    else if (answer_due_q && (is_fetch_q ? fetched : finished)) follow_q <= 1'b0;
    if (accept) begin
      inside_q   <= 1'b1;
      is_fetch_q <= s_fetch;
      left_q     <= s_length[31:4];
    end else if (inside_q && step) begin
      inside_q <= !\u_dut.burst_last ;
      left_q   <= left_q - \u_dut.burst_len - 1'b1;
      place_q  <= behind[1:0];
    end else if (!inside_q && done) begin
      due_q    <= follow_q && !due_q && !answer_due_q && place_q == 0;
      place_q  <= place_q - 1'b1;
    end
    if (accept) budget_q <= {s_length[31:4], 4'd0} + 3 + busy;
    else if (!stalled) budget_q <= budget_q - 1'b1;
  end

  // ---- what the registers say: beats that are promised, that come, that come up to the followed
  integer    i;
  reg        whole;
  reg [11:0] promised;
  reg [11:0] coming;
  reg [11:0] before;
  reg [7:0]  len;
  reg [1:0]  entry;
  always @* begin
    entry    = 0;
    len      = 0;
    whole    = open == total && count_q <= OUTSTANDING && total <= OUTSTANDING
            && (count_q == 0 ? beat_q == 0 : beat_q <= lens_q[7:0]);
    promised = 0;
    coming   = 0;
    before   = 0;
    for (i = 0; i < MOST; i = i + 1) begin
      len = i == count_q ? arlen : lens_q[8*i +: 8];
      if (i < total) begin
        entry    = i[0] ^ \u_dut.u_outstanding.read_q [0]
                 ? \u_dut.u_outstanding.u_memory.gen_slice[0].memory_q[1] [61:60]
                 : \u_dut.u_outstanding.u_memory.gen_slice[0].memory_q[0] [61:60];
        whole    = whole && len < MAX_BURST && entry == {last_q[i], fetch_q[i]};
        coming   = coming + len + 1'b1;
        promised = promised + (fetch_q[i] ? 0 : len + 1'b1);
        before   = before + (i <= place_q ? len + 1'b1 : 0);
      end
    end
    coming   = coming - beat_q;
    before   = before - beat_q;
    promised = promised - (fetch_q[0] ? 0 : beat_q);
  end
  wire [11:0] given  = \u_dut.room_q + level + stored + m_valid + \u_dut.held_q + data
                     + \u_dut.left_q + \u_dut.dropped_q + promised
                     - (\u_dut.taken_q ? arlen + 12'd1 : 12'd0);
  // The clocks that are left to all that is inside: what a step makes of a beat weighs one less.
  wire [11:0] busy   = 7 * coming + arvalid + 6 * came + 5 * \u_dut.held_q + 4 * level + 3 * stored
                     + 2 * m_valid + \u_dut.left_q + \u_dut.dropped_q ;
  wire        credit = whole && level <= FIFO_DEPTH && !(\u_dut.good_q && \u_dut.bad_q )
                    && given <= FIFO_DEPTH && (soft_q || given == FIFO_DEPTH)
                    && !(\u_dut.taken_q && (\u_dut.dropped_q
                        || (\u_dut.u_address.state_q != 0 && \u_dut.u_address.state_q != 5
                            && !\u_dut.stop_q && !soft_q)))
                    && (!\u_dut.taken_q || \u_dut.room_q > arlen)
                    && (rready || (total == 0 && \u_dut.u_address.state_q == 0));

  // The followed one in the generator, on its way, or answered in this clock; and the clocks it
  // may still take, which every clock without a stall makes fewer.
  (* hierconn *) wire \u_dut.u_address.check_q ;
  wire       reaches = {\u_dut.u_address.wraps_q , \u_dut.u_address.last_q }
                    == {1'b0, \u_dut.u_address.next_q } + left_q - 61'd1;
  reg        known;
  reg [33:0] rank;
  always @* begin
    rank = 0;
    if (inside_q) begin
      known = \u_dut.fetch_q == is_fetch_q && !due_q && !answer_due_q;
      case (\u_dut.u_address.state_q )
        3'd0: known = known && refused;
        3'd1: known = known && !refused
                   && {\u_dut.u_address.none_q , \u_dut.u_address.more_q } == left_q - 29'd1;
        3'd2, 3'd3: known = known && !refused && (\u_dut.u_address.misaligned_q
                         || (\u_dut.u_address.none_q ? left_q == 0 : left_q != 0 && reaches));
        3'd4: known = known && !refused && left_q != 0 && reaches;
        default: known = known && !refused && left_q != 0 && \u_dut.u_address.state_q == 3'd5
                      && {1'b0, \u_dut.u_address.last_q } == {1'b0, \u_dut.u_address.next_q }
                         + \u_dut.u_address.more_q + left_q;
      endcase
      known = known && !\u_dut.u_address.check_q ;
      if (\u_dut.u_address.state_q != 0)
        rank = {left_q, 4'd0} + busy + (\u_dut.u_address.state_q == 3'd5 ? 3'd3
                                        : 3'd4 - \u_dut.u_address.state_q );
    end else if (answer_due_q) begin
      known = !due_q && (is_fetch_q ? fetched : finished);
      rank  = 1;
    end else if (due_q) begin
      known = \u_dut.good_q ? \u_dut.fetched_q == is_fetch_q && (is_fetch_q || \u_dut.end_q )
                            : \u_dut.bad_q ;
      rank  = 2;
    end else begin
      known = place_q < total && last_q[place_q] && fetch_q[place_q] == is_fetch_q;
      rank  = before + (arvalid && place_q == count_q) + 2'd2;
    end
    known = known && !\u_dut.stop_q && !soft_q;
  end
  localparam MOST_BUSY = 6 * FIFO_DEPTH + 7 * OUTSTANDING * MAX_BURST + 7;

  always @* if (!first_q && !rst) begin
    window: assert ((!arvalid || (ar_fits && ar_page && arlen < MAX_BURST && araddr[3:0] == 0))
                    && holds);
    stable: assert (!wait_q || (arvalid && araddr == wait_address_q && arlen == wait_len_q));
    outstanding: assert (credit && count_q + arvalid <= OUTSTANDING);
    room: assert (credit && (!\u_dut.release_held || level < FIFO_DEPTH));
    answered: assert (!rvalid || rready);
    silent: assert (!failed_q || !arvalid || raised_q);
    quiet_means: assert (!quiet || (count_q == 0 && !arvalid));
    live: assert (holds && credit && busy <= MOST_BUSY && (!follow_q || (known && rank <= budget_q)));
  end
endmodule

`default_nettype wire
