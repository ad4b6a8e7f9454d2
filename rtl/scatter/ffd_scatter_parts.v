// ffd_scatter_parts: a component of a gradient into the parts of 64 banks, 1 -> 4 -> 16 -> 64
//
// Along s, then t, then u: 21 expansions, 63 multiplications. All three components of a vertex go
// the same way, one after the other. With ROWS 1 it is a component of a layer's sum, into the parts
// of 16 banks, along t and u: 5 expansions, 15 wide multiplications.
//
// Formats:    gradient, parts Q2.(W-1); with ROWS of 35 bits in the same units. Rounding,
//             saturation: those of ffd_scatter_expand. saturated_o comes with the parts, and says
//             that something in front of the expansions (saturated_i) or any of them did.
// Pipeline:   gradient, weights of s | FFD_SCATTER_EXPAND_LATENCY: weights of t | the same: weights
//             of u | the same: parts. With ROWS from t on. II 1, never frozen.
// Bad input:  none.
// Parameters: ROWS 0 or 1, FORMAT 12 to 18, latencies >= 1.
// Model:      golden/include/hwffd/model/scatter.hpp (scattered).  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_scatter.vh"

module ffd_scatter_parts #(
  parameter ROWS        = 0,
  parameter FORMAT      = 17,
  parameter MUL_LATENCY = 4,
  parameter ADD_LATENCY = 1,
  parameter AXES        = `FFD_SCATTER_AXES(ROWS),
  parameter PART_W      = ROWS == 0 ? `FFD_PART_W(FORMAT) : `FFD_WIDE_W
) (
  input  wire                                    clk,
  input  wire [3*AXES*`FFD_WEIGHT_W(FORMAT)-1:0] weights_i,   // cumulative {u, t, s} or {u, t}
  input  wire [AXES-1:0]                         whole_i,
  input  wire [PART_W-1:0]                       gradient_i,
  input  wire                                    saturated_i,
  output wire [(1<<(2*AXES))*PART_W-1:0]         parts_o,     // bank {s, t, u}, u fastest
  output wire                                    saturated_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam EXPAND   = `FFD_SCATTER_EXPAND_LATENCY(ROWS, MUL_LATENCY, ADD_LATENCY);
  `FFD_TAKES(AXES * EXPAND)

  genvar axis;
  genvar i;
  generate
    for (axis = 0; axis < AXES; axis = axis + 1) begin : gen_axis
      localparam PARTS = 1 << (2 * axis);
      wire [PARTS*PART_W-1:0]   parts_in;
      wire [4*PARTS*PART_W-1:0] parts;
      wire [PARTS-1:0]          own;
      wire                      saturated_in;
      wire                      earlier;
      wire                      saturated = earlier || (|own);

      if (axis == 0) begin : gen_gradient
        assign parts_in     = gradient_i;
        assign saturated_in = saturated_i;
      end else begin : gen_parts
        assign parts_in     = gen_axis[axis-1].parts;
        assign saturated_in = gen_axis[axis-1].saturated;
      end

      ffd_num_delay #(
        .WIDTH  (1),
        .LATENCY(EXPAND)
      ) u_earlier (
        .clk(clk),
        .rst(1'b0),
        .d_i(saturated_in),
        .q_o(earlier)
      );

      for (i = 0; i < PARTS; i = i + 1) begin : gen_expand
        ffd_scatter_expand #(
          .WIDE       (ROWS),
          .FORMAT     (FORMAT),
          .MUL_LATENCY(MUL_LATENCY),
          .ADD_LATENCY(ADD_LATENCY)
        ) u_expand (
          .clk        (clk),
          .weights_i  (weights_i[3*WEIGHT_W*axis +: 3*WEIGHT_W]),
          .whole_i    (whole_i[axis]),
          .part_i     (parts_in[i*PART_W +: PART_W]),
          .parts_o    (parts[4*i*PART_W +: 4*PART_W]),
          .saturated_o(own[i])
        );
        `FFD_ASSERT_TAKES(u_expand, EXPAND)
      end
    end
  endgenerate

  assign parts_o     = gen_axis[AXES-1].parts;
  assign saturated_o = gen_axis[AXES-1].saturated;
endmodule

`default_nettype wire
