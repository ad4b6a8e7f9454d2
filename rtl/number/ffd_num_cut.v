// ffd_num_cut: sum -> point, of a sum that began with half a unit of a point (ffd_num_begin)
//
// What ffd_num_narrow makes of the sum without that half: the half is added with the sum's base,
// where it costs no adder.
//
// Formats:    fxW only: Q9.(2W-3) -> Q1.(W-1).
// Rounding:   down, with the half therefore half up; saturated and flagged outside [-1, 1).
// Pipeline:   LATENCY registers, II 1, never frozen.
// Parameters: FORMAT 8 to 32, LATENCY >= 0.
// Model:      golden/include/hwffd/numerics (narrow).  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_cut #(
  parameter FORMAT  = 17,
  parameter LATENCY = 0
) (
  input  wire                             clk,
  input  wire [`FFD_SUM_W(FORMAT)-1:0]    sum_i,
  output wire [`FFD_POINT_W(FORMAT)-1:0]  point_o
);
  localparam W       = `FFD_FIXED_W(FORMAT);
  localparam VALUE_W = 2 * W + 6;
  localparam WHOLE_W = VALUE_W - (W - 2);

  wire signed [WHOLE_W-1:0] whole = sum_i[VALUE_W-1:W-2];
  wire signed [W-1:0]       value;
  wire                      saturated;

  generate
    if (`FFD_OFFSET_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_cut_needs_fixed_point u_error ();
    end else begin : gen_saturate
      ffd_fx_round #(
        .IN_W (WHOLE_W),
        .DROP (0),
        .OUT_W(W)
      ) u_saturate (
        .value_i    (whole),
        .addend_i   ({W{1'b0}}),
        .value_o    (value),
        .saturated_o(saturated)
      );
    end
  endgenerate

  ffd_num_delay #(
    .WIDTH  (`FFD_POINT_W(FORMAT)),
    .LATENCY(LATENCY)
  ) u_point (
    .clk(clk),
    .rst(1'b0),
    .d_i({sum_i[VALUE_W] | saturated, value}),
    .q_o(point_o)
  );

  wire unused_ok = &{1'b0, sum_i};
endmodule

`default_nettype wire
