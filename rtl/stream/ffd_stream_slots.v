// ffd_stream_slots: where the points of interleaved vertices go
//
// Slots are handed out and freed in turn, because vertices keep their order.
//
// Pipeline:   a slot that became free is known a clock later.
// Parameters: SLOTS >= 2; FEATURES as in ffd_stream.vh: slot 0 is free where there are none.
// Not checked: a claim while none is free, but by FFD_ASSERTIONS.
// Model:      none (storage only).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_stream.vh"

module ffd_stream_slots #(
  parameter FEATURES = `FFD_FEATURES_USUAL,
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
  generate
    if (`FFD_FEATURE_INTERLEAVED(FEATURES) != 0) begin : gen_slots
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
      `FFD_ASSERT(a_slot_is_claimed_and_none_is_free, !claim_i || used_q != ALL_SLOTS)
      `FFD_ASSERT(a_slot_becomes_free_that_none_had, !free_i || used_q != {(SLOT_W + 1) {1'b0}})
    end else begin : gen_no_slots
      assign slot_o = {SLOT_W{1'b0}};
      assign free_o = 1'b1;
      wire unused_ok = &{1'b0, clk, rst, claim_i, next_i, free_i};
    end
  endgenerate
endmodule

`default_nettype wire
