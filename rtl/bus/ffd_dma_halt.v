// ffd_dma_halt: when the halves of the DMA hold, end and are reset
//
// What ffd_dma_engine says of soft resets, bus errors and time-outs. hold_read_o, hold_write_o: no
// new address of that half. soft_o: a soft reset goes on, until what is open has been answered or
// is late; half_rst_o, the reset of the halves, is its last clock, or rst and a clock more.
// With HARDENED it is the guard of the bus that knows what is open, and its fault is one like a
// time-out, which waits for nothing but the guard. guard_rst_o: rst, and the end of a soft reset.
//
// Pipeline:   holds a clock after the fault; halted_o and idle_o a clock after what they say.
// Parameters: HARDENED 0 or 1.
// Model:      none (control only).  Test: tests/bus/dma, tests/bus/axi.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_dma_halt #(
  parameter HARDENED = 0
) (
  input  wire       clk,
  input  wire       rst,
  input  wire       soft_reset_i,
  input  wire       read_quiet_i,
  input  wire       read_open_i,
  input  wire       read_empty_i,
  input  wire       read_fault_i,
  input  wire       write_busy_i,
  input  wire       write_empty_i,
  input  wire       write_fault_i,
  input  wire       write_started_i,
  input  wire       ring_empty_i,
  input  wire       ring_started_i,
  input  wire       ring_running_i,
  input  wire       result_running_i,
  input  wire [4:0] late_i,
  input  wire [4:0] timeout_i,
  input  wire       guard_quiet_read_i,
  input  wire       guard_quiet_write_i,
  input  wire       guard_fault_i,
  output wire       guard_rst_o,
  output wire       soft_o,
  output wire       half_rst_o,
  output wire       hold_read_o,
  output wire       hold_write_o,
  output wire       fault_o,
  output reg        idle_o,
  output reg        halted_o
);
  reg  soft_q;
  reg  hold_read_q;
  reg  hold_write_q;
  reg  late_q;
  reg  cleared_q;    // a soft reset has ended, or rst, which lasts a clock longer inside
  reg  fault_q;      // that of the guard is known
  wire half_rst   = rst || cleared_q;
  wire read_late  = |late_i[1:0];
  wire write_late = |late_i[4:2];
  wire read_ends  = (HARDENED != 0 ? guard_quiet_read_i : read_quiet_i) || read_late;
  wire write_ends = (HARDENED != 0 ? guard_quiet_write_i : !write_busy_i) || write_late;

  always @(posedge clk) begin
    cleared_q <= rst || (soft_q && read_ends && write_ends && !cleared_q);
    if (half_rst) begin
      soft_q       <= soft_reset_i && !rst;
      hold_read_q  <= 1'b0;
      hold_write_q <= 1'b0;
      late_q       <= 1'b0;
      fault_q      <= 1'b0;
    end else begin
      soft_q       <= soft_q || soft_reset_i;
      hold_read_q  <= write_fault_i || (hold_read_q && !write_started_i);
      hold_write_q <= read_fault_i || (hold_write_q && !ring_started_i);
      late_q       <= late_q || late_i != 5'd0 || guard_fault_i;
      fault_q      <= guard_fault_i;
    end
  end

  assign soft_o       = soft_q;
  assign half_rst_o   = half_rst;
  assign hold_read_o  = hold_read_q || late_q;
  assign hold_write_o = hold_write_q || late_q;
  assign guard_rst_o  = rst || (cleared_q && soft_q);
  assign fault_o      = read_fault_i || write_fault_i || timeout_i != 5'd0
                     || (guard_fault_i && !fault_q);

  wire read_over  = (guard_fault_i ? guard_quiet_read_i : !read_open_i) || read_late;
  wire write_over = (guard_fault_i ? guard_quiet_write_i : !write_busy_i) || write_late;
  always @(posedge clk) begin
    halted_o <= read_over && write_over && !half_rst
             && (late_q || (hold_write_q && !ring_running_i) || (hold_read_q && !result_running_i));
    idle_o   <= !soft_q && ring_empty_i && read_quiet_i && read_empty_i && !write_busy_i
             && write_empty_i;
  end
endmodule

`default_nettype wire
