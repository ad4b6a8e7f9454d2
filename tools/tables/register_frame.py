"""Parts of ffd_bus_registers.v that stand around its fields (register_rtl.py): header, words, settings
that are read from a memory, error record.

SPDX-License-Identifier: Apache-2.0
"""

BUS = """\
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
"""
HEADER = """\
// ffd_bus_registers: the registers of rtl/bus/registers.csv, from words to the hardware
//
// {generated}
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
"""
WORDS = """\
  // The bits that a write sets: partial strobes leave the other bytes alone.
  wire [31:0] ones = s_write_data &
    {{8 {s_write_strobe[3]}}, {8 {s_write_strobe[2]}}, {8 {s_write_strobe[1]}},
     {8 {s_write_strobe[0]}}};
  // What the high half of an address may hold.
  localparam [63:0] MOST = 64'hffff_ffff_ffff_ffff >> (64 - ADDRESS_WIDTH);
  localparam [31:0] HIGH = MOST[63:32];
  wire [31:0] high_data = s_write_data & HIGH;
"""
STORED = """\
  // Settings of a whole word are read from a memory, in which four of them share a block.
  reg  {width:<6} write_block;
  reg  {width:<6} read_block;
  reg  {slot:<6} write_slot_q;
  reg  {slot:<6} read_slot_q;
  wire        clearing;
  wire [31:0] stored_word;
{hits}
{high_hits}

  always @* begin
{write_case}
{read_case}
  end

  assign s_clearing = rst || clearing;

  always @(posedge clk) begin
    write_slot_q <= {{write_block, s_write_word[1:0]}};
    read_slot_q  <= {{read_block, s_read_word[1:0]}};
  end

  ffd_bus_stored #(
    .WORDS   ({words}),
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
"""
ERRORS = """\
  ffd_bus_errors #(
    .CODES({codes})
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
"""
