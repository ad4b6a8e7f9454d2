// ffd_stream_expand: packets that say much in few beats become packets of vertices
//
// In front of the framer. A grid (opcode 8) becomes a packet of vertices of its page, or without
// pages of the resident lattice, that come until tlast; a beat of packed vertices (flag P) becomes
// two of one vertex each. The words are those that a driver would send for these vertices one by
// one. All other packets pass as they came.
//
// With PAIRS a grid whose results are half a beat each becomes beats of one or two vertices of a
// row: the second one brings its coordinate s and has all else of the first.
//
// Bad input:  a grid whose packet is too short, or that ffd_stream_grid calls bad, becomes one beat
//             that belongs to nothing; what is behind a grid is dropped up to tlast. Of a packed
//             vertex bit 63 refuses it. as_o tells the framer (FFD_AS_*). A header with bits that
//             mean nothing keeps its opcode or flag, which are then unknown.
// Stop:       a grid under way in a clock of grid_stop_i ends with the next vertex.
// Formats:    docs/interface.md section 2; last_cell {k, j, i}.
// Pipeline:   1 clock; a beat a clock, of packed ones one in two clocks. The first vertex of a grid
//             23 clocks behind its last beat, then one a clock.
// Freezes:    while m_beat_ready is 0. A grid waits until header_i says that its header, and with
//             it its lattice, is known.
// Cuts:       data, valid and last leave registers; s_beat_ready follows m_beat_ready by gates.
// Parameters: FORMAT as in ffd_num.vh; FEATURES and AXIS as in ffd_stream_header, with one of the
//             bits of grids and packed vertices; GRID_LIMIT as LIMIT of ffd_stream_grid, PAIRS as
//             there.
// Model:      golden/include/hwffd/stream/grid.hpp, packed.hpp.  Test: tests/system/grid_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_stream.vh"

