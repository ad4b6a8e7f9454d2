// ffd_bus_registers: the registers of rtl/bus/registers.csv, from words to the hardware
//
// Made from rtl/bus/registers.csv by tools/tables/registers.py; changes here are lost.
//
// Registers, hardware side: docs/registers.md. _i and _o of a field are its value, _set_i sets
// a sticky bit and wins over a write that clears it, _event_i and _second_i are counted in every
// clock in which they are high; a bit of error_event_i is one error, with packet and beat of the
// same clock, and, where error_address_valid_i is high, an address; error_any_i is high where a bit
// is. Outputs of w1 fields are pulses of one clock.
//
// Writes and reads come as words, of any bus, and do not wait for each other.
// In the same clock a read sees what was there before the write.
//
// Pipeline:   a write acts at the end of the clock of s_write_valid; irq_o follows a clock later.
//             The word is decoded in the clock before.
// Cuts:       every output to the hardware leaves a register. Answers follow the clock's values.
// Needs:      status_busy_i high from the clock after control_start_o on (a start in the clock of
//             that pulse is refused here); a word, of a write or a read, in the clock before its
//             valid too; no valid while s_clearing is high, in rst and 16 clocks after.
// Parameters: WAITS 1: the counts WAIT_* are there; 0: their words are unknown. MARKS 1: interrupts
//             of packets and descriptors are there; 0: their bits stay 0. HARDENED 1: UPSET_STATUS
//             is there, and ffd_bus_stored has its copies, of which differs_o tells. ADDRESS_WIDTH
//             32 to 64, the bits of an address on the memory's bus: those above are 0 in settings,
//             whatever is written to them.
// Model:      tests/bus/axil/register_model.hpp.  Test: tests/bus/axil.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_bus_registers #(
  parameter WAITS         = 1,
  parameter MARKS         = 1,
  parameter HARDENED      = 0,
  parameter ADDRESS_WIDTH = 64
) (
  input  wire        clk,
  input  wire        rst,
  // While it is high, in reset and 16 clocks after, nothing may be valid.
  output wire        s_clearing,

  // A write acts in the clock of its valid and is answered in it; its word comes a clock before.
  input  wire        s_write_valid,
  input  wire [9:0]  s_write_word,
  input  wire [31:0] s_write_data,
  input  wire [3:0]  s_write_strobe,
  output wire        s_write_error,

  // A read is answered in the clock of its valid; its word comes a clock before.
  input  wire        s_read_valid,
  input  wire [9:0]  s_read_word,
  output wire [31:0] s_read_data,
  output wire        s_read_error,
  output wire        differs_o,
  input  wire [7:0]  config_org_i,
  input  wire [7:0]  config_n_i,
  input  wire [7:0]  config_format_i,
  input  wire        config_schedule_i,
  input  wire [1:0]  config_evaluator_i,
  input  wire [15:0] limits_in_flight_i,
  input  wire [7:0]  limits_points_axis_i,
  input  wire [5:0]  limits_grid_limit_i,
  output reg         control_start_o,
  output reg         control_soft_reset_o,
  output reg         control_clear_counters_o,
  output reg         control_stop_grid_o,
  input  wire        status_busy_i,
  input  wire        status_idle_i,
  input  wire        status_stopped_i,
  input  wire        status_ring_running_i,
  input  wire        status_done_set_i,
  input  wire        features_pages_i,
  input  wire        features_large_i,
  input  wire        features_fourth_i,
  input  wire        features_spans_i,
  input  wire        features_grids_i,
  input  wire        features_packed_i,
  input  wire        features_marks_i,
  input  wire        features_resident_i,
  input  wire        features_interleaved_i,
  input  wire        features_derivatives_i,
  input  wire        features_determinant_i,
  input  wire        features_halves_i,
  input  wire [15:0] limits2_pages_i,
  input  wire [7:0]  limits2_spans_i,
  input  wire [5:0]  limits2_count_width_i,
  input  wire        limits2_hardened_i,
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
  input  wire        counter_vertices_second_i,
  input  wire        counter_stalls_event_i,
  input  wire        counter_stalls_second_i,
  input  wire        counter_busy_event_i,
  input  wire        counter_busy_second_i,
  input  wire [31:0] wait_input_i,
  input  wire [31:0] wait_memory_i,
  input  wire [31:0] wait_evaluator_i,
  input  wire [31:0] wait_read_i,
  input  wire [31:0] wait_write_i,
  input  wire        error_any_i,
  input  wire [29:0] error_event_i,
  input  wire [31:0] error_packet_i,
  input  wire [31:0] error_beat_i,
  input  wire        error_address_valid_i,
  input  wire [63:0] error_address_i,
  input  wire        upset_status_memory_set_i,
  input  wire        upset_status_state_set_i,
  input  wire        upset_status_window_set_i,
  input  wire        upset_status_burst_set_i,
  input  wire        upset_status_copy_set_i,
  output reg         irq_enable_done_o,
  output reg         irq_enable_error_o,
  output reg         irq_enable_refused_o,
  output reg         irq_enable_packet_o,
  output reg         irq_enable_descriptor_o,
  input  wire        irq_state_packet_set_i,
  input  wire        irq_state_descriptor_set_i,
  output reg         irq_o
);
  // The bits that a write sets: partial strobes leave the other bytes alone.
  wire [31:0] ones = s_write_data &
    {{8 {s_write_strobe[3]}}, {8 {s_write_strobe[2]}}, {8 {s_write_strobe[1]}},
     {8 {s_write_strobe[0]}}};
  // What the high half of an address may hold.
  localparam [63:0] MOST = 64'hffff_ffff_ffff_ffff >> (64 - ADDRESS_WIDTH);
  localparam [31:0] HIGH = MOST[63:32];
  wire [31:0] high_data = s_write_data & HIGH;

  reg to_open_q;
  reg to_locked_q;
  reg to_control_q;
  reg to_status_q;
  reg to_ring_base_lo_q;
  reg to_ring_base_hi_q;
  reg to_ring_log2_size_q;
  reg to_ring_head_q;
  reg to_result_base_lo_q;
  reg to_result_base_hi_q;
  reg to_result_size_q;
  reg to_read_window_base_lo_q;
  reg to_read_window_base_hi_q;
  reg to_read_window_limit_lo_q;
  reg to_read_window_limit_hi_q;
  reg to_write_window_base_lo_q;
  reg to_write_window_base_hi_q;
  reg to_write_window_limit_lo_q;
  reg to_write_window_limit_hi_q;
  reg to_window_lock_q;
  reg to_error_status_q;
  reg to_error_first_q;
  reg to_upset_status_q;
  reg to_irq_enable_q;
  reg to_irq_state_q;
  reg to_irq_test_q;
  reg at_stored_q;
  reg at_id_q;
  reg at_version_q;
  reg at_config_q;
  reg at_limits_q;
  reg at_control_q;
  reg at_status_q;
  reg at_features_q;
  reg at_limits2_q;
  reg at_ring_log2_size_q;
  reg at_ring_head_q;
  reg at_ring_tail_q;
  reg at_result_count_q;
  reg at_window_lock_q;
  reg at_counter_vertices_lo_q;
  reg at_counter_vertices_hi_q;
  reg at_counter_stalls_lo_q;
  reg at_counter_stalls_hi_q;
  reg at_counter_busy_lo_q;
  reg at_counter_busy_hi_q;
  reg at_wait_input_q;
  reg at_wait_memory_q;
  reg at_wait_evaluator_q;
  reg at_wait_forming_q;
  reg at_wait_read_q;
  reg at_wait_write_q;
  reg at_error_status_q;
  reg at_error_count_q;
  reg at_error_first_q;
  reg at_error_packet_q;
  reg at_error_beat_q;
  reg at_error_address_lo_q;
  reg at_error_address_hi_q;
  reg at_upset_status_q;
  reg at_irq_enable_q;
  reg at_irq_state_q;
  reg at_irq_test_q;

  always @(posedge clk) begin
    to_open_q <= s_write_word == 10'h004 || s_write_word == 10'h005 || s_write_word == 10'h010 ||
      s_write_word == 10'h011 || s_write_word == 10'h012 || s_write_word == 10'h013 ||
      s_write_word == 10'h018 || s_write_word == 10'h019 || s_write_word == 10'h01a ||
      s_write_word == 10'h028 || s_write_word == 10'h040 || s_write_word == 10'h042 ||
      (HARDENED != 0 && s_write_word == 10'h047) || s_write_word == 10'h050 ||
      s_write_word == 10'h051 || s_write_word == 10'h052;
    to_locked_q <= s_write_word == 10'h020 || s_write_word == 10'h021 || s_write_word == 10'h022 ||
      s_write_word == 10'h023 || s_write_word == 10'h024 || s_write_word == 10'h025 ||
      s_write_word == 10'h026 || s_write_word == 10'h027;
    to_control_q <= s_write_word == 10'h004;
    to_status_q <= s_write_word == 10'h005;
    to_ring_base_lo_q <= s_write_word == 10'h010;
    to_ring_base_hi_q <= s_write_word == 10'h011;
    to_ring_log2_size_q <= s_write_word == 10'h012;
    to_ring_head_q <= s_write_word == 10'h013;
    to_result_base_lo_q <= s_write_word == 10'h018;
    to_result_base_hi_q <= s_write_word == 10'h019;
    to_result_size_q <= s_write_word == 10'h01a;
    to_read_window_base_lo_q <= s_write_word == 10'h020;
    to_read_window_base_hi_q <= s_write_word == 10'h021;
    to_read_window_limit_lo_q <= s_write_word == 10'h022;
    to_read_window_limit_hi_q <= s_write_word == 10'h023;
    to_write_window_base_lo_q <= s_write_word == 10'h024;
    to_write_window_base_hi_q <= s_write_word == 10'h025;
    to_write_window_limit_lo_q <= s_write_word == 10'h026;
    to_write_window_limit_hi_q <= s_write_word == 10'h027;
    to_window_lock_q <= s_write_word == 10'h028;
    to_error_status_q <= s_write_word == 10'h040;
    to_error_first_q <= s_write_word == 10'h042;
    to_upset_status_q <= HARDENED != 0 && s_write_word == 10'h047;
    to_irq_enable_q <= s_write_word == 10'h050;
    to_irq_state_q <= s_write_word == 10'h051;
    to_irq_test_q <= s_write_word == 10'h052;
    at_stored_q <= s_read_word == 10'h010 || s_read_word == 10'h011 || s_read_word == 10'h018 ||
      s_read_word == 10'h019 || s_read_word == 10'h01a || s_read_word == 10'h020 ||
      s_read_word == 10'h021 || s_read_word == 10'h022 || s_read_word == 10'h023 ||
      s_read_word == 10'h024 || s_read_word == 10'h025 || s_read_word == 10'h026 ||
      s_read_word == 10'h027;
    at_id_q <= s_read_word == 10'h000;
    at_version_q <= s_read_word == 10'h001;
    at_config_q <= s_read_word == 10'h002;
    at_limits_q <= s_read_word == 10'h003;
    at_control_q <= s_read_word == 10'h004;
    at_status_q <= s_read_word == 10'h005;
    at_features_q <= s_read_word == 10'h006;
    at_limits2_q <= s_read_word == 10'h007;
    at_ring_log2_size_q <= s_read_word == 10'h012;
    at_ring_head_q <= s_read_word == 10'h013;
    at_ring_tail_q <= s_read_word == 10'h014;
    at_result_count_q <= s_read_word == 10'h01b;
    at_window_lock_q <= s_read_word == 10'h028;
    at_counter_vertices_lo_q <= s_read_word == 10'h030;
    at_counter_vertices_hi_q <= s_read_word == 10'h031;
    at_counter_stalls_lo_q <= s_read_word == 10'h032;
    at_counter_stalls_hi_q <= s_read_word == 10'h033;
    at_counter_busy_lo_q <= s_read_word == 10'h034;
    at_counter_busy_hi_q <= s_read_word == 10'h035;
    at_wait_input_q <= WAITS != 0 && s_read_word == 10'h036;
    at_wait_memory_q <= WAITS != 0 && s_read_word == 10'h037;
    at_wait_evaluator_q <= WAITS != 0 && s_read_word == 10'h038;
    at_wait_forming_q <= WAITS != 0 && s_read_word == 10'h039;
    at_wait_read_q <= WAITS != 0 && s_read_word == 10'h03a;
    at_wait_write_q <= WAITS != 0 && s_read_word == 10'h03b;
    at_error_status_q <= s_read_word == 10'h040;
    at_error_count_q <= s_read_word == 10'h041;
    at_error_first_q <= s_read_word == 10'h042;
    at_error_packet_q <= s_read_word == 10'h043;
    at_error_beat_q <= s_read_word == 10'h044;
    at_error_address_lo_q <= s_read_word == 10'h045;
    at_error_address_hi_q <= s_read_word == 10'h046;
    at_upset_status_q <= HARDENED != 0 && s_read_word == 10'h047;
    at_irq_enable_q <= s_read_word == 10'h050;
    at_irq_state_q <= s_read_word == 10'h051;
    at_irq_test_q <= s_read_word == 10'h052;
  end

  wire write_control = s_write_valid && to_control_q;
  wire write_status = s_write_valid && to_status_q;
  wire write_ring_base_lo = s_write_valid && to_ring_base_lo_q;
  wire write_ring_base_hi = s_write_valid && to_ring_base_hi_q;
  wire write_ring_log2_size = s_write_valid && to_ring_log2_size_q;
  wire write_ring_head = s_write_valid && to_ring_head_q;
  wire write_result_base_lo = s_write_valid && to_result_base_lo_q;
  wire write_result_base_hi = s_write_valid && to_result_base_hi_q;
  wire write_result_size = s_write_valid && to_result_size_q;
  wire write_read_window_base_lo = s_write_valid && to_read_window_base_lo_q &&
    !window_lock_windows_o;
  wire write_read_window_base_hi = s_write_valid && to_read_window_base_hi_q &&
    !window_lock_windows_o;
  wire write_read_window_limit_lo = s_write_valid && to_read_window_limit_lo_q &&
    !window_lock_windows_o;
  wire write_read_window_limit_hi = s_write_valid && to_read_window_limit_hi_q &&
    !window_lock_windows_o;
  wire write_write_window_base_lo = s_write_valid && to_write_window_base_lo_q &&
    !window_lock_windows_o;
  wire write_write_window_base_hi = s_write_valid && to_write_window_base_hi_q &&
    !window_lock_windows_o;
  wire write_write_window_limit_lo = s_write_valid && to_write_window_limit_lo_q &&
    !window_lock_windows_o;
  wire write_write_window_limit_hi = s_write_valid && to_write_window_limit_hi_q &&
    !window_lock_windows_o;
  wire write_window_lock = s_write_valid && to_window_lock_q;
  wire write_error_status = s_write_valid && to_error_status_q;
  wire write_error_first = s_write_valid && to_error_first_q;
  wire write_upset_status = s_write_valid && to_upset_status_q;
  wire write_irq_enable = s_write_valid && to_irq_enable_q;
  wire write_irq_state = s_write_valid && to_irq_state_q;
  wire write_irq_test = s_write_valid && to_irq_test_q;
  reg status_done_q;
  reg status_start_refused_q;
  wire [63:0] counter_vertices;
  wire [63:0] counter_stalls;
  wire [63:0] counter_busy;
  reg [29:0] error_status_q;
  reg error_first_valid_q;
  reg upset_status_memory_q;
  reg upset_status_state_q;
  reg upset_status_window_q;
  reg upset_status_burst_q;
  reg upset_status_copy_q;
  reg irq_state_done_q;
  reg irq_state_error_q;
  reg irq_state_refused_q;
  reg irq_state_packet_q;
  reg irq_state_descriptor_q;
  wire control_start_asked = write_control && ones[0];
  wire control_start_blocked = status_busy_i || status_stopped_i || !window_lock_windows_o ||
    control_start_o;
  wire control_start_refused = control_start_asked && control_start_blocked;
  wire status_done_set = status_done_set_i;
  wire status_done_held = status_done_q && !(write_status && ones[8]);
  wire status_start_refused_set = control_start_refused;
  wire status_start_refused_held = status_start_refused_q && !(write_status && ones[9]);
  wire [29:0] error_status_held = error_status_q & ~(ones[29:0] & {30 {write_error_status}});
  wire upset_status_memory_set = upset_status_memory_set_i;
  wire upset_status_memory_held = upset_status_memory_q && !(write_upset_status && ones[0]);
  wire upset_status_state_set = upset_status_state_set_i;
  wire upset_status_state_held = upset_status_state_q && !(write_upset_status && ones[1]);
  wire upset_status_window_set = upset_status_window_set_i;
  wire upset_status_window_held = upset_status_window_q && !(write_upset_status && ones[2]);
  wire upset_status_burst_set = upset_status_burst_set_i;
  wire upset_status_burst_held = upset_status_burst_q && !(write_upset_status && ones[3]);
  wire upset_status_copy_set = upset_status_copy_set_i;
  wire upset_status_copy_held = upset_status_copy_q && !(write_upset_status && ones[4]);
  wire irq_state_packet_set = irq_state_packet_set_i || (write_irq_test && ones[3]);
  wire irq_state_packet_held = irq_state_packet_q && !(write_irq_state && ones[3]);
  wire irq_state_descriptor_set = irq_state_descriptor_set_i || (write_irq_test && ones[4]);
  wire irq_state_descriptor_held = irq_state_descriptor_q && !(write_irq_state && ones[4]);
  wire error_first_valid_set = error_any_i;
  wire error_first_valid_held = error_first_valid_q && !(write_error_first && ones[31]);
  wire irq_state_done_set = status_done_set || (write_irq_test && ones[0]);
  wire irq_state_done_held = irq_state_done_q && !(write_irq_state && ones[0]);
  wire irq_state_error_set = error_any_i || (write_irq_test && ones[1]);
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
  reg  [3:0]  write_slot_q;
  reg  [3:0]  read_slot_q;
  wire        clearing;
  wire [31:0] stored_word;
  wire write_stored = write_ring_base_lo || write_ring_base_hi || write_result_base_lo ||
    write_result_base_hi || write_result_size || write_read_window_base_lo ||
    write_read_window_base_hi || write_read_window_limit_lo || write_read_window_limit_hi ||
    write_write_window_base_lo || write_write_window_base_hi || write_write_window_limit_lo ||
    write_write_window_limit_hi;
  wire write_high = write_ring_base_hi || write_result_base_hi || write_read_window_base_hi ||
    write_read_window_limit_hi || write_write_window_base_hi || write_write_window_limit_hi;

  always @* begin
    case (s_write_word[9:2])
      8'h06: write_block = 2'd1;
      8'h08: write_block = 2'd2;
      8'h09: write_block = 2'd3;
      default: write_block = 2'd0;
    endcase
    case (s_read_word[9:2])
      8'h06: read_block = 2'd1;
      8'h08: read_block = 2'd2;
      8'h09: read_block = 2'd3;
      default: read_block = 2'd0;
    endcase
  end

  assign s_clearing = rst || clearing;

  always @(posedge clk) begin
    write_slot_q <= {write_block, s_write_word[1:0]};
    read_slot_q  <= {read_block, s_read_word[1:0]};
  end

  ffd_bus_stored #(
    .WORDS   (16),
    .HARDENED(HARDENED)
  ) u_stored (
    .clk           (clk),
    .rst           (rst),
    .clearing_o    (clearing),
    .differs_o     (differs_o),
    .write_i       (write_stored),
    .write_slot_i  (write_slot_q),
    .write_data_i  (write_high ? high_data : s_write_data),
    .write_strobe_i(s_write_strobe),
    .read_slot_i   (read_slot_q),
    .word_o        (stored_word)
  );

  ffd_bus_errors #(
    .CODES(30)
  ) u_errors (
    .clk            (clk),
    .rst            (rst),
    .any_i          (error_any_i),
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

  ffd_bus_counter u_counter_vertices (
    .clk     (clk),
    .rst     (rst),
    .event_i (counter_vertices_event_i),
    .second_i(counter_vertices_second_i),
    .clear_i (control_clear_counters_o),
    .latch_i (s_read_valid && at_counter_vertices_lo_q),
    .low_o   (counter_vertices[31:0]),
    .high_o  (counter_vertices[63:32])
  );

  ffd_bus_counter u_counter_stalls (
    .clk     (clk),
    .rst     (rst),
    .event_i (counter_stalls_event_i),
    .second_i(counter_stalls_second_i),
    .clear_i (control_clear_counters_o),
    .latch_i (s_read_valid && at_counter_stalls_lo_q),
    .low_o   (counter_stalls[31:0]),
    .high_o  (counter_stalls[63:32])
  );

  ffd_bus_counter u_counter_busy (
    .clk     (clk),
    .rst     (rst),
    .event_i (counter_busy_event_i),
    .second_i(counter_busy_second_i),
    .clear_i (control_clear_counters_o),
    .latch_i (s_read_valid && at_counter_busy_lo_q),
    .low_o   (counter_busy[31:0]),
    .high_o  (counter_busy[63:32])
  );

  // 0x010 CONTROL
  always @(posedge clk) begin
    if (rst) begin
      control_start_o <= 1'b0;
      control_soft_reset_o <= 1'b0;
      control_clear_counters_o <= 1'b0;
      control_stop_grid_o <= 1'b0;
    end else begin
      control_start_o <= control_start_asked && !control_start_blocked;
      control_soft_reset_o <= write_control && ones[1];
      control_clear_counters_o <= write_control && ones[2];
      control_stop_grid_o <= write_control && ones[3];
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
        if (s_write_strobe[0]) ring_base_o[7:0] <= s_write_data[7:0];
        if (s_write_strobe[1]) ring_base_o[15:8] <= s_write_data[15:8];
        if (s_write_strobe[2]) ring_base_o[23:16] <= s_write_data[23:16];
        if (s_write_strobe[3]) ring_base_o[31:24] <= s_write_data[31:24];
      end
    end
  end

  // 0x044 RING_BASE_HI
  always @(posedge clk) begin
    if (rst) begin
      ring_base_o[63:32] <= 32'h0;
    end else begin
      if (write_ring_base_hi) begin
        if (s_write_strobe[0]) ring_base_o[39:32] <= high_data[7:0];
        if (s_write_strobe[1]) ring_base_o[47:40] <= high_data[15:8];
        if (s_write_strobe[2]) ring_base_o[55:48] <= high_data[23:16];
        if (s_write_strobe[3]) ring_base_o[63:56] <= high_data[31:24];
      end
    end
  end

  // 0x048 RING_LOG2_SIZE
  always @(posedge clk) begin
    if (rst) begin
      ring_log2_size_o <= 4'h0;
    end else begin
      if (write_ring_log2_size) begin
        if (s_write_strobe[0]) ring_log2_size_o[3:0] <= s_write_data[3:0];
      end
    end
  end

  // 0x04C RING_HEAD
  always @(posedge clk) begin
    if (rst) begin
      ring_head_o <= 16'h0;
    end else begin
      if (write_ring_head) begin
        if (s_write_strobe[0]) ring_head_o[7:0] <= s_write_data[7:0];
        if (s_write_strobe[1]) ring_head_o[15:8] <= s_write_data[15:8];
      end
    end
  end

  // 0x060 RESULT_BASE_LO
  always @(posedge clk) begin
    if (rst) begin
      result_base_o[31:0] <= 32'h0;
    end else begin
      if (write_result_base_lo) begin
        if (s_write_strobe[0]) result_base_o[7:0] <= s_write_data[7:0];
        if (s_write_strobe[1]) result_base_o[15:8] <= s_write_data[15:8];
        if (s_write_strobe[2]) result_base_o[23:16] <= s_write_data[23:16];
        if (s_write_strobe[3]) result_base_o[31:24] <= s_write_data[31:24];
      end
    end
  end

  // 0x064 RESULT_BASE_HI
  always @(posedge clk) begin
    if (rst) begin
      result_base_o[63:32] <= 32'h0;
    end else begin
      if (write_result_base_hi) begin
        if (s_write_strobe[0]) result_base_o[39:32] <= high_data[7:0];
        if (s_write_strobe[1]) result_base_o[47:40] <= high_data[15:8];
        if (s_write_strobe[2]) result_base_o[55:48] <= high_data[23:16];
        if (s_write_strobe[3]) result_base_o[63:56] <= high_data[31:24];
      end
    end
  end

  // 0x068 RESULT_SIZE
  always @(posedge clk) begin
    if (rst) begin
      result_size_o <= 32'h0;
    end else begin
      if (write_result_size) begin
        if (s_write_strobe[0]) result_size_o[7:0] <= s_write_data[7:0];
        if (s_write_strobe[1]) result_size_o[15:8] <= s_write_data[15:8];
        if (s_write_strobe[2]) result_size_o[23:16] <= s_write_data[23:16];
        if (s_write_strobe[3]) result_size_o[31:24] <= s_write_data[31:24];
      end
    end
  end

  // 0x080 READ_WINDOW_BASE_LO
  always @(posedge clk) begin
    if (rst) begin
      read_window_base_o[31:0] <= 32'h0;
    end else begin
      if (write_read_window_base_lo) begin
        if (s_write_strobe[0]) read_window_base_o[7:0] <= s_write_data[7:0];
        if (s_write_strobe[1]) read_window_base_o[15:8] <= s_write_data[15:8];
        if (s_write_strobe[2]) read_window_base_o[23:16] <= s_write_data[23:16];
        if (s_write_strobe[3]) read_window_base_o[31:24] <= s_write_data[31:24];
      end
    end
  end

  // 0x084 READ_WINDOW_BASE_HI
  always @(posedge clk) begin
    if (rst) begin
      read_window_base_o[63:32] <= 32'h0;
    end else begin
      if (write_read_window_base_hi) begin
        if (s_write_strobe[0]) read_window_base_o[39:32] <= high_data[7:0];
        if (s_write_strobe[1]) read_window_base_o[47:40] <= high_data[15:8];
        if (s_write_strobe[2]) read_window_base_o[55:48] <= high_data[23:16];
        if (s_write_strobe[3]) read_window_base_o[63:56] <= high_data[31:24];
      end
    end
  end

  // 0x088 READ_WINDOW_LIMIT_LO
  always @(posedge clk) begin
    if (rst) begin
      read_window_limit_o[31:0] <= 32'h0;
    end else begin
      if (write_read_window_limit_lo) begin
        if (s_write_strobe[0]) read_window_limit_o[7:0] <= s_write_data[7:0];
        if (s_write_strobe[1]) read_window_limit_o[15:8] <= s_write_data[15:8];
        if (s_write_strobe[2]) read_window_limit_o[23:16] <= s_write_data[23:16];
        if (s_write_strobe[3]) read_window_limit_o[31:24] <= s_write_data[31:24];
      end
    end
  end

  // 0x08C READ_WINDOW_LIMIT_HI
  always @(posedge clk) begin
    if (rst) begin
      read_window_limit_o[63:32] <= 32'h0;
    end else begin
      if (write_read_window_limit_hi) begin
        if (s_write_strobe[0]) read_window_limit_o[39:32] <= high_data[7:0];
        if (s_write_strobe[1]) read_window_limit_o[47:40] <= high_data[15:8];
        if (s_write_strobe[2]) read_window_limit_o[55:48] <= high_data[23:16];
        if (s_write_strobe[3]) read_window_limit_o[63:56] <= high_data[31:24];
      end
    end
  end

  // 0x090 WRITE_WINDOW_BASE_LO
  always @(posedge clk) begin
    if (rst) begin
      write_window_base_o[31:0] <= 32'h0;
    end else begin
      if (write_write_window_base_lo) begin
        if (s_write_strobe[0]) write_window_base_o[7:0] <= s_write_data[7:0];
        if (s_write_strobe[1]) write_window_base_o[15:8] <= s_write_data[15:8];
        if (s_write_strobe[2]) write_window_base_o[23:16] <= s_write_data[23:16];
        if (s_write_strobe[3]) write_window_base_o[31:24] <= s_write_data[31:24];
      end
    end
  end

  // 0x094 WRITE_WINDOW_BASE_HI
  always @(posedge clk) begin
    if (rst) begin
      write_window_base_o[63:32] <= 32'h0;
    end else begin
      if (write_write_window_base_hi) begin
        if (s_write_strobe[0]) write_window_base_o[39:32] <= high_data[7:0];
        if (s_write_strobe[1]) write_window_base_o[47:40] <= high_data[15:8];
        if (s_write_strobe[2]) write_window_base_o[55:48] <= high_data[23:16];
        if (s_write_strobe[3]) write_window_base_o[63:56] <= high_data[31:24];
      end
    end
  end

  // 0x098 WRITE_WINDOW_LIMIT_LO
  always @(posedge clk) begin
    if (rst) begin
      write_window_limit_o[31:0] <= 32'h0;
    end else begin
      if (write_write_window_limit_lo) begin
        if (s_write_strobe[0]) write_window_limit_o[7:0] <= s_write_data[7:0];
        if (s_write_strobe[1]) write_window_limit_o[15:8] <= s_write_data[15:8];
        if (s_write_strobe[2]) write_window_limit_o[23:16] <= s_write_data[23:16];
        if (s_write_strobe[3]) write_window_limit_o[31:24] <= s_write_data[31:24];
      end
    end
  end

  // 0x09C WRITE_WINDOW_LIMIT_HI
  always @(posedge clk) begin
    if (rst) begin
      write_window_limit_o[63:32] <= 32'h0;
    end else begin
      if (write_write_window_limit_hi) begin
        if (s_write_strobe[0]) write_window_limit_o[39:32] <= high_data[7:0];
        if (s_write_strobe[1]) write_window_limit_o[47:40] <= high_data[15:8];
        if (s_write_strobe[2]) write_window_limit_o[55:48] <= high_data[23:16];
        if (s_write_strobe[3]) write_window_limit_o[63:56] <= high_data[31:24];
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
      error_status_q <= 30'h0;
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

  // 0x11C UPSET_STATUS
  always @(posedge clk) begin
    if (rst) begin
      upset_status_memory_q <= 1'b0;
      upset_status_state_q <= 1'b0;
      upset_status_window_q <= 1'b0;
      upset_status_burst_q <= 1'b0;
      upset_status_copy_q <= 1'b0;
    end else begin
      upset_status_memory_q <= HARDENED != 0 && (upset_status_memory_set ||
        upset_status_memory_held);
      upset_status_state_q <= HARDENED != 0 && (upset_status_state_set || upset_status_state_held);
      upset_status_window_q <= HARDENED != 0 && (upset_status_window_set ||
        upset_status_window_held);
      upset_status_burst_q <= HARDENED != 0 && (upset_status_burst_set || upset_status_burst_held);
      upset_status_copy_q <= HARDENED != 0 && (upset_status_copy_set || upset_status_copy_held);
    end
  end

  // 0x140 IRQ_ENABLE
  always @(posedge clk) begin
    if (rst) begin
      irq_enable_done_o <= 1'h0;
      irq_enable_error_o <= 1'h0;
      irq_enable_refused_o <= 1'h0;
      irq_enable_packet_o <= 1'h0;
      irq_enable_descriptor_o <= 1'h0;
    end else begin
      if (write_irq_enable) begin
        if (s_write_strobe[0]) irq_enable_done_o <= s_write_data[0];
        if (s_write_strobe[0]) irq_enable_error_o <= s_write_data[1];
        if (s_write_strobe[0]) irq_enable_refused_o <= s_write_data[2];
        if (MARKS != 0 && s_write_strobe[0]) irq_enable_packet_o <= s_write_data[3];
        if (MARKS != 0 && s_write_strobe[0]) irq_enable_descriptor_o <= s_write_data[4];
      end
    end
  end

  // 0x144 IRQ_STATE
  always @(posedge clk) begin
    if (rst) begin
      irq_state_done_q <= 1'b0;
      irq_state_error_q <= 1'b0;
      irq_state_refused_q <= 1'b0;
      irq_state_packet_q <= 1'b0;
      irq_state_descriptor_q <= 1'b0;
    end else begin
      irq_state_done_q <= irq_state_done_set || irq_state_done_held;
      irq_state_error_q <= irq_state_error_set || irq_state_error_held;
      irq_state_refused_q <= irq_state_refused_set || irq_state_refused_held;
      irq_state_packet_q <= MARKS != 0 && (irq_state_packet_set || irq_state_packet_held);
      irq_state_descriptor_q <= MARKS != 0 && (irq_state_descriptor_set ||
        irq_state_descriptor_held);
    end
  end

  always @(posedge clk) begin
    if (rst) begin
      irq_o <= 1'b0;
    end else begin
      irq_o <=
        (irq_state_done_q && irq_enable_done_o) ||
        (irq_state_error_q && irq_enable_error_o) ||
        (irq_state_refused_q && irq_enable_refused_o) ||
        (irq_state_packet_q && irq_enable_packet_o) ||
        (irq_state_descriptor_q && irq_enable_descriptor_o);
    end
  end

  wire unused_ok = &{1'b0, ones};

  assign s_write_error = !(to_open_q || (to_locked_q && !window_lock_windows_o));

  assign s_read_data =
    ({32 {at_stored_q}} & stored_word) |
    ({32 {at_id_q}} & 32'h48464644) |
    ({32 {at_version_q}} & {16'h0, 8'h3, 8'h0}) |
    ({32 {at_config_q}} & {2'h0, config_evaluator_i, 3'h0, config_schedule_i, config_format_i,
      config_n_i, config_org_i}) |
    ({32 {at_limits_q}} & {2'h0, limits_grid_limit_i, limits_points_axis_i, limits_in_flight_i}) |
    ({32 {at_control_q}} & {28'h0, 1'b0, 1'b0, 1'b0, 1'b0}) |
    ({32 {at_status_q}} & {22'h0, status_start_refused_q, status_done_q, 4'h0,
      status_ring_running_i, status_stopped_i, status_idle_i, status_busy_i}) |
    ({32 {at_features_q}} & {19'h0, features_halves_i, features_determinant_i,
      features_derivatives_i, features_interleaved_i, features_resident_i, 1'h0, features_marks_i,
      features_packed_i, features_grids_i, features_spans_i, features_fourth_i, features_large_i,
      features_pages_i}) |
    ({32 {at_limits2_q}} & {1'h0, limits2_hardened_i, limits2_count_width_i, limits2_spans_i,
      limits2_pages_i}) |
    ({32 {at_ring_log2_size_q}} & {28'h0, ring_log2_size_o}) |
    ({32 {at_ring_head_q}} & {16'h0, ring_head_o}) |
    ({32 {at_ring_tail_q}} & {16'h0, ring_tail_i}) |
    ({32 {at_result_count_q}} & result_count_i) |
    ({32 {at_window_lock_q}} & {31'h0, window_lock_windows_o}) |
    ({32 {at_counter_vertices_lo_q}} & counter_vertices[31:0]) |
    ({32 {at_counter_vertices_hi_q}} & counter_vertices[63:32]) |
    ({32 {at_counter_stalls_lo_q}} & counter_stalls[31:0]) |
    ({32 {at_counter_stalls_hi_q}} & counter_stalls[63:32]) |
    ({32 {at_counter_busy_lo_q}} & counter_busy[31:0]) |
    ({32 {at_counter_busy_hi_q}} & counter_busy[63:32]) |
    ({32 {at_wait_input_q}} & wait_input_i) |
    ({32 {at_wait_memory_q}} & wait_memory_i) |
    ({32 {at_wait_evaluator_q}} & wait_evaluator_i) |
    ({32 {at_wait_forming_q}} & 32'h0) |
    ({32 {at_wait_read_q}} & wait_read_i) |
    ({32 {at_wait_write_q}} & wait_write_i) |
    ({32 {at_error_status_q}} & {2'h0, error_status_q}) |
    ({32 {at_error_count_q}} & log_count) |
    ({32 {at_error_first_q}} & {error_first_valid_q, 26'h0, log_code}) |
    ({32 {at_error_packet_q}} & log_packet) |
    ({32 {at_error_beat_q}} & log_beat) |
    ({32 {at_error_address_lo_q}} & log_address[31:0]) |
    ({32 {at_error_address_hi_q}} & log_address[63:32]) |
    ({32 {at_upset_status_q}} & {27'h0, upset_status_copy_q, upset_status_burst_q,
      upset_status_window_q, upset_status_state_q, upset_status_memory_q}) |
    ({32 {at_irq_enable_q}} & {27'h0, irq_enable_descriptor_o, irq_enable_packet_o,
      irq_enable_refused_o, irq_enable_error_o, irq_enable_done_o}) |
    ({32 {at_irq_state_q}} & {27'h0, irq_state_descriptor_q, irq_state_packet_q,
      irq_state_refused_q, irq_state_error_q, irq_state_done_q}) |
    ({32 {at_irq_test_q}} & {27'h0, 1'b0, 1'b0, 1'b0, 1'b0, 1'b0});
  assign s_read_error = !(at_stored_q || at_id_q || at_version_q || at_config_q || at_limits_q ||
    at_control_q || at_status_q || at_features_q || at_limits2_q || at_ring_log2_size_q ||
    at_ring_head_q || at_ring_tail_q || at_result_count_q || at_window_lock_q ||
    at_counter_vertices_lo_q || at_counter_vertices_hi_q || at_counter_stalls_lo_q ||
    at_counter_stalls_hi_q || at_counter_busy_lo_q || at_counter_busy_hi_q || at_wait_input_q ||
    at_wait_memory_q || at_wait_evaluator_q || at_wait_forming_q || at_wait_read_q ||
    at_wait_write_q || at_error_status_q || at_error_count_q || at_error_first_q ||
    at_error_packet_q || at_error_beat_q || at_error_address_lo_q || at_error_address_hi_q ||
    at_upset_status_q || at_irq_enable_q || at_irq_state_q || at_irq_test_q);
endmodule

`default_nettype wire
