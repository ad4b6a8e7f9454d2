// formal_scatter_slots: ffd_scatter_slots with any vertices, points and sweeps and any reset
//
// A vertex asks in the clock of component 2, as ffd_scatter_core's does, and stays for three clocks
// or until reset. An address of a bank is {page, place, component}, so that two reads of a word have
// the same component.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_scatter_slots #(
  parameter CELL_W = 2,
  parameter PAGE_W = 1,
  parameter FIRST  = 1
) (
  input wire              clk,
  input wire              rst,
  input wire              want_vertex,
  input wire [PAGE_W-1:0] vertex_page,
  input wire [CELL_W-1:0] vertex_cell,
  input wire              point_valid,
  input wire [PAGE_W-1:0] point_page,
  input wire [CELL_W-1:0] point_cell,
  input wire              sweep_valid,
  input wire              sweep_clear,
  input wire [PAGE_W-1:0] sweep_page,
  input wire [CELL_W-1:0] sweep_cell
);
  localparam KIND_W = 3;

  wire              point_take;
  wire              sweep_take;
  wire              valid;
  wire [KIND_W-1:0] kind;
  wire [1:0]        component;
  wire [PAGE_W-1:0] page;
  wire [CELL_W-1:0] place;
  reg               vertex_q;
  wire              asks   = component == 2'd2;
  wire              vertex = asks ? want_vertex : vertex_q;
  always @(posedge clk) vertex_q <= vertex && !rst;

  ffd_scatter_slots #(
    .CELL_W(CELL_W),
    .PAGE_W(PAGE_W),
    .FIRST (FIRST)
  ) u_dut (
    .clk             (clk),
    .rst             (rst),
    .vertex_valid_i  (vertex),
    .vertex_page_i   (vertex_page),
    .vertex_cell_i   (vertex_cell),
    .point_valid_i   (point_valid),
    .point_page_i    (point_page),
    .point_cell_i    (point_cell),
    .point_take_o    (point_take),
    .sweep_valid_i   (sweep_valid),
    .sweep_clear_i   (sweep_clear),
    .sweep_page_i    (sweep_page),
    .sweep_cell_i    (sweep_cell),
    .sweep_take_o    (sweep_take),
    .slot_valid_o    (valid),
    .slot_vertex_o   (kind[0]),
    .slot_point_o    (kind[1]),
    .slot_sweep_o    (kind[2]),
    .slot_component_o(component),
    .slot_page_o     (page),
    .slot_cell_o     (place)
  );

  // What is read in this clock, in those before since reset, and who was told that a slot is his.
  wire [KIND_W+PAGE_W+CELL_W-1:0] slot = {kind, page, place};
  reg                             valid_q      = 1'b0;
  reg                             valid_qq     = 1'b0;
  reg  [1:0]                      component_q;
  reg  [1:0]                      component_qq;
  reg  [KIND_W+PAGE_W+CELL_W-1:0] slot_q;
  reg                             was_reset_q  = 1'b0;
  reg                             running_q    = 1'b0;
  reg                             told_point_q;
  reg                             told_sweep_q;
  reg                             told_vertex_q;
  reg  [CELL_W-1:0]               told_cell_q;
  always @(posedge clk) begin
    was_reset_q   <= was_reset_q || rst;
    running_q     <= was_reset_q && !rst;
    valid_q       <= valid && !rst && was_reset_q;
    valid_qq      <= valid_q && !rst;
    component_q   <= component;
    component_qq  <= component_q;
    slot_q        <= slot;
    told_point_q  <= point_take;
    told_sweep_q  <= sweep_take;
    told_vertex_q <= asks && vertex;
    told_cell_q   <= vertex ? vertex_cell : point_take ? point_cell : sweep_cell;
  end

  always @* begin
    if (was_reset_q && !rst && valid) begin
      apart:  assert ((!valid_q || component != component_q)
                      && (!valid_qq || component != component_qq));
      steady: assert (component == 2'd0 || slot == slot_q);
    end
    if (was_reset_q && !rst && running_q && component == 2'd0) begin
      whose:  assert (valid == (told_vertex_q || told_point_q || told_sweep_q)
                      && (!valid || place == told_cell_q));
    end
    if (was_reset_q) begin
      single: assert (!(point_take && sweep_take) && !(vertex && (point_take || sweep_take)));
    end
  end
endmodule

`default_nettype wire
