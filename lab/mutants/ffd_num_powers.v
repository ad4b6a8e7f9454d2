// domain: ffd_num_powers with the coordinates that come to it, from 0 to 1
// SPDX-License-Identifier: Apache-2.0
module domain (
  input  wire        clk,
  input  wire [8:0]  coordinate_i,
  input  wire        derivative_i,
  output wire [35:0] weights_o
);
  wire [7:0] inside = coordinate_i[7:0] > 8'd64 ? 8'd64 : coordinate_i[7:0];
  ffd_num_powers u_inside (
    .clk         (clk),
    .coordinate_i({coordinate_i[8], inside}),
    .derivative_i(derivative_i),
    .weights_o   (weights_o)
  );
endmodule
