// ffd_eval_address: where a coefficient file of all axes has a function
//
// Such a file has 64 functions: 16 of each axis, and 16 of an axis 3 that there is none. With spans
// it has 64 for each of them. The functions that all spans of an axis share are then those of axis
// 3, the axis for the span, so that they take no memory.
//
// Formats:    place {FFD_PLACE_W, function}; address {axis, span, derivative, bank, function}.
// Pipeline:   combinational.
// Parameters: SPANS >= 1.
// Model:      none (an address only).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_eval.vh"

module ffd_eval_address #(
  parameter SPANS = 1
) (
  input  wire [1:0]                        axis_i,
  input  wire [`FFD_OWN_W(SPANS)-1:0]      place_i,
  output wire [`FFD_SHARED_W(SPANS)-1:0]   address_o
);
  localparam SPAN_W = `FFD_SPAN_W(SPANS);

  generate
    if (SPANS == 1) begin : gen_single
      assign address_o = {axis_i, place_i};
    end else begin : gen_spans
      localparam [31:0] NONE = 0;
      wire              uniform = place_i[4+SPAN_W];
      wire [SPAN_W-1:0] span    = place_i[4 +: SPAN_W];
      wire [SPAN_W+1:0] shared  = {NONE[SPAN_W-1:0], axis_i};
      assign address_o = {uniform ? 2'd3 : axis_i, uniform ? shared[SPAN_W-1:0] : span,
                          place_i[3:0]};
      wire unused_ok = &{1'b0, shared};
    end
  endgenerate
endmodule

`default_nettype wire
