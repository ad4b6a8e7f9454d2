// ffd_stream_vertex: the beat of a vertex becomes what the evaluator takes
//
// Keeps what is known of a vertex until its last beat, and by the mode of its packet
// (docs/interface.md section 2) clamps it into the lattice, passes it or blanks its result. The
// cell of a resident lattice has been brought inside, whatever the mode. Whole vertices wait in a
// queue for the evaluator.
//
// Formats:    coordinates {u, t, s} as weights; results FFD_RESULTS_*; user as FFD_USER_*.
// Pipeline:   inputs up to tag_i .. exponent_i with the beat, *_there_i and below when its numbers
//             are there, LATENCY clocks later; the vertex is offered 3 clocks behind.
// Freezes:    room_o is 0 while WAITING vertices are between finish_i and the evaluator.
// Parameters: FORMAT as in ffd_num.vh, SOURCE_W > SLOT_W >= 1, LATENCY >= 1, WAITING a power of
//             two >= 2; EVERY_CLOCK 0: vertices are offered in every other clock at most, and
//             m_vertex_ready then ends at a register. SPANS as in ffd_stream_functions; PAIRS 0,
//             or 1: a vertex may be the first of two, of which the second brings its s.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module ffd_stream_vertex #(
  parameter FORMAT      = 18,
  parameter SOURCE_W    = 2,
  parameter SLOT_W      = 1,
  parameter LATENCY     = 1,
  parameter WAITING     = 16,
  parameter EVERY_CLOCK = 1,
  parameter SPANS       = 1,
  parameter PAIRS       = 0
) (
  input  wire                                 clk,
  input  wire                                 rst,
  input  wire                                 finish_i,
  input  wire [11:0]                          cell_i,
  input  wire                                 beyond_i,
  input  wire                                 clamp_i,
  input  wire                                 refuse_i,
  input  wire                                 no_functions_i,
  input  wire                                 no_lattice_i,
  input  wire                                 refused_i,  // it is no vertex
  input  wire [15:0]                          tag_i,
  input  wire [SOURCE_W-1:0]                  source_i,
  input  wire                                 bank_i,
  input  wire [`FFD_PLACES_W(SPANS)-1:0]      places_i,  // a clock behind vertex_there_i
  input  wire                                 changed_i,
  input  wire [1:0]                           results_i,
  input  wire                                 half_i,
  input  wire [`FFD_EXPONENT_W-1:0]           exponent_i,
  input  wire                                 pair_i,
  input  wire                                 vertex_there_i,
  input  wire                                 finish_there_i,
  input  wire                                 top_i,
  input  wire                                 final_i,
  input  wire [3*`FFD_POINT_W(FORMAT)-1:0]    numbers_i,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]     second_i,
  input  wire                                 nan_i,
  input  wire                                 outside_i,
  output wire [11:0]                          held_cell_o,
  output wire [SLOT_W-1:0]                    held_slot_o,
  output wire                                 room_o,
  output wire                                 rooms_o,  // for two
  output wire                                 waiting_o,
  output reg                                  m_vertex_valid,
  input  wire                                 m_vertex_ready,
  output wire [3*`FFD_WEIGHT_W(FORMAT)-1:0]   m_vertex_coordinates,
  output wire [`FFD_WEIGHT_W(FORMAT):0]       m_vertex_second,  // {it is there, s}
  output wire [11:0]                          m_vertex_cell,
  output wire [SOURCE_W-1:0]                  m_vertex_source,
  output wire [`FFD_PLACES_W(SPANS)-1:0]      m_vertex_bank,
  output wire                                 m_vertex_changed,
  output wire [1:0]                           m_vertex_results,
  output wire [`FFD_EXPONENT_W-1:0]           m_vertex_exponent,
  output wire [`FFD_USER_W-1:0]               m_vertex_user,
  output reg  [`FFD_EVENTS-1:0]               event_o
);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam COUNT_W  = $clog2(WAITING) + 1;

  // ---- room: vertices between their last beat and the evaluator

  reg  [COUNT_W-1:0] waiting_q;
  wire               leave = m_vertex_valid && m_vertex_ready;
  assign room_o    = !waiting_q[COUNT_W-1];
  assign waiting_o = waiting_q != {COUNT_W{1'b0}};
  assign rooms_o   = room_o && !(&waiting_q[COUNT_W-2:0]);
  always @(posedge clk) begin
    if (rst) waiting_q <= {COUNT_W{1'b0}};
    else if (finish_i && !leave) waiting_q <= waiting_q + 1'b1;
    else if (leave && !finish_i) waiting_q <= waiting_q - 1'b1;
  end

  // ---- what came with the vertex's beat

  localparam KNOWN_W = 1 + 1 + 2 + `FFD_EXPONENT_W + SOURCE_W + 1 + 1 + 12 + 5 + 16;
  localparam NUMBERS_W = 3 * WEIGHT_W;
  wire [KNOWN_W-1:0]         known;
  wire [NUMBERS_W-1:0]       coordinates;
  reg  [KNOWN_W-1:0]         known_q;
  reg  [NUMBERS_W-1:0]       coordinates_q;
  reg                        nan_q;
  reg                        outside_q;

  ffd_num_delay #(
    .WIDTH  (KNOWN_W),
    .LATENCY(LATENCY)
  ) u_known (
    .clk(clk),
    .rst(1'b0),
    .d_i({half_i, refused_i, results_i, exponent_i, source_i, bank_i, changed_i, cell_i, beyond_i,
          clamp_i, refuse_i, no_functions_i, no_lattice_i, tag_i}),
    .q_o(known)
  );

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      assign coordinates[a*WEIGHT_W +: WEIGHT_W] = numbers_i[a*POINT_W +: WEIGHT_W];
    end
  endgenerate

  always @(posedge clk) begin
    if (vertex_there_i) begin
      known_q       <= known;
      coordinates_q <= coordinates;
      nan_q         <= nan_i;
      outside_q     <= outside_i;
    end
  end

  // ---- when it is whole: a vertex's only beat, or the last of its points

  wire [4:0] facts   = vertex_there_i ? known[20:16] : known_q[20:16];
  wire       nan     = vertex_there_i ? nan_i : nan_q;
  wire       outside = vertex_there_i ? outside_i : outside_q;
  always @* begin
    event_o                             = {`FFD_EVENTS{1'b0}};
    event_o[`FFD_EVENT_CELL_OUTSIDE]       = finish_there_i && facts[4];
    event_o[`FFD_EVENT_NO_COEFFICIENTS]    = finish_there_i && facts[1];
    event_o[`FFD_EVENT_NO_LATTICE]         = finish_there_i && facts[0];
    event_o[`FFD_EVENT_COORDINATE_NAN]     = finish_there_i && nan;
    event_o[`FFD_EVENT_COORDINATE_OUTSIDE] = finish_there_i && outside;
  end

  reg whole_q;
  reg top_q;
  reg final_q;
  always @(posedge clk) begin
    whole_q <= finish_there_i && !rst;
    top_q   <= top_i;
    final_q <= final_i;
  end

  // ---- a clock later it goes into the queue

  wire [1:0]                 results;
  wire [`FFD_EXPONENT_W-1:0] exponent;
  wire [SOURCE_W-1:0]        source;
  wire                       bank;
  wire                       changed;
  wire [11:0]                cell_index;
  wire                       beyond;
  wire                       clamp;
  wire                       refuse;
  wire                       no_functions;
  wire                       no_lattice;
  wire [15:0]                tag;
  wire                       refused;
  wire                       half;
  assign {half, refused, results, exponent, source, bank, changed, cell_index, beyond, clamp,
          refuse, no_functions, no_lattice, tag} = known_q;
  assign held_cell_o = cell_index;
  assign held_slot_o = source[SLOT_W-1:0];

  wire       resident  = source[SOURCE_W-1];
  wire       truncated = !resident && !top_q;
  wire       unloaded  = no_functions || no_lattice || refused;
  wire       out       = outside_q || beyond;
  wire       blank     = truncated || unloaded || nan_q || (out && refuse);
  wire [5:0] status    = {unloaded, truncated, out, nan_q, out && clamp, 1'b0};

  // The buffer is that bit of the source where there is one.
  wire [`FFD_USER_W-1:0] user = {resident, source[0], bank, half, final_q, blank, status,
                                  tag};

  // The head of the queue waits in a register, near to the evaluator.
  localparam PLACES_W = `FFD_PLACES_W(SPANS);
  localparam ALONE_W  = `FFD_USER_W + 2 + `FFD_EXPONENT_W + SOURCE_W + PLACES_W + 1 + 12
                      + NUMBERS_W;
  localparam VERTEX_W = ALONE_W + PAIRS * (WEIGHT_W + 1);
  wire [PLACES_W-1:0] places = SPANS == 1 ? {PLACES_W{bank}} : places_i;
  wire                queue_ready;
  wire                next_valid;
  wire                next_ready = !m_vertex_valid || (EVERY_CLOCK != 0 && m_vertex_ready);
  wire [VERTEX_W-1:0] entering;
  wire [VERTEX_W-1:0] next;
  reg  [VERTEX_W-1:0] vertex_q;

  assign entering[ALONE_W-1:0] = {user, results, exponent, source, places, changed, cell_index,
                                  coordinates_q};
  generate
    if (PAIRS != 0) begin : gen_pairs
      wire              pair;
      reg  [WEIGHT_W:0] second_q;
      ffd_num_delay #(
        .WIDTH  (1),
        .LATENCY(LATENCY)
      ) u_pair (
        .clk(clk),
        .rst(1'b0),
        .d_i(pair_i),
        .q_o(pair)
      );
      always @(posedge clk) if (vertex_there_i) second_q <= {pair, second_i};
      assign entering[VERTEX_W-1:ALONE_W] = second_q;
      assign m_vertex_second              = vertex_q[VERTEX_W-1:ALONE_W];
    end else begin : gen_no_pairs
      assign m_vertex_second = {(WEIGHT_W + 1) {1'b0}};
      wire unused_second = &{1'b0, pair_i, second_i};
    end
  endgenerate

  ffd_stream_fifo #(
    .WIDTH(VERTEX_W),
    .DEPTH(WAITING)
  ) u_queue (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(whole_q),
    .s_word_ready(queue_ready),
    .s_word_data (entering),
    .m_word_valid(next_valid),
    .m_word_ready(next_ready),
    .m_word_data (next)
  );

  always @(posedge clk) begin
    if (rst) m_vertex_valid <= 1'b0;
    else if (!m_vertex_valid || m_vertex_ready) m_vertex_valid <= next_ready && next_valid;
  end
  always @(posedge clk) if (next_ready) vertex_q <= next;
  assign {m_vertex_user, m_vertex_results, m_vertex_exponent, m_vertex_source, m_vertex_bank,
          m_vertex_changed, m_vertex_cell, m_vertex_coordinates} = vertex_q[ALONE_W-1:0];

  wire unused_ok = &{1'b0, queue_ready, numbers_i, facts, places_i};

  `FFD_ASSERT(a_vertex_ends_and_the_queue_is_full,
              !whole_q || queue_ready)
  `FFD_ASSERT(more_vertices_have_left_than_came,
              !leave || waiting_q != {COUNT_W{1'b0}})
endmodule

`default_nettype wire
