// An organization's ports, each joined with the wire of the same name. To be included in an
// instance.
// SPDX-License-Identifier: Apache-2.0
.clk                 (clk),
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
.result_valid_o      (result_valid_o),
.result_sum_o        (result_sum_o)
