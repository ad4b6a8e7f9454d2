// ffd_num_rescale: sum x 2^shift -> point, where a cell's coefficients are formed
//
// ffd_num_narrow with a scale: what is formed grows past a point's range, or is a coefficient whose
// bank has a shift (docs/numerics.md section 3).
//
// Formats:    fp32: a wire, the shift is ignored. Else: Q9.(2W-3) -> Q1.(W-1).
// Rounding:   half up, once; saturated and flagged outside [-1, 1).
// Error:      half a unit of a point.
// Pipeline:   LATENCY registers, II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh, LATENCY >= 0.
// Not checked: shift_i is -1 to 3; below, bits are dropped before they are rounded.
// Model:      golden/include/hwffd/numerics (rescale).  Test: tests/unit/fixed.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_rescale #(
  parameter FORMAT  = 18,
  parameter LATENCY = 0
) (
  input  wire                             clk,
  input  wire [`FFD_SUM_W(FORMAT)-1:0]    sum_i,
  input  wire signed [2:0]                shift_i,
  output wire [`FFD_POINT_W(FORMAT)-1:0]  point_o
);
  localparam POINT_W = `FFD_POINT_W(FORMAT);

  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_rescale_format_is_unknown u_error ();
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
      wire unused_ok = &{1'b0, shift_i};
    end else begin : gen_fixed
      // One place more behind the point than the sum has, for the shift by -1.
      localparam W         = `FFD_FIXED_W(FORMAT);
      localparam VALUE_W   = 2 * W + 6;
      localparam SHIFTED_W = VALUE_W + 4;
      localparam FLAGS_W   = `FFD_FLAGS_W(FORMAT);
      wire signed [SHIFTED_W-1:0] value   = {{4{sum_i[VALUE_W-1]}}, sum_i[VALUE_W-1:0]};
      wire        [2:0]           places  = shift_i + 3'd1;
      wire signed [SHIFTED_W-1:0] shifted = value <<< places;

      ffd_fx_narrow #(
        .IN_W   (SHIFTED_W),
        .DROP   (W - 1),
        .OUT_W  (W),
        .FLAGS_W(FLAGS_W),
        .LATENCY(LATENCY)
      ) u_narrow (
        .clk    (clk),
        .value_i(shifted),
        .flags_i(sum_i[VALUE_W +: FLAGS_W]),
        .value_o(point_o[W-1:0]),
        .flags_o(point_o[POINT_W-1:W])
      );
    end
  endgenerate
endmodule

`default_nettype wire
