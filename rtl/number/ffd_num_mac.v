// ffd_num_mac: sum + weight x point -> sum, fused: one rounding (paper, section 3.4)
//
// Formats:    fp32 only: in fixed point ffd_num_term and ffd_num_add give the same bits.
// Rounding:   to nearest even, once.
// Pipeline:   LATENCY registers, II 1, never frozen.
// Parameters: FORMAT 0 (fp32), LATENCY >= 1; OPEN as in ffd_num_add.
// Model:      golden/include/hwffd/numerics/binary32.hpp (Binary32Fused::mac).
// Test:       tests/unit/float, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_mac #(
  parameter FORMAT  = 0,
  parameter LATENCY = 1,
  parameter OPEN    = 0
) (
  input  wire                              clk,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  weight_i,
  input  wire [`FFD_POINT_W(FORMAT)-1:0]   point_i,
  input  wire [`FFD_SUM_W(FORMAT)-1:0]     sum_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]     sum_o
);
  generate
    if (FORMAT != `FFD_FORMAT_FP32) begin : gen_bad_format
      ERROR_ffd_num_mac_needs_fp32 u_error ();
    end else begin : gen_float
      ffd_fp_fma #(
        .EXP_W  (8),
        .SIG_W  (24),
        .LATENCY(LATENCY),
        .OPEN   (OPEN)
      ) u_fma (
        .clk     (clk),
        .a_i     (weight_i),
        .b_i     (point_i),
        .c_i     (sum_i),
        .result_o(sum_o)
      );
    end
  endgenerate
endmodule

`default_nettype wire
