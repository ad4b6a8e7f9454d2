// ffd_num_out: a sum becomes a word of the stream, with its flags
//
// Formats:    fp32: the sum is the word; nan_o where it is one. fxW: Q9.(2W-3) times 2^-SHIFT ->
//             Q1.31, half up, saturated_o outside [-1, 1) or where any operand was.
// Pipeline:   LATENCY registers, II 1, never frozen.
// Parameters: FORMAT as in ffd_num.vh, SHIFT 0 to 7, LATENCY >= 0.
// Model:      golden/include/hwffd/numerics (out).  Test: tests/unit/fixed.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_out #(
  parameter FORMAT  = 18,
  parameter SHIFT   = 0,
  parameter LATENCY = 0
) (
  input  wire                           clk,
  input  wire [`FFD_SUM_W(FORMAT)-1:0]  sum_i,
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
  endgenerate

  wire [31:0] word;
  wire        saturated;
  wire        nan;

  generate
    if (FORMAT == `FFD_FORMAT_FP32) begin : gen_float
      assign word      = sum_i;
      assign saturated = 1'b0;
      assign nan       = &sum_i[30:23] & |sum_i[22:0];
    end else begin : gen_fixed
      localparam FRACTION = 2 * FORMAT - 3 + SHIFT;
      localparam PAD      = FRACTION < 31 ? 31 - FRACTION : 0;
      localparam DROP     = FRACTION < 31 ? 0 : FRACTION - 31;
      localparam VALUE_W  = `FFD_SUM_W(FORMAT) - 1;
      wire signed [VALUE_W+PAD-1:0] value;
      wire                          overflow;

      if (PAD > 0) begin : gen_pad
        assign value = {sum_i[VALUE_W-1:0], {PAD{1'b0}}};
      end else begin : gen_no_pad
        assign value = sum_i[VALUE_W-1:0];
      end

      ffd_fx_round #(
        .IN_W (VALUE_W + PAD),
        .DROP (DROP),
        .OUT_W(32)
      ) u_round (
        .value_i    (value),
        .addend_i   (32'd0),
        .value_o    (word),
        .saturated_o(overflow)
      );
      assign saturated = overflow | sum_i[VALUE_W];
      assign nan       = 1'b0;
    end
  endgenerate

  ffd_num_delay #(
    .WIDTH  (34),
    .LATENCY(LATENCY)
  ) u_word (
    .clk(clk),
    .rst(1'b0),
    .d_i({nan, saturated, word}),
    .q_o({nan_o, saturated_o, word_o})
  );
endmodule

`default_nettype wire
