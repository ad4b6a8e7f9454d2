// formal_bus_run: ffd_bus_run behind the registers, with any software and any DMA and core
//
// What the DMA takes with a start is compared with what the registers held in the clock in which
// the start was written.
// registers_at_rest.vh, connections of what is only read, is made by proofs.py.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_events.vh"

module formal_bus_run (
  input wire        clk,
  input wire        rst,
  input wire        write,
  input wire [9:0]  word,
  input wire [31:0] data,
  input wire [3:0]  strobe,
  input wire        ring_running,
  input wire        write_error,
  input wire        fault,
  input wire        clearing,
  input wire        halted,
  input wire        dma_idle,
  input wire        core_idle
);
  wire        start;
  wire        soft_reset;
  wire        busy;
  wire        stopped;
  wire [63:0] result_base;
  wire [31:0] result_size;
  wire        result_start;
  wire        core_rst;

  ffd_bus_registers u_registers (
    .clk                     (clk),
    .rst                     (rst),
    .s_write_valid           (write),
    .s_write_word            (word),
    .s_write_data            (data),
    .s_write_strobe          (strobe),
    .s_read_valid            (1'b0),
    .s_read_word             (10'd0),
    `include "registers_at_rest.vh"
    .control_start_o         (start),
    .control_soft_reset_o    (soft_reset),
    .status_busy_i           (busy),
    .status_idle_i           (1'b0),
    .status_stopped_i        (stopped),
    .status_ring_running_i   (1'b0),
    .status_done_set_i       (1'b0),
    .result_base_o           (result_base),
    .result_size_o           (result_size),
    .counter_vertices_event_i(1'b0),
    .counter_stalls_event_i  (1'b0),
    .counter_busy_event_i    (1'b0),
    .counter_vertices_second_i(1'b0),
    .counter_stalls_second_i (1'b0),
    .counter_busy_second_i   (1'b0),
    .upset_status_memory_set_i(1'b0),
    .upset_status_state_set_i(1'b0),
    .upset_status_window_set_i(1'b0),
    .upset_status_burst_set_i(1'b0),
    .upset_status_copy_set_i(1'b0),
    .irq_state_packet_set_i  (1'b0),
    .irq_state_descriptor_set_i(1'b0),
    .error_any_i             (1'b0),
    .error_event_i           ({`FFD_ERRORS{1'b0}}),
    .error_packet_i          (32'd0),
    .error_beat_i            (32'd0),
    .error_address_valid_i   (1'b0),
    .error_address_i         (64'd0)
  );

  ffd_bus_run u_run (
    .clk             (clk),
    .rst             (rst),
    .start_i         (start),
    .soft_reset_i    (soft_reset),
    .ring_base_i     (64'd0),
    .ring_log2_size_i(4'd0),
    .ring_head_i     (16'd0),
    .busy_o          (busy),
    .stopped_o       (stopped),
    .result_start_o  (result_start),
    .ring_running_i  (ring_running),
    .write_error_i   (write_error),
    .dma_fault_i     (fault),
    .dma_clearing_i  (clearing),
    .dma_halted_i    (halted),
    .dma_idle_i      (dma_idle),
    .core_rst_o      (core_rst),
    .core_idle_i     (core_idle)
  );

  (* hierconn *) wire \u_registers.control_start_asked ;

  reg         first_q = 1'b1;
  reg         rst_q = 1'b0;
  reg         clear_q;       // the DMA cleared in the clock before, or a soft reset came
  reg  [95:0] area_q;        // base and size when a start was last written
  always @(posedge clk) begin
    first_q <= 1'b0;
    rst_q   <= rst;
    clear_q <= (clearing || soft_reset) && !rst;
    if (\u_registers.control_start_asked ) area_q <= {result_base, result_size};
  end
  always @* if (first_q) assume (rst);

  always @* if (!first_q) begin
    reset: assert (!rst_q || core_rst);
    cleared: assert (!clear_q || core_rst);
    area: assert (rst || !result_start || {result_base, result_size} == area_q);
  end
endmodule

`default_nettype wire
