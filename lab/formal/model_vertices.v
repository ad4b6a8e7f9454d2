// model_vertices: the vertices inside, from their last beat until they retire, the oldest first
//
// What the stream said of each: its tag, and the bank, buffer or slot that it must read. ordered_o
// is a part of the lemma `in_order`: from the youngest to the oldest, those that read what is in
// use come before those that read what was, and slots go round. The clashes are vertices whose
// beats are all behind the converters, and a write to what they read.
//
// Formats:    entry {final, a lattice was loaded, its size, about}; about {results, source, bank,
//             changed, cell, tag}; source {resident, slot or buffer}.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module model_vertices #(
  parameter SLOTS = 3
) (
  input  wire            clk,
  input  wire            rst,
  input  wire            enter_i,
  input  wire [48:0]     entry_i,
  input  wire            leave_i,
  output reg  [2:0]      inside_o,
  output reg  [4*49-1:0] list_o,
  input  wire            bank_i,         // in use
  input  wire            bank_busy_i,
  input  wire            buffer_i,
  input  wire            buffer_busy_i,
  input  wire [1:0]      slot_i,         // the next
  input  wire            midst_i,        // of a vertex that has it
  input  wire [2:0]      used_i,
  input  wire [2:0]      there_i,        // so many are behind the converters
  input  wire            young_i,        // the youngest is at their first register
  input  wire [1:0]      evaluated_i,    // with the evaluator: the older, the younger
  input  wire [1:0]      freed_i,        // and without a slot
  input  wire [2:0]      function_0_i,   // in the converters: valid, buffer, bank; the younger
  input  wire [2:0]      function_1_i,
  input  wire [2:0]      point_0_i,
  input  wire [2:0]      point_1_i,
  input  wire [2:0]      slot_write_i,   // valid, slot
  output reg             ordered_o,
  output reg             bank_clash_o,
  output reg             buffer_clash_o,
  output reg             slot_clash_o
);
  wire [2:0] behind = inside_o - leave_i;
  always @(posedge clk) inside_o <= rst ? 3'd0 : behind + enter_i;

  genvar v;
  generate
    for (v = 0; v < 4; v = v + 1) begin : gen_vertex
      wire [48:0] above = v == 3 ? 49'd0 : list_o[(v+1)%4*49 +: 49];
      always @(posedge clk) begin
        if (enter_i && behind == v) list_o[v*49 +: 49] <= entry_i;
        else if (leave_i) list_o[v*49 +: 49] <= above;
      end
    end
  endgenerate

  reg        old_bank;     // one that is younger reads what was in use before
  reg        old_buffer;
  reg [1:0]  slot;
  reg [2:0]  slots;
  reg [48:0] e;
  reg [11:0] beyond;       // the cells of its lattice
  integer    i;
  always @* begin
    ordered_o      = used_i <= SLOTS && slot_i < SLOTS;
    bank_clash_o   = 1'b0;
    buffer_clash_o = 1'b0;
    slot_clash_o   = 1'b0;
    old_bank       = 1'b0;
    old_buffer     = 1'b0;
    slot           = slot_i;
    slots          = midst_i;
    e              = 0;
    beyond         = 0;
    for (i = 3; i >= 0; i = i - 1) begin
      e      = list_o[i*49 +: 49];
      beyond = {e[46:43] - 4'd3, e[42:39] - 4'd3, e[38:35] - 4'd3};
      if (i < inside_o) begin
        if (e[29] == bank_i ? old_bank : !bank_busy_i) ordered_o = 1'b0;
        if (e[29] != bank_i) old_bank = 1'b1;
        if (function_0_i[2] && e[29] == function_0_i[0]) ordered_o = 1'b0;
        if (function_1_i[2] && e[29] == function_1_i[0] && !(young_i && i == inside_o - 1)) begin
          bank_clash_o = 1'b1;
        end
      end
      if (i < inside_o && e[32]) begin
        if (e[30] == buffer_i ? old_buffer : !buffer_busy_i) ordered_o = 1'b0;
        if (e[30] != buffer_i) old_buffer = 1'b1;
        if (point_0_i[2] && e[30] == point_0_i[1]) ordered_o = 1'b0;
        if (point_1_i[2] && e[30] == point_1_i[1] && !(young_i && i == inside_o - 1)) begin
          buffer_clash_o = 1'b1;
        end
        // A cell of the lattice, if there is one, whose dimensions are good.
        if (e[47] && (e[38:35] < 3 || e[42:39] < 3 || e[46:43] < 3 || e[19:16] > beyond[3:0]
                      || e[23:20] > beyond[7:4] || e[27:24] > beyond[11:8])) ordered_o = 1'b0;
      end
      if (i < inside_o && !e[32] && !(i < 2 && evaluated_i[i%2] && freed_i[i%2])) begin
        slot  = slot == 0 ? SLOTS - 1 : slot - 2'd1;
        slots = slots + 3'd1;
        if (e[31:30] != slot) ordered_o = 1'b0;
        if (slot_write_i[2] && slot_write_i[1:0] == e[31:30] && i < there_i) slot_clash_o = 1'b1;
      end
    end
    if (used_i != slots) ordered_o = 1'b0;
  end
endmodule

`default_nettype wire
