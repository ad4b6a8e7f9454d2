// ffd_org_select: a netlist of standard cells in place of the module of rtl/
//
// For the study of energy only. The clock of the netlist stands still while the bench fills its
// memory of control points: those clocks need not be simulated.
//
// Parameters: none is handed on; the netlist was mapped with those of the bench.
// Model:      golden/include/hwffd/model/evaluator.hpp.  Test: lab/tests/energy.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`timescale 1ns/1ps
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_org_select #(
  parameter ORG             = 0,
  parameter FORMAT          = 18,
  parameter N               = 1,
  parameter PORTS           = `FFD_ORG_PORTS(ORG),
  `include "ffd_org_parameters.vh"
) (
  `include "ffd_org_ports.vh"
);
  wire clk_cells = clk && !ffd_bench_energy.asleep;

  generate
    if (1) begin : gen_cells
      wire clk = clk_cells;
      ffd_energy_netlist u_cells (
        `include "ffd_org_connections.vh"
      );
    end
  endgenerate
endmodule

`default_nettype wire
