// Wires between the bus of the registers and the core behind it (ffd_word_ports.vh).
// SPDX-License-Identifier: Apache-2.0
wire        clearing;
wire        awake;
wire        upset;
wire        write_valid;
wire [9:0]  write_word;
wire [31:0] write_data;
wire [3:0]  write_strobe;
wire        write_error;
wire        read_valid;
wire [9:0]  read_word;
wire [31:0] read_data;
wire        read_error;
