// ffd_stream_grid: the vertices of a regular grid, s fastest, then t, then u
//
// Along an axis vertex n is at start + n * step, summed exactly from one to the next. Its cell is
// the whole part, its coordinate the first 24 bits of the fraction; what ends on the last face is
// in the last cell at 1. Before the first vertex the end, start + (count - 1) * step, is found by
// as many doublings as a count has bits: whatever lies between both ends is inside if they are.
//
// With PAIRS two vertices that are neighbours in a row are one item where pairs_i allows it and the
// whole parts of their sums are equal: they share a cell, and a coordinate of s more goes with the
// first one. So one on the last face is no pair with one of the last cell that is not there.
//
// Bad input:  bad_o, when checked: a count of 0, an end outside the lattice, no lattice, a cell
//             beyond the 32nd without the flag L, or more than 2^LIMIT vertices: these are counted
//             from the header on, two bits of a count a clock, and known before the check is done.
// Formats:    data of a header: counts of s and t in word 1, of u in word 3; of an axis: start,
//             unsigned, and step, signed, 24 bits before the point and 40 behind it. Coordinates
//             Q1.24, cells six bits, {u, t, s}.
// Pipeline:   checked 20 clocks after check_i, with the first vertex; then a vertex or a pair in
//             every clock, in that of next_i the one before. A vertex leaves registers, a clock
//             behind its sums.
//             A header makes checked_o 0; what it says is that of the last clock of header_i.
// Parameters: AXIS as in ffd_stream_header; LIMIT 0 to 48, and with 48 there is none; PAIRS 0, 1.
// Model:      golden/include/hwffd/stream/grid.hpp.  Test: tests/system/grid_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_stream.vh"

