"""Parts of ffd_axil_registers.v that stand around its fields (register_rtl.py): header, bus, settings
that are read from a memory, error record.

SPDX-License-Identifier: Apache-2.0
"""

BUS = """\
  input  wire        clk,
  input  wire        rst,
  `include "ffd_axil_ports.vh"
"""
HEADER = """\
// ffd_axil_registers: the registers of rtl/bus/registers.csv, from AXI4-Lite to the hardware
//
// {generated}
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
"""
SLAVE = """\
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
"""
STORED = """\
  // Settings of a whole word are read from a memory, in which four of them share a block.
  reg  {width:<6} write_block_q;
  reg  {width:<6} read_block_q;
  reg         write_stored_q;
  reg         read_stored_q;
  reg         write_high_q;
  wire [31:0] stored_word;

  always @(posedge clk) begin
    if (write_next) begin
{write_case}
{write_words}
{write_highs}
    end
    if (read_next) begin
{read_case}
{read_words}
    end
  end

  ffd_axil_stored #(
    .WORDS({words})
  ) u_stored (
    .clk           (clk),
    .rst           (rst),
    .clearing_o    (clearing),
    .write_i       (write && write_stored_q && !write_error),
    .write_slot_i  ({{write_block_q, write_word[1:0]}}),
    .write_data_i  (write_high_q ? high_data : write_data),
    .write_strobe_i(write_strobe),
    .read_slot_i   ({{read_block_q, read_word[1:0]}}),
    .word_o        (stored_word)
  );
"""
ERRORS = """\
  ffd_axil_errors #(
    .CODES({codes})
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
"""
