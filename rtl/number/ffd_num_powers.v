// ffd_num_powers: the four weights of the uniform cubic B-spline, or of its derivative, from s^2
//                 and s^3
//
// Two multiplications in place of the twelve of four polynomials, and one sixth by shifts:
//
//   w_0 = (1 - 3s + 3s^2 - s^3)/6   w_2 = (1 - 3s^3)/6 + (s + s^2)/2   w_3 = s^3/6
//
// and w_1 is what these leave of 1, so that weights sum to one exactly. Rounded, they are A,
// 1 - 2A, A, 0 at s = 0, A being 1/6 rounded. At s = 1 they must be 0, A, 1 - 2A, A, which makes
// seams watertight; they are, but for w_2: 2/3 rounded is a unit off 1 - 2A, so there it is put
// right.
// The derivative's are halved (docs/numerics.md section 9):
//
//   -(1 - s)^2/4   1/4 + s/2 - 3s^2/4   s^2/4        and B_1' what these leave of 0.
//
// Formats:    fxW only: coordinate and weights Q2.(W-2), the coordinate's flag in each of them.
//             docs/numerics.md section 5 says where it rounds: s^2 for the second multiplication
//             and each weight, half up; s^2 and s^3 are cut GUARD bits behind a unit.
// Error:      1.75 units of a weight, 1.6 of a derivative's.
// Overflow:   none: all is within [-1, 1] where the coordinate is in [0, 1].
// Pipeline:   s^2: MUL_LATENCY + ADD_LATENCY | s^3: the same | s^3/6: MUL_LATENCY, the sums
//             ADD_LATENCY. II 1, never frozen.
// Parameters: FORMAT 8 to 32, latencies >= 1.
// Not checked: that the coordinate is in [0, 1]; ffd_num_in sees to that.
// Model:      golden/include/hwffd/model/org_powers.hpp.  Test: tests/unit/powers.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_powers #(
  parameter FORMAT      = 17,
  parameter MUL_LATENCY = 1,
  parameter ADD_LATENCY = 1
) (
  input  wire                                clk,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]    coordinate_i,
  input  wire                                derivative_i,
  output wire [4*`FFD_WEIGHT_W(FORMAT)-1:0]  weights_o
);
  localparam W        = `FFD_OFFSET_BAD(FORMAT) ? 8 : `FFD_FIXED_W(FORMAT);
  localparam FRACTION = W - 2;
  localparam GUARD    = 3;
  localparam CUT      = FRACTION - GUARD;      // bits of a product that are cut
  localparam POWER_W  = FRACTION + GUARD + 1;  // of a power, 0 to 1
  localparam LANE_W   = W + GUARD + 3;         // Q2.(FRACTION + GUARD + 3)

  generate
    if (`FFD_OFFSET_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_powers_needs_fixed_point u_error ();
    end
    if (MUL_LATENCY < 1 || ADD_LATENCY < 1) begin : gen_bad_latency
      ERROR_ffd_num_powers_latencies_must_be_at_least_1 u_error ();
    end
  endgenerate

  // ---- s^2, and rounded for the second multiplication; 0 there where a derivative has no cube

  wire [2*W-1:0]     square;
  wire [1:0]         marks_1;  // {flag, derivative}
  wire [W-1:0]       factor;
  wire               factor_saturated;
  wire [W-1:0]       s_2;
  wire [W-1:0]       factor_2;
  wire [POWER_W-1:0] square_2;
  wire [1:0]         marks_2;

  ffd_fx_product #(
    .W      (W),
    .FLAGS_W(2),
    .LATENCY(MUL_LATENCY)
  ) u_square (
    .clk      (clk),
    .a_i      (coordinate_i[W-1:0]),
    .b_i      (coordinate_i[W-1:0]),
    .flags_i  ({coordinate_i[W], derivative_i}),
    .product_o(square),
    .flags_o  (marks_1)
  );

  ffd_fx_round #(
    .IN_W (2 * W),
    .DROP (FRACTION),
    .OUT_W(W)
  ) u_factor (
    .value_i    (square),
    .addend_i   ({W{1'b0}}),
    .value_o    (factor),
    .saturated_o(factor_saturated)
  );

  ffd_num_delay #(
    .WIDTH  (W),
    .LATENCY(`FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, 0))
  ) u_s_2 (
    .clk(clk),
    .rst(1'b0),
    .d_i(coordinate_i[W-1:0]),
    .q_o(s_2)
  );

  ffd_num_delay #(
    .WIDTH  (2 + POWER_W + W),
    .LATENCY(ADD_LATENCY)
  ) u_square_2 (
    .clk(clk),
    .rst(1'b0),
    .d_i({marks_1, square[CUT +: POWER_W], factor & {W{!marks_1[0]}}}),
    .q_o({marks_2, square_2, factor_2})
  );

  // ---- s^3

  wire [2*W-1:0]     cube;
  wire [1:0]         marks_cube;
  wire [W-1:0]       s_3;
  wire [POWER_W-1:0] square_3;
  wire [POWER_W-1:0] cube_3;
  wire [1:0]         marks_3;

  ffd_fx_product #(
    .W      (W),
    .FLAGS_W(2),
    .LATENCY(MUL_LATENCY)
  ) u_cube (
    .clk      (clk),
    .a_i      (s_2),
    .b_i      (factor_2),
    .flags_i  (marks_2),
    .product_o(cube),
    .flags_o  (marks_cube)
  );

  ffd_num_delay #(
    .WIDTH  (W + POWER_W),
    .LATENCY(`FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, 0))
  ) u_square_3 (
    .clk(clk),
    .rst(1'b0),
    .d_i({s_2, square_2}),
    .q_o({s_3, square_3})
  );

  ffd_num_delay #(
    .WIDTH  (2 + POWER_W),
    .LATENCY(ADD_LATENCY)
  ) u_cube_3 (
    .clk(clk),
    .rst(1'b0),
    .d_i({marks_cube, cube[CUT +: POWER_W]}),
    .q_o({marks_3, cube_3})
  );

  // ---- s^3/6, and beside it what else is in w_0, w_2 and w_3, in its units of
  // 2^-(FRACTION + GUARD + 3): of s and of powers, 8 of these

  localparam [63:0]       WHOLE   = 64'd1 << (FRACTION + GUARD + 3);
  localparam [63:0]       PART    = WHOLE / 64'd6;
  localparam [LANE_W-1:0] SIXTH   = PART[LANE_W-1:0];
  localparam [LANE_W-1:0] QUARTER = WHOLE[LANE_W+1:2];
  localparam [LANE_W-1:0] CARRY   = 1;
  localparam [LANE_W-1:0] NONE    = 0;

  wire              derivative = marks_3[0];
  wire [LANE_W-1:0] s_cut      = {4'd0, s_3[FRACTION:0], {GUARD{1'b0}}};
  wire [LANE_W-1:0] square_cut = {4'd0, square_3};
  wire [LANE_W-1:0] cube_cut   = {4'd0, cube_3};

  // 1/6 + (s^2 - s)/2, or -1/4 + s/2 - s^2/4.
  wire [LANE_W-1:0] more_0     = derivative ? s_cut << 2 : square_cut << 2;
  wire [LANE_W-1:0] less_0     = derivative ? square_cut << 1 : s_cut << 2;
  wire [LANE_W-1:0] lane_0     = (derivative ? NONE - QUARTER : SIXTH) + more_0 - less_0;

  // 1/6 + (s + s^2 - s^3)/2, or 1/4 + s/2 - s^2/2 - s^2/4, where - x is ~x + 1.
  wire [LANE_W-1:0] more_2     = (square_cut << 2) ^ {LANE_W{derivative}};
  wire [LANE_W-1:0] less_2     = derivative ? square_cut << 1 : cube_cut << 2;
  wire [LANE_W-1:0] start_2    = (derivative ? QUARTER + CARRY : SIXTH) + (s_cut << 2);
  wire [LANE_W-1:0] lane_2     = start_2 + more_2 - less_2;

  // s^2/4, or nothing: s^3/6 comes there.
  wire [LANE_W-1:0] lane_3     = derivative ? square_cut << 1 : NONE;

  wire [POWER_W-1:0] sixth;
  wire [LANE_W-1:0]  part_0;
  wire [LANE_W-1:0]  part_2;
  wire [LANE_W-1:0]  part_3;
  wire               flag;
  wire               slope;
  wire               at_end;

  ffd_fx_sixth #(
    .W      (POWER_W),
    .LATENCY(MUL_LATENCY)
  ) u_sixth (
    .clk     (clk),
    .value_i (cube_3),
    .eighth_o(sixth)
  );

  ffd_num_delay #(
    .WIDTH  (3 + 3 * LANE_W),
    .LATENCY(MUL_LATENCY)
  ) u_lanes (
    .clk(clk),
    .rst(1'b0),
    .d_i({marks_3, s_3[FRACTION] && !derivative, lane_0, lane_2, lane_3}),
    .q_o({flag, slope, at_end, part_0, part_2, part_3})
  );

  // ---- each weight rounded once, and the rest

  localparam         A     = ((1 << FRACTION) + 3) / 6;
  localparam         ABOVE = 3 * A > (1 << (FRACTION - 1));  // 1/6, so that 2/3 is above 1 - 2A
  localparam [W-1:0] ONE   = 1 << FRACTION;
  localparam [W-1:0] UNIT  = 1;
  localparam [W-1:0] ZERO  = 0;
  localparam [W-1:0] RIGHT = ABOVE ? ZERO - UNIT : UNIT;

  wire [LANE_W-1:0]   cube_part = {4'd0, sixth};
  wire [3*LANE_W-1:0] totals    = {part_3 | cube_part, part_2, part_0 - cube_part};
  wire [3*W-1:0]      ends      = {ZERO, at_end ? RIGHT : ZERO, ZERO};
  wire [3*W-1:0]      rounded;
  wire [2:0]          saturated;
  wire [3*W-1:0]      weights;
  wire [1:0]          marks;

  genvar i;
  generate
    for (i = 0; i < 3; i = i + 1) begin : gen_weight
      ffd_fx_round #(
        .IN_W (LANE_W),
        .DROP (GUARD + 3),
        .OUT_W(W)
      ) u_weight (
        .value_i    (totals[i*LANE_W +: LANE_W]),
        .addend_i   (ends[i*W +: W]),
        .value_o    (rounded[i*W +: W]),
        .saturated_o(saturated[i])
      );
    end
  endgenerate

  ffd_num_delay #(
    .WIDTH  (2 + 3 * W),
    .LATENCY(ADD_LATENCY)
  ) u_weights (
    .clk(clk),
    .rst(1'b0),
    .d_i({flag, slope, rounded}),
    .q_o({marks, weights})
  );

  wire [W-1:0] w_0 = weights[0*W +: W];
  wire [W-1:0] w_2 = weights[1*W +: W];
  wire [W-1:0] w_3 = weights[2*W +: W];
  wire [W-1:0] w_1 = (marks[0] ? ZERO : ONE) - w_0 - (w_2 + w_3);

  assign weights_o = {marks[1], w_3, marks[1], w_2, marks[1], w_1, marks[1], w_0};

  wire unused_ok = &{1'b0, factor_saturated, square[CUT-1:0], square[2*W-1:CUT+POWER_W],
                     cube[CUT-1:0], cube[2*W-1:CUT+POWER_W], s_3[W-1], saturated};
endmodule

`default_nettype wire
