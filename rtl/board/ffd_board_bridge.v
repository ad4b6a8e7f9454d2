// ffd_board_bridge: frames on a serial line become packets of beats, results become bytes
//
// A frame is two bytes, the number of beats (lower byte first), then 16 bytes a beat, word 0 first
// and the lower byte of a word first; its last beat has tlast. A count of 0 is an empty frame. A
// result is 16 bytes alike, with tlast in bit 31 of word 3 (synth/boards/README.md).
//
// Bad input:  a byte without a stop bit, a break, and a byte for which there is no room break a
//             frame off; what follows is ignored until the line has been high for PAUSE clocks. A
//             pause breaks off a frame, too. A packet that had begun is ended then: the rest of its
//             beat is filled with zeros (a beat of zeros where none is under way), with tlast.
// Pipeline:   a beat is offered in the clock after its last byte; a result's first byte is taken by
//             the line in the clock in which both are ready.
// Freezes:    the line cannot wait: a beat must be taken before the next byte of its frame comes.
// Parameters: CLOCKS a bit, 4 or more; PAUSE_W, PAUSE is 2^PAUSE_W - 1 clocks and longer than a
//             character.
// Model:      tests/boards/frame_model.hpp.  Test: tests/boards.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_board_bridge #(
  parameter CLOCKS  = 12,
  parameter PAUSE_W = 20
) (
  input  wire         clk,
  input  wire         rst,
  input  wire         uart_rx_i,
  output wire         uart_tx_o,
  output reg          m_beat_valid,
  input  wire         m_beat_ready,
  output reg  [127:0] m_beat_data,
  output reg          m_beat_last,
  input  wire         s_beat_valid,
  output reg          s_beat_ready,
  input  wire [127:0] s_beat_data,
  input  wire         s_beat_last
);
  generate
    if ((1 << PAUSE_W) < 16 * CLOCKS) begin : gen_bad_pause
      ERROR_ffd_board_bridge_pause_must_be_longer_than_a_character u_error ();
    end
  endgenerate

  // ---- the line

  wire       line;
  wire       byte_valid;
  wire [7:0] byte_data;
  wire       byte_error;

  ffd_board_uart_rx #(
    .CLOCKS(CLOCKS)
  ) u_rx (
    .clk         (clk),
    .rst         (rst),
    .uart_rx_i   (uart_rx_i),
    .line_o      (line),
    .byte_valid_o(byte_valid),
    .byte_o      (byte_data),
    .error_o     (byte_error)
  );

  reg  [PAUSE_W-1:0] quiet_q;
  wire               pause = &quiet_q;

  always @(posedge clk) begin
    if (rst || !line) quiet_q <= {PAUSE_W{1'b0}};
    else if (!pause) quiet_q <= quiet_q + 1'b1;
  end

  // ---- where the next byte belongs

  localparam [2:0] COUNT_LOW  = 3'd0;
  localparam [2:0] COUNT_HIGH = 3'd1;
  localparam [2:0] BEATS      = 3'd2;
  localparam [2:0] BROKEN     = 3'd3;  // until a pause
  localparam [2:0] CLOSE      = 3'd4;  // zeros to the end of a beat

  reg  [2:0]  state_q;
  reg  [2:0]  state_d;
  reg         open_q;   // the packet has begun, and no tlast was there
  reg  [15:0] count_q;  // beats to come
  reg  [3:0]  place_q;
  wire [15:0] count     = {byte_data, count_q[7:0]};
  wire        room      = !m_beat_valid;
  wire        last_beat = count_q == 16'd1;
  wire        shift     = room && (state_q == CLOSE || (state_q == BEATS && byte_valid));
  wire        full      = shift && &place_q;
  wire        ends      = full && (state_q == CLOSE || last_beat);
  wire        breaks    = byte_error || (byte_valid && !room && state_q == BEATS);

  always @* begin
    state_d = state_q;
    case (state_q)
      COUNT_LOW:  if (byte_valid) state_d = COUNT_HIGH;
      COUNT_HIGH:
        if (byte_valid) state_d = count == 16'd0 ? COUNT_LOW : BEATS;
        else if (pause) state_d = COUNT_LOW;
      BEATS:
        if (ends) state_d = COUNT_LOW;
        else if (pause) state_d = CLOSE;
      BROKEN:     if (pause) state_d = open_q ? CLOSE : COUNT_LOW;
      CLOSE:      if (ends) state_d = COUNT_LOW;
      default:    state_d = COUNT_LOW;
    endcase
    if (breaks) state_d = BROKEN;
  end

  always @(posedge clk) begin
    if (rst) state_q <= COUNT_LOW;
    else state_q <= state_d;
  end

  always @(posedge clk) begin
    if (rst || ends) open_q <= 1'b0;
    else if (state_q == BEATS) open_q <= 1'b1;
  end

  always @(posedge clk) begin
    if (state_q == COUNT_LOW && byte_valid) count_q[7:0] <= byte_data;
    else if (state_q == COUNT_HIGH && byte_valid) count_q <= count;
    else if (full) count_q <= count_q - 16'd1;
  end

  // ---- the beat

  always @(posedge clk) begin
    if (rst) place_q <= 4'd0;
    else place_q <= place_q + {3'd0, shift};
  end

  always @(posedge clk) begin
    if (rst) m_beat_valid <= 1'b0;
    else m_beat_valid <= full || (m_beat_valid && !m_beat_ready);
  end

  always @(posedge clk) begin
    if (shift) begin
      m_beat_data <= {state_q == CLOSE ? 8'd0 : byte_data, m_beat_data[127:8]};
      m_beat_last <= ends;
    end
  end

  // ---- results: the source holds its beat until the clock after its last byte is taken, in which
  // the line takes no byte

  reg  [3:0]   sent_q;
  wire         byte_ready;
  wire [127:0] result = {s_beat_last, s_beat_data[126:0]};

  wire         sent = s_beat_valid && byte_ready;

  always @(posedge clk) begin
    if (rst) sent_q <= 4'd0;
    else sent_q <= sent_q + {3'd0, sent};
  end

  always @(posedge clk) s_beat_ready <= sent && &sent_q && !rst;

  ffd_board_uart_tx #(
    .CLOCKS(CLOCKS)
  ) u_tx (
    .clk         (clk),
    .rst         (rst),
    .s_byte_valid(s_beat_valid),
    .s_byte_ready(byte_ready),
    .s_byte_data (result[8*sent_q +: 8]),
    .uart_tx_o   (uart_tx_o)
  );

  wire unused_ok = &{1'b0, s_beat_data[127]};
endmodule

`default_nettype wire
