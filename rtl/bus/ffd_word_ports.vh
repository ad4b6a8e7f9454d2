// Ports of what is read and written in words of 32 bits, whatever the bus: docs/registers.md
// section 3. To be included in the list of a module's ports, more of which follow.
// SPDX-License-Identifier: Apache-2.0

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
