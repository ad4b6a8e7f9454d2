// ffd_stream_slots: where the points of interleaved vertices go
//
// Slots are handed out and freed in turn, because vertices keep their order.
//
// Pipeline:   a slot that became free is known a clock later.
// Parameters: SLOTS >= 2.
// Not checked: a claim while none is free.
// Model:      none (storage only).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_stream_slots #(
  parameter SLOTS  = 3,
  parameter SLOT_W = $clog2(SLOTS)
) (
  input  wire              clk,
  input  wire              rst,
  input  wire              claim_i,
  input  wire              next_i,
  input  wire              free_i,
  output wire [SLOT_W-1:0] slot_o,
  output wire              free_o
);
  localparam              TOP       = SLOTS - 1;
  localparam [SLOT_W-1:0] LAST_SLOT = TOP[SLOT_W-1:0];
  localparam [SLOT_W:0]   ALL_SLOTS = SLOTS[SLOT_W:0];

  reg [SLOT_W-1:0] slot_q;
  reg [SLOT_W:0]   used_q;
  assign slot_o = slot_q;
  assign free_o = used_q != ALL_SLOTS;

  always @(posedge clk) begin
    if (rst) begin
      slot_q <= {SLOT_W{1'b0}};
      used_q <= {(SLOT_W + 1) {1'b0}};
    end else begin
      if (next_i) slot_q <= slot_q == LAST_SLOT ? {SLOT_W{1'b0}} : slot_q + 1'b1;
      used_q <= used_q + {{SLOT_W{1'b0}}, claim_i} - {{SLOT_W{1'b0}}, free_i};
    end
  end
endmodule

`default_nettype wire
