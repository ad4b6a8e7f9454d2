// ffd_num_narrow: sum -> point, between two contractions
//
// Formats:    fp32: a wire. Else: Q9.(2W-3) times 2^-SHIFT -> Q1.(W-1), the point's own format, so
//             that the next multiplication is again one of W x W bits.
// Rounding:   half up, saturated and flagged outside [-1, 1).
// Error:      half a unit of a point.
// Pipeline:   LATENCY registers, II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh, SHIFT 0 to 7, LATENCY >= 0.
// Model:      golden/include/hwffd/numerics (narrow).  Test: tests/unit/fixed.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_narrow #(
  parameter FORMAT  = 18,
  parameter SHIFT   = 0,
  parameter LATENCY = 0
) (
  input  wire                             clk,
  input  wire [`FFD_SUM_W(FORMAT)-1:0]    sum_i,
  output wire [`FFD_POINT_W(FORMAT)-1:0]  point_o
);
  localparam POINT_W = `FFD_POINT_W(FORMAT);

  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_narrow_format_is_unknown u_error ();
    end
    if (SHIFT < 0 || SHIFT > 7) begin : gen_bad_shift
      ERROR_ffd_num_narrow_shift_must_be_0_to_7 u_error ();
    end
  endgenerate

  generate
    if (FORMAT == `FFD_FORMAT_FP32) begin : gen_float
      ffd_num_delay #(
        .WIDTH  (POINT_W),
        .LATENCY(LATENCY)
      ) u_point (
        .clk(clk),
        .rst(1'b0),
        .d_i(sum_i),
        .q_o(point_o)
      );
    end else begin : gen_fixed
      localparam W       = `FFD_FIXED_W(FORMAT);
      localparam VALUE_W = 2 * W + 6;
      localparam FLAGS_W = `FFD_FLAGS_W(FORMAT);

      ffd_fx_narrow #(
        .IN_W   (VALUE_W),
        .DROP   (W - 2 + SHIFT),
        .OUT_W  (W),
        .FLAGS_W(FLAGS_W),
        .LATENCY(LATENCY)
      ) u_narrow (
        .clk    (clk),
        .value_i(sum_i[VALUE_W-1:0]),
        .flags_i(sum_i[VALUE_W +: FLAGS_W]),
        .value_o(point_o[W-1:0]),
        .flags_o(point_o[POINT_W-1:W])
      );
    end
  endgenerate
endmodule

`default_nettype wire
