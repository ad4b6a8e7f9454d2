// ffd_axil_registers: the registers of rtl/bus/registers.csv, from AXI4-Lite to the hardware
//
// Made from rtl/bus/registers.csv by scripts/registers.py; changes here are lost.
//
// Registers, bus, hardware side: docs/registers.md. _i and _o of a field are its value, _set_i sets
// a sticky bit and wins over a write that clears it, _event_i is counted in every clock in which it
// is high; a bit of error_event_i is one error, with packet and beat of the same clock, and, where
// error_address_valid_i is high, an address. Outputs of w1 fields are pulses of one clock.
//
// Pipeline:   a write acts at the edge at which its response appears; irq_o follows a clock later.
// Cuts:       every output leaves a register.
// Needs:      status_busy_i high from the clock after control_start_o on (a start in the clock of
//             that pulse is refused here).
// Parameters: SECURE_ONLY as in ffd_axil_slave.
// Model:      tests/bus/axil/register_model.hpp.  Test: tests/bus/axil.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_axil_registers #(
  parameter SECURE_ONLY = 0
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
  input  wire [27:0] error_event_i,
  input  wire [31:0] error_packet_i,
  input  wire [31:0] error_beat_i,
  input  wire        error_address_valid_i,
  input  wire [63:0] error_address_i,
  output reg         irq_enable_done_o,
  output reg         irq_enable_error_o,
  output reg         irq_enable_refused_o,
  output reg         irq_o
);
  wire        write;
  wire [9:0]  write_word;
  wire [31:0] write_data;
  wire [31:0] write_mask;
  wire [3:0]  write_strobe = {write_mask[24], write_mask[16], write_mask[8], write_mask[0]};
  reg         write_error;
  wire        read;
  wire [9:0]  read_word;
  reg  [31:0] read_data;
  reg         read_error;
  wire        clearing;

  ffd_axil_slave #(
    .ADDRESS_W  (12),
    .SECURE_ONLY(SECURE_ONLY)
  ) u_slave (
    .clk           (clk),
    .rst           (rst || clearing),
    `include "ffd_axil_connections.vh"
    .write_o       (write),
    .write_word_o  (write_word),
    .write_data_o  (write_data),
    .write_mask_o  (write_mask),
    .write_error_i (write_error),
    .read_o        (read),
    .read_word_o   (read_word),
    .read_data_i   (read_data),
    .read_error_i  (read_error)
  );

  // The bits that a write sets: partial strobes leave the other bytes alone.
  wire [31:0] ones = write_data & write_mask;

  wire write_control = write && write_word == 10'h004;
  wire write_status = write && write_word == 10'h005;
  wire write_ring_base_lo = write && write_word == 10'h010;
  wire write_ring_base_hi = write && write_word == 10'h011;
  wire write_ring_log2_size = write && write_word == 10'h012;
  wire write_ring_head = write && write_word == 10'h013;
  wire write_result_base_lo = write && write_word == 10'h018;
  wire write_result_base_hi = write && write_word == 10'h019;
  wire write_result_size = write && write_word == 10'h01a;
  wire write_read_window_base_lo = write && write_word == 10'h020 && !window_lock_windows_o;
  wire write_read_window_base_hi = write && write_word == 10'h021 && !window_lock_windows_o;
  wire write_read_window_limit_lo = write && write_word == 10'h022 && !window_lock_windows_o;
  wire write_read_window_limit_hi = write && write_word == 10'h023 && !window_lock_windows_o;
  wire write_write_window_base_lo = write && write_word == 10'h024 && !window_lock_windows_o;
  wire write_write_window_base_hi = write && write_word == 10'h025 && !window_lock_windows_o;
  wire write_write_window_limit_lo = write && write_word == 10'h026 && !window_lock_windows_o;
  wire write_write_window_limit_hi = write && write_word == 10'h027 && !window_lock_windows_o;
  wire write_window_lock = write && write_word == 10'h028;
  wire write_error_status = write && write_word == 10'h040;
  wire write_error_first = write && write_word == 10'h042;
  wire write_irq_enable = write && write_word == 10'h050;
  wire write_irq_state = write && write_word == 10'h051;
  wire write_irq_test = write && write_word == 10'h052;
  reg status_done_q;
  reg status_start_refused_q;
  wire [63:0] counter_vertices;
  wire [63:0] counter_stalls;
  wire [63:0] counter_busy;
  reg [27:0] error_status_q;
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
  wire [27:0] error_status_held = error_status_q & ~(ones[27:0] & {28 {write_error_status}});
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
  reg  [1:0]  write_block;
  reg  [1:0]  read_block;
  wire [31:0] stored_word;
  wire write_stored = write_ring_base_lo || write_ring_base_hi || write_result_base_lo ||
    write_result_base_hi || write_result_size || write_read_window_base_lo ||
    write_read_window_base_hi || write_read_window_limit_lo || write_read_window_limit_hi ||
    write_write_window_base_lo || write_write_window_base_hi || write_write_window_limit_lo ||
    write_write_window_limit_hi;

  always @* begin
    case (write_word[9:2])
      8'h06: write_block = 2'd1;
      8'h08: write_block = 2'd2;
      8'h09: write_block = 2'd3;
      default: write_block = 2'd0;
    endcase
    case (read_word[9:2])
      8'h06: read_block = 2'd1;
      8'h08: read_block = 2'd2;
      8'h09: read_block = 2'd3;
      default: read_block = 2'd0;
    endcase
  end

  ffd_axil_stored #(
    .WORDS(16)
  ) u_stored (
    .clk           (clk),
    .rst           (rst),
    .clearing_o    (clearing),
    .write_i       (write_stored),
    .write_slot_i  ({write_block, write_word[1:0]}),
    .write_data_i  (write_data),
    .write_strobe_i(write_strobe),
    .read_slot_i   ({read_block, read_word[1:0]}),
    .word_o        (stored_word)
  );

  ffd_axil_errors #(
    .CODES(28)
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
    .latch_i(read && read_word == 10'h030),
    .low_o  (counter_vertices[31:0]),
    .high_o (counter_vertices[63:32])
  );

  ffd_axil_counter u_counter_stalls (
    .clk    (clk),
    .rst    (rst),
    .event_i(counter_stalls_event_i),
    .clear_i(control_clear_counters_o),
    .latch_i(read && read_word == 10'h032),
    .low_o  (counter_stalls[31:0]),
    .high_o (counter_stalls[63:32])
  );

  ffd_axil_counter u_counter_busy (
    .clk    (clk),
    .rst    (rst),
    .event_i(counter_busy_event_i),
    .clear_i(control_clear_counters_o),
    .latch_i(read && read_word == 10'h034),
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
        if (write_strobe[0]) ring_base_o[39:32] <= write_data[7:0];
        if (write_strobe[1]) ring_base_o[47:40] <= write_data[15:8];
        if (write_strobe[2]) ring_base_o[55:48] <= write_data[23:16];
        if (write_strobe[3]) ring_base_o[63:56] <= write_data[31:24];
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
        if (write_strobe[0]) result_base_o[39:32] <= write_data[7:0];
        if (write_strobe[1]) result_base_o[47:40] <= write_data[15:8];
        if (write_strobe[2]) result_base_o[55:48] <= write_data[23:16];
        if (write_strobe[3]) result_base_o[63:56] <= write_data[31:24];
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
        if (write_strobe[0]) read_window_base_o[39:32] <= write_data[7:0];
        if (write_strobe[1]) read_window_base_o[47:40] <= write_data[15:8];
        if (write_strobe[2]) read_window_base_o[55:48] <= write_data[23:16];
        if (write_strobe[3]) read_window_base_o[63:56] <= write_data[31:24];
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
        if (write_strobe[0]) read_window_limit_o[39:32] <= write_data[7:0];
        if (write_strobe[1]) read_window_limit_o[47:40] <= write_data[15:8];
        if (write_strobe[2]) read_window_limit_o[55:48] <= write_data[23:16];
        if (write_strobe[3]) read_window_limit_o[63:56] <= write_data[31:24];
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
        if (write_strobe[0]) write_window_base_o[39:32] <= write_data[7:0];
        if (write_strobe[1]) write_window_base_o[47:40] <= write_data[15:8];
        if (write_strobe[2]) write_window_base_o[55:48] <= write_data[23:16];
        if (write_strobe[3]) write_window_base_o[63:56] <= write_data[31:24];
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
        if (write_strobe[0]) write_window_limit_o[39:32] <= write_data[7:0];
        if (write_strobe[1]) write_window_limit_o[47:40] <= write_data[15:8];
        if (write_strobe[2]) write_window_limit_o[55:48] <= write_data[23:16];
        if (write_strobe[3]) write_window_limit_o[63:56] <= write_data[31:24];
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
      error_status_q <= 28'h0;
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

  wire unused_ok = &{1'b0, ones, write_mask};

  always @* begin
    case (write_word)
      10'h004, 10'h005, 10'h010, 10'h011, 10'h012, 10'h013, 10'h018, 10'h019, 10'h01a, 10'h028,
      10'h040, 10'h042, 10'h050, 10'h051, 10'h052: write_error = 1'b0;
      10'h020, 10'h021, 10'h022, 10'h023, 10'h024, 10'h025, 10'h026, 10'h027: write_error =
      window_lock_windows_o;
      default: write_error = 1'b1;
    endcase
  end

  always @* begin
    read_error = 1'b0;
    case (read_word)
      10'h010, 10'h011, 10'h018, 10'h019, 10'h01a, 10'h020, 10'h021, 10'h022, 10'h023, 10'h024,
      10'h025, 10'h026, 10'h027: read_data = stored_word;
      10'h000: read_data = 32'h48464644;
      10'h001: read_data = {16'h0, 8'h2, 8'h0};
      10'h002: read_data = {2'h0, config_evaluator_i, 3'h0, config_schedule_i, config_format_i,
        config_n_i, config_org_i};
      10'h003: read_data = {8'h0, limits_points_axis_i, limits_in_flight_i};
      10'h004: read_data = {29'h0, 1'b0, 1'b0, 1'b0};
      10'h005: read_data = {22'h0, status_start_refused_q, status_done_q, 4'h0,
        status_ring_running_i, status_stopped_i, status_idle_i, status_busy_i};
      10'h012: read_data = {28'h0, ring_log2_size_o};
      10'h013: read_data = {16'h0, ring_head_o};
      10'h014: read_data = {16'h0, ring_tail_i};
      10'h01b: read_data = result_count_i;
      10'h028: read_data = {31'h0, window_lock_windows_o};
      10'h030: read_data = counter_vertices[31:0];
      10'h031: read_data = counter_vertices[63:32];
      10'h032: read_data = counter_stalls[31:0];
      10'h033: read_data = counter_stalls[63:32];
      10'h034: read_data = counter_busy[31:0];
      10'h035: read_data = counter_busy[63:32];
      10'h040: read_data = {4'h0, error_status_q};
      10'h041: read_data = log_count;
      10'h042: read_data = {error_first_valid_q, 26'h0, log_code};
      10'h043: read_data = log_packet;
      10'h044: read_data = log_beat;
      10'h045: read_data = log_address[31:0];
      10'h046: read_data = log_address[63:32];
      10'h050: read_data = {29'h0, irq_enable_refused_o, irq_enable_error_o, irq_enable_done_o};
      10'h051: read_data = {29'h0, irq_state_refused_q, irq_state_error_q, irq_state_done_q};
      10'h052: read_data = {29'h0, 1'b0, 1'b0, 1'b0};
      default: begin
        read_data  = 32'd0;
        read_error = 1'b1;
      end
    endcase
  end
endmodule

`default_nettype wire