module ffd_stream_grid #(
  parameter AXIS  = 16,
  parameter LIMIT = 48,
  parameter PAIRS = 0
) (
  input  wire                           clk,
  input  wire                           rst,
  input  wire [127:0]                   data_i,
  input  wire                           header_i,
  input  wire [2:0]                     axis_i,       // which of them data_i is of
  input  wire                           check_i,
  input  wire                           loaded_i,
  input  wire                           large_i,      // the flag L
  input  wire [3*`FFD_AXIS_W(AXIS)-1:0] last_cell_i,  // {k, j, i}
  input  wire                           next_i,
  input  wire                           pairs_i,
  output reg                            checked_o,
  output wire                           bad_o,
  output reg                            last_o,
  output reg                            row_last_o,   // the last one along s
  output reg  [17:0]                    cells_o,
  output reg  [74:0]                    coordinates_o,
  output wire                           pair_o,
  output wire [24:0]                    second_o      // of s
);
  localparam AXIS_W   = `FFD_AXIS_W(AXIS);
  localparam FRACTION = 40;
  localparam START_W  = AXIS_W + FRACTION;
  localparam STEP_W   = START_W + 1;
  // A sum of two times what fits and once; whatever fits has three equal bits on top.
  localparam SUM_W    = START_W + 3;
  localparam COUNT_W  = 16;

  // ---- how many: n_s n_t and then n_u of them, from the highest bits on

  wire many;
  generate
    if (LIMIT < 0 || LIMIT > 3 * COUNT_W) begin : gen_bad_limit
      ERROR_ffd_stream_grid_limit_must_be_0_to_48 u_error ();
    end
    if (LIMIT < 3 * COUNT_W) begin : gen_limit
      localparam                PRODUCT_W = LIMIT < COUNT_W ? COUNT_W : LIMIT + 1;
      localparam [PRODUCT_W+2:0] ONE      = 1;
      localparam [PRODUCT_W+2:0] MOST     = ONE << LIMIT;
      reg  [4:0]           step_q;     // eight for each product
      reg  [PRODUCT_W-1:0] product_q;  // of no meaning where it is too many
      reg  [PRODUCT_W-1:0] factor_q;
      reg  [COUNT_W-1:0]   bits_q;
      reg  [COUNT_W-1:0]   last_bits_q;
      reg                  many_q;
      wire [PRODUCT_W+2:0] factor = {3'd0, factor_q};
      wire [PRODUCT_W+2:0] next   = {1'b0, product_q, 2'd0}
                                  + (bits_q[COUNT_W-1] ? {factor[PRODUCT_W+1:0], 1'b0}
                                                       : {(PRODUCT_W + 3) {1'b0}})
                                  + (factor & {(PRODUCT_W + 3) {bits_q[COUNT_W-2]}});
      wire                 turns  = step_q[2:0] == 3'd7;
      always @(posedge clk) begin
        if (header_i) begin
          step_q      <= 5'd0;
          product_q   <= {PRODUCT_W{1'b0}};
          factor_q    <= {{(PRODUCT_W - COUNT_W) {1'b0}}, data_i[32 +: COUNT_W]};
          bits_q      <= data_i[48 +: COUNT_W];
          last_bits_q <= data_i[96 +: COUNT_W];
          many_q      <= 1'b0;
        end else if (!step_q[4]) begin
          step_q    <= step_q + 5'd1;
          product_q <= turns ? {PRODUCT_W{1'b0}} : next[PRODUCT_W-1:0];
          if (turns) factor_q <= next[PRODUCT_W-1:0];
          bits_q    <= turns ? last_bits_q : {bits_q[COUNT_W-3:0], 2'd0};
          many_q    <= many_q || next > MOST;
        end
      end
      assign many = many_q;
    end else begin : gen_no_limit
      assign many = 1'b0;
    end
  endgenerate

  // ---- the check: doublings, the end, back to the start

  reg  [3:0] bit_q;
  reg        doubling_q;
  reg        ending_q;
  reg        first_q;    // the sums are of the end, and then of the start
  reg        done_q;     // of the start, and then of the vertex behind it
  // What a sum and its term are made of, known a clock before.
  reg        summing_q;  // doubling or ending
  reg        empty_q;    // the sum begins anew
  reg        starts_q;   // with the start, or the start comes to it
  reg        changes_q;  // the check changes it
  wire       last_bit = doubling_q && &bit_q;
  wire [2:0] zero;
  wire [2:0] beyond;     // what is known without the sum
  wire [2:0] over;       // a multiple of the step that no lattice has room for
  wire [2:0] outside;
  reg        bad_q;
  reg        outside_q;

  always @(posedge clk) begin
    if (rst) begin
      {doubling_q, ending_q, first_q, done_q, summing_q, empty_q, starts_q, changes_q} <= 8'd0;
    end else begin
      doubling_q <= check_i || (doubling_q && !last_bit);
      ending_q   <= last_bit;
      first_q    <= ending_q;
      done_q     <= first_q;
      summing_q  <= check_i || doubling_q;
      empty_q    <= check_i || ending_q;
      starts_q   <= last_bit || ending_q;
      changes_q  <= check_i || summing_q;
    end
  end
  always @(posedge clk) bit_q <= check_i ? 4'd0 : bit_q + 4'd1;
  always @(posedge clk) begin
    if (header_i) checked_o <= 1'b0;
    else if (done_q) checked_o <= 1'b1;
    outside_q <= (first_q || done_q) && |outside;
    if (check_i) bad_q <= !loaded_i || |zero || |beyond;
    else bad_q <= bad_q || outside_q || (summing_q && !empty_q && |over);
  end
  assign bad_o = bad_q || outside_q || many;

  // ---- three axes

  wire       next   = next_i || done_q;
  wire [2:0] to_last;   // an axis will be at its last vertex
  wire [2:0] at_last;   // it is
  wire [2:0] behind;    // all before it are
  wire [2:0] wraps;     // it begins anew when it moves
  wire       last;
  wire       row_last;
  wire       pair;      // the sums are of two vertices
  wire       ends;      // the row ends with them
  generate
    if (PAIRS == 0) begin : gen_alone
      reg [2:0] all_q;  // an axis is at its last vertex, and all before it are
      always @(posedge clk) begin
        if (check_i) all_q <= 3'd0;
        else if (first_q || next) all_q <= {&to_last, &to_last[1:0], to_last[0]};
      end
      assign behind   = {all_q[1:0], 1'b1};
      assign wraps    = all_q;
      assign last     = all_q[2];
      assign row_last = all_q[0];
      assign {pair, ends, pair_o, second_o} = 28'd0;
      wire unused_ok = &{1'b0, at_last, pair, ends, pairs_i};
    end else begin : gen_pairs
      // Whether a row ends is known late, and enables what it moves.
      assign behind   = {ends && at_last[1], ends, 1'b1};
      assign wraps    = {at_last[2:1], 1'b0};
      assign last     = ends && &at_last[2:1];
      assign row_last = ends;
      wire unused_ok = &{1'b0, to_last[0], at_last[0]};
    end
  endgenerate
  always @(posedge clk) if (next) {last_o, row_last_o} <= {last, row_last};

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      reg  [START_W-1:0] start_q;
      reg                far_q;     // it is beyond any lattice
      reg  [STEP_W-1:0]  step_q;
      reg                wide_q;    // the same of the step
      reg  [COUNT_W-1:0] top_q;     // count - 1
      reg                zero_q;
      reg                single_q;  // count is 1
      reg  [COUNT_W-1:0] left_q;    // in the check its bits pass by, the highest first
      reg                last_q;    // left_q is 0
      reg  [SUM_W-1:0]   sum_q;

      always @(posedge clk) begin
        if (axis_i[a]) begin
          start_q <= data_i[START_W-1:0];
          far_q   <= data_i[63:START_W] != {(64 - START_W) {1'b0}};
          step_q  <= data_i[64 +: STEP_W];
          wide_q  <= data_i[127:63+STEP_W] != {(65 - STEP_W) {data_i[127]}};
        end
      end

      // The last vertex of an axis, and of all before it, is followed by its first.
      wire [COUNT_W-1:0] count = a == 2 ? data_i[96 +: COUNT_W] : data_i[32+16*(a%2) +: COUNT_W];
      wire               moves = next && behind[a];
      wire               wraps_left;
      wire [COUNT_W-1:0] left;       // behind this move
      always @(posedge clk) begin
        if (header_i) begin
          top_q  <= count - 1'b1;
          zero_q <= count == {COUNT_W{1'b0}};
        end
        single_q <= top_q == {COUNT_W{1'b0}};
        if (header_i) left_q <= count - 1'b1;
        else if (doubling_q) left_q <= {left_q[COUNT_W-2:0], left_q[COUNT_W-1]};
        else if (moves) left_q <= wraps_left ? top_q : left;
      end
      wire to_one = left_q == {{(COUNT_W - 1) {1'b0}}, 1'b1};
      assign zero[a]    = zero_q;
      assign at_last[a] = last_q;
      assign beyond[a]  = far_q || (wide_q && !single_q);

      // From nothing to the end of the doublings, then to the end, then back and along.
      wire             empty  = empty_q || wraps[a];
      wire             starts = starts_q || wraps[a];
      wire             steps  = !doubling_q || left_q[COUNT_W-1];
      wire [SUM_W-1:0] from   = (doubling_q ? {sum_q[SUM_W-2:0], 1'b0} : sum_q) & {SUM_W{!empty}};
      wire [SUM_W-1:0] more   = starts ? {3'd0, start_q}
                              : {{(SUM_W - STEP_W) {step_q[STEP_W-1]}}, step_q} & {SUM_W{steps}};
      wire [SUM_W-1:0] sum    = from + more;
      assign over[a] = sum_q[SUM_W-1 -: 3] != {3{sum_q[SUM_W-1]}};

      // Where that is.
      reg  [AXIS_W-1:0] end_cell_q;
      reg  [AXIS_W:0]   end_q;       // of the lattice, known long before
      always @(posedge clk) begin
        end_cell_q <= last_cell_i[AXIS_W*a +: AXIS_W];
        end_q      <= {1'b0, last_cell_i[AXIS_W*a +: AXIS_W]} + 1'b1;
      end
      wire [AXIS_W+1:0] whole    = sum_q[SUM_W-2:FRACTION];
      wire [23:0]       fraction = sum_q[FRACTION-1 -: 24];
      wire              above    = whole > {2'd0, end_cell_q};
      wire              face     = whole == {1'b0, end_q} && fraction == 24'd0;
      wire [AXIS_W-1:0] inner    = above ? end_cell_q : whole[AXIS_W-1:0];
      wire [5:0]        here;
      if (AXIS_W < 6) begin : gen_few
        assign here = {{(6 - AXIS_W) {1'b0}}, inner};
      end else begin : gen_many
        assign here = inner;
      end
      assign outside[a] = sum_q[SUM_W-1] || (above && !face) || (here[5] && !large_i);
      always @(posedge clk) begin
        if (next) begin
          cells_o[6*a +: 6]         <= here;
          coordinates_o[25*a +: 25] <= above ? 25'h100_0000 : {1'b0, fraction};
        end
      end

      // The rest of an axis that moves by one vertex; or of s, with PAIRS, by one or two.
      if (PAIRS == 0) begin : gen_one
        assign to_last[a] = first_q || wraps[a] ? single_q : behind[a] ? to_one : last_q;
        assign wraps_left = last_q;
        assign left       = left_q - 1'b1;
        always @(posedge clk) begin
          if (first_q || next) last_q <= to_last[a];
          if (moves || changes_q) sum_q <= sum;
        end
      end else if (a != 0) begin : gen_of_rows
        assign to_last[a] = first_q || last_q ? single_q : to_one;
        assign wraps_left = last_q;
        assign left       = left_q - 1'b1;
        always @(posedge clk) begin
          if (check_i) last_q <= 1'b0;
          else if (first_q || moves) last_q <= to_last[a];
          if (moves || changes_q) sum_q <= sum;
        end
      end else begin : gen_two
        localparam [COUNT_W-1:0] TWO = 2;
        localparam [COUNT_W-1:0] THREE = 3;
        reg  [SUM_W-1:0] behind_q;   // the vertex behind that of sum_q, if the row has one
        reg  [SUM_W-1:0] second_q;   // the second one of a row
        reg              to_last_q;  // the last one is that behind
        reg              pair_q;
        reg  [24:0]      coordinate_q;
        wire [SUM_W-1:0] step  = {{(SUM_W - STEP_W) {step_q[STEP_W-1]}}, step_q};
        wire [SUM_W-1:0] one   = behind_q + step;
        wire [SUM_W-1:0] two   = behind_q + {step[SUM_W-2:0], 1'b0};
        wire             again = empty_q && starts_q;
        assign pair       = pairs_i && !last_q
                         && sum_q[START_W:FRACTION] == behind_q[START_W:FRACTION];
        assign ends       = last_q || (pair && to_last_q);
        assign wraps_left = ends;
        assign left       = left_q - (pair ? TWO : 16'd1);
        assign to_last[a] = 1'b0;
        always @(posedge clk) begin
          second_q <= {3'd0, start_q} + step;
          if (check_i) {to_last_q, last_q} <= 2'd0;
          else if (first_q || (next && ends)) begin
            {to_last_q, last_q} <= {top_q == 16'd1, single_q};
          end else if (next) begin
            {to_last_q, last_q} <= {left_q == (pair ? THREE : TWO), pair ? left_q == TWO : to_one};
          end
          if (changes_q) sum_q <= sum;
          else if (next) sum_q <= ends ? {3'd0, start_q} : pair ? one : behind_q;
          if (again || (next && ends)) behind_q <= second_q;
          else if (next) behind_q <= pair ? two : one;
          if (next) begin
            pair_q       <= pair;
            coordinate_q <= above ? 25'h100_0000 : {1'b0, behind_q[FRACTION-1 -: 24]};
          end
        end
        assign pair_o   = pair_q;
        assign second_o = coordinate_q;
      end
    end
  endgenerate
endmodule

`default_nettype wire
