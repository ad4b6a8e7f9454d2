// ffd_stream_readers: whether the bank and the buffer that are not in use are still read
//
// Vertices keep their order, and those that read what was in use before the last change are older
// than those that read what is in use now. So the bank that is not in use is free when a vertex has
// left that read the one in use, or when none is inside; the buffer likewise. A vertex is inside
// from its last beat on until at least the clock in which it leaves.
//
// Pipeline:   busy from the clock after the change until the clock after it became free.
// Model:      none (order only).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_stream_readers (
  input  wire clk,
  input  wire rst,
  input  wire leave_i,
  input  wire leave_bank_i,
  input  wire leave_buffer_i,
  input  wire leave_lattice_i,  // it has read that buffer
  input  wire new_bank_i,
  input  wire new_buffer_i,
  input  wire bank_i,           // in use
  input  wire buffer_i,
  input  wire inside_i,
  output reg  bank_busy_o,
  output reg  buffer_busy_o
);
  wire bank_left   = leave_i && leave_bank_i == bank_i;
  wire buffer_left = leave_i && leave_lattice_i && leave_buffer_i == buffer_i;

  always @(posedge clk) begin
    if (rst) begin
      bank_busy_o   <= 1'b0;
      buffer_busy_o <= 1'b0;
    end else begin
      bank_busy_o   <= inside_i && (new_bank_i || (bank_busy_o && !bank_left));
      buffer_busy_o <= inside_i && (new_buffer_i || (buffer_busy_o && !buffer_left));
    end
  end
endmodule

`default_nettype wire
