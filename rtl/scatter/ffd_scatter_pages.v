// ffd_scatter_pages: what is known of the pages of sums, and when a header may go on
//
// Of each page: its points an axis, where it has any, how many vertices added to it since it was
// zero, and whether one saturated or there were too many. Every header is held while its page is
// looked up. One of coefficients waits until no vertex reads the bank that it fills; gradients
// for the page of a collect wait until that has read all; with B they wait for all vertices and for
// the sweep of the begin before, and then the page begins.
//
// A collect leaves the page without points at once, and its header goes on. It is offered to the
// core when all vertices before it have added, with what the page's status is then. There is one
// at a time: the header of the next one waits.
//
// Bad input:  verdict_o with go_o: the packet is refused.
// Overflow:   a page's count ends at 2^(34 - FORMAT): up to so many vertices no sum can overflow.
// Formats:    verdict {other points, bad points an axis, no page, unknown}; tops and last cell
//             {u, t, s}, tops = points an axis - 1.
// Pipeline:   look up | verdict | go: 3 clocks behind the first in which the header is held. What
//             it says stays until the next one is looked up.
// Parameters: FORMAT as in ffd_scatter_core; PAGES 1 to 256; AXIS as in ffd_scatter_header.
// Model:      golden/include/hwffd/model/scatter_stream.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_scatter.vh"

