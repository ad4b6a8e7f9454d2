// hwffd_axi: the core in a system: commands from memory, results to memory, registers on AXI4-Lite
//
// The registers of docs/registers.md behind ffd_axil_slave; they start runs of the DMA
// (docs/interface.md section 8), which feeds hwffd_stream and writes down what comes out.
//
// Formats:    as hwffd_stream; addresses of ADDRESS_WIDTH bits, data of DATA_WIDTH.
// Pipeline:   as hwffd_stream behind the DMA's queues.
// Cuts:       every output leaves a register, or is a constant.
// Clock:      it may stop where sleep_o is 1 and no request is offered (docs/interface.md).
// Not checked: nothing on a bus can hang it but a slave that does not answer, and that only for
//             BUS_TIMEOUT clocks.
// Parameters: ffd_bus_parameters.vh: as in hwffd_stream, IN_FLIGHT below 65536 (register LIMITS);
//             MAX_BURST to FLUSH_CLOCKS as in ffd_dma_engine; BUS_TIMEOUT as in ffd_dma_watch;
//             AXI_PROT and AXI_CACHE, what the master drives on *prot (010: not secure) and *cache
//             (0010: normal, not cacheable, not bufferable); ADDRESS_WIDTH 32 to 64, an address
//             beyond being outside of every window; DATA_WIDTH 64, 128 or 256; ID_WIDTH 1 to 16
//             and ID, what the master drives on *id. SECURE_ONLY as in ffd_axil_slave. HARDENED 0,
//             or 1: bits that flip do no more than docs/assurance.md says.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/bus/axi.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module hwffd_axi #(
  parameter SECURE_ONLY = 0,
  `include "ffd_bus_parameters.vh"
) (
  input  wire         aclk,
  input  wire         aresetn,
  output wire         irq_o,
  output wire         sleep_o,

  `include "ffd_axil_ports.vh"
  output wire [ID_WIDTH-1:0] m_axi_arid,
  output wire [ID_WIDTH-1:0] m_axi_awid,
  `include "ffd_axi_ports.vh"
);
  // Registers are read and written in words; not in reset and not while they are cleared.
  `include "ffd_word_wires.vh"

  ffd_axil_voted #(
    .ADDRESS_W  (12),
    .SECURE_ONLY(SECURE_ONLY),
    .HARDENED   (HARDENED)
  ) u_slave (
    .clk           (aclk),
    .rst           (clearing),
    .differs_o     (upset),
    `include "ffd_axil_connections.vh"
    `include "ffd_word_master.vh"
  );

  ffd_bus_core #(
    `include "ffd_bus_arguments.vh"
  ) u_core (
    `include "ffd_bus_connections.vh"
  );
endmodule

`default_nettype wire
