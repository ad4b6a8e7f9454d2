// ffd_num_binomial: binom(POWER, k) / 2^POWER, the part of x^POWER in (2x - 1)^k
//
// x^j = ((1 + (2x - 1)) / 2)^j, so a polynomial's coefficient of (2x - 1)^k is the sum over j of
// its coefficients of x^j times these: 1, 1/2, 1/4, 1/8 and 3/8.
//
// Formats:    a weight, exact, never flagged.
// Pipeline:   combinational.
// Parameters: FORMAT as in ffd_num.vh, POWER 0 to 3: j.
// Model:      golden/include/hwffd/numerics (binomial).  Test: tests/evaluator (nested).
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_binomial #(
  parameter FORMAT = 18,
  parameter POWER  = 0
) (
  input  wire [1:0]                        power_i,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]  weight_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);

  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_binomial_format_is_unknown u_error ();
    end
    if (POWER < 0 || POWER > 3) begin : gen_bad_power
      ERROR_ffd_num_binomial_power_must_be_0_to_3 u_error ();
    end
  endgenerate

  wire [WEIGHT_W-1:0] zero = {WEIGHT_W{1'b0}};
  wire [WEIGHT_W-1:0] unit;   // 2^-POWER
  wire [WEIGHT_W-1:0] inner;  // binom(POWER, 1) / 2^POWER

  generate
    if (FORMAT == `FFD_FORMAT_FP32) begin : gen_float
      localparam [7:0] EXPONENT = 127 - POWER;
      assign unit  = {1'b0, EXPONENT, 23'd0};
      assign inner = POWER == 3 ? 32'h3EC0_0000 : 32'h3F00_0000;
    end else begin : gen_fixed
      localparam W = `FFD_FIXED_W(FORMAT);
      localparam [W-1:0] ONE   = 1;
      localparam [W-1:0] UNIT  = ONE << (W - 2 - POWER);
      localparam [W-1:0] INNER = POWER * UNIT;
      assign unit  = {1'b0, UNIT};
      assign inner = {1'b0, INNER};
    end
  endgenerate

  wire [WEIGHT_W-1:0] at_1 = POWER == 0 ? zero : POWER == 1 ? unit : inner;
  wire [WEIGHT_W-1:0] at_2 = POWER < 2 ? zero : POWER == 2 ? unit : inner;
  wire [WEIGHT_W-1:0] at_3 = POWER < 3 ? zero : unit;

  assign weight_o = power_i[1] ? (power_i[0] ? at_3 : at_2) : (power_i[0] ? at_1 : unit);
endmodule

`default_nettype wire
