// formal_dma_write: ffd_dma_write at its bus, with any area, any window, any results, and any memory
// that answers what was written
//
// The memory answers a burst after its address and its last beat, at any time, with any response.
// The window is any pair of addresses, held from reset on. A soft reset lasts until rst, as the
// engine has it.
//
// `beats` is inductive: it says besides where in the module the lengths and the beats of the bursts
// are whose addresses were seen on the bus. `live` is, too: how many clocks can still pass gets less.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_dma_write #(
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
  input wire [63:0]  base,
  input wire [31:0]  size,
  input wire         s_valid,
  input wire [127:0] s_data,
  input wire         s_last,
  input wire         awready,
  input wire         wready,
  input wire         want_answer,
  input wire [1:0]   bresp
);
  localparam FLUSH_CLOCKS = 2;
  wire         s_ready;
  wire         awvalid;
  wire [63:0]  awaddr;
  wire [7:0]   awlen;
  wire         wvalid;
  wire [127:0] wdata;
  wire         wlast;
  wire         bvalid;
  wire         bready;
  wire         fault;
  wire         running;
  wire         empty;
  wire         busy;

  ffd_dma_write #(
    .MAX_BURST   (MAX_BURST),
    .FIFO_DEPTH  (FIFO_DEPTH),
    .OUTSTANDING (OUTSTANDING),
    .FLUSH_CLOCKS(FLUSH_CLOCKS)
  ) u_dut (
    .clk           (clk),
    .rst           (rst),
    .start_i       (start),
    .soft_i        (soft),
    .hold_i        (hold),
    .window_first_i(window_first),
    .window_last_i (window_last),
    .base_i        (base),
    .size_i        (size),
    .s_result_valid(s_valid),
    .s_result_ready(s_ready),
    .s_result_data (s_data),
    .s_result_last (s_last),
    .m_axi_awvalid (awvalid),
    .m_axi_awready (awready),
    .m_axi_awaddr  (awaddr),
    .m_axi_awlen   (awlen),
    .m_axi_wvalid  (wvalid),
    .m_axi_wready  (wready),
    .m_axi_wdata   (wdata),
    .m_axi_wlast   (wlast),
    .m_axi_bvalid  (bvalid),
    .m_axi_bready  (bready),
    .m_axi_bresp   (bresp),
    .running_o     (running),
    .empty_o       (empty),
    .busy_o        (busy),
    .fault_o       (fault)
  );

  reg         first_q = 1'b1;
  reg         soft_q = 1'b0;
  reg [63:0]  window_first_q;
  reg [63:0]  window_last_q;
  reg         wait_q;
  reg [63:0]  wait_address_q;
  reg [7:0]   wait_len_q;
  reg         wait_data_q;
  reg [128:0] data_q;
  reg [3:0]   open_q;        // addresses taken and not answered
  reg [3:0]   written_q;     // bursts whose last beat was taken and that are not answered
  reg         failed_q;
  wire        asked  = awvalid && awready;
  wire        ended  = wvalid && wready && wlast;
  wire        answer = bvalid && bready;
  assign bvalid = want_answer && open_q != 0 && written_q != 0;
  always @(posedge clk) begin
    first_q        <= 1'b0;
    soft_q         <= soft && !rst;
    window_first_q <= window_first;
    window_last_q  <= window_last;
    wait_q         <= awvalid && !awready && !rst;
    wait_address_q <= awaddr;
    wait_len_q     <= awlen;
    wait_data_q    <= wvalid && !wready && !rst;
    data_q         <= {wlast, wdata};
    failed_q       <= !rst && (fault || (failed_q && busy));
    if (rst) begin
      open_q    <= 0;
      written_q <= 0;
    end else begin
      open_q    <= open_q + asked - answer;
      written_q <= written_q + ended - answer;
    end
  end
  always @* begin
    if (first_q) assume (rst);
    else assume (window_first == window_first_q && window_last == window_last_q);
    if (soft_q) assume (soft || rst);
  end

  localparam BURST_W      = $clog2(MAX_BURST);
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
  wire        aw_fits;
  wire        aw_page;
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
    .address_i     (awaddr),
    .len_i         (awlen),
    .holds_o       (holds),
    .inside_o      (aw_fits),
    .page_o        (aw_page)
  );

  // The length of the burst that may go is that of what is offered, or less.
  (* hierconn *) wire       \u_dut.go_q ;
  (* hierconn *) wire       \u_dut.limited_q ;
  (* hierconn *) wire [BURST_W-1:0] \u_dut.limit_q ;
  wire        measured = !\u_dut.go_q || \u_dut.u_address.state_q != 3'd4 || !\u_dut.limited_q
                      || \u_dut.limit_q < \u_dut.u_address.offer_q ;

  // ---- bursts whose data has not left, the oldest first, each from the clock its address is raised
  localparam MOST    = 4;
  localparam PLACE_W = $clog2(OUTSTANDING);
  (* hierconn *) wire             \u_dut.active_q ;
  (* hierconn *) wire [BURST_W-1:0] \u_dut.left_q ;
  (* hierconn *) wire [PLACE_W:0] \u_dut.u_outstanding.write_q ;
  (* hierconn *) wire [PLACE_W:0] \u_dut.u_outstanding.read_q ;
  (* hierconn *) wire [PLACE_W:0] \u_dut.u_lengths.write_q ;
  (* hierconn *) wire [PLACE_W:0] \u_dut.u_lengths.read_q ;
  (* hierconn *) wire [BURST_W-1:0] \u_dut.u_lengths.u_memory.gen_slice[0].memory_q[0] ;
  (* hierconn *) wire [BURST_W-1:0] \u_dut.u_lengths.u_memory.gen_slice[0].memory_q[1] ;
  reg  [2:0]          count_q;
  reg  [8*MOST-1:0]   lens_q;
  reg  [7:0]          beat_q;
  wire                raise   = awvalid && !wait_q;
  wire [2:0]          total   = count_q + raise;
  wire [PLACE_W:0]    open    = \u_dut.u_outstanding.write_q - \u_dut.u_outstanding.read_q ;
  wire [PLACE_W:0]    lengths = \u_dut.u_lengths.write_q - \u_dut.u_lengths.read_q ;
  wire [8*MOST+7:0]   lens;       // and that of the address that is raised in this clock
  genvar g;
  generate
    for (g = 0; g <= MOST; g = g + 1) begin : gen_lens
      if (g == MOST) assign lens[8*g +: 8] = awlen;
      else assign lens[8*g +: 8] = raise && count_q == g ? awlen : lens_q[8*g +: 8];
    end
  endgenerate
  always @(posedge clk) begin
    if (rst) begin
      count_q <= 0;
      beat_q  <= 0;
    end else begin
      count_q <= total - ended;
      if (wvalid && wready) beat_q <= wlast ? 0 : beat_q + 1'b1;
    end
    lens_q <= ended ? lens[8*MOST-1:0] >> 8 : lens[8*MOST-1:0];
  end

  // Through the module from the bus back: the beat there, the burst under way, the lengths.
  integer   i;
  reg       ordered;
  reg [2:0] at;
  reg [7:0] beat;
  always @* begin
    at      = 0;
    beat    = beat_q;
    ordered = count_q <= OUTSTANDING && open_q <= OUTSTANDING && written_q <= OUTSTANDING
           && open <= OUTSTANDING && open == open_q + awvalid && open == total + written_q
           && (!wait_q || awvalid)
           && (!\u_dut.go_q || (!awvalid && open < OUTSTANDING && lengths < OUTSTANDING));
    if (wvalid) begin
      ordered = ordered && count_q != 0 && wlast == (beat == lens[7:0]);
      at      = wlast;
      beat    = wlast ? 0 : beat + 1'b1;
    end
    if (\u_dut.active_q ) begin
      ordered = ordered && at < count_q && \u_dut.left_q == lens[8*at +: 8] - beat;
      at      = at + 1'b1;
    end else ordered = ordered && beat == 0;
    ordered = ordered && at <= count_q && lengths == total - at;
    for (i = 0; i < 2; i = i + 1)
      if (i < lengths)
        ordered = ordered && lens[8*(at+i) +: 8] == (i[0] ^ \u_dut.u_lengths.read_q [0]
                  ? \u_dut.u_lengths.u_memory.gen_slice[0].memory_q[1] : \u_dut.u_lengths.u_memory.gen_slice[0].memory_q[0] );
  end

  // ---- clocks in a row in which nothing outside keeps what is inside from moving, and nothing moves
  localparam MOST_IDLE = FLUSH_CLOCKS + 13;
  localparam FIFO_W    = $clog2(FIFO_DEPTH);
  localparam [2:0] IDLE = 3'd0;
  localparam [2:0] SUM  = 3'd1;
  localparam [2:0] BURST = 3'd4;
  localparam [2:0] NEXT = 3'd5;
  (* hierconn *) wire            \u_dut.drop ;
  (* hierconn *) wire            \u_dut.asking_q ;
  (* hierconn *) wire            \u_dut.stop_q ;
  (* hierconn *) wire            \u_dut.full_q ;
  (* hierconn *) wire            \u_dut.past_q ;
  (* hierconn *) wire            \u_dut.flush_q ;
  (* hierconn *) wire            \u_dut.some_q ;
  (* hierconn *) wire            \u_dut.quiet_q ;
  (* hierconn *) wire            \u_dut.late_q ;
  (* hierconn *) wire [FIFO_W:0] \u_dut.pending_q ;
  (* hierconn *) wire [FIFO_W:0] \u_dut.behind_q ;
  (* hierconn *) wire            \u_dut.fifo_valid ;
  (* hierconn *) wire            \u_dut.fifo_ready ;
  (* hierconn *) wire            \u_dut.u_address.refused_o ;
  (* hierconn *) wire [FIFO_W:0] \u_dut.u_fifo.write_q ;
  (* hierconn *) wire [FIFO_W:0] \u_dut.u_fifo.read_q ;
  wire [2:0]      state  = \u_dut.u_address.state_q ;
  wire            active = \u_dut.active_q ;
  wire [FIFO_W:0] pending = \u_dut.pending_q ;
  wire [FIFO_W:0] level  = \u_dut.u_fifo.write_q - \u_dut.u_fifo.read_q ;
  reg  [4:0]      idle_q;
  wire        inside  = !empty || count_q != 0;
  wire        outside = start || soft || hold || (awvalid && !awready) || (wvalid && !wready)
                     || open_q == OUTSTANDING || !running || \u_dut.stop_q ;
  wire        moves   = (wvalid && wready) || \u_dut.drop || (s_valid && s_ready) || fault;
  always @(posedge clk) idle_q <= rst || !inside || outside || moves ? 0 : idle_q + 1'b1;

  // How many such clocks can still come: to the burst that is offered, to the flush, to the beat.
  wire [2:0] to_burst = state == BURST ? 0 : state == NEXT ? 3 : state != IDLE ? 3'd4 - state
                      : \u_dut.u_address.refused_o ? 0 : \u_dut.asking_q ? 4 : 5;
  wire [2:0] to_flush = \u_dut.flush_q ? 0 : 3'd1 + (\u_dut.late_q ? 0 : FLUSH_CLOCKS - \u_dut.quiet_q );
  wire [3:0] to_go    = to_burst + to_flush + !\u_dut.some_q + awvalid;
  wire [4:0] left     = wvalid ? 0
                      : active ? 1
                      : lengths != 0 ? 3
                      : \u_dut.full_q ? !(\u_dut.past_q && \u_dut.fifo_valid )
                      : \u_dut.go_q && state == BURST ? 4 : 5 + to_go;

  // What is in the FIFO is what waits, what of a burst has not moved, and what bursts will take; in a
  // soft reset also what nobody counts.
  integer    k;
  reg  [9:0] owed;
  always @* begin
    owed = pending + (active ? \u_dut.left_q + 1 : 0);
    for (k = 0; k < 2; k = k + 1)
      if (k < lengths)
        owed = owed + 1 + (k[0] ^ \u_dut.u_lengths.read_q [0]
                           ? \u_dut.u_lengths.u_memory.gen_slice[0].memory_q[1]
                           : \u_dut.u_lengths.u_memory.gen_slice[0].memory_q[0] );
  end
  wire [8:0] wanted = 9'd1 + (\u_dut.limited_q ? \u_dut.limit_q
                                               : \u_dut.u_address.offer_q );
  wire       stored = level <= FIFO_DEPTH && (!\u_dut.fifo_ready || level < FIFO_DEPTH)
                   && owed <= level + \u_dut.fifo_valid
                   && (soft_q || owed == level + \u_dut.fifo_valid )
                   && (\u_dut.fifo_valid || (!active && lengths == 0 && !\u_dut.go_q ))
                   && (state != BURST || !\u_dut.some_q || \u_dut.fifo_valid )
                   && (!\u_dut.past_q || (\u_dut.full_q && !active && lengths == 0))
                   && (!\u_dut.full_q || (state == IDLE && !\u_dut.asking_q ))
                   && (!\u_dut.asking_q || (state == IDLE && !\u_dut.u_address.refused_o ))
                   && (state != IDLE || \u_dut.asking_q || \u_dut.full_q || \u_dut.stop_q
                       || !running || soft_q || \u_dut.u_address.refused_o )
                   && (state != BURST || !\u_dut.some_q || pending > \u_dut.behind_q )
                   && (state != BURST || !\u_dut.go_q || pending >= wanted);

  always @* if (!first_q && !rst) begin
    live: assert (ordered && measured && stored && idle_q <= MOST_IDLE
                  && (!inside || outside || moves || idle_q + left <= MOST_IDLE));
    window: assert ((!awvalid || (aw_fits && aw_page && awlen < MAX_BURST && awaddr[3:0] == 0))
                    && holds && measured);
    stable: assert (!wait_q || (awvalid && awaddr == wait_address_q && awlen == wait_len_q));
    data_stable: assert (!wait_data_q || (wvalid && {wlast, wdata} == data_q));
    beats: assert (ordered && (!wvalid || (count_q != 0 && wlast == (beat_q == lens[7:0]))));
    outstanding: assert (open_q + awvalid <= OUTSTANDING);
    answered: assert (!bvalid || bready);
    silent: assert (!failed_q || !awvalid || wait_q);
    busy_means: assert (busy || (open_q == 0 && !awvalid));
  end
endmodule

`default_nettype wire
