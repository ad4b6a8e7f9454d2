// hwffd_wishbone: hwffd_axi with its registers on Wishbone B4
//
// The registers of docs/registers.md behind ffd_wb_slave; all else is that of hwffd_axi, the AXI4
// master to memory too.
//
// Formats, Pipeline, Cuts, Not checked: as hwffd_axi.
// Parameters: ffd_bus_parameters.vh: those of hwffd_axi, without SECURE_ONLY.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/bus/wb.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module hwffd_wishbone #(
  `include "ffd_bus_parameters.vh"
) (
  input  wire         aclk,
  input  wire         aresetn,
  output wire         irq_o,
  output wire         sleep_o,

  `include "ffd_wb_ports.vh"
  output wire [ID_WIDTH-1:0] m_axi_arid,
  output wire [ID_WIDTH-1:0] m_axi_awid,
  `include "ffd_axi_ports.vh"
);
  // Registers are read and written in words; not in reset and not while they are cleared.
  `include "ffd_word_wires.vh"

  ffd_bus_core #(
    `include "ffd_bus_arguments.vh"
  ) u_core (
    `include "ffd_bus_connections.vh"
  );

  assign upset = 1'b0;    // there is one slave only

  ffd_wb_slave #(
    .ADDRESS_W(12)
  ) u_slave (
    .clk           (aclk),
    .rst           (clearing),
    `include "ffd_wb_connections.vh"
    `include "ffd_word_master.vh"
  );
endmodule

`default_nettype wire
