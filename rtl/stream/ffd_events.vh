// Made from rtl/bus/registers.csv by tools/tables/registers.py; changes here are lost.
// Events of the core and of its buses: bits of ERROR_STATUS (docs/registers.md).
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_EVENTS_VH
`define FFD_EVENTS_VH
`define FFD_EVENT_UNKNOWN_OPCODE       0
`define FFD_EVENT_PACKET_SHORT         1
`define FFD_EVENT_PACKET_LONG          2
`define FFD_EVENT_NO_COEFFICIENTS      3
`define FFD_EVENT_NO_LATTICE           4
`define FFD_EVENT_LATTICE_SIZE         5
`define FFD_EVENT_CELL_OUTSIDE         6
`define FFD_EVENT_COORDINATE_NAN       7
`define FFD_EVENT_COORDINATE_OUTSIDE   8
`define FFD_EVENT_SATURATED            9
`define FFD_EVENT_DMA_ZERO             10
`define FFD_EVENT_DMA_MISALIGNED       11
`define FFD_EVENT_DMA_WRAP             12
`define FFD_EVENT_DMA_WINDOW           13
`define FFD_EVENT_DMA_DESCRIPTOR       14
`define FFD_EVENT_DMA_READ_RESPONSE    15
`define FFD_EVENT_DMA_WRITE_RESPONSE   16
`define FFD_EVENT_RESULT_OVERFLOW      17
`define FFD_EVENT_DMA_RING             18
`define FFD_EVENT_TIMEOUT_AR           19
`define FFD_EVENT_TIMEOUT_R            20
`define FFD_EVENT_TIMEOUT_AW           21
`define FFD_EVENT_TIMEOUT_W            22
`define FFD_EVENT_TIMEOUT_B            23
`define FFD_EVENT_PAGE_POINTS          24
`define FFD_EVENT_SPAN_BEYOND          25
`define FFD_EVENT_NO_FOURTH            26
`define FFD_EVENT_GRID_COUNT           27
`define FFD_EVENT_FUNCTIONS_SUM        28
`define FFD_EVENT_PAGE_OVERFLOWED      29

// How many these are; how many of them are events of the stream, and which of those one is: a
// pulse of event_o each (docs/interface.md section 5).
`define FFD_ERRORS                     30
`define FFD_EVENTS                     16
`define FFD_STREAM_EVENT(BIT) \
  ((BIT) > `FFD_EVENT_SATURATED ? (BIT) - 14 : (BIT))
`endif
