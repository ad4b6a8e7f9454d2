// ffd_num_begin: point -> sum, with half a unit of a point where that is narrowed later
//
// A sum that begins with the half is rounded by dropping bits: ffd_num_cut.
//
// Formats:    fxW only: Q1.(W-1) -> Q9.(2W-3), exact.
// Pipeline:   combinational.
// Parameters: FORMAT 8 to 32.
// Model:      none: org_affine.hpp rounds behind the sum.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_begin #(
  parameter FORMAT = 17
) (
  input  wire [`FFD_POINT_W(FORMAT)-1:0]  point_i,
  input  wire                             half_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]    sum_o
);
  localparam W     = `FFD_FIXED_W(FORMAT);
  localparam SUM_W = `FFD_SUM_W(FORMAT);

  generate
    if (`FFD_OFFSET_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_begin_needs_fixed_point u_error ();
    end
  endgenerate

  wire [SUM_W-1:0] wide;

  ffd_num_widen #(
    .FORMAT(FORMAT)
  ) u_widen (
    .point_i(point_i),
    .sum_o  (wide)
  );

  assign sum_o = {wide[SUM_W-1:W-2], half_i, {(W - 3) {1'b0}}};
  wire unused_ok = &{1'b0, wide[W-3:0]};
endmodule

`default_nettype wire
