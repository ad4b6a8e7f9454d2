// ffd_eval_order: results leave in the order of their user words, which say what kind they are
//
// Sums become words in one queue, determinants come later and wait in another, user words wait in a
// third; the head of the third says which of the others is next.
//
// With SUMS 4 a vertex has one user word, and its four results are queued side by side. RESULTS 1:
// they leave one after the other, as many as the vertex wants: its position; that and its three
// derivatives; that and det J; or det J alone. RESULTS 2: four of them leave two at once, in the
// same order. RESULTS 4: all leave at once.
//
// With PAIRS the result of a second vertex goes beside each one, and leaves with it.
//
// Formats:    words {z, y, x} of each result, flags {folded, nan, saturated} of each; of a
//             determinant the words are {any, any, det J}. Of a second vertex {nan, saturated,
//             words}.
// Pipeline:   3 clocks from a word to its result.
// Freezes:    a result waits for m_result_ready; nothing behind takes notice.
// Parameters: SUMS 1 or 4; RESULTS 1 or SUMS, or 2 with SUMS 4; USER_W >= 1; DEPTH a power of two
//             >= 4, the most vertices inside; DETERMINANT 0, or 1 with RESULTS 1 or 2; APART 0:
//             determinants come before the next sum, so SUMS 1 needs one queue only. PAIRS 0, or
//             1 with SUMS 1.
// Not checked: room, which who lets vertices in must count.
// Model:      golden/include/hwffd/model/evaluator.hpp.  Test: tests/system, tests/evaluator.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"