module ffd_stream_expand #(
  parameter FORMAT     = 18,
  parameter FEATURES   = `FFD_FEATURES_USUAL + 48,
  parameter AXIS       = 16,
  parameter GRID_LIMIT = 48,
  parameter PAIRS      = 0
) (
  input  wire                           clk,
  input  wire                           rst,
  input  wire                           s_beat_valid,
  output wire                           s_beat_ready,
  input  wire [127:0]                   s_beat_data,
  input  wire [`FFD_PACKET_W-1:0]       s_beat_packet,  // of a header
  input  wire                           s_beat_last,
  output wire                           m_beat_valid,
  input  wire                           m_beat_ready,
  output wire [127:0]                   m_beat_data,
  output wire [127:0]                   m_beat_header,  // where it is one: data, sooner
  output wire [`FFD_PACKET_W-1:0]       m_beat_packet,
  output wire                           m_beat_last,
  output wire [32:0]                    m_beat_second,  // {there is a second vertex, its word s}
  output wire [2:0]                     as_o,
  input  wire                           expects_i,    // the framer, a vertex
  input  wire                           header_i,     // one goes on to the decoder
  input  wire                           loaded_i,     // the lattice of that header
  input  wire [3*`FFD_AXIS_W(AXIS)-1:0] last_cell_i,
  input  wire                           pairs_i,      // functions are there: vertices may be two
  input  wire                           grid_stop_i,
  output wire                           idle_o
);
  localparam GRIDS  = `FFD_FEATURE_GRIDS(FEATURES);
  localparam PACKED = `FFD_FEATURE_PACKED(FEATURES);
  localparam PAGES  = `FFD_FEATURE_PAGES(FEATURES);
  localparam LARGE  = `FFD_FEATURE_LARGE(FEATURES);
  localparam [3:0] HEADER = 4'd0;
  localparam [3:0] PASS   = 4'd1;
  localparam [3:0] SPLIT  = 4'd2;
  localparam [3:0] AXES   = 4'd3;
  localparam [3:0] CHECK  = 4'd4;
  localparam [3:0] CLOSE  = 4'd5;
  localparam [3:0] DROP   = 4'd6;
  localparam [3:0] WALK   = 4'd8;  // bit 3 alone: what a walk enables waits for nothing else

  // ---- the beat that goes on

  reg          open_q;     // not in reset
  reg          valid_q;
  reg  [127:0] data_q;     // of a vertex three coordinates Q1.24 in place of its words
  reg          vertex_q;
  reg          last_q;
  reg  [2:0]   as_q;
  reg          second_q;   // it may be behind the last vertex, which the framer knows
  reg          rest_q;     // the second vertex of a pair waits
  wire         rest = PACKED != 0 && rest_q;
  reg  [63:0]  rest_data_q;
  reg          rest_last_q;
  reg  [3:0]   state_q;
  wire         free = !valid_q || m_beat_ready;
  wire         walks = state_q[3];
  wire         paired = PACKED != 0 && state_q == SPLIT;
  wire         pass = state_q == HEADER || state_q == PASS || paired;
  wire         sink = state_q == AXES || state_q[2:1] == DROP[2:1];  // 7 is no state: it drops, too
  wire         take = s_beat_valid && s_beat_ready;
  assign s_beat_ready = open_q && ((pass && free && !rest) || sink);
  assign idle_o       = !valid_q && !rest && state_q == HEADER;
  always @(posedge clk) open_q <= !rst;

  // ---- headers

  wire       of_page = s_beat_packet[`FFD_PACKET_PAGE_VERTICES];
  // Of a grid no mode, no E and no P; without pages nothing but the kind of results.
  wire       strange = s_beat_data[16] || s_beat_data[18] || s_beat_data[65:64] != 2'd0
                    || (PAGES == 0 && (s_beat_data[31:8] != 24'd0 || s_beat_data[71:66] != 6'd0
                                       || s_beat_data[95:74] != 22'd0));
  // What a header says is read in every clock in which the next beat is one, as in the framer.
  wire       header  = state_q == HEADER && !rest;
  wire       grid    = s_beat_packet[`FFD_PACKET_GRID] && !strange;
  wire       pairs   = PACKED != 0 && s_beat_data[18]
                    && (s_beat_packet[`FFD_PACKET_VERTICES] || (of_page && !s_beat_data[19]));
  wire [127:0] grid_header = {32'd0, s_beat_data[95:17], 1'b1, s_beat_data[15:0]};
  wire [127:0] new_header = grid ? grid_header
                           : {s_beat_data[127:19], s_beat_data[18] && !pairs, s_beat_data[17:0]};

  // A grid that is well formed goes on as vertices of its page, any other as nothing that is known.
  localparam [`FFD_PACKET_W-1:0] ONE_KIND = 1;
  localparam [`FFD_PACKET_W-1:0] OF_GRID  =
      ONE_KIND << (PAGES != 0 ? `FFD_PACKET_PAGE_VERTICES : `FFD_PACKET_VERTICES);
  wire [`FFD_PACKET_W-1:0] known  = s_beat_packet & ~(ONE_KIND << `FFD_PACKET_GRID);
  reg  [`FFD_PACKET_W-1:0] packet_q;

  // ---- a pair of vertices

  wire [63:0] half  = rest ? rest_data_q : s_beat_data[63:0];
  wire        alone = s_beat_last && &s_beat_data[127:64];  // the second one is empty
  wire        take_pair   = take && paired;
  wire        other = rest && free;

  always @(posedge clk) begin
    if (rst) rest_q <= 1'b0;
    else rest_q <= (take_pair && !alone) || (rest && !free);
  end
  always @(posedge clk) begin
    if (take_pair) rest_data_q <= s_beat_data[127:64];
    if (take_pair) rest_last_q <= s_beat_last;
  end

  // ---- a grid

  reg  [1:0]  axis_q;
  reg         ended_q;   // its packet
  reg         short_q;
  reg         known_q;   // its header has gone on
  reg         large_q;
  wire        axis_taken = s_beat_valid && open_q && state_q == AXES;
  wire        end_axes   = axis_taken && (axis_q == 2'd2 || s_beat_last);
  wire        walk       = walks && m_beat_ready;  // nothing waits here before its first vertex
  wire        close      = state_q == CLOSE && free;
  wire        checked;
  wire        bad;
  wire        walk_last;
  wire [17:0] grid_cells;
  wire [74:0] grid_coordinates;
  wire        grid_pair;
  wire [24:0] grid_second;
  wire        decided = state_q == CHECK && known_q && checked;
  reg         stop_q;    // it ends with its next vertex
  wire        walk_ends  = walk_last || stop_q;

  always @(posedge clk) begin
    if (header) large_q <= LARGE != 0 && PAGES != 0 && s_beat_data[19];
    axis_q  <= header ? 2'd0 : axis_q + {1'b0, axis_taken};
    stop_q  <= state_q != HEADER && (stop_q || grid_stop_i);
    known_q <= state_q != HEADER && !(valid_q && as_q == `FFD_AS_GRID) && (known_q || header_i);
    if (end_axes) ended_q <= s_beat_last;
    if (end_axes) short_q <= axis_q != 2'd2;
  end

  // That its lattice is known, the first clock of the check does not wait for.
  reg checks_q;
  wire checks = state_q == CHECK && known_q && !checks_q;
  always @(posedge clk) checks_q <= state_q == CHECK && (checks_q || checks);

  // Results of two vertices a beat, each a position.
  reg halves_q;
  always @(posedge clk) begin
    if (header) halves_q <= PAIRS != 0 && s_beat_data[22] && s_beat_data[73:72] == 2'd0;
  end

  generate
    if (GRIDS != 0) begin : gen_grid
      wire row_last;
      ffd_stream_grid #(
        .AXIS (AXIS),
        .LIMIT(GRID_LIMIT),
        .PAIRS(PAIRS)
      ) u_grid (
        .clk          (clk),
        .rst          (rst),
        .data_i       (s_beat_data),
        .header_i     (header),
        .axis_i       ({3{axis_taken}} & (3'd1 << axis_q)),
        .check_i      (checks),
        .loaded_i     (loaded_i),
        .large_i      (large_q),
        .last_cell_i  (last_cell_i),
        .next_i       (walk),
        .pairs_i      (halves_q && pairs_i),
        .checked_o    (checked),
        .bad_o        (bad),
        .last_o       (walk_last),
        .row_last_o   (row_last),
        .cells_o      (grid_cells),
        .coordinates_o(grid_coordinates),
        .pair_o       (grid_pair),
        .second_o     (grid_second)
      );
      wire unused_row = &{1'b0, row_last};
    end else begin : gen_no_grid
      assign {checked, bad, walk_last, grid_cells, grid_coordinates} = {96{1'b0}};
      assign {grid_pair, grid_second} = 26'd0;
      wire unused_grid = &{1'b0, checks, walk, loaded_i, last_cell_i, pairs_i, halves_q};
    end
  endgenerate

  // ---- the vertex of either: its number is its tag, for a grid from a given one on

  reg  [15:0] tag_q;
  wire        vertex   = walks || paired || rest;  // or nothing goes on
  wire [17:0] in_cell  = walks ? grid_cells
                       : {2'd0, half[62:59], 2'd0, half[58:55], 2'd0, half[54:51]};
  wire [31:0] few      = {1'b0, in_cell[16], in_cell[10], in_cell[4],
                          in_cell[15:12], in_cell[9:6], in_cell[3:0], tag_q};
  wire [31:0] fourth   = walks && large_q ? {in_cell, tag_q[13:0]} : few;
  wire [74:0] place    = walks ? grid_coordinates
                       : {half[50:34], 8'd0, half[33:17], 8'd0, half[16:0], 8'd0};
  wire [127:0] vertex_data = {fourth, 7'd0, place[74:50], 7'd0, place[49:25], 7'd0, place[24:0]};

  always @(posedge clk) begin
    if (header) tag_q <= grid ? s_beat_data[127:112] : 16'd0;
    else if (take_pair || other || walk) tag_q <= tag_q + 16'd1;
  end

  // ---- what comes next

  always @(posedge clk) begin
    if (rst) valid_q <= 1'b0;
    else if (free) valid_q <= (take && pass) || other || walk || close;
  end
  always @(posedge clk) begin
    if (free) begin
      vertex_q <= vertex;
      second_q <= rest;
      data_q   <= vertex ? vertex_data : state_q == HEADER ? new_header : s_beat_data;
      packet_q <= grid ? OF_GRID : known;
      last_q   <= rest ? rest_last_q : walks ? walk_ends : state_q == CLOSE
               || (paired ? alone : s_beat_last);
      as_q     <= rest || paired ? (half[63] ? `FFD_AS_REFUSED : `FFD_AS_IT_IS)
                : walks && walk_last && !ended_q ? `FFD_AS_LONG
                : walks && walk_ends && !walk_last ? `FFD_AS_STOPPED
                : walks              ? `FFD_AS_IT_IS
                : state_q == CLOSE   ? (short_q ? `FFD_AS_SHORT : `FFD_AS_NO_GRID)
                : state_q == HEADER && grid ? `FFD_AS_GRID : `FFD_AS_IT_IS;
    end
  end

  always @(posedge clk) begin
    if (rst) state_q <= HEADER;
    else if (walks) begin
      if (walk && walk_ends) state_q <= ended_q ? HEADER : DROP;
    end else case (state_q)
      HEADER: if (take && !s_beat_last) state_q <= grid ? AXES : pairs ? SPLIT : PASS;
      AXES:   if (end_axes) state_q <= CHECK;
      CHECK:  if (decided) state_q <= expects_i && !short_q && !bad ? WALK : CLOSE;
      CLOSE:  if (close) state_q <= ended_q ? HEADER : DROP;
      default: if (take && s_beat_last) state_q <= HEADER;
    endcase
  end

  // ---- its words

  assign m_beat_valid = valid_q;
  assign m_beat_last   = last_q;
  assign m_beat_packet = packet_q;
  assign m_beat_header = data_q;
  assign as_o         = second_q && !expects_i ? `FFD_AS_NOTHING : as_q;
  assign m_beat_data[127:96] = data_q[127:96];
  generate
    if (PAIRS != 0) begin : gen_second
      reg        pair_q;
      reg [24:0] neighbour_q;
      always @(posedge clk) begin
        if (free) pair_q <= walks && grid_pair;
        if (free) neighbour_q <= grid_second;
      end
      assign m_beat_second[32] = pair_q;
      ffd_num_coordinate #(
        .FORMAT(FORMAT)
      ) u_word (
        .coordinate_i(neighbour_q),
        .word_o      (m_beat_second[31:0])
      );
    end else begin : gen_no_second
      assign m_beat_second = 33'd0;
      wire unused_second = &{1'b0, grid_pair, grid_second};
    end
  endgenerate
  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_word
      wire [31:0] word;
      ffd_num_coordinate #(
        .FORMAT(FORMAT)
      ) u_word (
        .coordinate_i(data_q[32*a +: 25]),
        .word_o      (word)
      );
      assign m_beat_data[32*a +: 32] = vertex_q ? word : data_q[32*a +: 32];
    end
  endgenerate
endmodule

`default_nettype wire
