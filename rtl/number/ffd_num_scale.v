// ffd_num_scale: weight x 2^shift -> weight
//
// Undoes the shift of a coefficient bank whose coefficients were stored times 2^-shift to fit
// [-2, 2) (docs/numerics.md section 3).
//
// Formats:    fp32: a wire, the shift is ignored. Else: saturated and flagged outside [-2, 2).
// Pipeline:   LATENCY registers, II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh, LATENCY >= 0.
// Model:      golden/include/hwffd/numerics (scale).  Test: tests/unit/fixed.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_scale #(
  parameter FORMAT  = 18,
  parameter LATENCY = 0
) (
  input  wire                              clk,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  weight_i,
  input  wire [1:0]                        shift_i,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]  weight_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);

  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_scale_format_is_unknown u_error ();
    end
  endgenerate

  wire [WEIGHT_W-1:0] scaled;

  generate
    if (FORMAT == `FFD_FORMAT_FP32) begin : gen_float
      assign scaled = weight_i;
      wire unused_ok = &{1'b0, shift_i};
    end else begin : gen_fixed
      localparam W = `FFD_FIXED_W(FORMAT);
      wire         sign = weight_i[W-1];
      wire [2:0]   lost = weight_i[W-2 -: 3] ^ {3{sign}};
      wire         saturated = shift_i > 2'd0 && lost[2] || shift_i > 2'd1 && lost[1] ||
                               shift_i > 2'd2 && lost[0];
      wire [W-1:0] once = shift_i[0] ? {weight_i[W-2:0], 1'b0} : weight_i[W-1:0];
      // Each bit chooses by two bits out of once, once shifted by two, 0 and 1: one LUT of four
      // inputs.
      wire [1:0]   choice = saturated ? {1'b1, !sign} : {1'b0, shift_i[1]};
      wire [W-1:0] twice  = choice[0] ? {once[W-3:0], 2'b00} : once;

      assign scaled = {weight_i[W] | saturated, sign,
                       choice[1] ? {(W - 1) {choice[0]}} : twice[W-2:0]};
      wire unused_ok = &{1'b0, twice[W-1]};
    end
  endgenerate

  ffd_num_delay #(
    .WIDTH  (WEIGHT_W),
    .LATENCY(LATENCY)
  ) u_scaled (
    .clk(clk),
    .rst(1'b0),
    .d_i(scaled),
    .q_o(weight_o)
  );
endmodule

`default_nettype wire
