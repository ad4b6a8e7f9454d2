// ffd_stream_pages: what is known of the pages of the point store, and when a header may touch one
//
// Every header of a page, of its points or of its vertices is held (ffd_stream_intake) while its
// page is looked up. One that loads a page or a part of it waits until no vertex inside reads that
// page. Opcodes 2 and 3 are of pages 0 and 1: a lattice goes to the one that is not the newest, and
// vertices are of the newest. A single page takes all of them.
//
// Readers:    each page knows the number of the last vertex that read it. Its age, counted in
//             vertices, is compared with how many are inside: vertices keep their order, so a page
//             whose last reader is older than all of them is free. Numbers are cut to READERS_W
//             bits: a reader of long ago may look young until the core is empty, a young one never
//             looks old. A page that is not loaded is read by no vertex whose result is used.
// Bad input:  verdict_o, one of FFD_PAGE_*: such a header refuses its packet; refuse_o tells the
//             framer. A page counts as not loaded from its header on, until its last point.
// Formats:    place, tops and last cell {i, j, k}, tops = points an axis - 1; origin {u, t, s}.
// Pipeline:   look up | verdict | go: 3 clocks behind the first in which the header is held, for a
//             place within a page later by ffd_stream_locate. The facts stay until the next one.
// Parameters: FORMAT as in ffd_num.vh, FEATURES as in ffd_stream.vh, PAGES 1 to 256, AXIS as in
//             ffd_stream_header, INSIDE >= the most vertices inside. Origins are kept where SPANS
//             is above 1.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system/pages_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"
`include "ffd_stream.vh"

module ffd_stream_pages #(
  parameter FORMAT   = 18,
  parameter FEATURES = `FFD_FEATURES_USUAL + 1,
  parameter PAGES    = 2,
  parameter AXIS     = 16,
  parameter INSIDE   = 152,
  parameter SPANS    = 1,
  parameter PAGE_W   = `FFD_PAGE_NUMBER_W(PAGES),
  parameter PLACE_W  = 3 * `FFD_AXIS_W(AXIS)
) (
  input  wire                         clk,
  input  wire                         rst,
  input  wire                         held_i,    // a header of a page
  input  wire                         size_i,    // its dimensions are bad
  input  wire [127:0]                 data_i,
  input  wire [`FFD_PACKET_W-1:0]     packet_i,
  input  wire                         header_i,  // it goes on
  input  wire                         point_i,
  input  wire                         top_i,     // the last one of a lattice
  input  wire                         finish_i,  // a vertex, of a page or not
  input  wire                         of_page_i,
  input  wire                         leave_i,   // a vertex
  input  wire [`FFD_EXPONENT_W-1:0]   exponent_i,  // of the packet under way
  output wire                         go_o,
  output wire                         waits_o,   // for the readers of its page
  output wire                         refuse_o,
  output wire                         place_valid_o,
  output wire [PLACE_W-1:0]           place_o,
  output wire [PLACE_W-1:0]           tops_o,
  output reg  [`FFD_PAGE_W-1:0]       verdict_o,
  output reg                          empty_o,      // it counts its payload, and has none
  output wire [PAGE_W-1:0]            page_o,
  output wire                         loaded_o,
  output reg  [PLACE_W-1:0]           last_cell_o,  // {k, j, i}
  output wire [`FFD_EXPONENT_W-1:0]   exponent_o,
  output wire                         large_o,
  output wire                         fourth_o,
  output wire [20:0]                  origin_o
);
  localparam AXIS_W     = `FFD_AXIS_W(AXIS);
  localparam LARGE      = `FFD_FEATURE_LARGE(FEATURES);
  localparam FOURTH     = `FFD_FEATURE_FOURTH(FEATURES);
  localparam HALVES     = `FFD_FEATURE_HALVES(FEATURES);
  localparam BLOCK      = `FFD_FORMAT_BLOCK(FORMAT);
  localparam EXPONENT_W = `FFD_EXPONENT_W;
  localparam COUNT_W    = PLACE_W + 1;
  localparam READERS_W  = $clog2(INSIDE + 1) + 1;
  localparam FACTS_W    = 1 + EXPONENT_W + COUNT_W + PLACE_W;
  localparam [31:0] PAGES_WORD = PAGES;  // 32 bits where set from outside
  localparam [8:0]  MOST       = PAGES_WORD[8:0];
  localparam        DEPTH      = PAGES > 1 ? PAGES : 2;  // of a memory
  localparam [AXIS_W-1:0] NOT_CELLS = 3;

  generate
    if (PAGES < 1 || PAGES > 256) begin : gen_bad_pages
      ERROR_ffd_stream_pages_pages_must_be_1_to_256 u_error ();
    end
  endgenerate

  // ---- the header that is held: the first clock

  // Packets that name their page: it, points of it, vertices of it.
  wire       part     = packet_i[`FFD_PACKET_POINTS];
  wire       vertices = packet_i[`FFD_PACKET_VERTICES] || packet_i[`FFD_PACKET_PAGE_VERTICES];
  wire       lattice  = packet_i[`FFD_PACKET_LATTICE] || packet_i[`FFD_PACKET_PAGE];
  wire       newer    = part || packet_i[`FFD_PACKET_PAGE] || packet_i[`FFD_PACKET_PAGE_VERTICES];
  reg        newest_q;
  wire [7:0] number   = newer ? data_i[15:8] : {7'd0, PAGES > 1 && newest_q != lattice};
  wire       beyond   = {1'b0, number} >= MOST;
  wire [PAGE_W-1:0] page = number[PAGE_W-1:0];

  // Flags that this opcode has not, and bits that nothing means.
  wire        marks = vertices && `FFD_FEATURE_MARKS(FEATURES) != 0;
  wire [15:0] flags = {9'd0, HALVES != 0 && vertices, {2{marks}}, LARGE != 0 && !part, 1'b0,
                       FOURTH != 0, vertices};
  wire        strange = (data_i[31:16] & ~flags) != 16'd0
                     || (part && data_i[95:82] != 14'd0)
                     || (vertices && (data_i[95:74] != 22'd0 || data_i[71:66] != 6'd0))
                     || (HALVES != 0 && data_i[22] && (data_i[17] || data_i[72]))
                     || (lattice ? data_i[127] || data_i[95:88] != 8'd0
                                 : data_i[127:106] != 22'd0);
  wire [19:0] place_end = {2'd0, data_i[81:64]} + {1'b0, data_i[50:32]};

  reg  [2:0]          step_q;
  reg                 newer_q;
  reg                 vertices_q;
  reg                 part_q;
  reg                 lattice_q;
  reg                 strange_q;
  reg                 beyond_q;
  reg                 many_q;
  reg  [19:0]         place_end_q;
  reg                 large_q;
  reg                 wants_fourth_q;
  reg  [PAGE_W-1:0]   page_q;
  reg  [PAGES-1:0]    loaded_q;
  reg                 hit_q;      // the page is loaded
  reg  [FACTS_W-1:0]  facts_q;
  reg  [READERS_W-1:0] reader_q;
  wire [FACTS_W-1:0]  facts;
  wire [READERS_W-1:0] reader;
  wire                go = go_o;
  wire                look = held_i && step_q == 3'd0;

  always @(posedge clk) begin
    if (rst || go) step_q <= 3'd0;
    else step_q <= {step_q[1] || step_q[2], step_q[0], look};
  end
  always @(posedge clk) begin
    if (look) begin
      newer_q        <= newer;
      vertices_q     <= vertices;
      part_q         <= part;
      lattice_q      <= lattice;
      strange_q      <= newer && strange;
      beyond_q       <= beyond;
      many_q         <= data_i[63:51] != 13'd0;
      empty_o        <= data_i[63:32] == 32'd0 && (part || (vertices && !(newer && data_i[16])));
      place_end_q    <= place_end;
      large_q        <= LARGE != 0 && newer && data_i[19];
      wants_fourth_q <= FOURTH != 0 && newer && data_i[17];
      page_q         <= page;
      hit_q        <= loaded_q[page] && !beyond;
      facts_q        <= facts;
      reader_q       <= reader;
    end
  end

  wire [EXPONENT_W-1:0] exponent = data_i[96 +: EXPONENT_W] & {EXPONENT_W{BLOCK}};
  wire                  has_fourth;
  wire [COUNT_W-1:0]    size;
  assign {has_fourth, exponent_o, size, tops_o} = facts_q;
  assign page_o   = page_q;
  assign loaded_o = hit_q;
  assign large_o  = large_q;
  assign fourth_o = wants_fourth_q;

  // ---- the second clock: what is wrong with it

  wire determinant = data_i[73:72] == `FFD_RESULTS_DETERMINANT
                  || data_i[73:72] == `FFD_RESULTS_ALONE;
  wire bad_points  = !hit_q || many_q || place_end_q > {{(20 - COUNT_W) {1'b0}}, size}
                  || (BLOCK && exponent != exponent_o);
  wire bad_fourth  = wants_fourth_q && !(hit_q && has_fourth && !(vertices_q && determinant));
  reg  [`FFD_PAGE_W-1:0] verdict;
  always @* begin
    verdict = {`FFD_PAGE_W{1'b0}};
    if (strange_q) verdict[`FFD_PAGE_UNKNOWN] = 1'b1;
    else if (beyond_q && !vertices_q) verdict[`FFD_PAGE_BEYOND] = 1'b1;
    else if (lattice_q && size_i) verdict[`FFD_PAGE_SIZE] = 1'b1;
    else if (part_q && bad_points) verdict[`FFD_PAGE_POINTS] = 1'b1;
    else if (!lattice_q && bad_fourth) verdict[`FFD_PAGE_FOURTH] = 1'b1;
  end

  // ---- the third one: whether it has to wait

  reg  [READERS_W-1:0] came_q;
  reg  [READERS_W-1:0] inside_q;
  reg  [READERS_W-1:0] age_q;
  wire                 refused = |verdict_o;
  wire                 free    = !hit_q || inside_q == {READERS_W{1'b0}} || age_q > inside_q;
  wire                 located;
  reg                  ready_q;
  always @(posedge clk) begin
    verdict_o <= step_q[0] ? verdict : verdict_o;
    if (step_q[0]) age_q <= came_q - reader_q;
    ready_q <= step_q[1] || step_q[2]
            ? !rst && !go && (refused || vertices_q || (free && (located || !part_q))) : 1'b0;
  end
  assign go_o          = ready_q;
  assign waits_o       = step_q[2] && !refused && !vertices_q && !free;
  assign refuse_o      = ready_q && refused;
  assign place_valid_o = ready_q && part_q;

  ffd_stream_locate #(
    .AXIS_W(AXIS_W)
  ) u_locate (
    .clk      (clk),
    .start_i  (step_q[0]),
    .place_i  (data_i[64 +: PLACE_W]),
    .tops_i   (tops_o),
    .done_o   (located),
    .indices_o(place_o)
  );

  always @(posedge clk) begin
    if (rst) begin
      came_q   <= {READERS_W{1'b0}};
      inside_q <= {READERS_W{1'b0}};
    end else begin
      if (finish_i) came_q <= came_q + 1'b1;
      if (finish_i && !leave_i) inside_q <= inside_q + 1'b1;
      else if (leave_i && !finish_i) inside_q <= inside_q - 1'b1;
    end
  end

  // ---- what is known of a page: it is not loaded from its header on until its last point

  wire               load  = header_i && lattice_q && !refused;
  wire               whole = point_i && top_i && lattice_q;
  reg  [PLACE_W-1:0] new_tops_q;
  reg  [COUNT_W-1:0] count_q;
  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      always @(posedge clk) begin
        if (header_i) begin
          new_tops_q[AXIS_W*(2-a) +: AXIS_W] <= data_i[64+8*a +: AXIS_W] - 1'b1;
        end
        last_cell_o[AXIS_W*a +: AXIS_W] <= tops_o[AXIS_W*(2-a) +: AXIS_W] - NOT_CELLS;
      end
    end
  endgenerate
  always @(posedge clk) begin
    if (header_i) count_q <= {{PLACE_W{1'b0}}, 1'b1};
    else if (point_i) count_q <= count_q + 1'b1;
  end
  always @(posedge clk) begin
    if (rst) newest_q <= 1'b0;
    else if (whole && !newer_q) newest_q <= !newest_q;
  end
  genvar p;
  generate
    for (p = 0; p < PAGES; p = p + 1) begin : gen_page
      localparam [PAGE_W-1:0] NUMBER = p;
      always @(posedge clk) begin
        if (rst) loaded_q[p] <= 1'b0;
        else if ((load || whole) && page_q == NUMBER) loaded_q[p] <= whole;
      end
    end
  endgenerate

  ffd_mem_sdp #(
    .WIDTH       (FACTS_W),
    .DEPTH       (DEPTH),
    .READ_LATENCY(0)
  ) u_facts (
    .clk            (clk),
    .write_i        (whole),
    .write_address_i(page_q),
    .write_data_i   ({wants_fourth_q, exponent_i, count_q, new_tops_q}),
    .read_i         (1'b1),
    .read_address_i (page),
    .read_data_o    (facts)
  );

  // Only opcode 5 brings an origin.
  generate
    if (SPANS > 1) begin : gen_origins
      reg  [20:0] new_origin_q;
      reg  [20:0] origin_q;
      wire [20:0] origin;
      always @(posedge clk) begin
        if (header_i) new_origin_q <= data_i[126:106] & {21{newer_q}};
        if (look) origin_q <= origin;
      end
      assign origin_o = origin_q;

      ffd_mem_sdp #(
        .WIDTH       (21),
        .DEPTH       (DEPTH),
        .READ_LATENCY(0)
      ) u_origins (
        .clk            (clk),
        .write_i        (whole),
        .write_address_i(page_q),
        .write_data_i   (new_origin_q),
        .read_i         (1'b1),
        .read_address_i (page),
        .read_data_o    (origin)
      );
    end else begin : gen_no_origins
      assign origin_o = 21'd0;
    end
  endgenerate

  // A page that is just loaded has a reader of long ago.
  ffd_mem_sdp #(
    .WIDTH       (READERS_W),
    .DEPTH       (DEPTH),
    .READ_LATENCY(0)
  ) u_readers (
    .clk            (clk),
    .write_i        (whole || (finish_i && of_page_i && hit_q)),
    .write_address_i(page_q),
    .write_data_i   ({came_q[READERS_W-1] ^ whole, came_q[READERS_W-2:0]}),
    .read_i         (1'b1),
    .read_address_i (page),
    .read_data_o    (reader)
  );

  wire unused_ok = &{1'b0, has_fourth, size, data_i, packet_i, number};

  `FFD_ASSERT(a_vertex_leaves_and_none_is_inside,
              !leave_i || inside_q != {READERS_W{1'b0}})
  `FFD_ASSERT(more_vertices_are_inside_than_may_be,
              inside_q <= INSIDE[READERS_W-1:0])
endmodule

`default_nettype wire
