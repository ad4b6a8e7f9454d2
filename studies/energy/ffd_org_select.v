// ffd_org_select: a netlist of standard cells in place of the module of rtl/
//
// For the study of energy only. The clock of the netlist stands still while the bench fills its
// memory of control points: those clocks need not be simulated.
//
// Parameters: none is handed on; the netlist was mapped with those of the bench.
// Model:      golden/include/hwffd/model/evaluator.hpp.  Test: tests/studies/energy.
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

  ffd_energy_netlist u_cells (
    .clk                 (clk_cells),
    .rst                 (rst),
    .load_i              (load_i),
    .load_axis_i         (load_axis_i),
    .load_address_i      (load_address_i),
    .load_entry_i        (load_entry_i),
    .s_vertex_valid      (s_vertex_valid),
    .s_vertex_ready      (s_vertex_ready),
    .s_vertex_coordinates(s_vertex_coordinates),
    .s_vertex_cell       (s_vertex_cell),
    .s_vertex_source     (s_vertex_source),
    .s_vertex_bank       (s_vertex_bank),
    .s_vertex_changed    (s_vertex_changed),
    .read_o              (read_o),
    .read_last_o         (read_last_o),
    .read_source_o       (read_source_o),
    .read_cell_o         (read_cell_o),
    .read_index_o        (read_index_o),
    .read_points_i       (read_points_i),
    .forming_o           (forming_o),
    .result_valid_o      (result_valid_o),
    .result_sum_o        (result_sum_o),
    .result_jacobian_o   (result_jacobian_o)
  );
endmodule

`default_nettype wire
