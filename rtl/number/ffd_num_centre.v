// ffd_num_centre: coordinate -> 2 x coordinate - 1, from [0, 1] to [-1, 1] about the cell's centre
//
// Rounding:   fp32: the doubling is exact (but for overflow to infinity), the sum to nearest even.
//             Else: none: a coordinate is a multiple of 2^-(W-2) in [0, 1], and so is twice it less
//             one in [-1, 1].
// Pipeline:   LATENCY registers, II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh, LATENCY >= 1.
// Model:      golden/include/hwffd/numerics (centre).  Test: tests/unit/fixed, tests/unit/float.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_centre #(
  parameter FORMAT  = 18,
  parameter LATENCY = 1
) (
  input  wire                              clk,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  coordinate_i,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]  centred_o
);
  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_centre_format_is_unknown u_error ();
    end
    if (LATENCY < 1) begin : gen_bad_latency
      ERROR_ffd_num_centre_latency_must_be_at_least_1 u_error ();
    end
  endgenerate

  generate
    if (FORMAT == `FFD_FORMAT_FP32) begin : gen_float
      wire [7:0]  exponent = coordinate_i[30:23];
      wire [30:0] doubled  = exponent == 8'd0   ? {coordinate_i[29:0], 1'b0} :
                             exponent == 8'd254 ? {8'd255, 23'd0} :
                             exponent == 8'd255 ? coordinate_i[30:0] :
                                                  {exponent + 8'd1, coordinate_i[22:0]};
      ffd_fp_add #(
        .EXP_W  (8),
        .SIG_W  (24),
        .LATENCY(LATENCY)
      ) u_add (
        .clk     (clk),
        .a_i     ({coordinate_i[31], doubled}),
        .b_i     (32'hBF80_0000),
        .result_o(centred_o)
      );
    end else begin : gen_fixed
      localparam W = `FFD_FIXED_W(FORMAT);
      wire [W-1:0] one     = {2'b01, {(W - 2) {1'b0}}};
      wire [W-1:0] centred = {coordinate_i[W-2:0], 1'b0} - one;

      ffd_num_delay #(
        .WIDTH  (W + 1),
        .LATENCY(LATENCY)
      ) u_centred (
        .clk(clk),
        .rst(1'b0),
        .d_i({coordinate_i[W], centred}),
        .q_o(centred_o)
      );
      wire unused_ok = &{1'b0, coordinate_i[W-1]};
    end
  endgenerate
endmodule

`default_nettype wire
