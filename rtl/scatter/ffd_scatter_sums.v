// ffd_scatter_sums: the sums of all pages, in 64 banks
//
// Point (i, j, k) lies in bank (i mod 4, j mod 4, k mod 4), so any 4 x 4 x 4 support has one point
// in each bank: of cell i, bank b has the point at place i / 4, or the next one if b < i mod 4. A
// slot of three clocks goes to the words of one place in each bank, a component a clock, x first.
//
// Slots:      a vertex adds its parts; with ROWS 1 it is a layer, the points at one index along s,
//             which is that of the cell, and has parts for the 16 banks with that index. A sweep
//             adds nothing, and leaves 0 of the page's epoch where the word was of another. A clear
//             leaves 0 whatever the word was. The slot of a point of a collect reads the bank of
//             the point in cell_i, and leaves 0 there.
// Formats:    those of ffd_scatter_bank; words {epoch, sum}.
// Pipeline:   slot | addresses | word | sum: written. Parts come two clocks behind the slot's
//             component, the word of a point FFD_SCATTER_READ_LATENCY behind it: it is in a
//             register, and three choose one of 64. II 1, never frozen.
// Bad input:  a cell outside the lattice adds to some point of that page, never to another page.
// Parameters: ROWS 0 or 1, FORMAT 12 to 18, AXIS 4 to 64, PAGES >= 1.
// Model:      golden/include/hwffd/model/scatter.hpp (ScatterPage).  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_scatter.vh"

