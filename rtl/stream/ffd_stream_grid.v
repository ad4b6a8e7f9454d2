// ffd_stream_grid: the vertices of a regular grid, s fastest, then t, then u
//
// Along an axis vertex n is at start + n * step, summed exactly from one to the next. Its cell is
// the whole part, its coordinate the first 24 bits of the fraction; what ends on the last face is
// in the last cell at 1. Before the first vertex the end, start + (count - 1) * step, is found by
// as many doublings as a count has bits: whatever lies between both ends is inside if they are.
//
// Bad input:  bad_o, when checked: a count of 0, an end outside the lattice, no lattice, or without
//             the flag L a cell beyond the 32nd.
// Formats:    data of a header: counts of s and t in word 1, of u in word 3; of an axis: start,
//             unsigned, and step, signed, 24 bits before the point and 40 behind it. Coordinates
//             Q1.24, cells six bits, {u, t, s}.
// Pipeline:   checked 20 clocks after check_i; then a vertex in every clock, in that of next_i the
//             one before. A header makes checked_o 0.
// Parameters: AXIS as in ffd_stream_header.
// Model:      golden/include/hwffd/stream/grid.hpp.  Test: tests/system/grid_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_stream.vh"

module ffd_stream_grid #(
  parameter AXIS = 16
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
  output reg                            checked_o,
  output reg                            bad_o,
  output wire                           last_o,
  output wire [17:0]                    cells_o,
  output wire [74:0]                    coordinates_o
);
  localparam AXIS_W   = `FFD_AXIS_W(AXIS);
  localparam FRACTION = 40;
  localparam START_W  = AXIS_W + FRACTION;
  localparam STEP_W   = START_W + 1;
  // A sum of two times what fits and once; whatever fits has three equal bits on top.
  localparam SUM_W    = START_W + 3;
  localparam COUNT_W  = 16;
  localparam [4:0] LAST_DOUBLING = COUNT_W - 1;
  localparam [4:0] END           = COUNT_W;
  localparam [4:0] FIRST         = COUNT_W + 1;
  localparam [4:0] DONE          = COUNT_W + 2;

  // ---- the check: doublings, the end, back to the start

  reg  [4:0] phase_q;
  reg        checking_q;
  wire       doubling = checking_q && phase_q <= LAST_DOUBLING;
  wire       ending   = checking_q && phase_q == END;
  wire       first    = checking_q && phase_q == FIRST;
  wire       begins   = phase_q == 5'd0;
  wire [2:0] zero;
  wire [2:0] beyond;   // what is known without the sum
  wire [2:0] over;     // a multiple of the step that no lattice has room for
  wire [2:0] outside;

  always @(posedge clk) begin
    if (rst) checking_q <= 1'b0;
    else checking_q <= check_i || (checking_q && phase_q != DONE);
    phase_q <= check_i ? 5'd0 : phase_q + 5'd1;
  end
  always @(posedge clk) begin
    if (header_i) checked_o <= 1'b0;
    else if (checking_q && phase_q == DONE) checked_o <= 1'b1;
    if (check_i) bad_o <= !loaded_i || |zero || |beyond;
    else if (doubling || ending) bad_o <= bad_o || (!begins && |over);
    else if (checking_q) bad_o <= bad_o || |outside;
  end

  // ---- three axes

  wire [2:0] at_last;
  wire [2:0] moves = {at_last[1] && at_last[0], at_last[0], 1'b1};
  assign last_o = &at_last;

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      reg  [START_W-1:0] start_q;
      reg                far_q;     // it is beyond any lattice
      reg  [STEP_W-1:0]  step_q;
      reg                wide_q;    // the same of the step
      reg  [COUNT_W-1:0] top_q;     // count - 1
      reg                zero_q;
      reg  [COUNT_W-1:0] left_q;    // in the check its bits pass by, the highest first
      reg  [SUM_W-1:0]   sum_q;

      always @(posedge clk) begin
        if (axis_i[a]) begin
          start_q <= data_i[START_W-1:0];
          far_q   <= data_i[63:START_W] != {(64 - START_W) {1'b0}};
          step_q  <= data_i[64 +: STEP_W];
          wide_q  <= data_i[127:63+STEP_W] != {(65 - STEP_W) {data_i[127]}};
        end
      end

      wire [COUNT_W-1:0] count = a == 2 ? data_i[96 +: COUNT_W] : data_i[32+16*(a%2) +: COUNT_W];
      wire               again = next_i && moves[a] && at_last[a];
      wire               goes  = next_i && moves[a] && !at_last[a];
      always @(posedge clk) begin
        if (header_i) begin
          top_q  <= count - 1'b1;
          zero_q <= count == {COUNT_W{1'b0}};
        end
        if (header_i) left_q <= count - 1'b1;
        else if (doubling) left_q <= {left_q[COUNT_W-2:0], left_q[COUNT_W-1]};
        else if (again) left_q <= top_q;
        else if (goes) left_q <= left_q - 1'b1;
      end
      // left_q is 0, known from a register: it decides what all axes do next. A walk begins clocks
      // after the last bit has passed by.
      reg top_last_q;
      reg last_q;
      always @(posedge clk) begin
        top_last_q <= top_q == {COUNT_W{1'b0}};
        last_q     <= again ? top_last_q : left_q == {{(COUNT_W - 1) {1'b0}}, goes};
      end
      assign at_last[a] = last_q;
      assign zero[a]    = zero_q;
      assign beyond[a]  = far_q || (wide_q && top_q != {COUNT_W{1'b0}});

      // From nothing to the end of the doublings, then to the end, then back.
      wire             starts = first || ending || again;
      wire             steps  = goes || (doubling && left_q[COUNT_W-1]);
      wire [SUM_W-1:0] base   = sum_q & {SUM_W{!first && !again && !(doubling && begins)}};
      wire [SUM_W-1:0] from   = doubling ? {base[SUM_W-2:0], 1'b0} : base;
      wire [SUM_W-1:0] more   = starts ? {3'd0, start_q}
                              : {{(SUM_W - STEP_W) {step_q[STEP_W-1]}}, step_q} & {SUM_W{steps}};
      always @(posedge clk) begin
        if (doubling || starts || goes) sum_q <= from + more;
      end
      assign over[a] = sum_q[SUM_W-1 -: 3] != {3{sum_q[SUM_W-1]}};

      // Where that is.
      wire [AXIS_W-1:0] last     = last_cell_i[AXIS_W*a +: AXIS_W];
      wire [AXIS_W+1:0] whole    = sum_q[SUM_W-2:FRACTION];
      wire [23:0]       fraction = sum_q[FRACTION-1 -: 24];
      wire              above    = whole > {2'd0, last};
      wire              face     = whole == {2'd0, last} + 1'b1 && fraction == 24'd0;
      wire [AXIS_W-1:0] inner    = above ? last : whole[AXIS_W-1:0];
      wire [5:0]        here;
      if (AXIS_W < 6) begin : gen_few
        assign here = {{(6 - AXIS_W) {1'b0}}, inner};
      end else begin : gen_many
        assign here = inner;
      end
      assign outside[a] = sum_q[SUM_W-1] || (above && !face) || (here[5] && !large_i);
      assign cells_o[6*a +: 6]         = here;
      assign coordinates_o[25*a +: 25] = above ? 25'h100_0000 : {1'b0, fraction};
    end
  endgenerate
endmodule

`default_nettype wire
