// ffd_scatter_sweep: the epochs of pages, and the sweeps that leave none of the one before
//
// A page begins when its epoch turns over: words of the other epoch stand for 0. A sweep then goes
// through the places of the page, so that none of these is left when it begins again. After reset,
// when memory may hold anything, all places of all pages are cleared, with the epoch 0.
//
// Pipeline:   begin_i | epoch, sweeping_o. A place each time that take_i says that it has a slot.
// Freezes:    a sweep has only slots that nobody else wants.
// Bad input:  a begin while a sweep is under way: FFD_ASSERTIONS.
// Parameters: AXIS 4 to 64, PAGES >= 1.
// Model:      golden/include/hwffd/model/scatter.hpp (ScatterPage::begin).  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_scatter.vh"

module ffd_scatter_sweep #(
  parameter AXIS   = 16,
  parameter PAGES  = 2,
  parameter AXIS_W = `FFD_AXIS_W(AXIS),
  parameter PAGE_W = `FFD_PAGE_NUMBER_W(PAGES)
) (
  input  wire                     clk,
  input  wire                     rst,
  input  wire                     begin_i,
  input  wire [PAGE_W-1:0]        begin_page_i,
  output wire [(1<<PAGE_W)-1:0]   epochs_o,
  output wire                     sweeping_o,
  output wire                     clearing_o,  // the sweep is that after reset
  output wire [PAGE_W-1:0]        page_o,
  output wire [3*AXIS_W-1:0]      cell_o,      // the first cell of the place, {k, j, i}
  input  wire                     take_i
);
  localparam              HIGH_W    = `FFD_SCATTER_HIGH_W(AXIS);
  localparam              TOP       = PAGES - 1;
  localparam [PAGE_W-1:0] LAST_PAGE = TOP[PAGE_W-1:0];

  reg                 sweeping_q;
  reg                 clearing_q;
  reg  [PAGE_W-1:0]   page_q;
  reg  [3*HIGH_W-1:0] place_q;
  wire                last = &place_q;
  wire                more = clearing_q && page_q != LAST_PAGE;

  always @(posedge clk) begin
    if (rst) begin
      sweeping_q <= 1'b1;
      clearing_q <= 1'b1;
    end else if (begin_i) begin
      sweeping_q <= 1'b1;
    end else if (take_i && last && !more) begin
      sweeping_q <= 1'b0;
      clearing_q <= 1'b0;
    end
  end
  always @(posedge clk) begin
    if (rst) page_q <= {PAGE_W{1'b0}};
    else if (begin_i) page_q <= begin_page_i;
    else if (take_i && last && more) page_q <= page_q + 1'b1;
  end
  always @(posedge clk) begin
    if (rst || begin_i) place_q <= {(3 * HIGH_W) {1'b0}};
    else if (take_i) place_q <= place_q + 1'b1;
  end

  genvar p;
  generate
    for (p = 0; p < 1 << PAGE_W; p = p + 1) begin : gen_page
      localparam [PAGE_W-1:0] PAGE = p;
      if (p < PAGES) begin : gen_epoch
        reg epoch_q;
        always @(posedge clk) begin
          if (rst) epoch_q <= 1'b0;
          else if (begin_i && begin_page_i == PAGE) epoch_q <= !epoch_q;
        end
        assign epochs_o[p] = epoch_q;
      end else begin : gen_none
        assign epochs_o[p] = 1'b0;
      end
    end
  endgenerate

  assign sweeping_o = sweeping_q;
  assign clearing_o = clearing_q;
  assign page_o     = page_q;

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      wire [AXIS_W-1:0] at;
      assign at[HIGH_W+1:0] = {place_q[HIGH_W*a +: HIGH_W], 2'd0};
      if (AXIS_W > HIGH_W + 2) begin : gen_high
        assign at[AXIS_W-1:HIGH_W+2] = {(AXIS_W - HIGH_W - 2) {1'b0}};
      end
      assign cell_o[AXIS_W*a +: AXIS_W] = at;
    end
  endgenerate

  `FFD_ASSERT(a_page_begins_while_a_sweep_is_under_way, !begin_i || !sweeping_q)
endmodule

`default_nettype wire
