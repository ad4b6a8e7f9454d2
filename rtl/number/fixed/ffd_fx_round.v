// ffd_fx_round: value_o = saturate(addend_i + floor(value_i / 2^DROP + 1/2))
//
// The one place where fixed point rounds (half up) and saturates. The addend sits on the output's
// grid, so adding it before or after rounding is the same; done before, rounding is one bit of the
// addend and costs no adder.
//
// Formats:    value_i signed IN_W bits, addend_i and value_o signed OUT_W bits; saturated_o where
//             the exact value lies outside [-2^(OUT_W-1), 2^(OUT_W-1) - 1].
// Error:      at most 1/2 unit of value_o where not saturated.
// Pipeline:   combinational.
// Overflow:   none inside: TOTAL_W = max(IN_W, OUT_W + DROP) + 2 holds both terms and the half.
// Parameters: IN_W >= 2, DROP >= 0, OUT_W >= 2.
// Model:      golden/include/hwffd/numerics/fixed.hpp (round_to).  Test: tests/unit/fixed.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_fx_round #(
  parameter IN_W  = 36,
  parameter DROP  = 16,
  parameter OUT_W = 18
) (
  input  wire signed [IN_W-1:0]  value_i,
  input  wire signed [OUT_W-1:0] addend_i,
  output wire signed [OUT_W-1:0] value_o,
  output wire                    saturated_o
);
  generate
    if (IN_W < 2 || OUT_W < 2) begin : gen_bad_width
      ERROR_ffd_fx_round_widths_must_be_at_least_2 u_error ();
    end
    if (DROP < 0) begin : gen_bad_drop
      ERROR_ffd_fx_round_drop_must_not_be_negative u_error ();
    end
  endgenerate

  localparam AT_LEAST = OUT_W + DROP;
  localparam TOTAL_W  = (IN_W > AT_LEAST ? IN_W : AT_LEAST) + 2;
  localparam KEEP_W   = TOTAL_W - DROP;

  wire signed [TOTAL_W-1:0] value  = {{(TOTAL_W - IN_W) {value_i[IN_W-1]}}, value_i};
  wire signed [TOTAL_W-1:0] addend;
  wire signed [TOTAL_W-1:0] total = value + addend;

  generate
    if (DROP == 0) begin : gen_exact
      assign addend = {{(TOTAL_W - OUT_W) {addend_i[OUT_W-1]}}, addend_i};
    end else if (DROP == 1) begin : gen_half
      assign addend = {{(TOTAL_W - OUT_W - 1) {addend_i[OUT_W-1]}}, addend_i, 1'b1};
    end else begin : gen_round
      assign addend = {{(TOTAL_W - OUT_W - DROP) {addend_i[OUT_W-1]}}, addend_i, 1'b1,
                       {(DROP - 1) {1'b0}}};
    end
    if (DROP > 0) begin : gen_dropped
      wire unused_ok = &{1'b0, total[DROP-1:0]};
    end
  endgenerate

  // In range where all bits from the output's sign upward agree.
  wire [KEEP_W-1:0]     shifted = total[TOTAL_W-1:DROP];
  wire [KEEP_W-OUT_W:0] high = shifted[KEEP_W-1:OUT_W-1];
  wire                  sign = shifted[KEEP_W-1];

  assign saturated_o = high != {(KEEP_W - OUT_W + 1) {sign}};
  assign value_o     = saturated_o ? {sign, {(OUT_W - 1) {!sign}}} : shifted[OUT_W-1:0];
endmodule

`default_nettype wire
