// ffd_fx_sixth: eighth_o / 8 = value_i / 6, by shifts and additions
//
// 1/6 = 1/8 (1 + 1/4) (1 + 1/16) (1 + 1/256) ..., a step for each factor, as long as it shifts by
// less than a word. eighth_o is value_i times these factors: a sixth with three bits more behind.
//
// Formats:    unsigned words of W bits; value_i at most 2^(W-1), so that 4/3 of it fits.
// Rounding:   each step cuts what it shifts: eighth_o is too small by less than a unit a step, and
//             by what the factors left out would have added, less than 3.
// Pipeline:   LATENCY registers, spread over the steps; II 1, never frozen.
// Parameters: W 4 to 64, LATENCY >= 0.
// Model:      golden/include/hwffd/model/org_powers.hpp.  Test: tests/unit/powers.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_fx_sixth #(
  parameter W       = 19,
  parameter LATENCY = 1
) (
  input  wire         clk,
  input  wire [W-1:0] value_i,
  output wire [W-1:0] eighth_o
);
  localparam STEPS = $clog2(W - 1);  // shifts 2, 4, 8 ... below W - 1

  generate
    if (W < 4 || W > 64) begin : gen_bad_width
      ERROR_ffd_fx_sixth_width_must_be_4_to_64 u_error ();
    end
  endgenerate

  genvar k;
  generate
    for (k = 0; k < STEPS - 1; k = k + 1) begin : gen_step
      wire [W-1:0] part;
      wire [W-1:0] more;
      wire [W-1:0] held;

      if (k == 0) begin : gen_first
        assign part = value_i;
      end else begin : gen_next
        assign part = gen_step[k-1].held;
      end

      assign more = part + (part >> (2 << k));

      ffd_num_delay #(
        .WIDTH  (W),
        .LATENCY(`FFD_FP_REGISTERS(LATENCY, STEPS - 1, k))
      ) u_step (
        .clk(clk),
        .rst(1'b0),
        .d_i(more),
        .q_o(held)
      );
    end
  endgenerate

  generate
    if (STEPS > 1) begin : gen_last
      assign eighth_o = gen_step[STEPS-2].held;
    end else begin : gen_refused
      assign eighth_o = value_i;
    end
  endgenerate
endmodule

`default_nettype wire
