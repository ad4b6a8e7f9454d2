// ffd_scatter_expand: one part into those of the four banks of an axis
//
//   c_b = round(C_b v), b = 0, 1, 2    c_3 = v, or 0    v_0 = c_0    v_b = c_b - c_(b-1)
//
// Three multiplications for four parts, whose sum is c_3 to the bit, whatever was rounded.
//
// Formats:    weights Q2.(W-2), parts Q2.(W-1), or with WIDE 1 of 35 bits in the same units.
//             Rounding, saturation: those of ffd_num_share or ffd_num_wide_share, and ffd_num_less;
//             saturated_o says of any of them, with parts_o. Flags of weights are not looked at.
// Pipeline:   part, weights | FFD_SCATTER_SHARE_LATENCY: c_b | FFD_SCATTER_LESS_LATENCY: parts. II
//             1, never frozen.
// Bad input:  none: every part and weight has a result.
// Parameters: FORMAT 12 to 18, WIDE 0 or 1, latencies >= 1.
// Model:      golden/include/hwffd/model/scatter.hpp (expanded).  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_scatter.vh"

module ffd_scatter_expand #(
  parameter WIDE        = 0,
  parameter FORMAT      = 17,
  parameter MUL_LATENCY = 4,
  parameter ADD_LATENCY = 1,
  parameter PART_W      = WIDE == 0 ? `FFD_PART_W(FORMAT) : `FFD_WIDE_W
) (
  input  wire                               clk,
  input  wire [3*`FFD_WEIGHT_W(FORMAT)-1:0] weights_i,  // {C_2, C_1, C_0}
  input  wire                               whole_i,    // c_3 is the part, else 0
  input  wire [PART_W-1:0]                  part_i,
  output wire [4*PART_W-1:0]                parts_o,    // that of bank 0 lowest
  output wire                               saturated_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam SHARE    = `FFD_SCATTER_SHARE_LATENCY(WIDE, MUL_LATENCY, ADD_LATENCY);
  localparam LESS     = `FFD_SCATTER_LESS_LATENCY(WIDE, ADD_LATENCY);
  `FFD_TAKES(`FFD_SCATTER_EXPAND_LATENCY(WIDE, MUL_LATENCY, ADD_LATENCY))

  wire [4*PART_W-1:0] shares;  // c_b
  wire [3:0]          flags;
  wire [3:0]          saturated;

  ffd_num_delay #(
    .WIDTH  (PART_W),
    .LATENCY(SHARE)
  ) u_whole (
    .clk(clk),
    .rst(1'b0),
    .d_i(whole_i ? part_i : {PART_W{1'b0}}),
    .q_o(shares[3*PART_W +: PART_W])
  );
  assign flags[3] = 1'b0;

  genvar b;
  generate
    for (b = 0; b < 3; b = b + 1) begin : gen_share
      if (WIDE == 0) begin : gen_narrow
        ffd_num_share #(
          .FORMAT     (FORMAT),
          .MUL_LATENCY(MUL_LATENCY),
          .ADD_LATENCY(ADD_LATENCY)
        ) u_share (
          .clk        (clk),
          .weight_i   (weights_i[b*WEIGHT_W +: WEIGHT_W]),
          .part_i     (part_i),
          .share_o    (shares[b*PART_W +: PART_W]),
          .saturated_o(flags[b])
        );
      end else begin : gen_wide
        ffd_num_wide_share #(
          .FORMAT     (FORMAT),
          .MUL_LATENCY(MUL_LATENCY),
          .ADD_LATENCY(ADD_LATENCY)
        ) u_share (
          .clk        (clk),
          .weight_i   (weights_i[b*WEIGHT_W +: WEIGHT_W]),
          .part_i     (part_i),
          .share_o    (shares[b*PART_W +: PART_W]),
          .saturated_o(flags[b])
        );
        `FFD_ASSERT_TAKES(u_share, SHARE)
      end
    end

    for (b = 0; b < 4; b = b + 1) begin : gen_part
      if (b == 0) begin : gen_first
        ffd_num_delay #(
          .WIDTH  (1 + PART_W),
          .LATENCY(LESS)
        ) u_part (
          .clk(clk),
          .rst(1'b0),
          .d_i({flags[0], shares[0 +: PART_W]}),
          .q_o({saturated[0], parts_o[0 +: PART_W]})
        );
      end else begin : gen_next
        ffd_num_less #(
          .FORMAT (FORMAT),
          .LATENCY(LESS),
          .PART_W (PART_W)
        ) u_part (
          .clk        (clk),
          .a_i        (shares[b*PART_W +: PART_W]),
          .b_i        (shares[(b-1)*PART_W +: PART_W]),
          .saturated_i(flags[b]),
          .part_o     (parts_o[b*PART_W +: PART_W]),
          .saturated_o(saturated[b])
        );
      end
    end
  endgenerate

  assign saturated_o = |saturated;
endmodule

`default_nettype wire
