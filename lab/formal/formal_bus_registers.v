// formal_bus_registers: locks, sticky bits and settings of ffd_bus_registers
//
// Writes and reads come as any bus hands them on (that they are the bus's is proved of each), with
// the word a clock before the valid, and not while the block clears its memory. Looks at each
// register in the clock before and after.
// registers_at_rest.vh, connections of what is only read, is made by proofs.py.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_events.vh"

module formal_bus_registers #(
  parameter ERRORS = `FFD_ERRORS
) (
  input wire        clk,
  input wire        rst,
  input wire        write,
  input wire [9:0]  word,
  input wire [31:0] data,
  input wire [3:0]  strobe,
  input wire        read,
  input wire [9:0]  read_word,
  input wire        busy,
  input wire        stopped,
  input wire        done,
  input wire [ERRORS-1:0] error,
  input wire        packet,
  input wire        descriptor,
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
  wire [4:0]  enable;
  wire        irq;
  wire        clearing;
  wire        write_error;
  wire [31:0] read_data;

  ffd_bus_registers u_dut (
    .clk                     (clk),
    .rst                     (rst),
    .s_clearing              (clearing),
    .s_write_valid           (write),
    .s_write_word            (word),
    .s_write_data            (data),
    .s_write_strobe          (strobe),
    .s_write_error           (write_error),
    .s_read_valid            (read),
    .s_read_word             (read_word),
    .s_read_data             (read_data),
    `include "registers_at_rest.vh"
    .control_start_o         (start),
    .status_busy_i           (busy),
    .status_idle_i           (1'b0),
    .status_stopped_i        (stopped),
    .status_ring_running_i   (1'b0),
    .status_done_set_i       (done),
    .ring_base_o             (ring_base),
    .ring_log2_size_o        (ring_log2_size),
    .ring_head_o             (ring_head),
    .result_base_o           (result_base),
    .result_size_o           (result_size),
    .read_window_base_o      (read_base),
    .read_window_limit_o     (read_limit),
    .write_window_base_o     (write_base),
    .write_window_limit_o    (write_limit),
    .window_lock_windows_o   (lock),
    .counter_vertices_event_i(count[0]),
    .counter_stalls_event_i  (count[1]),
    .counter_busy_event_i    (count[2]),
    .counter_vertices_second_i(1'b0),
    .counter_stalls_second_i (1'b0),
    .counter_busy_second_i   (1'b0),
    .error_any_i             (error != 0),
    .error_event_i           (error),
    .error_packet_i          (32'd0),
    .error_beat_i            (32'd0),
    .error_address_i         (64'd0),
    .error_address_valid_i   (1'b0),
    .irq_enable_done_o       (enable[0]),
    .irq_enable_error_o      (enable[1]),
    .irq_enable_refused_o    (enable[2]),
    .irq_enable_packet_o     (enable[3]),
    .irq_enable_descriptor_o (enable[4]),
    .upset_status_memory_set_i(1'b0),
    .upset_status_state_set_i(1'b0),
    .upset_status_window_set_i(1'b0),
    .upset_status_burst_set_i(1'b0),
    .upset_status_copy_set_i (1'b0),
    .irq_state_packet_set_i  (packet),
    .irq_state_descriptor_set_i(descriptor),
    .irq_o                   (irq)
  );

  (* hierconn *) wire        \u_dut.status_done_q ;
  (* hierconn *) wire        \u_dut.status_start_refused_q ;
  (* hierconn *) wire [ERRORS-1:0] \u_dut.error_status_q ;
  (* hierconn *) wire        \u_dut.error_first_valid_q ;
  (* hierconn *) wire        \u_dut.irq_state_done_q ;
  (* hierconn *) wire        \u_dut.irq_state_error_q ;
  (* hierconn *) wire        \u_dut.irq_state_refused_q ;
  (* hierconn *) wire        \u_dut.irq_state_packet_q ;
  (* hierconn *) wire        \u_dut.irq_state_descriptor_q ;

  // Counters side by side: count, high word as it was latched, and what latches it.
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
  reg [9:0]   read_word_q;
  reg         counters_read;
  integer     c;
  always @* begin
    counters_read = 1'b1;
    for (c = 0; c < 3; c = c + 1) begin
      if (latches[c] != (read && read_word_q == COUNTERS + 2 * c)) counters_read = 1'b0;
      if (read_word_q == COUNTERS + 2 * c && read_data != lows[32*c +: 32]) counters_read = 1'b0;
      if (read_word_q == COUNTERS + 2 * c + 1 && read_data != highs[32*c +: 32])
        counters_read = 1'b0;
    end
  end

  wire [31:0] mask  = {{8 {strobe[3]}}, {8 {strobe[2]}}, {8 {strobe[1]}}, {8 {strobe[0]}}};
  wire [31:0] ones  = data & mask;

  // Sticky bits side by side: as they are, what clears and what sets each of them.
  wire [4:0]  state   = {\u_dut.irq_state_descriptor_q , \u_dut.irq_state_packet_q ,
                         \u_dut.irq_state_refused_q , \u_dut.irq_state_error_q ,
                         \u_dut.irq_state_done_q };
  wire [ERRORS+7:0] sticky  = {state, \u_dut.error_first_valid_q , \u_dut.error_status_q ,
                         \u_dut.status_start_refused_q , \u_dut.status_done_q };
  wire [ERRORS+7:0] clears  = {write && word == IRQ_STATE ? ones[4:0] : 5'd0,
                         write && word == ERROR_FIRST && ones[31],
                         write && word == ERROR_STATUS ? ones[ERRORS-1:0] : {ERRORS {1'b0}},
                         write && word == STATUS ? ones[9:8] : 2'd0};
  wire        asked   = write && word == CONTROL && ones[0];
  wire        refused = asked && (busy || stopped || !lock || start);
  wire [4:0]  tests   = write && word == IRQ_TEST ? ones[4:0] : 5'd0;
  wire [ERRORS+7:0] sets    = {{descriptor, packet, refused, |error, done} | tests, |error, error,
                             refused, done};

  // Settings side by side, a word each.
  wire [255:0] windows  = {write_limit, write_base, read_limit, read_base};
  wire [223:0] settings = {ring_base, {28'd0, ring_log2_size}, {16'd0, ring_head},
                           result_base, result_size};
  wire [6:0]   owners   = {word == RING_BASE_HI, word == RING_BASE_LO,
                           word == RING_LOG2_SIZE, word == RING_HEAD, word == RESULT_BASE_HI,
                           word == RESULT_BASE_LO, word == RESULT_SIZE};

  // A clock without a reset comes first: in the second, words are decoded and counters hold any count.
  reg         zero_q  = 1'b1;
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
  reg [ERRORS+7:0]  sticky_q;
  reg [ERRORS+7:0]  clears_q;
  reg [ERRORS+7:0]  sets_q;
  reg [4:0]   pending_q;
  reg         asked_q;
  reg         refused_q;
  always @(posedge clk) begin
    zero_q     <= 1'b0;
    first_q    <= zero_q;
    rst_q      <= rst || first_q;
    write_q    <= write;
    error_q    <= write_error;
    word_q     <= word;
    read_word_q <= read_word;
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

  always @* if (first_q && !zero_q) assume (rst);

  // A word comes a clock before its valid, and none is valid while the block clears its memory.
  always @* assume (!write || (word == word_q && !clearing));
  always @* assume (!read || (read_word == read_word_q && !clearing));

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
    locked_error: assert (!(write && lock && (word >> 3) == (WINDOWS >> 3)) || write_error);
  end
  always @* if (!zero_q) begin
    counters: assert (counters_read);
  end
endmodule

`default_nettype wire
