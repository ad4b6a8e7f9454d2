// ffd_axil_registers: the registers of rtl/bus/registers.csv, from AXI4-Lite to the hardware
//
// Made from rtl/bus/registers.csv by scripts/registers.py; changes here are lost.
//
// Registers, bus, hardware side: docs/registers.md. _i and _o of a field are its value, _set_i sets
// a sticky bit and wins over a write that clears it, _event_i is counted in every clock in which it
// is high; a bit of error_event_i is one error, with packet and beat of the same clock, and, where
// error_address_valid_i is high, an address. Outputs of w1 fields are pulses of one clock.
//
// Pipeline:   a request is decoded in the clock before it acts; a write acts at the edge at which
//             its response appears; irq_o follows a clock later.
// Cuts:       every output leaves a register.
// Needs:      status_busy_i high from the clock after control_start_o on (a start in the clock of
//             that pulse is refused here).
// Parameters: SECURE_ONLY as in ffd_axil_slave; ADDRESS_WIDTH 32 to 64, the bits of an address on
//             the memory's bus: those above are 0 in settings, whatever is written to them.
// Model:      tests/bus/axil/register_model.hpp.  Test: tests/bus/axil.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_axil_registers #(
  parameter SECURE_ONLY   = 0,
  parameter ADDRESS_WIDTH = 64
) (
  input  wire        clk,
  input  wire        rst,
  `include "ffd_axil_ports.vh"
  input  wire [7:0]  config_org_i,
  input  wire [7:0]  config_n_i,
  input  wire [7:0]  config_format_i,
  input  wire        config_schedule_i,
  input  wire [1:0]  config_evaluator_i,
  input  wire [15:0] limits_in_flight_i,
  input  wire [7:0]  limits_points_axis_i,
  output reg         control_start_o,
  output reg         control_soft_reset_o,
  output reg         control_clear_counters_o,
  input  wire        status_busy_i,
  input  wire        status_idle_i,
  input  wire        status_stopped_i,
  input  wire        status_ring_running_i,
  input  wire        status_done_set_i,
  output reg  [63:0] ring_base_o,
  output reg  [3:0]  ring_log2_size_o,
  output reg  [15:0] ring_head_o,
  input  wire [15:0] ring_tail_i,
  output reg  [63:0] result_base_o,
  output reg  [31:0] result_size_o,
  input  wire [31:0] result_count_i,
  output reg  [63:0] read_window_base_o,
  output reg  [63:0] read_window_limit_o,
  output reg  [63:0] write_window_base_o,
  output reg  [63:0] write_window_limit_o,
  output reg         window_lock_windows_o,
  input  wire        counter_vertices_event_i,
  input  wire        counter_stalls_event_i,
  input  wire        counter_busy_event_i,
  input  wire [23:0] error_event_i,
  input  wire [31:0] error_packet_i,
  input  wire [31:0] error_beat_i,
  input  wire        error_address_valid_i,
  input  wire [63:0] error_address_i,
  output reg         irq_enable_done_o,
  output reg         irq_enable_error_o,
  output reg         irq_enable_refused_o,
  output reg         irq_o
);
  wire        write_next;
  wire [9:0]  write_next_word;
  wire        write;
  wire [9:0]  write_word;
  wire [31:0] write_data;
  wire [31:0] write_mask;
  wire [3:0]  write_strobe = {write_mask[24], write_mask[16], write_mask[8], write_mask[0]};
  wire        write_error;
  wire        read_next;
  wire [9:0]  read_next_word;
  wire        read;
  wire [9:0]  read_word;
  wire [31:0] read_data;
  wire        read_error;
  wire        clearing;

  ffd_axil_slave #(
    .ADDRESS_W  (12),
    .SECURE_ONLY(SECURE_ONLY)
  ) u_slave (
    .clk              (clk),
    .rst              (rst || clearing),
    `include "ffd_axil_connections.vh"
    .write_next_o     (write_next),
    .write_next_word_o(write_next_word),
    .write_o          (write),
    .write_word_o     (write_word),
    .write_data_o     (write_data),
    .write_mask_o     (write_mask),
    .write_error_i    (write_error),
    .read_next_o      (read_next),
    .read_next_word_o (read_next_word),
    .read_o           (read),
    .read_word_o      (read_word),
    .read_data_i      (read_data),
    .read_error_i     (read_error)
  );

  // The bits that a write sets: partial strobes leave the other bytes alone.
  wire [31:0] ones = write_data & write_mask;
  // What the high half of an address may hold.
  localparam [31:0] HIGH = 32'hffff_ffff >> (64 - ADDRESS_WIDTH);
  wire [31:0] high_data = write_data & HIGH;

  reg write_unknown_q;
  reg write_locked_q;
  reg read_unknown_q;
  reg [26:0] read_of_q;
  reg write_control_q;
  wire write_control = write && write_control_q;
  reg write_status_q;
  wire write_status = write && write_status_q;
  reg write_ring_base_lo_q;
  wire write_ring_base_lo = write && write_ring_base_lo_q;
  reg write_ring_base_hi_q;
  wire write_ring_base_hi = write && write_ring_base_hi_q;
  reg write_ring_log2_size_q;
  wire write_ring_log2_size = write && write_ring_log2_size_q;
  reg write_ring_head_q;
  wire write_ring_head = write && write_ring_head_q;
  reg write_result_base_lo_q;
  wire write_result_base_lo = write && write_result_base_lo_q;
  reg write_result_base_hi_q;
  wire write_result_base_hi = write && write_result_base_hi_q;
  reg write_result_size_q;
  wire write_result_size = write && write_result_size_q;
  reg write_read_window_base_lo_q;
  wire write_read_window_base_lo = write && write_read_window_base_lo_q && !window_lock_windows_o;
  reg write_read_window_base_hi_q;
  wire write_read_window_base_hi = write && write_read_window_base_hi_q && !window_lock_windows_o;
  reg write_read_window_limit_lo_q;
  wire write_read_window_limit_lo = write && write_read_window_limit_lo_q && !window_lock_windows_o;
  reg write_read_window_limit_hi_q;
  wire write_read_window_limit_hi = write && write_read_window_limit_hi_q && !window_lock_windows_o;
  reg write_write_window_base_lo_q;
  wire write_write_window_base_lo = write && write_write_window_base_lo_q && !window_lock_windows_o;
  reg write_write_window_base_hi_q;
  wire write_write_window_base_hi = write && write_write_window_base_hi_q && !window_lock_windows_o;
  reg write_write_window_limit_lo_q;
  wire write_write_window_limit_lo = write && write_write_window_limit_lo_q &&
    !window_lock_windows_o;
  reg write_write_window_limit_hi_q;
  wire write_write_window_limit_hi = write && write_write_window_limit_hi_q &&
    !window_lock_windows_o;
  reg write_window_lock_q;
  wire write_window_lock = write && write_window_lock_q;
  reg write_error_status_q;
  wire write_error_status = write && write_error_status_q;
  reg write_error_first_q;
  wire write_error_first = write && write_error_first_q;
  reg write_irq_enable_q;
  wire write_irq_enable = write && write_irq_enable_q;
  reg write_irq_state_q;
  wire write_irq_state = write && write_irq_state_q;
  reg write_irq_test_q;
  wire write_irq_test = write && write_irq_test_q;
  reg status_done_q;
  reg status_start_refused_q;
  wire [63:0] counter_vertices;
  wire [63:0] counter_stalls;
  wire [63:0] counter_busy;
  reg [23:0] error_status_q;
  reg error_first_valid_q;
  reg irq_state_done_q;
  reg irq_state_error_q;
  reg irq_state_refused_q;
  wire control_start_asked = write_control && ones[0];
  wire control_start_blocked = status_busy_i || status_stopped_i || !window_lock_windows_o ||
    control_start_o;
  wire control_start_refused = control_start_asked && control_start_blocked;
  wire status_done_set = status_done_set_i;
  wire status_done_held = status_done_q && !(write_status && ones[8]);
  wire status_start_refused_set = control_start_refused;
  wire status_start_refused_held = status_start_refused_q && !(write_status && ones[9]);
  wire error_any = |error_event_i;
  wire [23:0] error_status_held = error_status_q & ~(ones[23:0] & {24 {write_error_status}});
  wire error_first_valid_set = error_any;
  wire error_first_valid_held = error_first_valid_q && !(write_error_first && ones[31]);
  wire irq_state_done_set = status_done_set || (write_irq_test && ones[0]);
  wire irq_state_done_held = irq_state_done_q && !(write_irq_state && ones[0]);
  wire irq_state_error_set = error_any || (write_irq_test && ones[1]);
  wire irq_state_error_held = irq_state_error_q && !(write_irq_state && ones[1]);
  wire irq_state_refused_set = status_start_refused_set || (write_irq_test && ones[2]);
  wire irq_state_refused_held = irq_state_refused_q && !(write_irq_state && ones[2]);

  wire [31:0] log_count;
  wire [4:0]  log_code;
  wire [31:0] log_packet;
  wire [31:0] log_beat;
  wire [63:0] log_address;

  // Settings of a whole word are read from a memory, in which four of them share a block.
  reg  [1:0]  write_block_q;
  reg  [1:0]  read_block_q;
  reg         write_stored_q;
  reg         read_stored_q;
  reg         write_high_q;
  wire [31:0] stored_word;

  always @(posedge clk) begin
    if (write_next) begin
      case (write_next_word[9:2])
        8'h06: write_block_q <= 2'd1;
        8'h08: write_block_q <= 2'd2;
        8'h09: write_block_q <= 2'd3;
        default: write_block_q <= 2'd0;
      endcase
      case (write_next_word)
        10'h010, 10'h011, 10'h018, 10'h019, 10'h01a, 10'h020, 10'h021, 10'h022, 10'h023, 10'h024,
        10'h025, 10'h026, 10'h027: write_stored_q <= 1'b1;
        default: write_stored_q <= 1'b0;
      endcase
      case (write_next_word)
        10'h011, 10'h019, 10'h021, 10'h023, 10'h025, 10'h027: write_high_q <= 1'b1;
        default: write_high_q <= 1'b0;
      endcase
    end
    if (read_next) begin
      case (read_next_word[9:2])
        8'h06: read_block_q <= 2'd1;
        8'h08: read_block_q <= 2'd2;
        8'h09: read_block_q <= 2'd3;
        default: read_block_q <= 2'd0;
      endcase
      case (read_next_word)
        10'h010, 10'h011, 10'h018, 10'h019, 10'h01a, 10'h020, 10'h021, 10'h022, 10'h023, 10'h024,
        10'h025, 10'h026, 10'h027: read_stored_q <= 1'b1;
        default: read_stored_q <= 1'b0;
      endcase
    end
  end

  ffd_axil_stored #(
    .WORDS(16)
  ) u_stored (
    .clk           (clk),
    .rst           (rst),
    .clearing_o    (clearing),
    .write_i       (write && write_stored_q && !write_error),
    .write_slot_i  ({write_block_q, write_word[1:0]}),
    .write_data_i  (write_high_q ? high_data : write_data),
    .write_strobe_i(write_strobe),
    .read_slot_i   ({read_block_q, read_word[1:0]}),
    .word_o        (stored_word)
  );

  ffd_axil_errors #(
    .CODES(24)
  ) u_errors (
    .clk            (clk),
    .rst            (rst),
    .event_i        (error_event_i),
    .packet_i       (error_packet_i),
    .beat_i         (error_beat_i),
    .address_valid_i(error_address_valid_i),
    .address_i      (error_address_i),
    .held_i         (error_first_valid_held),
    .clear_i        (control_clear_counters_o),
    .count_o        (log_count),
    .code_o         (log_code),
    .packet_o       (log_packet),
    .beat_o         (log_beat),
    .address_o      (log_address)
  );

  ffd_axil_counter u_counter_vertices (
    .clk    (clk),
    .rst    (rst),
    .event_i(counter_vertices_event_i),
    .clear_i(control_clear_counters_o),
    .latch_i(read && read_of_q[11]),
    .low_o  (counter_vertices[31:0]),
    .high_o (counter_vertices[63:32])
  );

  ffd_axil_counter u_counter_stalls (
    .clk    (clk),
    .rst    (rst),
    .event_i(counter_stalls_event_i),
    .clear_i(control_clear_counters_o),
    .latch_i(read && read_of_q[13]),
    .low_o  (counter_stalls[31:0]),
    .high_o (counter_stalls[63:32])
  );

  ffd_axil_counter u_counter_busy (
    .clk    (clk),
    .rst    (rst),
    .event_i(counter_busy_event_i),
    .clear_i(control_clear_counters_o),
    .latch_i(read && read_of_q[15]),
    .low_o  (counter_busy[31:0]),
    .high_o (counter_busy[63:32])
  );

  // 0x010 CONTROL
  always @(posedge clk) begin
    if (rst) begin
      control_start_o <= 1'b0;
      control_soft_reset_o <= 1'b0;
      control_clear_counters_o <= 1'b0;
    end else begin
      control_start_o <= control_start_asked && !control_start_blocked;
      control_soft_reset_o <= write_control && ones[1];
      control_clear_counters_o <= write_control && ones[2];
    end
  end

  // 0x014 STATUS
  always @(posedge clk) begin
    if (rst) begin
      status_done_q <= 1'b0;
      status_start_refused_q <= 1'b0;
    end else begin
      status_done_q <= status_done_set || status_done_held;
      status_start_refused_q <= status_start_refused_set || status_start_refused_held;
    end
  end

  // 0x040 RING_BASE_LO
  always @(posedge clk) begin
    if (rst) begin
      ring_base_o[31:0] <= 32'h0;
    end else begin
      if (write_ring_base_lo) begin
        if (write_strobe[0]) ring_base_o[7:0] <= write_data[7:0];
        if (write_strobe[1]) ring_base_o[15:8] <= write_data[15:8];
        if (write_strobe[2]) ring_base_o[23:16] <= write_data[23:16];
        if (write_strobe[3]) ring_base_o[31:24] <= write_data[31:24];
      end
    end
  end

  // 0x044 RING_BASE_HI
  always @(posedge clk) begin
    if (rst) begin
      ring_base_o[63:32] <= 32'h0;
    end else begin
      if (write_ring_base_hi) begin
        if (write_strobe[0]) ring_base_o[39:32] <= high_data[7:0];
        if (write_strobe[1]) ring_base_o[47:40] <= high_data[15:8];
        if (write_strobe[2]) ring_base_o[55:48] <= high_data[23:16];
        if (write_strobe[3]) ring_base_o[63:56] <= high_data[31:24];
      end
    end
  end

  // 0x048 RING_LOG2_SIZE
  always @(posedge clk) begin
    if (rst) begin
      ring_log2_size_o <= 4'h0;
    end else begin
      if (write_ring_log2_size) begin
        if (write_strobe[0]) ring_log2_size_o[3:0] <= write_data[3:0];
      end
    end
  end

  // 0x04C RING_HEAD
  always @(posedge clk) begin
    if (rst) begin
      ring_head_o <= 16'h0;
    end else begin
      if (write_ring_head) begin
        if (write_strobe[0]) ring_head_o[7:0] <= write_data[7:0];
        if (write_strobe[1]) ring_head_o[15:8] <= write_data[15:8];
      end
    end
  end

  // 0x060 RESULT_BASE_LO
  always @(posedge clk) begin
    if (rst) begin
      result_base_o[31:0] <= 32'h0;
    end else begin
      if (write_result_base_lo) begin
        if (write_strobe[0]) result_base_o[7:0] <= write_data[7:0];
        if (write_strobe[1]) result_base_o[15:8] <= write_data[15:8];
        if (write_strobe[2]) result_base_o[23:16] <= write_data[23:16];
        if (write_strobe[3]) result_base_o[31:24] <= write_data[31:24];
      end
    end
  end

  // 0x064 RESULT_BASE_HI
  always @(posedge clk) begin
    if (rst) begin
      result_base_o[63:32] <= 32'h0;
    end else begin
      if (write_result_base_hi) begin
        if (write_strobe[0]) result_base_o[39:32] <= high_data[7:0];
        if (write_strobe[1]) result_base_o[47:40] <= high_data[15:8];
        if (write_strobe[2]) result_base_o[55:48] <= high_data[23:16];
        if (write_strobe[3]) result_base_o[63:56] <= high_data[31:24];
      end
    end
  end

  // 0x068 RESULT_SIZE
  always @(posedge clk) begin
    if (rst) begin
      result_size_o <= 32'h0;
    end else begin
      if (write_result_size) begin
        if (write_strobe[0]) result_size_o[7:0] <= write_data[7:0];
        if (write_strobe[1]) result_size_o[15:8] <= write_data[15:8];
        if (write_strobe[2]) result_size_o[23:16] <= write_data[23:16];
        if (write_strobe[3]) result_size_o[31:24] <= write_data[31:24];
      end
    end
  end

  // 0x080 READ_WINDOW_BASE_LO
  always @(posedge clk) begin
    if (rst) begin
      read_window_base_o[31:0] <= 32'h0;
    end else begin
      if (write_read_window_base_lo) begin
        if (write_strobe[0]) read_window_base_o[7:0] <= write_data[7:0];
        if (write_strobe[1]) read_window_base_o[15:8] <= write_data[15:8];
        if (write_strobe[2]) read_window_base_o[23:16] <= write_data[23:16];
        if (write_strobe[3]) read_window_base_o[31:24] <= write_data[31:24];
      end
    end
  end

  // 0x084 READ_WINDOW_BASE_HI
  always @(posedge clk) begin
    if (rst) begin
      read_window_base_o[63:32] <= 32'h0;
    end else begin
      if (write_read_window_base_hi) begin
        if (write_strobe[0]) read_window_base_o[39:32] <= high_data[7:0];
        if (write_strobe[1]) read_window_base_o[47:40] <= high_data[15:8];
        if (write_strobe[2]) read_window_base_o[55:48] <= high_data[23:16];
        if (write_strobe[3]) read_window_base_o[63:56] <= high_data[31:24];
      end
    end
  end

  // 0x088 READ_WINDOW_LIMIT_LO
  always @(posedge clk) begin
    if (rst) begin
      read_window_limit_o[31:0] <= 32'h0;
    end else begin
      if (write_read_window_limit_lo) begin
        if (write_strobe[0]) read_window_limit_o[7:0] <= write_data[7:0];
        if (write_strobe[1]) read_window_limit_o[15:8] <= write_data[15:8];
        if (write_strobe[2]) read_window_limit_o[23:16] <= write_data[23:16];
        if (write_strobe[3]) read_window_limit_o[31:24] <= write_data[31:24];
      end
    end
  end

  // 0x08C READ_WINDOW_LIMIT_HI
  always @(posedge clk) begin
    if (rst) begin
      read_window_limit_o[63:32] <= 32'h0;
    end else begin
      if (write_read_window_limit_hi) begin
        if (write_strobe[0]) read_window_limit_o[39:32] <= high_data[7:0];
        if (write_strobe[1]) read_window_limit_o[47:40] <= high_data[15:8];
        if (write_strobe[2]) read_window_limit_o[55:48] <= high_data[23:16];
        if (write_strobe[3]) read_window_limit_o[63:56] <= high_data[31:24];
      end
    end
  end

  // 0x090 WRITE_WINDOW_BASE_LO
  always @(posedge clk) begin
    if (rst) begin
      write_window_base_o[31:0] <= 32'h0;
    end else begin
      if (write_write_window_base_lo) begin
        if (write_strobe[0]) write_window_base_o[7:0] <= write_data[7:0];
        if (write_strobe[1]) write_window_base_o[15:8] <= write_data[15:8];
        if (write_strobe[2]) write_window_base_o[23:16] <= write_data[23:16];
        if (write_strobe[3]) write_window_base_o[31:24] <= write_data[31:24];
      end
    end
  end

  // 0x094 WRITE_WINDOW_BASE_HI
  always @(posedge clk) begin
    if (rst) begin
      write_window_base_o[63:32] <= 32'h0;
    end else begin
      if (write_write_window_base_hi) begin
        if (write_strobe[0]) write_window_base_o[39:32] <= high_data[7:0];
        if (write_strobe[1]) write_window_base_o[47:40] <= high_data[15:8];
        if (write_strobe[2]) write_window_base_o[55:48] <= high_data[23:16];
        if (write_strobe[3]) write_window_base_o[63:56] <= high_data[31:24];
      end
    end
  end

  // 0x098 WRITE_WINDOW_LIMIT_LO
  always @(posedge clk) begin
    if (rst) begin
      write_window_limit_o[31:0] <= 32'h0;
    end else begin
      if (write_write_window_limit_lo) begin
        if (write_strobe[0]) write_window_limit_o[7:0] <= write_data[7:0];
        if (write_strobe[1]) write_window_limit_o[15:8] <= write_data[15:8];
        if (write_strobe[2]) write_window_limit_o[23:16] <= write_data[23:16];
        if (write_strobe[3]) write_window_limit_o[31:24] <= write_data[31:24];
      end
    end
  end

  // 0x09C WRITE_WINDOW_LIMIT_HI
  always @(posedge clk) begin
    if (rst) begin
      write_window_limit_o[63:32] <= 32'h0;
    end else begin
      if (write_write_window_limit_hi) begin
        if (write_strobe[0]) write_window_limit_o[39:32] <= high_data[7:0];
        if (write_strobe[1]) write_window_limit_o[47:40] <= high_data[15:8];
        if (write_strobe[2]) write_window_limit_o[55:48] <= high_data[23:16];
        if (write_strobe[3]) write_window_limit_o[63:56] <= high_data[31:24];
      end
    end
  end

  // 0x0A0 WINDOW_LOCK
  always @(posedge clk) begin
    if (rst) begin
      window_lock_windows_o <= 1'b0;
    end else begin
      if (write_window_lock && ones[0]) window_lock_windows_o <= 1'b1;
    end
  end

  // 0x100 ERROR_STATUS
  always @(posedge clk) begin
    if (rst) begin
      error_status_q <= 24'h0;
    end else begin
      error_status_q <= error_event_i | error_status_held;
    end
  end

  // 0x108 ERROR_FIRST
  always @(posedge clk) begin
    if (rst) begin
      error_first_valid_q <= 1'b0;
    end else begin
      error_first_valid_q <= error_first_valid_set || error_first_valid_held;
    end
  end

  // 0x140 IRQ_ENABLE
  always @(posedge clk) begin
    if (rst) begin
      irq_enable_done_o <= 1'h0;
      irq_enable_error_o <= 1'h0;
      irq_enable_refused_o <= 1'h0;
    end else begin
      if (write_irq_enable) begin
        if (write_strobe[0]) irq_enable_done_o <= write_data[0];
        if (write_strobe[0]) irq_enable_error_o <= write_data[1];
        if (write_strobe[0]) irq_enable_refused_o <= write_data[2];
      end
    end
  end

  // 0x144 IRQ_STATE
  always @(posedge clk) begin
    if (rst) begin
      irq_state_done_q <= 1'b0;
      irq_state_error_q <= 1'b0;
      irq_state_refused_q <= 1'b0;
    end else begin
      irq_state_done_q <= irq_state_done_set || irq_state_done_held;
      irq_state_error_q <= irq_state_error_set || irq_state_error_held;
      irq_state_refused_q <= irq_state_refused_set || irq_state_refused_held;
    end
  end

  always @(posedge clk) begin
    if (rst) begin
      irq_o <= 1'b0;
    end else begin
      irq_o <=
        (irq_state_done_q && irq_enable_done_o) ||
        (irq_state_error_q && irq_enable_error_o) ||
        (irq_state_refused_q && irq_enable_refused_o);
    end
  end

  wire unused_ok = &{1'b0, ones, write_mask, write_word[9:2], read_word[9:2], read_of_q};

  // What the request of the next clock names.
  always @(posedge clk) begin
    if (write_next) begin
      write_control_q <= write_next_word == 10'h004;
      write_status_q <= write_next_word == 10'h005;
      write_ring_base_lo_q <= write_next_word == 10'h010;
      write_ring_base_hi_q <= write_next_word == 10'h011;
      write_ring_log2_size_q <= write_next_word == 10'h012;
      write_ring_head_q <= write_next_word == 10'h013;
      write_result_base_lo_q <= write_next_word == 10'h018;
      write_result_base_hi_q <= write_next_word == 10'h019;
      write_result_size_q <= write_next_word == 10'h01a;
      write_read_window_base_lo_q <= write_next_word == 10'h020;
      write_read_window_base_hi_q <= write_next_word == 10'h021;
      write_read_window_limit_lo_q <= write_next_word == 10'h022;
      write_read_window_limit_hi_q <= write_next_word == 10'h023;
      write_write_window_base_lo_q <= write_next_word == 10'h024;
      write_write_window_base_hi_q <= write_next_word == 10'h025;
      write_write_window_limit_lo_q <= write_next_word == 10'h026;
      write_write_window_limit_hi_q <= write_next_word == 10'h027;
      write_window_lock_q <= write_next_word == 10'h028;
      write_error_status_q <= write_next_word == 10'h040;
      write_error_first_q <= write_next_word == 10'h042;
      write_irq_enable_q <= write_next_word == 10'h050;
      write_irq_state_q <= write_next_word == 10'h051;
      write_irq_test_q <= write_next_word == 10'h052;
      case (write_next_word)
        10'h004, 10'h005, 10'h010, 10'h011, 10'h012, 10'h013, 10'h018, 10'h019, 10'h01a, 10'h028,
        10'h040, 10'h042, 10'h050, 10'h051, 10'h052, 10'h020, 10'h021, 10'h022, 10'h023, 10'h024,
        10'h025, 10'h026, 10'h027: write_unknown_q <= 1'b0;
        default: write_unknown_q <= 1'b1;
      endcase
      case (write_next_word)
        10'h020, 10'h021, 10'h022, 10'h023, 10'h024, 10'h025, 10'h026, 10'h027: write_locked_q <=
        1'b1;
        default: write_locked_q <= 1'b0;
      endcase
    end
    if (read_next) begin
      read_of_q[0] <= read_next_word == 10'h000;
      read_of_q[1] <= read_next_word == 10'h001;
      read_of_q[2] <= read_next_word == 10'h002;
      read_of_q[3] <= read_next_word == 10'h003;
      read_of_q[4] <= read_next_word == 10'h004;
      read_of_q[5] <= read_next_word == 10'h005;
      read_of_q[6] <= read_next_word == 10'h012;
      read_of_q[7] <= read_next_word == 10'h013;
      read_of_q[8] <= read_next_word == 10'h014;
      read_of_q[9] <= read_next_word == 10'h01b;
      read_of_q[10] <= read_next_word == 10'h028;
      read_of_q[11] <= read_next_word == 10'h030;
      read_of_q[12] <= read_next_word == 10'h031;
      read_of_q[13] <= read_next_word == 10'h032;
      read_of_q[14] <= read_next_word == 10'h033;
      read_of_q[15] <= read_next_word == 10'h034;
      read_of_q[16] <= read_next_word == 10'h035;
      read_of_q[17] <= read_next_word == 10'h040;
      read_of_q[18] <= read_next_word == 10'h041;
      read_of_q[19] <= read_next_word == 10'h042;
      read_of_q[20] <= read_next_word == 10'h043;
      read_of_q[21] <= read_next_word == 10'h044;
      read_of_q[22] <= read_next_word == 10'h045;
      read_of_q[23] <= read_next_word == 10'h046;
      read_of_q[24] <= read_next_word == 10'h050;
      read_of_q[25] <= read_next_word == 10'h051;
      read_of_q[26] <= read_next_word == 10'h052;
      case (read_next_word)
        10'h000, 10'h001, 10'h002, 10'h003, 10'h004, 10'h005, 10'h010, 10'h011, 10'h012, 10'h013,
        10'h014, 10'h018, 10'h019, 10'h01a, 10'h01b, 10'h020, 10'h021, 10'h022, 10'h023, 10'h024,
        10'h025, 10'h026, 10'h027, 10'h028, 10'h030, 10'h031, 10'h032, 10'h033, 10'h034, 10'h035,
        10'h040, 10'h041, 10'h042, 10'h043, 10'h044, 10'h045, 10'h046, 10'h050, 10'h051, 10'h052:
        read_unknown_q <= 1'b0;
        default: read_unknown_q <= 1'b1;
      endcase
    end
  end

  assign write_error = write_unknown_q || (write_locked_q && window_lock_windows_o);
  assign read_error  = read_unknown_q;
  assign read_data   =
    (stored_word & {32 {read_stored_q}}) |
    (32'h48464644 & {32{read_of_q[0]}}) |
    ({16'h0, 8'h2, 8'h0} & {32{read_of_q[1]}}) |
    ({2'h0, config_evaluator_i, 3'h0, config_schedule_i, config_format_i, config_n_i,
        config_org_i} & {32{read_of_q[2]}}) |
    ({8'h0, limits_points_axis_i, limits_in_flight_i} & {32{read_of_q[3]}}) |
    ({22'h0, status_start_refused_q, status_done_q, 4'h0, status_ring_running_i, status_stopped_i,
        status_idle_i, status_busy_i} & {32{read_of_q[5]}}) |
    ({28'h0, ring_log2_size_o} & {32{read_of_q[6]}}) |
    ({16'h0, ring_head_o} & {32{read_of_q[7]}}) |
    ({16'h0, ring_tail_i} & {32{read_of_q[8]}}) |
    (result_count_i & {32{read_of_q[9]}}) |
    ({31'h0, window_lock_windows_o} & {32{read_of_q[10]}}) |
    (counter_vertices[31:0] & {32{read_of_q[11]}}) |
    (counter_vertices[63:32] & {32{read_of_q[12]}}) |
    (counter_stalls[31:0] & {32{read_of_q[13]}}) |
    (counter_stalls[63:32] & {32{read_of_q[14]}}) |
    (counter_busy[31:0] & {32{read_of_q[15]}}) |
    (counter_busy[63:32] & {32{read_of_q[16]}}) |
    ({8'h0, error_status_q} & {32{read_of_q[17]}}) |
    (log_count & {32{read_of_q[18]}}) |
    ({error_first_valid_q, 26'h0, log_code} & {32{read_of_q[19]}}) |
    (log_packet & {32{read_of_q[20]}}) |
    (log_beat & {32{read_of_q[21]}}) |
    (log_address[31:0] & {32{read_of_q[22]}}) |
    (log_address[63:32] & {32{read_of_q[23]}}) |
    ({29'h0, irq_enable_refused_o, irq_enable_error_o, irq_enable_done_o} & {32{read_of_q[24]}}) |
    ({29'h0, irq_state_refused_q, irq_state_error_q, irq_state_done_q} & {32{read_of_q[25]}});
endmodule

`default_nettype wire
