// ffd_dma_address: checks a request against its window and cuts it into bursts
//
// A request is {address, length in bytes}. Refused, with a code, before any burst is offered:
//   1 length 0; 2 address or length not a multiple of 16; 3 beyond the end of the address space;
//   4 not wholly inside [window_first_i, window_last_i], both bytes included.
// What passes is offered as bursts of 16-byte beats that end at every multiple of 16 * MAX_BURST.
// That divides 4096, so no burst crosses 4 KB, and only the first and the last are short. With
// limited_i a burst has limit_i, which is less than `offer_o`, its length without (the writer has
// no more).
// Lengths are beats - 1, as AXI wants them. A request with s_request_check is only checked.
// m_bus_len is the burst's length in beats of DATA_WIDTH bits: where those are 256, a burst may
// begin with the upper half of a beat, and end with the lower one; m_bus_upper: its last 16 bytes
// are an upper half.
// No address leaves the window: first <= next_q <= last_q <= last is kept by every step, whatever
// limit_i and m_burst_ready do. The window must not change between check and last burst (locked).
//
// Pipeline:   accept, sum, check, judge, then a burst; four clocks from one burst to the next; one
//             request at a time. Each clock has one carry chain of an address's width at most, or
//             one comparison. A refusal is a pulse of refused_o four clocks after acceptance. rst
//             forgets the request.
// Parameters: ADDRESS_W 14 to 64, LENGTH_W 5 to ADDRESS_W - 1, MAX_BURST a power of two, 2 to 256.
//             DATA_WIDTH 64, 128 or 256; with 64, MAX_BURST 128 at most. HARDENED 0, or 1: a state
//             that there is not becomes IDLE, with upset_o, a pulse.
// Model:      none (control only).  Test: tests/bus/dma.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_dma_address #(
  parameter ADDRESS_W  = 64,
  parameter LENGTH_W   = 32,
  parameter MAX_BURST  = 256,
  parameter DATA_WIDTH = 128,
  parameter HARDENED   = 0,
  parameter BURST_W    = $clog2(MAX_BURST)
) (
  input  wire                 clk,
  input  wire                 rst,
  input  wire [ADDRESS_W-1:0] window_first_i,
  input  wire [ADDRESS_W-1:0] window_last_i,
  input  wire                 s_request_valid,
  output wire                 s_request_ready,
  input  wire [ADDRESS_W-1:0] s_request_address,
  input  wire [LENGTH_W-1:0]  s_request_length,
  input  wire                 s_request_check,
  output reg                  refused_o,
  output reg  [2:0]           refused_code_o,
  output wire                 upset_o,
  output wire                 m_burst_valid,
  input  wire                 m_burst_ready,
  output wire [ADDRESS_W-1:0] m_burst_address,
  output wire [BURST_W-1:0]   m_burst_len,
  output wire                 m_burst_last,
  output wire [7:0]           m_bus_len,
  output wire                 m_bus_upper,
  output wire [BURST_W-1:0]   offer_o,
  input  wire                 limited_i,
  input  wire [BURST_W-1:0]   limit_i
);
  generate
    if (ADDRESS_W < 14 || ADDRESS_W > 64) begin : gen_bad_address
      ERROR_ffd_dma_address_width_must_be_14_to_64 u_error ();
    end
    if (LENGTH_W < 5 || LENGTH_W >= ADDRESS_W) begin : gen_bad_length
      ERROR_ffd_dma_address_length_must_be_narrower_than_the_address u_error ();
    end
    if (MAX_BURST < 2 || MAX_BURST > 256 || (1 << BURST_W) != MAX_BURST) begin : gen_bad_burst
      ERROR_ffd_dma_address_max_burst_must_be_a_power_of_two_up_to_256 u_error ();
    end
    if (DATA_WIDTH != 128 && DATA_WIDTH != 256 && (DATA_WIDTH != 64 || MAX_BURST > 128))
    begin : gen_bad_width
      ERROR_ffd_dma_address_burst_must_be_256_beats_of_64_128_or_256_bits_at_most u_error ();
    end
  endgenerate

  localparam BEAT_W  = ADDRESS_W - 4;        // numbers a beat in the address space
  localparam COUNT_W = LENGTH_W - 4;
  // Two beats of a request are less than 2^COUNT_W apart: these bits tell their blocks apart.
  localparam SAME_W  = COUNT_W + 1 < BURST_W + 1 ? BURST_W + 1
                     : COUNT_W + 1 > BEAT_W ? BEAT_W : COUNT_W + 1;

  localparam [2:0] IDLE  = 3'd0;
  localparam [2:0] SUM   = 3'd1;    // last_q and below_q
  localparam [2:0] CHECK = 3'd2;    // above_q, and where the burst could end
  localparam [2:0] JUDGE = 3'd3;    // refused, or offer_q
  localparam [2:0] BURST = 3'd4;
  localparam [2:0] NEXT  = 3'd5;    // next_q of the burst that follows

  reg [2:0]         state_q;
  reg [BEAT_W-1:0]  next_q;    // the first beat not yet handed out
  reg [BEAT_W-1:0]  last_q;    // the last beat of the request
  reg [COUNT_W-1:0] more_q;    // beats behind the first, of the request or of a burst
  reg [BURST_W-1:0] left_q;    // from next_q to last_q, where both are in one block
  reg [BURST_W-1:0] offer_q;
  reg               check_q;
  reg               misaligned_q;
  reg               none_q;
  reg               wraps_q;
  reg               below_q;
  reg               above_q;
  reg               same_q;    // the request's last block

  // Not in the clock of a refusal: the requester shall see it before its next request goes in.
  assign s_request_ready = state_q == IDLE && !refused_o;
  assign m_burst_valid   = state_q == BURST;

  wire illegal = HARDENED != 0 && state_q > NEXT;
  assign upset_o = illegal;

  // Where the burst ends: the block or the request, or what limit_i allows.
  wire [BURST_W-1:0] next_low = next_q[BURST_W-1:0];
  wire               step     = m_burst_valid && m_burst_ready;

  assign offer_o     = offer_q;
  assign m_burst_len = limited_i ? limit_i : offer_q;

  // Halves of 256 bits from the first one's start on: two a beat, the last of them may be odd.
  wire [8:0] beats  = {{(9 - BURST_W) {1'b0}}, m_burst_len};
  wire [8:0] halves = beats + {8'd0, next_q[0]};
  assign m_bus_len   = DATA_WIDTH == 64 ? {beats[6:0], 1'b1}
                     : DATA_WIDTH == 256 ? halves[8:1] : beats[7:0];
  assign m_bus_upper = halves[0];

  assign m_burst_address = {next_q, 4'd0};
  assign m_burst_last    = same_q && !limited_i;

  // next_q + more_q, and one more from burst to burst: {sum, a bit that nobody wants}.
  wire [BEAT_W+1:0] sums = {1'b0, next_q, 1'b1}
                         + {{(BEAT_W - COUNT_W + 1) {1'b0}}, more_q, state_q == NEXT};
  // One beat less than the window's first: its four bits within a beat count as one.
  wire [BEAT_W+1:0] borrow = {1'b0, next_q, 1'b0}
                           - {1'b0, window_first_i[ADDRESS_W-1:4], |window_first_i[3:0]};
  wire [2:0]      code = misaligned_q ? 3'd2 : none_q ? 3'd1 : wraps_q ? 3'd3
                       : below_q || above_q ? 3'd4 : 3'd0;

  always @(posedge clk) begin
    if (rst) begin
      state_q   <= IDLE;
      refused_o <= 1'b0;
    end else begin
      refused_o <= 1'b0;
      case (state_q)
        IDLE: if (s_request_valid && s_request_ready) state_q <= SUM;
        SUM: state_q <= CHECK;
        CHECK: state_q <= JUDGE;
        JUDGE: begin
          state_q   <= code == 3'd0 && !check_q ? BURST : IDLE;
          refused_o <= code != 3'd0;
        end
        BURST: if (step) state_q <= m_burst_last ? IDLE : NEXT;
        default: state_q <= illegal ? IDLE : CHECK;
      endcase
    end
  end

  always @(posedge clk) begin
    if (state_q == IDLE) begin
      next_q       <= s_request_address[ADDRESS_W-1:4];
      {none_q, more_q} <= {1'b0, s_request_length[LENGTH_W-1:4]} - 1'b1;
      misaligned_q <= s_request_address[3:0] != 4'd0 || s_request_length[3:0] != 4'd0;
      check_q      <= s_request_check;
    end else if (state_q == NEXT) begin
      next_q <= sums[BEAT_W:1];
    end
    if (step) more_q <= {{(COUNT_W - BURST_W) {1'b0}}, m_burst_len};
    if (state_q == SUM) begin
      {wraps_q, last_q} <= sums[BEAT_W+1:1];
      below_q           <= borrow[BEAT_W+1];
    end
    above_q <= {last_q, 4'hF} > window_last_i;
    same_q  <= next_q[SAME_W-1:BURST_W] == last_q[SAME_W-1:BURST_W];
    left_q  <= last_q[BURST_W-1:0] - next_low;
    if (state_q == JUDGE) begin
      offer_q        <= same_q ? left_q : ~next_low;
      refused_code_o <= code;
    end
  end
  wire unused_ok = &{1'b0, sums[0], borrow[BEAT_W:0]};
endmodule

`default_nettype wire