module ffd_eval_order #(
  parameter SUMS        = 1,
  parameter RESULTS     = 1,
  parameter USER_W      = 16,
  parameter DEPTH       = 16,
  parameter DETERMINANT = 1,
  parameter APART       = 1,
  parameter PAIRS       = 0
) (
  input  wire                  clk,
  input  wire                  rst,
  // A vertex that has come, and what of it is wanted.
  input  wire                  take_i,
  input  wire                  take_determinant_i,
  input  wire                  take_alone_i,  // of one pass: no position
  input  wire                  take_four_i,
  input  wire [USER_W-1:0]     take_user_i,
  input  wire                  word_valid_i,
  input  wire [SUMS*96-1:0]    words_i,
  input  wire [SUMS-1:0]       saturated_i,
  input  wire [SUMS-1:0]       nan_i,
  input  wire [97:0]           second_i,
  input  wire                  determinant_valid_i,
  input  wire [31:0]           determinant_i,
  input  wire [2:0]            determinant_flags_i,
  output wire                  m_result_valid,
  input  wire                  m_result_ready,
  output wire [RESULTS*96-1:0] m_result_words,
  output wire [RESULTS*3-1:0]  m_result_flags,
  output wire                  m_result_determinant,
  output wire                  m_result_two,   // with RESULTS 2: two are there, else the first
  output wire                  m_result_last,  // of the results of its user word
  output wire [USER_W-1:0]     m_result_user,
  output wire [97:0]           m_result_second
);
  localparam WORDS_W  = SUMS * 96;
  localparam OWN_W    = 1 + 3 * SUMS + WORDS_W;
  localparam RESULT_W = OWN_W + 98 * PAIRS;
  localparam TOGETHER = SUMS == 1 && APART == 0;  // both kinds in one queue

  generate
    if (RESULTS != 1 && (SUMS == 1 || RESULTS != 2)
        && (RESULTS != SUMS || DETERMINANT != 0)) begin : gen_bad_results
      ERROR_ffd_eval_order_results_must_be_1_or_2_of_sums_4_or_all_without_determinant u_error ();
    end
  endgenerate

  wire                leave = m_result_valid && m_result_ready && m_result_last;
  wire [3*SUMS-1:0]   flags;
  wire                results_ready;
  wire                result_valid;
  wire                result_ready;
  wire                result_determinant;
  wire [3*SUMS-1:0]   result_flags;
  wire [WORDS_W-1:0]  result_words;
  wire                users_ready;
  wire                user_valid;
  wire                user_determinant;
  wire                user_alone;
  wire                user_four;
  wire                waiting_valid;
  wire [2:0]          waiting_flags;
  wire [31:0]         waiting;

  genvar r;
  generate
    for (r = 0; r < SUMS; r = r + 1) begin : gen_flags
      assign flags[3*r +: 3] = {1'b0, nan_i[r], saturated_i[r]};
    end
  endgenerate

  wire                own   = TOGETHER && determinant_valid_i;
  wire [RESULT_W-1:0] queued;
  assign queued[OWN_W-1]              = own;
  assign queued[WORDS_W +: 3 * SUMS]  = own ? {SUMS{determinant_flags_i}} : flags;
  assign queued[WORDS_W-1:32]         = words_i[WORDS_W-1:32];
  assign queued[31:0]                 = own ? determinant_i : words_i[31:0];

  wire [RESULT_W-1:0] head_result;
  generate
    if (PAIRS != 0) begin : gen_second
      assign queued[RESULT_W-1 -: 98] = second_i;
      assign m_result_second          = head_result[RESULT_W-1 -: 98];
    end else begin : gen_no_second
      assign m_result_second = 98'd0;
      wire unused_second = &{1'b0, second_i};
    end
  endgenerate
  assign {result_determinant, result_flags, result_words} = head_result[OWN_W-1:0];

  ffd_stream_queue #(
    .WIDTH(RESULT_W),
    .DEPTH(DEPTH)
  ) u_results (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(word_valid_i || own),
    .s_word_ready(results_ready),
    .s_word_data (queued),
    .m_word_valid(result_valid),
    .m_word_ready(result_ready),
    .m_word_data (head_result)
  );

  // A user word is there whenever its result is. Beside it what it wants, as far as that is not
  // known otherwise.
  localparam EXTRA = SUMS != 1 ? 3 : TOGETHER ? 0 : 1;
  wire [USER_W+2:0] user = {take_alone_i, take_four_i, take_determinant_i, take_user_i};
  wire [USER_W+2:0] head;
  generate
    if (EXTRA < 3) begin : gen_known
      assign head[USER_W+2 : USER_W+EXTRA] = {3 - EXTRA {1'b0}};
    end
  endgenerate
  assign {user_alone, user_four, user_determinant, m_result_user} = head;

  ffd_stream_queue #(
    .WIDTH(USER_W + EXTRA),
    .DEPTH(DEPTH)
  ) u_users (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(take_i),
    .s_word_ready(users_ready),
    .s_word_data (user[USER_W+EXTRA-1:0]),
    .m_word_valid(user_valid),
    .m_word_ready(leave),
    .m_word_data (head[USER_W+EXTRA-1:0])
  );

  generate
    if (DETERMINANT != 0 && !TOGETHER) begin : gen_determinants
      wire waiting_ready;
      ffd_stream_queue #(
        .WIDTH(35),
        .DEPTH(SUMS == 1 ? DEPTH / 2 : DEPTH)
      ) u_determinants (
        .clk         (clk),
        .rst         (rst),
        .s_word_valid(determinant_valid_i),
        .s_word_ready(waiting_ready),
        .s_word_data ({determinant_flags_i, determinant_i}),
        .m_word_valid(waiting_valid),
        .m_word_ready(leave && user_determinant),
        .m_word_data ({waiting_flags, waiting})
      );
      wire unused_ok = &{1'b0, waiting_ready};
      `FFD_ASSERT(a_determinant_comes_and_the_queue_is_full,
                  !determinant_valid_i || waiting_ready)
    end else begin : gen_no_determinants
      assign waiting_valid = 1'b0;
      assign waiting_flags = 3'd0;
      assign waiting       = 32'd0;
      wire unused_ok = &{1'b0, determinant_valid_i, determinant_flags_i, determinant_i};
    end
  endgenerate

  generate
    if (SUMS != 1 && RESULTS < SUMS) begin : gen_in_turn
      localparam [1:0] LAST_OF_FOUR = RESULTS == 2 ? 2'd2 : 2'd3;
      reg  [1:0] part_q;
      wire [1:0] last = user_alone ? 2'd0 : user_determinant ? 2'd1
                      : user_four ? LAST_OF_FOUR : 2'd0;
      wire [1:0] next = part_q + (m_result_two ? 2'd2 : 2'd1);
      always @(posedge clk) begin
        if (rst) part_q <= 2'd0;
        else if (m_result_valid && m_result_ready) part_q <= m_result_last ? 2'd0 : next;
      end
      wire [191:0] two_words = part_q[1] ? result_words[383:192] : result_words[191:0];
      wire [5:0]   two_flags = part_q[1] ? result_flags[11:6] : result_flags[5:0];
      wire [95:0]  words;
      wire [2:0]   one_flags;
      if (RESULTS == 2) begin : gen_two
        // Part 1 is that of det J only.
        assign m_result_two           = user_four && !user_determinant;
        assign m_result_words[191:96] = two_words[191:96];
        assign m_result_flags[5:3]    = two_flags[5:3];
        assign {one_flags, words}     = {two_flags[2:0], two_words[95:0]};
      end else begin : gen_one
        assign m_result_two       = 1'b0;
        assign {one_flags, words} = part_q[0] ? {two_flags[5:3], two_words[191:96]}
                                              : {two_flags[2:0], two_words[95:0]};
      end
      assign result_ready         = leave;
      assign m_result_determinant = user_determinant && (part_q[0] || user_alone);
      assign m_result_last        = part_q == last;
      assign m_result_valid = user_valid && result_valid
                           && (waiting_valid || !m_result_determinant);
      assign m_result_words[95:0] = {words[95:32], m_result_determinant ? waiting : words[31:0]};
      assign m_result_flags[2:0]  = m_result_determinant ? waiting_flags : one_flags;
      wire unused_ok = &{1'b0, result_determinant};
    end else if (DETERMINANT != 0 && !TOGETHER) begin : gen_apart
      assign result_ready         = leave && !user_determinant;
      assign m_result_determinant = user_determinant;
      assign m_result_two         = 1'b0;
      assign m_result_last        = 1'b1;
      assign m_result_valid = user_valid && (user_determinant ? waiting_valid : result_valid);
      assign m_result_words = {result_words[95:32],
                               user_determinant ? waiting : result_words[31:0]};
      assign m_result_flags = user_determinant ? waiting_flags : result_flags;
      wire unused_ok = &{1'b0, result_determinant, user_four, user_alone};
    end else begin : gen_as_they_come
      assign result_ready         = m_result_ready;
      assign m_result_determinant = result_determinant;
      assign m_result_two         = 1'b0;
      assign m_result_last        = 1'b1;
      assign m_result_valid       = result_valid;
      assign m_result_words       = result_words;
      assign m_result_flags       = result_flags;
      wire unused_ok = &{1'b0, user_valid, user_determinant, user_four, user_alone, waiting_valid,
                         waiting_flags, waiting};
    end
  endgenerate

  // Who counts vertices leaves room in all of them.
  wire unused_ok = &{1'b0, users_ready, results_ready, user};

  `FFD_ASSERT(a_result_comes_and_the_queue_is_full,
              !(word_valid_i || own) || results_ready)
  `FFD_ASSERT(a_vertex_comes_and_the_queue_is_full,
              !take_i || users_ready)
  `FFD_ASSERT(a_result_comes_of_a_vertex_that_did_not,
              !(word_valid_i || own) || user_valid)
endmodule

`default_nettype wire