module ffd_scatter_sums #(
  parameter ROWS   = 0,
  parameter FORMAT = 17,
  parameter AXIS   = 16,
  parameter PAGES  = 2,
  parameter AXIS_W = `FFD_AXIS_W(AXIS),
  parameter PAGE_W = `FFD_PAGE_NUMBER_W(PAGES),
  parameter PART_W = ROWS == 0 ? `FFD_PART_W(FORMAT) : `FFD_WIDE_W,
  parameter PARTS  = ROWS == 0 ? 64 : 16
) (
  input  wire                              clk,
  input  wire                              rst,
  input  wire                              slot_valid_i,
  input  wire                              slot_vertex_i,     // of a vertex,
  input  wire                              slot_sweep_i,      // of a sweep,
  input  wire                              slot_point_i,      // of a point; else of a clear
  input  wire [1:0]                        slot_component_i,
  input  wire [PAGE_W-1:0]                 slot_page_i,
  input  wire                              slot_epoch_i,
  input  wire [3*AXIS_W-1:0]               slot_cell_i,       // {k, j, i}
  input  wire [PARTS*PART_W-1:0]           parts_i,           // bank {s, t, u} or {t, u}
  output wire [`FFD_SCATTER_WORD_W-1:0]    word_o
);
  localparam WORD_W    = `FFD_SCATTER_WORD_W;
  localparam HIGH_W    = `FFD_SCATTER_HIGH_W(AXIS);
  localparam HIGHS_W   = 3 * 4 * HIGH_W;
  localparam BELOW_W   = 3 * HIGH_W + 2;  // of an address, below the page
  localparam DEPTH     = PAGES * 2 ** BELOW_W;
  localparam ADDRESS_W = $clog2(DEPTH);
  localparam PLACES_W  = 9 * HIGH_W;        // of one bank of s, four of t and of u
  localparam AT_W      = PAGE_W + 2 + PLACES_W;
  `FFD_TAKES(`FFD_SCATTER_READ_LATENCY)

  generate
    if (AXIS < 4 || AXIS > 64) begin : gen_bad_axis
      ERROR_ffd_scatter_sums_axis_must_be_4_to_64 u_error ();
    end
    if (PAGES < 1) begin : gen_bad_pages
      ERROR_ffd_scatter_sums_pages_must_be_at_least_1 u_error ();
    end
  endgenerate

  // ---- the places of the four banks of each axis, and whether they are read

  wire [HIGHS_W-1:0] highs;
  wire [3*4-1:0]     reads;
  wire [5:0]         residues;  // {s, t, u}: the bank of the point

  genvar a;
  genvar v;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      wire [1:0] residue = slot_cell_i[AXIS_W*a +: 2];
      assign residues[4-2*a +: 2] = residue;
      ffd_scatter_places #(
        .AXIS(AXIS)
      ) u_places (
        .cell_i  (slot_cell_i[AXIS_W*a +: AXIS_W]),
        .places_o(highs[4*a*HIGH_W +: 4*HIGH_W])
      );
      for (v = 0; v < 4; v = v + 1) begin : gen_bank
        localparam [1:0] BANK = v;
        // Those of an axis that has one point in the slot.
        wire single = slot_point_i || (ROWS != 0 && a == 0 && slot_vertex_i);
        assign reads[4*a+v] = slot_valid_i && (!single || BANK == residue);
      end
    end
  endgenerate

  // ---- from the read to the write: p1_ is the read, p2_ has the word, p3_ the sum

  reg  [5:0] p1_bank_q;
  reg  [5:0] p2_bank_q;
  reg  [5:0] p3_bank_q;
  reg  [3:0] p4_bank_q;
  reg  [1:0] p5_bank_q;
  always @(posedge clk) begin
    p1_bank_q <= residues;
    p2_bank_q <= p1_bank_q;
    p3_bank_q <= p2_bank_q;
    p4_bank_q <= p3_bank_q[5:2];
    p5_bank_q <= p4_bank_q[3:2];
  end

  // Of each bank of s for itself, where it is read: no register drives more than 16 memories.
  genvar s;
  generate
    for (s = 0; s < 4; s = s + 1) begin : gen_quarter
      reg  [AT_W-1:0] p1_at_q;
      reg             p1_keep_q;
      reg             p1_add_q;
      reg             p1_epoch_q;
      reg  [AT_W-1:0] p2_at_q;
      reg             p2_keep_q;
      reg             p2_add_q;
      reg             p2_epoch_q;
      reg  [AT_W-1:0] p3_at_q;
      reg             p3_epoch_q;
      always @(posedge clk) begin
        if (reads[s]) begin
          p1_at_q    <= {slot_page_i, slot_component_i, highs[4*HIGH_W +: 8*HIGH_W],
                         highs[s*HIGH_W +: HIGH_W]};
          p1_keep_q  <= slot_vertex_i || slot_sweep_i;
          p1_add_q   <= slot_vertex_i;
          p1_epoch_q <= slot_epoch_i;
        end
        p2_at_q    <= p1_at_q;
        p2_keep_q  <= p1_keep_q;
        p2_add_q   <= p1_add_q;
        p2_epoch_q <= p1_epoch_q;
        p3_at_q    <= p2_at_q;
        p3_epoch_q <= p2_epoch_q;
      end
    end
  endgenerate

  wire [64*WORD_W-1:0] words;

  genvar b;
  generate
    for (b = 0; b < 64; b = b + 1) begin : gen_sum
      localparam T = 1 + b / 4 % 4;  // of a place in AT_W
      localparam U = 5 + b % 4;
      wire [AT_W-1:0]      p1_at   = gen_quarter[b/16].p1_at_q;
      wire [AT_W-1:0]      p3_at   = gen_quarter[b/16].p3_at_q;
      reg                  p1_read_q;
      reg                  p2_read_q;
      reg                  p3_read_q;
      wire [ADDRESS_W-1:0] p1_address;
      wire [ADDRESS_W-1:0] p3_address;

      always @(posedge clk) begin
        p1_read_q <= reads[b/16] && reads[T+3] && reads[U+3] && !rst;
        p2_read_q <= p1_read_q && !rst;
        p3_read_q <= p2_read_q && !rst;
      end

      assign p1_address[BELOW_W-1:0] = {p1_at[0 +: HIGH_W], p1_at[T*HIGH_W +: HIGH_W],
                                        p1_at[U*HIGH_W +: HIGH_W], p1_at[PLACES_W +: 2]};
      assign p3_address[BELOW_W-1:0] = {p3_at[0 +: HIGH_W], p3_at[T*HIGH_W +: HIGH_W],
                                        p3_at[U*HIGH_W +: HIGH_W], p3_at[PLACES_W +: 2]};
      if (PAGES > 1) begin : gen_page
        assign p1_address[ADDRESS_W-1:BELOW_W] = p1_at[PLACES_W+2 +: PAGE_W];
        assign p3_address[ADDRESS_W-1:BELOW_W] = p3_at[PLACES_W+2 +: PAGE_W];
      end
      wire unused_ok = &{1'b0, p1_at, p3_at};

      ffd_scatter_bank #(
        .PART_W(PART_W),
        .DEPTH (DEPTH)
      ) u_bank (
        .clk            (clk),
        .rst            (rst),
        .read_i         (p1_read_q),
        .read_address_i (p1_address),
        .word_o         (words[b*WORD_W +: WORD_W]),
        .epoch_i        (gen_quarter[b/16].p2_epoch_q),
        .keep_i         (gen_quarter[b/16].p2_keep_q),
        .add_i          (gen_quarter[b/16].p2_add_q),
        .part_i         (parts_i[(b%PARTS)*PART_W +: PART_W]),
        .write_i        (p3_read_q),
        .write_address_i(p3_address),
        .write_epoch_i  (gen_quarter[b/16].p3_epoch_q)
      );
    end
  endgenerate

  // ---- one of 64 words, by u, by t, by s

  wire [16*WORD_W-1:0] of_t;
  wire [4*WORD_W-1:0]  of_s;

  generate
    for (b = 0; b < 16; b = b + 1) begin : gen_along_u
      ffd_scatter_choice #(
        .WIDTH(WORD_W)
      ) u_choice (
        .clk     (clk),
        .number_i(p3_bank_q[1:0]),
        .words_i (words[4*b*WORD_W +: 4*WORD_W]),
        .word_o  (of_t[b*WORD_W +: WORD_W])
      );
    end
    for (b = 0; b < 4; b = b + 1) begin : gen_along_t
      ffd_scatter_choice #(
        .WIDTH(WORD_W)
      ) u_choice (
        .clk     (clk),
        .number_i(p4_bank_q[1:0]),
        .words_i (of_t[4*b*WORD_W +: 4*WORD_W]),
        .word_o  (of_s[b*WORD_W +: WORD_W])
      );
    end
  endgenerate

  ffd_scatter_choice #(
    .WIDTH(WORD_W)
  ) u_along_s (
    .clk     (clk),
    .number_i(p5_bank_q),
    .words_i (of_s),
    .word_o  (word_o)
  );
endmodule

`default_nettype wire
