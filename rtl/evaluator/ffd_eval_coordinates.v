// ffd_eval_coordinates: the local coordinates of a vertex, stream words to weights
//
// Formats:    {u, t, s} both.
// Pipeline:   combinational.
// Parameters: FORMAT as in ffd_num.vh.
// Model:      golden/include/hwffd/numerics (coordinate).  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_eval_coordinates #(
  parameter FORMAT = 18
) (
  input  wire [95:0]                         words_i,
  output wire [3*`FFD_WEIGHT_W(FORMAT)-1:0]  coordinates_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      ffd_num_in #(
        .FORMAT(FORMAT),
        .ROLE  (`FFD_ROLE_COORDINATE)
      ) u_in (
        .word_i    (words_i[32*a +: 32]),
        .exponent_i({`FFD_EXPONENT_W{1'b0}}),
        .number_o  (coordinates_o[a*WEIGHT_W +: WEIGHT_W])
      );
    end
  endgenerate
endmodule

`default_nettype wire
