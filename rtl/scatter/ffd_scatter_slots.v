// ffd_scatter_slots: who has the memory, in slots of three clocks
//
// A slot is one place in each bank, for its three components one after the other: it is a vertex's,
// a point's of a collect, or a place's of a sweep. So no word is read again before it is written. A
// vertex that comes has its slot at once; others have what vertices leave, first a collect, then a
// sweep. (Whoever lets vertices in leaves every second slot while a collect wants some.)
//
// Pipeline:   asked for in the clock of component 2 | slot_, for three clocks. Never frozen.
// Bad input:  a vertex in the middle of a slot: FFD_ASSERTIONS.
// Parameters: CELL_W >= 1, PAGE_W >= 1; FIRST 0 to 2: the component of the first clock after reset.
// Model:      none (order only).  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"

module ffd_scatter_slots #(
  parameter CELL_W = 12,
  parameter PAGE_W = 1,
  parameter FIRST  = 0
) (
  input  wire              clk,
  input  wire              rst,
  input  wire              vertex_valid_i,  // in the clocks of a vertex, the first that of asking
  input  wire [PAGE_W-1:0] vertex_page_i,
  input  wire [CELL_W-1:0] vertex_cell_i,
  input  wire              point_valid_i,
  input  wire [PAGE_W-1:0] point_page_i,
  input  wire [CELL_W-1:0] point_cell_i,
  output wire              point_take_o,
  input  wire              sweep_valid_i,
  input  wire              sweep_clear_i,
  input  wire [PAGE_W-1:0] sweep_page_i,
  input  wire [CELL_W-1:0] sweep_cell_i,
  output wire              sweep_take_o,
  output reg               slot_valid_o,
  output reg               slot_vertex_o,
  output reg               slot_point_o,
  output reg               slot_sweep_o,    // not a clear
  output reg  [1:0]        slot_component_o,
  output reg  [PAGE_W-1:0] slot_page_o,
  output reg  [CELL_W-1:0] slot_cell_o
);
  localparam [1:0] COMPONENT = FIRST[1:0];

  generate
    if (FIRST < 0 || FIRST > 2) begin : gen_bad_first
      ERROR_ffd_scatter_slots_first_must_be_0_to_2 u_error ();
    end
  endgenerate

  reg next_q;  // component 2

  assign point_take_o = next_q && !vertex_valid_i && point_valid_i;
  assign sweep_take_o = next_q && !vertex_valid_i && !point_valid_i && sweep_valid_i;

  always @(posedge clk) begin
    if (rst) slot_component_o <= COMPONENT;
    else slot_component_o <= next_q ? 2'd0 : slot_component_o + 2'd1;
  end
  always @(posedge clk) next_q <= rst ? COMPONENT == 2'd2 : slot_component_o == 2'd1;
  always @(posedge clk) begin
    if (rst) slot_valid_o <= 1'b0;
    else if (next_q) slot_valid_o <= vertex_valid_i || point_valid_i || sweep_valid_i;
  end
  always @(posedge clk) begin
    if (next_q) begin
      slot_vertex_o <= vertex_valid_i;
      slot_point_o  <= point_take_o;
      slot_sweep_o  <= sweep_take_o && !sweep_clear_i;
      slot_page_o   <= vertex_valid_i ? vertex_page_i : point_valid_i ? point_page_i : sweep_page_i;
      slot_cell_o   <= vertex_valid_i ? vertex_cell_i : point_valid_i ? point_cell_i : sweep_cell_i;
    end
  end

`ifdef FFD_ASSERTIONS
  reg vertex_q;
  always @(posedge clk) vertex_q <= vertex_valid_i && !rst;
  `FFD_ASSERT(a_vertex_comes_in_the_middle_of_a_slot, next_q || !vertex_valid_i || vertex_q)
`endif
endmodule

`default_nettype wire
