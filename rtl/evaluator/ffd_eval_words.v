// ffd_eval_words: the three sums of a vertex become stream words
//
// Three converters side by side, or one in turn where the next sums come 3 clocks later at the
// earliest.
//
// Formats:    sums and words {z, y, x}; the flags are of any component.
// Pipeline:   OUT = FFD_OUT_LATENCY clocks, II 1; SERIAL: OUT + 3 clocks, II 3. Never frozen.
// Parameters: FORMAT and CONVERT_LATENCY as in every organization; SERIAL 0 or 1.
// Not checked: with SERIAL, sums that come sooner (ffd_eval_sequencer keeps them apart).
// Model:      golden/include/hwffd/numerics (out).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_eval_words #(
  parameter FORMAT          = 18,
  parameter CONVERT_LATENCY = 1,
  parameter SERIAL          = 0
) (
  input  wire                              clk,
  input  wire                              rst,
  input  wire                              sum_valid_i,
  input  wire [3*`FFD_SUM_W(FORMAT)-1:0]   sum_i,
  input  wire [`FFD_EXPONENT_W-1:0]        exponent_i,
  output wire                              word_valid_o,
  output wire [95:0]                       words_o,
  output wire                              saturated_o,
  output wire                              nan_o
);
  localparam SUM_W = `FFD_SUM_W(FORMAT);
  localparam OUT   = `FFD_OUT_LATENCY(FORMAT, CONVERT_LATENCY);

  genvar c;
  generate
    if (SERIAL != 0) begin : gen_serial
      reg  [3*SUM_W-1:0]         sum_q;  // the lowest is converted
      reg  [`FFD_EXPONENT_W-1:0] exponent_q;
      reg  [2:0]                 step_q;
      reg  [95:0]                words_q;
      reg  [2:0]                 saturated_q;
      reg  [2:0]                 nan_q;
      wire [31:0]                word;
      wire                       saturated;
      wire                       nan;
      wire                       last;

      always @(posedge clk) begin
        step_q <= rst ? 3'd0 : {step_q[1:0], sum_valid_i};
        sum_q  <= sum_valid_i ? sum_i : {sum_q[3*SUM_W-1 -: SUM_W], sum_q[3*SUM_W-1 : SUM_W]};
        if (sum_valid_i) exponent_q <= exponent_i;
      end

      ffd_num_out #(
        .FORMAT (FORMAT),
        .LATENCY(OUT)
      ) u_out (
        .clk        (clk),
        .sum_i      (sum_q[SUM_W-1:0]),
        .exponent_i (exponent_q),
        .word_o     (word),
        .saturated_o(saturated),
        .nan_o      (nan)
      );

      // The last one goes on as it comes.
      always @(posedge clk) begin
        words_q     <= {word, words_q[95:32]};
        saturated_q <= {saturated, saturated_q[2:1]};
        nan_q       <= {nan, nan_q[2:1]};
      end

      ffd_num_delay #(
        .WIDTH  (1),
        .LATENCY(OUT),
        .RESET  (1)
      ) u_last (
        .clk(clk),
        .rst(rst),
        .d_i(step_q[2]),
        .q_o(last)
      );

      assign word_valid_o = last;
      assign words_o      = {word, words_q[95:32]};
      assign saturated_o  = saturated || saturated_q[2] || saturated_q[1];
      assign nan_o        = nan || nan_q[2] || nan_q[1];
      wire unused_ok = &{1'b0, words_q, saturated_q, nan_q};
    end else begin : gen_parallel
      wire [2:0] saturated;
      wire [2:0] nan;
      for (c = 0; c < 3; c = c + 1) begin : gen_component
        ffd_num_out #(
          .FORMAT (FORMAT),
          .LATENCY(OUT)
        ) u_out (
          .clk        (clk),
          .sum_i      (sum_i[c*SUM_W +: SUM_W]),
          .exponent_i (exponent_i),
          .word_o     (words_o[32*c +: 32]),
          .saturated_o(saturated[c]),
          .nan_o      (nan[c])
        );
      end

      ffd_num_delay #(
        .WIDTH  (1),
        .LATENCY(OUT),
        .RESET  (1)
      ) u_word_valid (
        .clk(clk),
        .rst(rst),
        .d_i(sum_valid_i),
        .q_o(word_valid_o)
      );
      assign saturated_o = |saturated;
      assign nan_o       = |nan;
    end
  endgenerate
endmodule

`default_nettype wire
