// ffd_scatter_collect: reads the points of a page out, as words
//
//   word = saturate(floor(sum / 2^shift + 1/2))
//
// It goes through the points (i, j, k), k fastest, and asks for a slot for each while there is room
// for its words (credits). What the slot reads comes back FFD_SCATTER_READ_LATENCY clocks later, a
// component a clock, is rounded in one place, and waits in a queue.
//
// Formats:    sum of 35 bits, two's complement; word of 32 bits, flagged where it saturates.
// Pipeline:   slot | FFD_SCATTER_READ_LATENCY: sum | 3: rounded, saturated | 3 in the queue.
// Freezes:    asks for no slot while 8 points are under way or wait.
// Bad input:  last indices of AXIS or more read some points; the front end refuses such pages.
// Parameters: AXIS 4 to 64, PAGE_W >= 1.
// Model:      golden/include/hwffd/model/scatter.hpp (collect).  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_scatter.vh"

module ffd_scatter_collect #(
  parameter AXIS   = 16,
  parameter AXIS_W = `FFD_AXIS_W(AXIS),
  parameter PAGE_W = 1
) (
  input  wire                           clk,
  input  wire                           rst,
  input  wire                           hold_i,            // take no collect yet
  input  wire                           s_collect_valid,
  output wire                           s_collect_ready,
  input  wire [PAGE_W-1:0]              s_collect_page,
  input  wire [1:0]                     s_collect_shift,
  input  wire [3*AXIS_W-1:0]            s_collect_tops,    // the last index along each axis
  output wire                           collecting_o,
  output wire [PAGE_W-1:0]              page_o,
  output wire                           point_valid_o,
  output wire [3*AXIS_W-1:0]            point_cell_o,      // {k, j, i}
  input  wire                           point_take_i,      // the slot begins in the next clock
  input  wire                           slot_point_i,
  input  wire                           slot_third_i,      // the last component of a point
  input  wire                           slot_epoch_i,      // of its page
  input  wire [`FFD_SCATTER_WORD_W-1:0] word_i,
  output wire                           m_word_valid,
  input  wire                           m_word_ready,
  output wire [95:0]                    m_word_data,       // {z, y, x}
  output wire                           m_word_saturated,
  output wire                           m_word_last,
  output wire                           idle_o
);
  localparam SUM_W  = `FFD_SCATTER_SUM_W;
  localparam WIDE_W = SUM_W + 3;
  localparam DEPTH  = 8;

  // ---- the points

  reg                 collecting_q;
  reg  [PAGE_W-1:0]   page_q;
  reg  [1:0]          shift_q;
  reg  [3*AXIS_W-1:0] tops_q;
  reg  [AXIS_W-1:0]   i_q;
  reg  [AXIS_W-1:0]   j_q;
  reg  [AXIS_W-1:0]   k_q;
  reg  [3:0]          inside_q;  // points, from their slot until they have left
  wire                accept = s_collect_valid && s_collect_ready;
  wire                leave  = m_word_valid && m_word_ready;
  wire                i_last = i_q == tops_q[0*AXIS_W +: AXIS_W];
  wire                j_last = j_q == tops_q[1*AXIS_W +: AXIS_W];
  wire                k_last = k_q == tops_q[2*AXIS_W +: AXIS_W];
  wire                last   = i_last && j_last && k_last;

  assign s_collect_ready = !collecting_q && !hold_i;
  assign collecting_o    = collecting_q;
  assign page_o          = page_q;
  assign point_valid_o   = collecting_q && !inside_q[3];  // of DEPTH
  assign point_cell_o    = {k_q, j_q, i_q};
  assign idle_o          = !collecting_q && inside_q == 4'd0;

  always @(posedge clk) begin
    if (rst) collecting_q <= 1'b0;
    else if (accept) collecting_q <= 1'b1;
    else if (point_take_i && last) collecting_q <= 1'b0;
  end
  always @(posedge clk) begin
    if (accept) begin
      page_q  <= s_collect_page;
      shift_q <= s_collect_shift;
      tops_q  <= s_collect_tops;
    end
  end
  always @(posedge clk) begin
    if (accept) begin
      i_q <= {AXIS_W{1'b0}};
      j_q <= {AXIS_W{1'b0}};
      k_q <= {AXIS_W{1'b0}};
    end else if (point_take_i) begin
      k_q <= k_last ? {AXIS_W{1'b0}} : k_q + 1'b1;
      if (k_last) j_q <= j_last ? {AXIS_W{1'b0}} : j_q + 1'b1;
      if (k_last && j_last) i_q <= i_q + 1'b1;
    end
  end
  always @(posedge clk) begin
    if (rst) inside_q <= 4'd0;
    else if (point_take_i && !leave) inside_q <= inside_q + 4'd1;
    else if (leave && !point_take_i) inside_q <= inside_q - 4'd1;
  end

  // ---- what its slot knows of a point goes along with its words

  reg  [1:0] slot_shift_q;
  reg        slot_last_q;
  wire       read_valid;
  wire       read_third;
  wire       read_epoch;
  wire [1:0] read_shift;
  wire       read_last;

  always @(posedge clk) begin
    if (point_take_i) begin
      slot_shift_q <= shift_q;
      slot_last_q  <= last;
    end
  end

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(`FFD_SCATTER_READ_LATENCY),
    .RESET  (1)
  ) u_read_valid (
    .clk(clk),
    .rst(rst),
    .d_i(slot_point_i),
    .q_o(read_valid)
  );

  ffd_num_delay #(
    .WIDTH  (5),
    .LATENCY(`FFD_SCATTER_READ_LATENCY)
  ) u_read (
    .clk(clk),
    .rst(1'b0),
    .d_i({slot_third_i, slot_epoch_i, slot_shift_q, slot_last_q}),
    .q_o({read_third, read_epoch, read_shift, read_last})
  );

  // ---- the sum times 8 / 2^shift, of which a narrower drops three bits

  reg  signed [WIDE_W-1:0] wide_q;
  wire                     fresh = word_i[SUM_W] == read_epoch;
  wire signed [WIDE_W-1:0] sum   = {{3{word_i[SUM_W-1]}}, word_i[SUM_W-1:0]};
  wire signed [WIDE_W-1:0] wide  = read_shift[1] ? (read_shift[0] ? sum : sum << 1)
                                                 : (read_shift[0] ? sum << 2 : sum << 3);
  wire [31:0]              word;
  wire                     saturated;
  wire                     word_valid;
  wire                     word_last;

  always @(posedge clk) begin
    if (!fresh) wide_q <= {WIDE_W{1'b0}};
    else wide_q <= wide;
  end

  ffd_fx_narrow #(
    .IN_W   (WIDE_W),
    .DROP   (3),
    .OUT_W  (32),
    .LATENCY(2)
  ) u_round (
    .clk    (clk),
    .value_i(wide_q),
    .flags_i(1'b0),
    .value_o(word),
    .flags_o(saturated)
  );

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(3),
    .RESET  (1)
  ) u_word_valid (
    .clk(clk),
    .rst(rst),
    .d_i(read_valid && read_third),
    .q_o(word_valid)
  );

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(3)
  ) u_word (
    .clk(clk),
    .rst(1'b0),
    .d_i(read_last),
    .q_o(word_last)
  );

  // ---- three of them are the words of a point

  reg  [65:0] before_q;
  wire        queue_ready;

  always @(posedge clk) before_q <= {saturated, word, before_q[33 +: 33]};

  ffd_stream_queue #(
    .WIDTH(98),
    .DEPTH(DEPTH)
  ) u_queue (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(word_valid),
    .s_word_ready(queue_ready),
    .s_word_data ({word_last, saturated | before_q[65] | before_q[32], word, before_q[33 +: 32],
                   before_q[0 +: 32]}),
    .m_word_valid(m_word_valid),
    .m_word_ready(m_word_ready),
    .m_word_data ({m_word_last, m_word_saturated, m_word_data})
  );

  `FFD_ASSERT(a_point_comes_and_the_queue_is_full, !word_valid || queue_ready)
  wire unused_ok = &{1'b0, queue_ready};
endmodule

`default_nettype wire
