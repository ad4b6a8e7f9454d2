// ffd_dma_ring: walks a ring of descriptors and asks for the packets they name
//
// A descriptor is 16 bytes, little-endian: {flags[31:0], length[31:0], address[63:0]}, flags 0.
// Entry k lies at base_i + 16 k; base_i is a multiple of the ring's size, so that no address needs
// an adder and none wraps. The ring is empty where head_i == tail_o: one entry stays unused, so a
// ring of one entry would hold nothing.
// Descriptors from tail to head are fetched, DESCRIPTORS ahead at most, and asked for in order.
//
// A start is refused, with code and base_i, where base_i is not aligned (2), the ring is not wholly
// inside the window (4), has one entry only, or head_i is none of its entries (8). Later the first
// fault stops it: a request refused (refused_i), flags that are not 0 (code 5), a head_i that is
// none of the entries (8, with base_i), a bus error (stop_i). error_o is a pulse with code and
// address of the descriptor for all but the last, which the reader reports. Earlier packets end as
// they should, then running_o falls. start_i begins at tail_o; it is taken where nothing runs or
// nothing is left, checks ring and head anew, and is ignored else. Only rst sets tail_o to 0.
//
// Pipeline:   a request every five clocks, fetches included.
// Parameters: DESCRIPTORS a power of two, 2 to 256: those fetched and not yet requested.
// Not checked: base_i, entries_log2_i and the window are to be held while entries are left; every
//             address is still checked by the reader.
// Model:      none (control only).  Test: tests/bus/dma.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_dma_ring #(
  parameter DESCRIPTORS = 4
) (
  input  wire         clk,
  input  wire         rst,
  input  wire         start_i,
  input  wire [63:0]  window_first_i,
  input  wire [63:0]  window_last_i,
  input  wire [63:0]  base_i,
  input  wire [3:0]   entries_log2_i,
  input  wire [15:0]  head_i,
  output wire [15:0]  tail_o,
  output wire         running_o,
  output wire         empty_o,
  output reg          m_request_valid,
  input  wire         m_request_ready,
  output reg  [63:0]  m_request_address,
  output reg  [31:0]  m_request_length,
  output reg          m_request_fetch,
  input  wire         refused_i,
  input  wire [2:0]   refused_code_i,
  input  wire         fetched_i,
  input  wire [127:0] fetched_data_i,
  input  wire         finished_i,
  input  wire         stop_i,
  input  wire         quiet_i,
  output wire         started_o,
  output reg          error_o,
  output reg  [3:0]   error_code_o,
  output reg  [63:0]  error_address_o
);
  generate
    if (DESCRIPTORS < 2 || DESCRIPTORS > 256) begin : gen_bad_descriptors
      ERROR_ffd_dma_ring_descriptors_must_be_2_to_256 u_error ();
    end
  endgenerate

  localparam [3:0] MISALIGNED = 4'd2;
  localparam [3:0] OUTSIDE = 4'd4;
  localparam [3:0] FLAGS = 4'd5;
  localparam [3:0] RING = 4'd8;
  localparam DESCRIPTOR_W = 64 + 32 + 1;

  reg         running_q;
  reg         stop_q;
  reg  [14:0] fetch_q;    // next to be fetched
  reg  [14:0] next_q;     // next to be requested
  reg  [14:0] tail_q;     // next to be finished
  reg  [14:0] asked_q;    // the descriptor of the request that was asked last

  wire [15:0] above      = 16'hFFFF << entries_log2_i;    // bits that no entry's number has
  wire [14:0] mask       = ~above[14:0];
  wire        beyond     = (head_i & above) != 16'd0;
  wire        misaligned = (base_i[18:0] & {mask, 4'hF}) != 19'd0;
  wire [63:0] ring_last  = {base_i[63:19], base_i[18:0] | {mask, 4'hF}};
  wire        outside    = base_i < window_first_i || ring_last > window_last_i;
  wire        legal      = !misaligned && !outside && !beyond && entries_log2_i != 4'd0;
  wire        over       = empty_o && !stop_q && quiet_i && !m_request_valid;
  wire        accept     = start_i && (!running_q || over);

  assign running_o = running_q;
  assign tail_o    = {1'b0, tail_q};
  assign empty_o   = !running_q || tail_q == (head_i[14:0] & mask);
  assign started_o = accept && legal;

  // Descriptors that have come.
  wire        queue_ready;
  wire        head_valid;
  wire        head_pop;
  wire        head_bad;
  wire [63:0] head_address;
  wire [31:0] head_length;

  ffd_stream_fifo #(
    .WIDTH(DESCRIPTOR_W),
    .DEPTH(DESCRIPTORS)
  ) u_queue (
    .clk         (clk),
    .rst         (rst || accept),
    .s_word_valid(fetched_i),
    .s_word_ready(queue_ready),
    .s_word_data ({fetched_data_i[127:96] != 32'd0, fetched_data_i[95:0]}),
    .m_word_valid(head_valid),
    .m_word_ready(head_pop),
    .m_word_data ({head_bad, head_length, head_address})
  );

  // What to ask next: descriptors first, since packets wait for them.
  wire [14:0] ahead     = (fetch_q - next_q) & mask;
  wire        fetch     = fetch_q != (head_i[14:0] & mask) && {1'b0, ahead} < DESCRIPTORS[15:0];
  wire        allowed   = running_q && !stop_q && !refused_i && !stop_i && !beyond;
  wire        free      = !m_request_valid || m_request_ready;
  wire        bad_head  = head_valid && head_bad;
  // Not before the reader is done with the request before: that one is still to be read.
  wire        bad_flags = allowed && bad_head && !m_request_valid && m_request_ready;
  wire        ask_fetch = allowed && free && fetch && !bad_head;
  wire        ask_data  = allowed && free && !fetch && head_valid && !head_bad;

  assign head_pop = ask_data;

  always @(posedge clk) begin
    if (rst) begin
      running_q <= 1'b0;
      stop_q    <= 1'b0;
    end else if (accept) begin
      running_q <= legal;
      stop_q    <= 1'b0;
    end else begin
      if (stop_q && quiet_i && !m_request_valid) running_q <= 1'b0;
      if (running_q && (refused_i || stop_i || bad_flags || beyond)) stop_q <= 1'b1;
    end
  end

  always @(posedge clk) begin
    if (rst) begin
      fetch_q <= 15'd0;
      next_q  <= 15'd0;
      tail_q  <= 15'd0;
    end else if (accept) begin
      fetch_q <= tail_q & mask;
      next_q  <= tail_q & mask;
      tail_q  <= tail_q & mask;
    end else begin
      if (ask_fetch) fetch_q <= (fetch_q + 1'b1) & mask;
      if (ask_data) next_q <= (next_q + 1'b1) & mask;
      if (finished_i) tail_q <= (tail_q + 1'b1) & mask;
    end
  end

  always @(posedge clk) begin
    if (rst || !allowed) m_request_valid <= 1'b0;
    else if (free) m_request_valid <= ask_fetch || ask_data;
  end

  always @(posedge clk) begin
    if (ask_fetch || ask_data) begin
      m_request_fetch   <= ask_fetch;
      m_request_length  <= ask_fetch ? 32'd16 : head_length;
      m_request_address <= ask_fetch ? {base_i[63:19], base_i[18:0] | {fetch_q, 4'd0}}
                                     : head_address;
    end
    if (m_request_valid && m_request_ready) begin
      asked_q <= (m_request_fetch ? fetch_q : next_q) - 1'b1;
    end
  end

  wire [14:0] guilty = accept ? 15'd0 : refused_i ? asked_q & mask : beyond ? 15'd0 : next_q;

  always @(posedge clk) begin
    error_o <= !rst && ((accept && !legal)
                        || (running_q && !stop_q && !stop_i
                            && (refused_i || bad_flags || beyond)));
    error_code_o    <= accept ? (misaligned ? MISALIGNED : outside ? OUTSIDE : RING)
                              : refused_i ? {1'b0, refused_code_i} : beyond ? RING : FLAGS;
    error_address_o <= {base_i[63:19], base_i[18:0] | {guilty, 4'd0}};
  end

  wire unused_ok = &{1'b0, queue_ready};
endmodule

`default_nettype wire
