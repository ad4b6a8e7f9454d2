// ffd_stream_encoder: a result becomes a beat {status, tag, z, y, x}
//
// Status bits (docs/interface.md section 4): 0 saturated, 1 clamped, 2 NaN, 3 outside, 4 truncated,
// 5 unloaded, 6 folded: det J, which is the word x of its result, is not positive; the rest is 0. A
// blank vertex gives blank coordinates (canonical NaN, or 0 in fixed
// point), never what the datapath made of half a vertex. Beside a determinant y and z are 0.
//
// The words of a vertex of a packet with the flag H are rounded to 20 bits, which may saturate, and
// ffd_stream_halves makes beats of two such results. What packets ask for behind their last result,
// ffd_stream_marks adds. With PAIRS the position of a second vertex with H may come with one, which
// shares all of its user word that a half beat has: neither is blank. With UNITS 2 the next result
// of the same vertex may come with one: a beat of two units of 16 bytes, the first one low.
//
// Formats:    flags {folded, nan, saturated}; user as FFD_USER_*.
// Pipeline:   1 clock: the last register of the stream; with halves and with marks one more each.
// Freezes:    s_word_ready is 0 while a beat waits to be taken.
// Parameters: FORMAT as in ffd_num.vh, fixed point where FEATURES has halves; FEATURES and
//             INSIDE as in ffd_stream_marks, PAIRS in ffd_stream_halves; UNITS 1, or 2 without
//             PAIRS.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_stream.vh"

