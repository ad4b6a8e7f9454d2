// ffd_num_out: a sum becomes a word of the stream, with its flags
//
// Formats:    fp32: the sum is the word; nan_o where it is one. fxW: Q9.(2W-3) times 2^-SHIFT ->
//             Q1.31, half up, saturated_o outside [-1, 1) or where any operand was. Block: the same
//             sum times 2^(POWER exponent_i - SHIFT) -> binary32, rounded once, nan_o where it is
//             one, saturated_o where any operand was.
// Pipeline:   LATENCY registers, II 1, never frozen. Block: spread over the normaliser.
// Parameters: FORMAT as in ffd_num.vh, SHIFT 0 to 7, POWER 1 or 3, LATENCY >= 0.
// Model:      golden/include/hwffd/numerics (out).  Test: tests/unit/fixed.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_out #(
  parameter FORMAT  = 18,
  parameter SHIFT   = 0,
  parameter POWER   = 1,
  parameter LATENCY = 0
) (
  input  wire                           clk,
  input  wire [`FFD_SUM_W(FORMAT)-1:0]  sum_i,
  input  wire [`FFD_EXPONENT_W-1:0]     exponent_i,
  output wire [31:0]                    word_o,
  output wire                           saturated_o,
  output wire                           nan_o
);
  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_out_format_is_unknown u_error ();
    end
    if (SHIFT < 0 || SHIFT > 7) begin : gen_bad_shift
      ERROR_ffd_num_out_shift_must_be_0_to_7 u_error ();
    end
    if (POWER != 1 && POWER != 3) begin : gen_bad_power
      ERROR_ffd_num_out_power_must_be_1_or_3 u_error ();
    end
  endgenerate

  generate
    if (FORMAT == `FFD_FORMAT_FP32) begin : gen_float
      wire nan = &sum_i[30:23] & |sum_i[22:0];
      ffd_num_delay #(
        .WIDTH  (33),
        .LATENCY(LATENCY)
      ) u_word (
        .clk(clk),
        .rst(1'b0),
        .d_i({nan, sum_i}),
        .q_o({nan_o, word_o})
      );
      assign saturated_o = 1'b0;
    end else if (`FFD_FORMAT_BLOCK(FORMAT)) begin : gen_block
      wire [`FFD_EXPONENT_W-1:0] exponent;

      if (POWER == 1 && SHIFT == 0) begin : gen_own
        assign exponent = exponent_i;
      end else begin : gen_scaled
        // Clamped to what the normaliser takes: out there every sum overflows, or rounds to 0.
        localparam EXPONENT_W = `FFD_EXPONENT_W;
        localparam WIDE_W     = EXPONENT_W + 2;
        localparam [WIDE_W-1:0] DOWN = SHIFT;
        wire [WIDE_W-1:0] once    = {{2{exponent_i[EXPONENT_W-1]}}, exponent_i};
        wire [WIDE_W-1:0] twice   = POWER == 3 ? {once[WIDE_W-2:0], 1'b0} : {WIDE_W{1'b0}};
        wire [WIDE_W-1:0] total   = once + twice - DOWN;
        wire              sign    = total[WIDE_W-1];
        wire              outside = total[WIDE_W-2] != sign || total[WIDE_W-3] != sign;
        assign exponent = outside ? {sign, {(EXPONENT_W - 1) {!sign}}} : total[EXPONENT_W-1:0];
      end

      ffd_bfp_normalise #(
        .W      (`FFD_FIXED_W(FORMAT)),
        .LATENCY(LATENCY)
      ) u_normalise (
        .clk        (clk),
        .sum_i      (sum_i),
        .exponent_i (exponent),
        .word_o     (word_o),
        .saturated_o(saturated_o),
        .nan_o      (nan_o)
      );
    end else begin : gen_fixed
      localparam FRACTION = 2 * FORMAT - 3 + SHIFT;
      localparam PAD      = FRACTION < 31 ? 31 - FRACTION : 0;
      localparam DROP     = FRACTION < 31 ? 0 : FRACTION - 31;
      localparam VALUE_W  = `FFD_SUM_W(FORMAT) - 1;
      wire signed [VALUE_W+PAD-1:0] value;

      if (PAD > 0) begin : gen_pad
        assign value = {sum_i[VALUE_W-1:0], {PAD{1'b0}}};
      end else begin : gen_no_pad
        assign value = sum_i[VALUE_W-1:0];
      end

      ffd_fx_narrow #(
        .IN_W   (VALUE_W + PAD),
        .DROP   (DROP),
        .OUT_W  (32),
        .FLAGS_W(1),
        .LATENCY(LATENCY)
      ) u_narrow (
        .clk    (clk),
        .value_i(value),
        .flags_i(sum_i[VALUE_W]),
        .value_o(word_o),
        .flags_o(saturated_o)
      );
      assign nan_o = 1'b0;
    end
  endgenerate

  wire unused_ok = &{1'b0, exponent_i};
endmodule

`default_nettype wire
