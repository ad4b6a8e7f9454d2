// formal_axil_registers: locks, sticky bits and settings of ffd_axil_registers
//
// Looks at the write as the bus slave hands it on (that it is the bus's is proved of the slave),
// and at each register in the clock before and after.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_axil_registers #(
  parameter ERRORS = 28
) (
  input wire        clk,
  input wire        rst,
  input wire        awvalid,
  input wire [11:0] awaddr,
  input wire        wvalid,
  input wire [31:0] wdata,
  input wire [3:0]  wstrb,
  input wire        bready,
  input wire        arvalid,
  input wire [11:0] araddr,
  input wire        rready,
  input wire        busy,
  input wire        stopped,
  input wire        done,
  input wire [ERRORS-1:0] error,
  input wire [2:0]  count
);
  localparam [9:0] CONTROL = 10'h004;
  localparam [9:0] STATUS = 10'h005;
  localparam [9:0] RING_BASE_LO = 10'h010;
  localparam [9:0] RING_BASE_HI = 10'h011;
  localparam [9:0] RING_LOG2_SIZE = 10'h012;
  localparam [9:0] RING_HEAD = 10'h013;
  localparam [9:0] RESULT_BASE_LO = 10'h018;
  localparam [9:0] RESULT_BASE_HI = 10'h019;
  localparam [9:0] RESULT_SIZE = 10'h01a;
  localparam [9:0] WINDOWS = 10'h020;    // eight of them
  localparam [9:0] COUNTERS = 10'h030;   // low and high word of each of three
  localparam [9:0] ERROR_STATUS = 10'h040;
  localparam [9:0] ERROR_FIRST = 10'h042;
  localparam [9:0] IRQ_STATE = 10'h051;
  localparam [9:0] IRQ_TEST = 10'h052;

  wire        start;
  wire [63:0] ring_base;
  wire [3:0]  ring_log2_size;
  wire [15:0] ring_head;
  wire [63:0] result_base;
  wire [31:0] result_size;
  wire [63:0] read_base;
  wire [63:0] read_limit;
  wire [63:0] write_base;
  wire [63:0] write_limit;
  wire        lock;
  wire [2:0]  enable;
  wire        irq;

  ffd_axil_registers u_dut (
    .clk                     (clk),
    .rst                     (rst),
    .s_axil_awvalid          (awvalid),
    .s_axil_awaddr           (awaddr),
    .s_axil_awprot           (3'd0),
    .s_axil_wvalid           (wvalid),
    .s_axil_wdata            (wdata),
    .s_axil_wstrb            (wstrb),
    .s_axil_bready           (bready),
    .s_axil_arvalid          (arvalid),
    .s_axil_araddr           (araddr),
    .s_axil_arprot           (3'd0),
    .s_axil_rready           (rready),
    .config_org_i            (8'd0),
    .config_n_i              (8'd0),
    .config_format_i         (8'd0),
    .config_schedule_i       (1'b0),
    .config_evaluator_i      (2'd0),
    .limits_in_flight_i      (16'd0),
    .limits_points_axis_i    (8'd0),
    .control_start_o         (start),
    .status_busy_i           (busy),
    .status_idle_i           (1'b0),
    .status_stopped_i        (stopped),
    .status_ring_running_i   (1'b0),
    .status_done_set_i       (done),
    .ring_base_o             (ring_base),
    .ring_log2_size_o        (ring_log2_size),
    .ring_head_o             (ring_head),
    .ring_tail_i             (16'd0),
    .result_base_o           (result_base),
    .result_size_o           (result_size),
    .result_count_i          (32'd0),
    .read_window_base_o      (read_base),
    .read_window_limit_o     (read_limit),
    .write_window_base_o     (write_base),
    .write_window_limit_o    (write_limit),
    .window_lock_windows_o   (lock),
    .counter_vertices_event_i(count[0]),
    .counter_stalls_event_i  (count[1]),
    .counter_busy_event_i    (count[2]),
    .error_event_i           (error),
    .error_packet_i          (32'd0),
    .error_beat_i            (32'd0),
    .error_address_i         (64'd0),
    .error_address_valid_i   (1'b0),
    .irq_enable_done_o       (enable[0]),
    .irq_enable_error_o      (enable[1]),
    .irq_enable_refused_o    (enable[2]),
    .irq_o                   (irq)
  );

  (* hierconn *) wire        \u_dut.write ;
  (* hierconn *) wire [9:0]  \u_dut.write_word ;
  (* hierconn *) wire [31:0] \u_dut.write_data ;
  (* hierconn *) wire [31:0] \u_dut.write_mask ;
  (* hierconn *) wire        \u_dut.write_error ;
  (* hierconn *) wire        \u_dut.status_done_q ;
  (* hierconn *) wire        \u_dut.status_start_refused_q ;
  (* hierconn *) wire [ERRORS-1:0] \u_dut.error_status_q ;
  (* hierconn *) wire        \u_dut.error_first_valid_q ;
  (* hierconn *) wire        \u_dut.irq_state_done_q ;
  (* hierconn *) wire        \u_dut.irq_state_error_q ;
  (* hierconn *) wire        \u_dut.irq_state_refused_q ;

  // Counters side by side: count, high word as it was latched, and what latches it.
  (* hierconn *) wire        \u_dut.read ;
  (* hierconn *) wire [9:0]  \u_dut.read_word ;
  (* hierconn *) wire [31:0] \u_dut.read_data ;
  (* hierconn *) wire [63:0] \u_dut.u_counter_vertices.count_q ;
  (* hierconn *) wire [63:0] \u_dut.u_counter_stalls.count_q ;
  (* hierconn *) wire [63:0] \u_dut.u_counter_busy.count_q ;
  (* hierconn *) wire [31:0] \u_dut.u_counter_vertices.high_q ;
  (* hierconn *) wire [31:0] \u_dut.u_counter_stalls.high_q ;
  (* hierconn *) wire [31:0] \u_dut.u_counter_busy.high_q ;
  (* hierconn *) wire        \u_dut.u_counter_vertices.latch_i ;
  (* hierconn *) wire        \u_dut.u_counter_stalls.latch_i ;
  (* hierconn *) wire        \u_dut.u_counter_busy.latch_i ;
  wire [95:0] lows    = {\u_dut.u_counter_busy.count_q [31:0],
                         \u_dut.u_counter_stalls.count_q [31:0],
                         \u_dut.u_counter_vertices.count_q [31:0]};
  wire [95:0] highs   = {\u_dut.u_counter_busy.high_q , \u_dut.u_counter_stalls.high_q ,
                         \u_dut.u_counter_vertices.high_q };
  wire [2:0]  latches = {\u_dut.u_counter_busy.latch_i , \u_dut.u_counter_stalls.latch_i ,
                         \u_dut.u_counter_vertices.latch_i };
  reg         counters_read;
  integer     c;
  always @* begin
    counters_read = 1'b1;
    for (c = 0; c < 3; c = c + 1) begin
      if (latches[c] != (\u_dut.read && \u_dut.read_word == COUNTERS + 2 * c)) counters_read = 1'b0;
      if (\u_dut.read_word == COUNTERS + 2 * c && \u_dut.read_data != lows[32*c +: 32])
        counters_read = 1'b0;
      if (\u_dut.read_word == COUNTERS + 2 * c + 1 && \u_dut.read_data != highs[32*c +: 32])
        counters_read = 1'b0;
    end
  end

  wire        write = \u_dut.write ;
  wire [9:0]  word  = \u_dut.write_word ;
  wire [31:0] mask  = \u_dut.write_mask ;
  wire [31:0] ones  = \u_dut.write_data & mask;

  // Sticky bits side by side: as they are, what clears and what sets each of them.
  wire [2:0]  state   = {\u_dut.irq_state_refused_q , \u_dut.irq_state_error_q ,
                         \u_dut.irq_state_done_q };
  wire [ERRORS+5:0] sticky  = {state, \u_dut.error_first_valid_q , \u_dut.error_status_q ,
                         \u_dut.status_start_refused_q , \u_dut.status_done_q };
  wire [ERRORS+5:0] clears  = {write && word == IRQ_STATE ? ones[2:0] : 3'd0,
                         write && word == ERROR_FIRST && ones[31],
                         write && word == ERROR_STATUS ? ones[ERRORS-1:0] : {ERRORS {1'b0}},
                         write && word == STATUS ? ones[9:8] : 2'd0};
  wire        asked   = write && word == CONTROL && ones[0];
  wire        refused = asked && (busy || stopped || !lock || start);
  wire [2:0]  tests   = write && word == IRQ_TEST ? ones[2:0] : 3'd0;
  wire [ERRORS+5:0] sets    = {{refused, |error, done} | tests, |error, error, refused, done};

  // Settings side by side, a word each.
  wire [255:0] windows  = {write_limit, write_base, read_limit, read_base};
  wire [223:0] settings = {ring_base, {28'd0, ring_log2_size}, {16'd0, ring_head},
                           result_base, result_size};
  wire [6:0]   owners   = {word == RING_BASE_HI, word == RING_BASE_LO,
                           word == RING_LOG2_SIZE, word == RING_HEAD, word == RESULT_BASE_HI,
                           word == RESULT_BASE_LO, word == RESULT_SIZE};

  reg         first_q = 1'b1;
  reg         rst_q;
  reg         write_q;
  reg         error_q;
  reg [9:0]   word_q;
  reg [31:0]  mask_q;
  reg [6:0]   owners_q;
  reg         lock_q;
  reg [255:0] windows_q;
  reg [223:0] settings_q;
  reg [ERRORS+5:0]  sticky_q;
  reg [ERRORS+5:0]  clears_q;
  reg [ERRORS+5:0]  sets_q;
  reg [2:0]   pending_q;
  reg         asked_q;
  reg         refused_q;
  always @(posedge clk) begin
    first_q    <= 1'b0;
    rst_q      <= rst || first_q;
    write_q    <= write;
    error_q    <= \u_dut.write_error ;
    word_q     <= word;
    mask_q     <= mask;
    owners_q   <= owners;
    lock_q     <= lock;
    windows_q  <= windows;
    settings_q <= settings;
    sticky_q   <= sticky;
    clears_q   <= clears;
    sets_q     <= sets;
    pending_q  <= state & enable;
    asked_q    <= asked;
    refused_q  <= refused;
  end

  always @* if (first_q) assume (rst);

  reg [6:0] moved;       // settings that have changed, or bytes of them without a strobe
  reg [6:0] strayed;
  integer i;
  always @* begin
    for (i = 0; i < 7; i = i + 1) begin
      moved[i]   = settings[32*i +: 32] != settings_q[32*i +: 32];
      strayed[i] = |((settings[32*i +: 32] ^ settings_q[32*i +: 32]) & ~mask_q);
    end
  end

  always @* if (!first_q && !rst_q) begin
    lock_stays: assert (!lock_q || lock);
    locked: assert (!lock_q || windows == windows_q);
    refused_write: assert (!(write_q && error_q)
                           || (settings == settings_q && windows == windows_q));
    owner: assert ((moved & ~(owners_q & {7 {write_q}})) == 0
                   && (windows == windows_q || (write_q && (word_q >> 3) == (WINDOWS >> 3))));
    strobes: assert (strayed == 0);
    w1c_kept: assert ((sticky_q & ~sticky & ~clears_q) == 0);
    w1c_cleared: assert ((sticky & clears_q & ~sets_q) == 0);
    w1c_set: assert ((sets_q & ~sticky) == 0);
    start_asked: assert (start == (asked_q && !refused_q) && (!refused_q || sticky[1]));
    interrupt: assert (irq == (pending_q != 0));
  end
  always @* if (!first_q) begin
    locked_error: assert (!(write && lock && (word >> 3) == (WINDOWS >> 3)) || \u_dut.write_error );
  end
  // From the first clock on, in which counters may hold any count.
  always @* counters: assert (counters_read);
endmodule

`default_nettype wire