module ffd_scatter_pages #(
  parameter FORMAT  = 17,
  parameter PAGES   = 2,
  parameter AXIS    = 16,
  parameter PAGE_W  = `FFD_PAGE_NUMBER_W(PAGES),
  parameter PLACE_W = 3 * `FFD_AXIS_W(AXIS)
) (
  input  wire                     clk,
  input  wire                     rst,
  input  wire                     held_i,      // a header
  input  wire [127:0]             data_i,
  input  wire [`FFD_PACKET_W-1:0] packet_i,
  output wire                     go_o,
  output wire                     waits_o,     // for vertices inside, a sweep or a collect
  output reg  [3:0]               verdict_o,
  output reg                      coefficients_o,
  output reg                      collect_o,
  output reg                      grid_o,
  output reg                      none_o,
  output reg  [1:0]               along_o,
  output reg                      clamp_o,     // mode 0
  output wire [PAGE_W-1:0]        page_o,
  output reg  [PLACE_W-1:0]       last_cell_o,
  // Vertices inside; and those of the core that have added.
  input  wire                     inside_i,
  input  wire                     bank_inside_i,
  input  wire                     collect_inside_i,
  input  wire                     added_i,
  input  wire [PAGE_W-1:0]        added_page_i,
  input  wire                     added_saturated_i,
  input  wire                     layer_saturated_i,  // of a layer of one of its rows
  input  wire [PAGE_W-1:0]        layer_page_i,
  output reg                      overflowed_o,  // event
  // To the core.
  output wire                     begin_o,
  output wire [PAGE_W-1:0]        begin_page_o,
  input  wire                     sweeping_i,
  output wire                     mark_o,        // a collect goes on
  output reg                      m_collect_valid,
  input  wire                     m_collect_ready,
  output wire [PAGE_W-1:0]        m_collect_page,
  output reg  [1:0]               m_collect_shift,
  output wire [PLACE_W-1:0]       m_collect_tops,
  // To the encoder, until it is done.
  output reg  [15:0]              collect_tag_o,
  output reg  [1:0]               collect_flags_o,   // {I, R}
  output reg  [1:0]               collect_status_o,  // {overflowed, saturated}
  input  wire                     collected_i,
  output wire                     collecting_o
);
  generate
    if (PAGES < 1 || PAGES > 256) begin : gen_bad_pages
      ERROR_ffd_scatter_pages_pages_must_be_1_to_256 u_error ();
    end
  endgenerate

  localparam AXIS_W             = `FFD_AXIS_W(AXIS);
  localparam COUNT_W            = `FFD_SCATTER_SUM_W - FORMAT;
  localparam DEPTH              = PAGES > 1 ? PAGES : 2;  // of a memory
  localparam [31:0] PAGES_WORD  = PAGES;  // 32 bits where set from outside
  localparam [8:0]  MOST        = PAGES_WORD[8:0];
  localparam [AXIS_W-1:0] NOT_CELLS = 3;
  localparam [PAGES-1:0]  ONE_PAGE  = 1;

  // ---- the header that is held: the first clock

  wire [7:0]         number = data_i[15:8];
  wire [PAGE_W-1:0]  page   = number[PAGE_W-1:0];
  wire               unknown;
  wire               size;
  wire               none;
  wire               grid;
  wire               begins;
  wire [PLACE_W-1:0] tops;
  ffd_scatter_header #(
    .AXIS(AXIS)
  ) u_header (
    .data_i   (data_i),
    .packet_i (packet_i),
    .unknown_o(unknown),
    .size_o   (size),
    .none_o   (none),
    .grid_o   (grid),
    .begin_o  (begins),
    .tops_o   (tops)
  );

  reg  [2:0]         step_q;
  reg                unknown_q;
  reg                beyond_q;
  reg                size_q;
  reg                begin_q;
  reg                known_q;    // the page has points
  reg  [PAGE_W-1:0]  page_q;
  reg  [PLACE_W-1:0] tops_q;
  reg  [PLACE_W-1:0] page_tops_q;
  reg  [PAGES-1:0]   pages_known_q;
  wire [PLACE_W-1:0] page_tops;
  wire               look = held_i && step_q == 3'd0;
  always @(posedge clk) begin
    if (rst || go_o) step_q <= 3'd0;
    else step_q <= {step_q[1] || step_q[2], step_q[0], look};
  end
  always @(posedge clk) begin
    if (look) begin
      coefficients_o <= packet_i[`FFD_PACKET_COEFFICIENTS];
      collect_o      <= packet_i[`FFD_PACKET_COLLECT];
      grid_o         <= grid;
      none_o         <= none;
      along_o        <= data_i[91:90];
      clamp_o        <= !data_i[89];
      unknown_q      <= unknown;
      beyond_q       <= !packet_i[`FFD_PACKET_COEFFICIENTS] && {1'b0, number} >= MOST;
      size_q         <= size;
      begin_q        <= begins;
      page_q         <= page;
      known_q        <= pages_known_q[page];
      tops_q         <= tops;
      page_tops_q    <= page_tops;
    end
  end
  assign page_o = page_q;

  // ---- the second clock: what is wrong with it

  wire gradients = !coefficients_o && !collect_o;
  wire other     = gradients && known_q && !begin_q && tops_q != page_tops_q;
  always @(posedge clk) begin
    if (step_q[0]) begin
      verdict_o <= unknown_q                               ? 4'b0001
                 : beyond_q || (collect_o && !known_q)     ? 4'b0010
                 : size_q                                  ? 4'b0100
                 : other                                   ? 4'b1000 : 4'b0000;
    end
  end

  // ---- the third one: whether it has to wait. What it waits for does not come back.

  reg                collecting_q;
  reg                ready_q;
  reg  [PAGE_W-1:0]  collect_page_q;
  wire               refused = verdict_o != 4'd0;
  wire               own     = collecting_q && collect_page_q == page_q;
  wire               waits   = coefficients_o ? bank_inside_i
                             : collect_o      ? collecting_q
                             : own || (begin_q && (inside_i || sweeping_i));
  always @(posedge clk) begin
    ready_q <= !rst && !go_o && (step_q[1] || step_q[2]) && (refused || !waits);
  end
  assign go_o    = ready_q;
  assign waits_o = step_q[2] && !go_o && !refused && waits;

  // ---- it goes on

  reg  of_tops_q;
  reg  of_zero_q;
  reg  of_mark_q;
  always @(posedge clk) begin
    of_tops_q <= !refused && gradients;
    of_zero_q <= !refused && gradients && begin_q;
    of_mark_q <= !refused && collect_o;
  end
  wire take_tops = go_o && of_tops_q;
  wire zero      = go_o && of_zero_q;
  assign mark_o       = go_o && of_mark_q;
  assign begin_o      = zero;
  assign begin_page_o = page_q;

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      always @(posedge clk) begin
        last_cell_o[AXIS_W*a +: AXIS_W] <= tops_q[AXIS_W*a +: AXIS_W] - NOT_CELLS;
      end
    end
  endgenerate

  ffd_mem_sdp #(
    .WIDTH       (PLACE_W),
    .DEPTH       (DEPTH),
    .READ_LATENCY(0)
  ) u_tops (
    .clk            (clk),
    .write_i        (take_tops),
    .write_address_i(page_q),
    .write_data_i   (tops_q),
    .read_i         (1'b1),
    .read_address_i (page),
    .read_data_o    (page_tops)
  );

  // ---- the collect

  reg                 offer_q;   // it may be offered
  wire                collects = m_collect_valid && m_collect_ready;
  reg  [PLACE_W-1:0]  collect_tops_q;
  reg  [PAGES-1:0]    saturated_q;
  reg  [PAGES-1:0]    overflowed_q;
  assign m_collect_page = collect_page_q;
  assign m_collect_tops = collect_tops_q;
  assign collecting_o   = collecting_q;
  always @(posedge clk) begin
    if (rst) begin
      collecting_q    <= 1'b0;
      offer_q         <= 1'b0;
      m_collect_valid <= 1'b0;
    end else begin
      collecting_q    <= mark_o || (collecting_q && !collected_i);
      offer_q         <= mark_o || (offer_q && collect_inside_i);
      m_collect_valid <= (offer_q && !collect_inside_i) || (m_collect_valid && !m_collect_ready);
    end
  end
  always @(posedge clk) begin
    if (mark_o) begin
      collect_page_q  <= page_q;
      collect_tops_q  <= page_tops_q;
      m_collect_shift <= data_i[65:64];
      collect_tag_o   <= data_i[111:96];
      collect_flags_o <= data_i[21:20];
    end
    if (collects) begin
      collect_status_o <= {overflowed_q[collect_page_q], saturated_q[collect_page_q]};
    end
  end

  // ---- what vertices leave: a page that is zero begins to count anew with the first one

  reg  [PAGES-1:0]   fresh_q;
  wire [COUNT_W-1:0] stored;
  wire [COUNT_W-1:0] count = stored & {COUNT_W{!fresh_q[added_page_i]}};
  wire               full  = count[COUNT_W-1];
  ffd_mem_sdp #(
    .WIDTH       (COUNT_W),
    .DEPTH       (DEPTH),
    .READ_LATENCY(0)
  ) u_count (
    .clk            (clk),
    .write_i        (added_i && !full),
    .write_address_i(added_page_i),
    .write_data_i   (count + 1'b1),
    .read_i         (1'b1),
    .read_address_i (added_page_i),
    .read_data_o    (stored)
  );
  always @(posedge clk) begin
    overflowed_o <= added_i && full && !overflowed_q[added_page_i] && !rst;
  end

  wire [PAGES-1:0] adds    = {PAGES{added_i}} & (ONE_PAGE << added_page_i);
  wire [PAGES-1:0] layers  = {PAGES{layer_saturated_i}} & (ONE_PAGE << layer_page_i);
  wire [PAGES-1:0] zeros   = ({PAGES{zero}} & (ONE_PAGE << page_q))
                           | ({PAGES{collects}} & (ONE_PAGE << collect_page_q));
  wire [PAGES-1:0] knows   = {PAGES{take_tops}} & (ONE_PAGE << page_q);
  wire [PAGES-1:0] forgets = {PAGES{mark_o}} & (ONE_PAGE << page_q);
  always @(posedge clk) begin
    if (rst) begin
      pages_known_q <= {PAGES{1'b0}};
      fresh_q       <= {PAGES{1'b1}};
      saturated_q   <= {PAGES{1'b0}};
      overflowed_q  <= {PAGES{1'b0}};
    end else begin
      pages_known_q <= (pages_known_q | knows) & ~forgets;
      fresh_q       <= (fresh_q & ~adds) | zeros;
      saturated_q   <= (saturated_q | (adds & {PAGES{added_saturated_i}}) | layers) & ~zeros;
      overflowed_q  <= (overflowed_q | (adds & {PAGES{full}})) & ~zeros;
    end
  end

  wire unused_ok = &{1'b0, data_i, packet_i};

  `FFD_ASSERT(a_page_begins_while_its_vertices_are_inside, !zero || !inside_i)
  `FFD_ASSERT(a_vertex_adds_to_a_page_that_is_collected,
              !(collects && added_i && added_page_i == collect_page_q))
endmodule

`default_nettype wire
