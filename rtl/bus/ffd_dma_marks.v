// ffd_dma_marks: which bursts hold the last result of a packet that asked for an interrupt
//
// Beats of bursts go by (beat_i; mark_i, it asked; last_i, of its burst) in the order of the
// bursts, and their answers come in the same order (answer_i). counted_i, a clock later, says that
// the answer was good, and marked_o, another clock later, that such a beat is in the burst.
//
// Pipeline:   2 clocks.
// Parameters: MARKS 0: nothing is built. OUTSTANDING, a power of two >= 2: bursts whose data has
//             left and that are not answered, at most.
// Model:      none (control only).  Test: tests/bus/dma/marks_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"

module ffd_dma_marks #(
  parameter OUTSTANDING = 8,
  parameter MARKS       = 0
) (
  input  wire clk,
  input  wire rst,
  input  wire beat_i,
  input  wire mark_i,
  input  wire last_i,
  input  wire answer_i,
  input  wire counted_i,
  output wire marked_o
);
  generate
    if (MARKS == 0) begin : gen_none
      assign marked_o = 1'b0;
      wire unused_ok = &{1'b0, clk, rst, beat_i, mark_i, last_i, answer_i, counted_i};
    end else begin : gen_marks
      reg  before_q;    // a beat of the burst before this one
      reg  burst_q;     // the burst that was answered
      reg  marked_q;
      wire some = before_q || mark_i;
      wire queue_ready;
      wire known;
      wire marked;

      ffd_stream_fifo #(
        .WIDTH(1),
        .DEPTH(OUTSTANDING)
      ) u_bursts (
        .clk         (clk),
        .rst         (rst),
        .s_word_valid(beat_i && last_i),
        .s_word_ready(queue_ready),
        .s_word_data (some),
        .m_word_valid(known),
        .m_word_ready(answer_i),
        .m_word_data (marked)
      );

      always @(posedge clk) begin
        if (rst) before_q <= 1'b0;
        else if (beat_i) before_q <= some && !last_i;
      end

      always @(posedge clk) begin
        burst_q  <= known && marked;
        marked_q <= burst_q && counted_i && !rst;
      end

      assign marked_o = marked_q;
      wire unused_ok = &{1'b0, queue_ready};
      `FFD_ASSERT(a_burst_ends_and_too_many_are_open, !(beat_i && last_i) || queue_ready)
    end
  endgenerate
endmodule

`default_nettype wire
