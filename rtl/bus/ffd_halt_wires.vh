// Wires between ffd_dma_halt and the rest of the DMA (ffd_halt_connections.vh).
// SPDX-License-Identifier: Apache-2.0
wire clearing;
wire half_rst;
wire hold_read;
wire hold_write;
wire read_quiet;
wire read_open;
wire read_empty;
wire read_fault;
wire write_busy;
wire write_empty;
wire write_fault;
wire write_started;
wire ring_empty;
wire ring_started;
wire guard_rst;
wire guard_quiet_read;
wire guard_quiet_write;
wire guard_fault;
wire [4:0] late;
