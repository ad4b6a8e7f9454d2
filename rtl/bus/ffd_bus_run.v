// ffd_bus_run: a run of the DMA and the core, from start_i to done_o
//
// Between registers (ffd_bus_registers), DMA engine (ffd_dma_engine) and core (hwffd_stream).
// CHECK: the result area is offered to the DMA, which may refuse it; then the run ends. RUN: the
// ring is started, ring_head_o follows ring_head_i. The run ends when DMA and core have been idle
// for 8 clocks in which no new head came; after a fault of the bus (stopped_o), when the DMA has
// been halted that long. So between runs the ring has nothing to do, and it sees no new head. Base
// and size of the ring are taken by the start that finds it stopped, so that software cannot change
// them under it.
// soft_reset_i ends a run without done_o and clears stopped_o. It wins over start_i. core_rst_o,
// the reset of the whole core, follows rst and the DMA's clearing a clock later, from a register.
// rst lasts two clocks at least, so that none of the core's results outlives it.
//
// Pipeline:   start_i to result_start_o 0 clocks, so that the DMA takes the area as it was when
//             start_i was given; to ring_start_o 9; the end to done_o 9.
// Not checked: that rst lasts two clocks; start_i while busy_o or stopped_o is 1 (the registers
//             refuse it).
// Needs:      the DMA refuses an area at most 7 clocks after result_start_o; an idle DMA or core
//             that has something handed to it shows it at most 7 clocks later.
// Parameters: HARDENED 0, or 1: a state that is none of the three ends the run at once, as a fault
//             does, with upset_o, a pulse.
// Model:      none (control only).  Test: tests/bus/axil/run_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_bus_run #(
  parameter HARDENED = 0
) (
  input  wire        clk,
  input  wire        rst,
  // registers
  input  wire        start_i,
  input  wire        soft_reset_i,
  input  wire [63:0] ring_base_i,
  input  wire [3:0]  ring_log2_size_i,
  input  wire [15:0] ring_head_i,
  output wire        busy_o,
  output wire        idle_o,
  output wire        stopped_o,
  output reg         done_o,
  output wire        upset_o,
  // DMA engine
  output reg         ring_start_o,
  output reg  [63:0] ring_base_o,
  output reg  [3:0]  ring_entries_log2_o,
  output reg  [15:0] ring_head_o,
  output wire        result_start_o,
  input  wire        ring_running_i,
  input  wire        write_error_i,
  input  wire        dma_fault_i,
  input  wire        dma_clearing_i,
  input  wire        dma_halted_i,
  input  wire        dma_idle_i,
  // core
  output reg         core_rst_o,
  input  wire        core_idle_i
);
  localparam [1:0] IDLE  = 2'd0;
  localparam [1:0] CHECK = 2'd1;
  localparam [1:0] RUN   = 2'd2;

  reg  [1:0] state_q;
  reg  [2:0] count_q;
  reg        stopped_q;
  wire       clear   = soft_reset_i || dma_clearing_i;
  wire       quiet   = stopped_q ? dma_halted_i : dma_idle_i && core_idle_i;
  wire       moves   = ring_head_o != ring_head_i;  // of which the DMA cannot show anything yet
  wire       settled = count_q == 3'd7;
  wire       accept  = state_q == IDLE && start_i && !clear;
  wire       checked = state_q == CHECK && settled && !write_error_i && !clear;
  wire       refused = state_q == CHECK && write_error_i && !clear;
  wire       ended   = state_q == RUN && settled && quiet && !clear;
  wire       illegal = HARDENED != 0 && state_q == 2'd3 && !clear;

  assign busy_o    = state_q != IDLE || clear;
  assign idle_o    = dma_idle_i && core_idle_i && !clear;
  assign stopped_o = stopped_q;
  assign upset_o   = illegal;
  assign result_start_o = accept;

  always @(posedge clk) core_rst_o <= rst || clear;

  always @(posedge clk) begin
    if (rst || clear) state_q <= IDLE;
    else if (accept) state_q <= CHECK;
    else if (checked) state_q <= RUN;
    else if (refused || ended || illegal) state_q <= IDLE;
  end

  always @(posedge clk) begin
    if (rst || accept || checked || (state_q == RUN && (!quiet || moves))) count_q <= 3'd0;
    else if (!settled) count_q <= count_q + 3'd1;
  end

  always @(posedge clk) begin
    stopped_q <= !rst && !clear && (stopped_q || dma_fault_i || illegal);
  end

  always @(posedge clk) begin
    if (rst) begin
      done_o       <= 1'b0;
      ring_start_o <= 1'b0;
    end else begin
      done_o       <= refused || ended || illegal;
      ring_start_o <= checked;
    end
  end

  always @(posedge clk) begin
    if (accept && !ring_running_i) begin
      ring_base_o         <= ring_base_i;
      ring_entries_log2_o <= ring_log2_size_i;
    end
    if (checked || (state_q == RUN && !ended)) ring_head_o <= ring_head_i;
  end
endmodule

`default_nettype wire