module ffd_stream_encoder #(
  parameter FORMAT   = 18,
  parameter FEATURES = `FFD_FEATURES_USUAL,
  parameter INSIDE   = 152,
  parameter PAIRS    = 0,
  parameter UNITS    = 1
) (
  input  wire                    clk,
  input  wire                    rst,
  output wire                    idle_o,
  // A beat of the decoder: word 0.
  input  wire                    valid_i,
  input  wire [31:0]             data_i,
  input  wire [`FFD_FRAME_W-1:0] frame_i,
  input  wire                    s_word_valid,
  output wire                    s_word_ready,
  output wire                    saturates_o,   // a word of the result that is there
  input  wire [96*UNITS-1:0]     s_word_data,
  input  wire [3*UNITS-1:0]      s_word_flags,
  input  wire                    s_word_determinant,
  input  wire                    s_word_final,  // of its vertex, which tlast comes with
  input  wire [`FFD_USER_W-1:0]  s_word_user,
  input  wire                    s_word_pair,    // there is a second vertex
  input  wire [97:0]             s_word_second,  // {nan, saturated, words} of it
  input  wire                    s_word_two,     // there is a second result
  output wire                    second_saturates_o,  // of a second vertex or result
  output wire                    m_beat_valid,
  input  wire                    m_beat_ready,
  output wire [128*UNITS-1:0]    m_beat_data,
  output wire                    m_beat_two,
  output wire                    m_beat_last,
  output wire                    m_beat_mark
);
  // ---- words of results that are half a beat: rounded once more, in their upper 20 bits

  wire        narrows = s_word_user[`FFD_USER_HALF] && !s_word_determinant;
  wire [95:0] words;
  wire [2:0]  narrow_saturated;
  genvar c;
  generate
    for (c = 0; c < 3; c = c + 1) begin : gen_word
      if (`FFD_FEATURE_HALVES(FEATURES) != 0) begin : gen_half
        wire [19:0] half;
        ffd_num_half #(
          .FORMAT(FORMAT)
        ) u_half (
          .word_i     (s_word_data[32*c +: 32]),
          .half_o     (half),
          .saturated_o(narrow_saturated[c])
        );
        assign words[32*c +: 32] = {narrows ? half : s_word_data[32*c+12 +: 20],
                                    s_word_data[32*c +: 12]};
      end else begin : gen_full
        assign words[32*c +: 32]   = s_word_data[32*c +: 32];
        assign narrow_saturated[c] = 1'b0;
      end
    end
  endgenerate

  wire       blank     = s_word_user[`FFD_USER_BLANK];
  wire       saturates = s_word_flags[0] || (narrows && |narrow_saturated);
  wire [2:0] flags     = {s_word_flags[2:1], saturates} & {3{!blank}};
  wire [6:0] raised    = {flags[2], 3'd0, flags[1], 1'b0, flags[0]};
  assign saturates_o = flags[0];

  // The words y and z are 0 beside a determinant, and where the blank word is.
  wire clear = blank ? `FFD_BLANK_IS_ZERO(FORMAT) : s_word_determinant;

  reg [95:0] words_q;
  reg [6:0]  status_q;
  reg [15:0] tag_q;
  reg        valid_q;
  reg        last_q;
  reg        half_q;
  reg        blank_q;
  reg        first_q;
  reg        final_q;
  wire       ready;
  wire         half_valid;
  wire         half_ready;
  wire         half_two;
  wire         half_last;
  wire [128*UNITS-1:0] half_data;
  assign s_word_ready = !valid_q || ready;
  assign idle_o       = !valid_q && !half_valid && !m_beat_valid;

  always @(posedge clk) begin
    if (rst) valid_q <= 1'b0;
    else if (s_word_ready) valid_q <= s_word_valid;
  end
  always @(posedge clk) begin
    if (s_word_ready && blank) words_q[31:0] <= `FFD_BLANK_WORD(FORMAT);
    else if (s_word_ready) words_q[31:0] <= words[31:0];
  end
  always @(posedge clk) begin
    if (s_word_ready && clear) words_q[95:32] <= 64'd0;
    else if (s_word_ready && blank) words_q[95:32] <= {2{`FFD_BLANK_WORD(FORMAT)}};
    else if (s_word_ready) words_q[95:32] <= words[95:32];
  end
  always @(posedge clk) begin
    if (s_word_ready) begin
      status_q <= {1'b0, s_word_user[`FFD_USER_STATUS]} | raised;
      tag_q    <= s_word_user[`FFD_USER_TAG];
      last_q   <= s_word_user[`FFD_USER_LAST] && s_word_final;
      half_q   <= s_word_user[`FFD_USER_HALF];
      blank_q  <= blank;
      first_q  <= !s_word_determinant;
      final_q  <= s_word_final;
    end
  end

  wire        pair;
  wire [60:0] second;
  wire        two;
  wire [128*UNITS-1:0] beat;
  assign beat[127:0] = {9'd0, status_q, tag_q, words_q};
  generate
    if (PAIRS != 0) begin : gen_second
      wire [59:0] halves;
      wire [2:0]  saturated;
      reg         pair_q;
      reg  [60:0] second_q;
      for (c = 0; c < 3; c = c + 1) begin : gen_word
        ffd_num_half #(
          .FORMAT(FORMAT)
        ) u_half (
          .word_i     (s_word_second[32*c +: 32]),
          .half_o     (halves[20*c +: 20]),
          .saturated_o(saturated[c])
        );
      end
      assign second_saturates_o = s_word_pair && (s_word_second[96] || |saturated);
      always @(posedge clk) begin
        if (s_word_ready) begin
          pair_q   <= s_word_pair;
          second_q <= {s_word_second[96] || |saturated, halves};
        end
      end
      assign pair   = pair_q;
      assign second = second_q;
      assign two    = 1'b0;
      wire unused_second = &{1'b0, s_word_second[97], s_word_two};
    end else if (UNITS == 2) begin : gen_two
      // A result of four: not of a packet with H, and no determinant.
      reg        two_q;
      reg [95:0] second_words_q;
      reg [6:0]  second_status_q;
      wire [1:0] second_flags = s_word_flags[4:3] & {2{!blank}};
      always @(posedge clk) begin
        if (s_word_ready) begin
          two_q           <= s_word_two;
          second_status_q <= {1'b0, s_word_user[`FFD_USER_STATUS]}
                           | {4'd0, second_flags[1], 1'b0, second_flags[0]};
        end
      end
      always @(posedge clk) begin
        if (s_word_ready && blank) second_words_q <= {3{`FFD_BLANK_WORD(FORMAT)}};
        else if (s_word_ready) second_words_q <= s_word_data[191:96];
      end
      assign second_saturates_o = s_word_two && second_flags[0];
      assign {pair, second}     = 62'd0;
      assign two                = two_q;
      assign beat[255:128]      = {9'd0, second_status_q, tag_q, second_words_q};
      wire unused_second = &{1'b0, s_word_pair, s_word_second, s_word_flags[5]};
    end else begin : gen_no_second
      assign {second_saturates_o, pair, second, two} = 64'd0;
      wire unused_second = &{1'b0, s_word_pair, s_word_second, s_word_two};
    end
  endgenerate

  ffd_stream_halves #(
    .FEATURES(FEATURES),
    .PAIRS   (PAIRS),
    .UNITS   (UNITS)
  ) u_halves (
    .clk         (clk),
    .rst         (rst),
    .s_beat_valid(valid_q),
    .s_beat_ready(ready),
    .s_beat_data (beat),
    .s_beat_two  (two),
    .s_beat_last (last_q),
    .s_beat_half (half_q),
    .s_beat_blank(blank_q),
    .s_beat_first(first_q),
    .s_beat_final(final_q),
    .s_beat_pair  (pair),
    .s_beat_second(second),
    .m_beat_valid(half_valid),
    .m_beat_ready(half_ready),
    .m_beat_data (half_data),
    .m_beat_two  (half_two),
    .m_beat_last (half_last)
  );

  ffd_stream_marks #(
    .FEATURES(FEATURES),
    .INSIDE  (INSIDE),
    .UNITS   (UNITS)
  ) u_marks (
    .clk         (clk),
    .rst         (rst),
    .valid_i     (valid_i),
    .data_i      (data_i),
    .frame_i     (frame_i),
    .s_beat_valid(half_valid),
    .s_beat_ready(half_ready),
    .s_beat_data (half_data),
    .s_beat_two  (half_two),
    .s_beat_last (half_last),
    .m_beat_valid(m_beat_valid),
    .m_beat_ready(m_beat_ready),
    .m_beat_data (m_beat_data),
    .m_beat_two  (m_beat_two),
    .m_beat_last (m_beat_last),
    .m_beat_mark (m_beat_mark)
  );

  wire unused_ok = &{1'b0, s_word_user};
endmodule

`default_nettype wire
