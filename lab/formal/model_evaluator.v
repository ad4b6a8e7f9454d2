// model_evaluator: any evaluator that holds two vertices, as the decoder's proofs want it
//
// Vertices enter in order; the slot of an interleaved one is free, and then it retires, at any
// later time, or never. The older one is a, the younger b.
//
// Parameters: WORD_W bits are kept of a vertex; bit NO_SLOT is 1 where it has no slot.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module model_evaluator #(
  parameter WORD_W  = 6,
  parameter NO_SLOT = 2
) (
  input  wire              clk,
  input  wire              rst,
  input  wire              want_vertex,
  input  wire              want_free,
  input  wire              want_retire,
  input  wire              s_vertex_valid,
  output wire              s_vertex_ready,
  input  wire [WORD_W-1:0] s_vertex_word,
  output wire              free_o,
  output wire              retire_o,
  output wire              a_there_o,
  output wire              a_slot_o,   // it has a slot that is not free
  output wire [WORD_W-1:0] a_word_o,
  output wire              b_there_o,
  output wire              b_slot_o,
  output wire [WORD_W-1:0] b_word_o
);
  reg              a_q;
  reg              a_freed_q;
  reg [WORD_W-1:0] a_word_q;
  reg              b_q;
  reg              b_freed_q;
  reg [WORD_W-1:0] b_word_q;

  wire enter   = s_vertex_valid && s_vertex_ready;
  wire b_freed = b_freed_q || (free_o && !a_slot_o);
  assign a_there_o      = a_q;
  assign b_there_o      = b_q;
  assign a_word_o       = a_word_q;
  assign b_word_o       = b_word_q;
  assign a_slot_o       = a_q && !a_word_q[NO_SLOT] && !a_freed_q;
  assign b_slot_o       = b_q && !b_word_q[NO_SLOT] && !b_freed_q;
  assign s_vertex_ready = want_vertex && !(a_q && b_q);
  assign free_o         = want_free && (a_slot_o || b_slot_o);
  assign retire_o       = want_retire && a_q && !a_slot_o;

  always @(posedge clk) begin
    if (rst) begin
      a_q <= 1'b0;
      b_q <= 1'b0;
    end else if (retire_o) begin
      a_q <= b_q || enter;
      b_q <= 1'b0;
    end else begin
      a_q <= a_q || enter;
      b_q <= b_q || (a_q && enter);
    end
    if (retire_o) a_freed_q <= b_q && b_freed;
    else a_freed_q <= a_q && (a_freed_q || free_o);
    b_freed_q <= !retire_o && b_q && b_freed;
    if (retire_o && b_q) a_word_q <= b_word_q;
    else if (retire_o || !a_q) a_word_q <= s_vertex_word;
    if (!b_q) b_word_q <= s_vertex_word;
  end
endmodule

`default_nettype wire
