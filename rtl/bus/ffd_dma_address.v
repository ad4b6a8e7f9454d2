// ffd_dma_address: checks a request against its window and cuts it into bursts
//
// A request is {address, length in bytes}. Refused, with a code, before any burst is offered:
//   1 length 0; 2 address or length not a multiple of 16; 3 beyond the end of the address space;
//   4 not wholly inside [window_first_i, window_last_i], both bytes included.
// What passes is offered as bursts of 16-byte beats that end at every multiple of 16 * MAX_BURST.
// That divides 4096, so no burst crosses 4 KB, and only the first and the last are short. A burst
// is at most limit_i beats long as well (the writer has no more); `offer_o` is its length without.
// Lengths are beats - 1, as AXI wants them.
// No address leaves the window: first <= next_q <= last_q <= last is kept by every step, whatever
// limit_i and m_burst_ready do. The window must not change between check and last burst (locked).
//
// Pipeline:   accept, sum, check, then one burst a clock; one request at a time. A refusal is a
//             pulse of refused_o two clocks after acceptance. rst forgets the request.
// Parameters: ADDRESS_W 14 to 64, LENGTH_W 5 to ADDRESS_W - 1, MAX_BURST a power of two, 2 to 256.
// Model:      none (control only).  Test: tests/bus/dma.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_dma_address #(
  parameter ADDRESS_W = 64,
  parameter LENGTH_W  = 32,
  parameter MAX_BURST = 256,
  parameter BURST_W   = $clog2(MAX_BURST)
) (
  input  wire                 clk,
  input  wire                 rst,
  input  wire [ADDRESS_W-1:0] window_first_i,
  input  wire [ADDRESS_W-1:0] window_last_i,
  input  wire                 s_request_valid,
  output wire                 s_request_ready,
  input  wire [ADDRESS_W-1:0] s_request_address,
  input  wire [LENGTH_W-1:0]  s_request_length,
  output reg                  refused_o,
  output reg  [2:0]           refused_code_o,
  output wire                 m_burst_valid,
  input  wire                 m_burst_ready,
  output wire [ADDRESS_W-1:0] m_burst_address,
  output wire [7:0]           m_burst_len,
  output wire                 m_burst_last,
  output wire [7:0]           offer_o,
  input  wire [7:0]           limit_i
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
  endgenerate

  localparam BEAT_W  = ADDRESS_W - 4;        // numbers a beat in the address space
  localparam BLOCK_W = BEAT_W - BURST_W;     // numbers a block of MAX_BURST beats
  localparam COUNT_W = LENGTH_W - 4;

  localparam [1:0] IDLE = 2'd0;
  localparam [1:0] SUM = 2'd1;
  localparam [1:0] CHECK = 2'd2;
  localparam [1:0] BURST = 2'd3;

  reg [1:0]         state_q;
  reg [BEAT_W-1:0]  next_q;    // the first beat not yet handed out
  reg [BEAT_W-1:0]  last_q;    // the last beat of the request
  reg [COUNT_W-1:0] beats_q;
  reg               misaligned_q;
  reg               wraps_q;

  // Not in the clock of a refusal: the requester shall see it before its next request goes in.
  assign s_request_ready = state_q == IDLE && !refused_o;
  assign m_burst_valid   = state_q == BURST;

  // Where the burst ends: the block or the request, or what limit_i allows.
  wire [BURST_W-1:0] next_low   = next_q[BURST_W-1:0];
  wire               last_block = next_q[BEAT_W-1:BURST_W] == last_q[BEAT_W-1:BURST_W];
  wire [BURST_W-1:0] offer      = last_block ? last_q[BURST_W-1:0] - next_low : ~next_low;
  wire               limited    = {{(8 - BURST_W + 1) {1'b0}}, offer} > {1'b0, limit_i};
  wire [BURST_W-1:0] len        = limited ? limit_i[BURST_W-1:0] : offer;
  wire [BEAT_W-1:0]  after      = next_q + {{BLOCK_W {1'b0}}, len} + 1'b1;
  wire               step       = m_burst_valid && m_burst_ready;

  generate
    if (BURST_W == 8) begin : gen_whole
      assign offer_o     = offer;
      assign m_burst_len = len;
    end else begin : gen_padded
      assign offer_o     = {{(8 - BURST_W) {1'b0}}, offer};
      assign m_burst_len = {{(8 - BURST_W) {1'b0}}, len};
    end
  endgenerate
  assign m_burst_address = {next_q, 4'd0};
  assign m_burst_last    = last_block && !limited;

  wire [BEAT_W:0] sum = {1'b0, next_q} + {{(BEAT_W - COUNT_W + 1) {1'b0}}, beats_q}
                      - {{BEAT_W {1'b0}}, 1'b1};
  wire            outside = {next_q, 4'h0} < window_first_i || {last_q, 4'hF} > window_last_i;
  wire [2:0]      code    = beats_q == {COUNT_W {1'b0}} && !misaligned_q ? 3'd1
                          : misaligned_q ? 3'd2 : wraps_q ? 3'd3 : outside ? 3'd4 : 3'd0;

  always @(posedge clk) begin
    if (rst) begin
      state_q   <= IDLE;
      refused_o <= 1'b0;
    end else begin
      refused_o <= 1'b0;
      case (state_q)
        IDLE: if (s_request_valid && s_request_ready) state_q <= SUM;
        SUM: state_q <= CHECK;
        CHECK: begin
          state_q   <= code == 3'd0 ? BURST : IDLE;
          refused_o <= code != 3'd0;
        end
        default: if (step && m_burst_last) state_q <= IDLE;
      endcase
    end
  end

  always @(posedge clk) begin
    if (state_q == IDLE) begin
      next_q       <= s_request_address[ADDRESS_W-1:4];
      beats_q      <= s_request_length[LENGTH_W-1:4];
      misaligned_q <= s_request_address[3:0] != 4'd0 || s_request_length[3:0] != 4'd0;
    end else if (step) begin
      next_q <= after;
    end
    if (state_q == SUM) {wraps_q, last_q} <= sum;
    if (state_q == CHECK) refused_code_o <= code;
  end
endmodule

`default_nettype wire
