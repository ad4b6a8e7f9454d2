// ffd_stream_resident: the resident lattice or page that a vertex is of
//
// ffd_stream_pages, or ffd_stream_buffers where there are no pages, knows what is loaded. A vertex
// of it whose cell is beyond the last one is brought into that one. Where its points are goes with
// it as its source, with the bits of its cell for which twelve are too few.
//
// Formats:    cell {k, j, i}, four bits each, the whole cell as many as AXIS wants; source as in
//             ffd_stream.vh. In word 3 of a vertex a cell has four bits an axis; above 16 points
//             five, the highest in bits 30 to 28; with the flag L six, and a tag of 14 bits.
// Pipeline:   cell, tag and source with the beat; the others as in ffd_stream_pages.
// Parameters: those of ffd_stream_pages; SLOTS >= 2.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_stream.vh"

module ffd_stream_resident #(
  parameter FORMAT   = 18,
  parameter FEATURES = `FFD_FEATURES_USUAL,
  parameter SLOTS    = 3,
  parameter PAGES    = 2,
  parameter AXIS     = 16,
  parameter INSIDE   = 152,
  parameter SPANS    = 1,
  parameter SLOT_W   = $clog2(SLOTS),
  parameter PAGE_W   = `FFD_PAGE_NUMBER_W(PAGES),
  parameter PLACE_W  = 3 * `FFD_AXIS_W(AXIS),
  parameter SOURCE_W = `FFD_SOURCE_W(SLOTS, PAGES, AXIS, FEATURES)
) (
  input  wire                        clk,
  input  wire                        rst,
  input  wire                        take_i,
  input  wire                        held_i,
  input  wire [127:0]                data_i,
  input  wire [`FFD_FRAME_W-1:0]     frame_i,
  input  wire [`FFD_EXPONENT_W-1:0]  exponent_i,  // of the packet under way
  input  wire                        resident_i,  // its vertices are of the lattice
  input  wire [SLOT_W-1:0]           slot_i,      // of those that are not
  input  wire                        leave_i,     // a vertex
  output wire                        go_o,
  output wire                        waits_o,     // for readers
  output wire                        refuse_o,
  output wire                        place_valid_o,
  output wire [PLACE_W-1:0]          place_o,
  output wire [PLACE_W-1:0]          tops_o,
  output wire [`FFD_PAGE_W-1:0]      verdict_o,
  output wire                        empty_o,
  output wire [PAGE_W-1:0]           new_page_o,  // that points go to
  output wire                        loaded_o,
  output wire [PLACE_W-1:0]          last_cell_o,
  output wire [`FFD_EXPONENT_W-1:0]  exponent_o,
  output wire                        fourth_o,
  output wire [2:0]                  beyond_o,
  output wire [11:0]                 cell_o,
  output wire [PLACE_W-1:0]          whole_cell_o,
  output wire [20:0]                 origin_o,    // {u, t, s}, of the page: added to its cells
  output wire [15:0]                 tag_o,
  output wire [SOURCE_W-1:0]         source_o
);
  localparam AXIS_W = `FFD_AXIS_W(AXIS);
  localparam HIGH_W = `FFD_HIGH_W(AXIS);
  localparam AT_W   = `FFD_AT_W(SLOTS, PAGES);

  wire header  = take_i && frame_i[`FFD_FRAME_HEADER];
  wire point   = take_i && frame_i[`FFD_FRAME_POINT];
  wire of_page = frame_i[`FFD_FRAME_PAGE];
  wire top     = frame_i[`FFD_FRAME_TOP];
  wire [PAGE_W-1:0]  page;
  wire               of_large;
  wire [20:0]        origin;

  generate
    if (`FFD_FEATURE_PAGES(FEATURES) != 0) begin : gen_pages
      ffd_stream_pages #(
        .FORMAT  (FORMAT),
        .FEATURES(FEATURES),
        .PAGES   (PAGES),
        .AXIS    (AXIS),
        .INSIDE  (INSIDE),
        .SPANS   (SPANS)
      ) u_pages (
        .clk          (clk),
        .rst          (rst),
        .held_i       (held_i && of_page),
        .size_i       (frame_i[`FFD_FRAME_SIZE]),
        .data_i       (data_i),
        .packet_i     (frame_i[`FFD_FRAME_PACKET]),
        .header_i     (header && of_page),
        .point_i      (point),
        .top_i        (top),
        .finish_i     (take_i && frame_i[`FFD_FRAME_FINISH]),
        .of_page_i    (resident_i),
        .leave_i      (leave_i),
        .exponent_i   (exponent_i),
        .go_o         (go_o),
        .waits_o      (waits_o),
        .refuse_o     (refuse_o),
        .place_valid_o(place_valid_o),
        .place_o      (place_o),
        .tops_o       (tops_o),
        .verdict_o    (verdict_o),
        .empty_o      (empty_o),
        .page_o       (page),
        .loaded_o     (loaded_o),
        .last_cell_o  (last_cell_o),
        .exponent_o   (exponent_o),
        .large_o      (of_large),
        .fourth_o     (fourth_o),
        .origin_o     (origin)
      );
      assign new_page_o = page;
    end else begin : gen_buffers
      if (PAGES != 2) begin : gen_bad_pages
        ERROR_ffd_stream_resident_has_two_buffers_without_pages u_error ();
      end
      ffd_stream_buffers #(
        .AXIS      (AXIS),
        .EXPONENT_W(`FFD_EXPONENT_W)
      ) u_buffers (
        .clk        (clk),
        .rst        (rst),
        .header_i   (header),
        .points_i   (data_i[87:64]),
        .exponent_i (exponent_i),
        .whole_i    (point && top),
        .buffer_o   (page),
        .loaded_o   (loaded_o),
        .last_cell_o(last_cell_o),
        .exponent_o (exponent_o)
      );
      assign new_page_o    = !page;
      assign go_o          = 1'b1;
      assign waits_o       = 1'b0;
      assign refuse_o      = 1'b0;
      assign place_valid_o = 1'b0;
      assign place_o       = {PLACE_W{1'b0}};
      assign tops_o        = {PLACE_W{1'b0}};
      assign verdict_o     = {`FFD_PAGE_W{1'b0}};
      assign empty_o       = 1'b0;
      assign of_large      = 1'b0;
      assign origin        = 21'd0;
      assign fourth_o      = 1'b0;
      wire unused_ok = &{1'b0, held_i, of_page, leave_i};
    end
  endgenerate

  wire bounded = resident_i && loaded_o;
  wire in_large = resident_i && of_large;  // as the last packet of a page said
  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      wire [5:0]        few     = {1'b0, AXIS_W > 4 && data_i[124+a], data_i[112+4*a +: 4]};
      wire [5:0]        asked   = in_large ? data_i[110+6*a +: 6] : few;
      wire [AXIS_W-1:0] last    = last_cell_o[AXIS_W*a +: AXIS_W];
      wire [AXIS_W-1:0] nearest = beyond_o[a] ? last : asked[AXIS_W-1:0];
      assign beyond_o[a]      = bounded && asked[AXIS_W-1:0] > last;
      assign cell_o[4*a +: 4] = nearest[3:0];
      assign whole_cell_o[AXIS_W*a +: AXIS_W] = nearest;
      if (HIGH_W > 0) begin : gen_high
        assign source_o[AT_W+HIGH_W*a +: HIGH_W] = nearest[AXIS_W-1:4];
      end
      wire unused_ok = &{1'b0, asked};
    end
    if (`FFD_FEATURE_FOURTH(FEATURES) != 0) begin : gen_fourth
      assign source_o[SOURCE_W-2] = fourth_o && resident_i;
    end
  endgenerate

  wire [AT_W:0] at_page = {{(AT_W + 1 - PAGE_W) {1'b0}}, page};
  wire [AT_W:0] at_slot = {{(AT_W + 1 - SLOT_W) {1'b0}}, slot_i};
  assign source_o[AT_W-1:0]   = resident_i ? at_page[AT_W-1:0] : at_slot[AT_W-1:0];
  assign source_o[SOURCE_W-1] = resident_i;
  assign origin_o = origin & {21{resident_i}};
  assign tag_o = {data_i[111:110] & {2{!in_large}}, data_i[109:96]};

  wire unused_ok = &{1'b0, data_i, frame_i, at_page, at_slot};
endmodule

`default_nettype wire
