// number_units: the whole number layer of one format side by side, for its unit test
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module number_units #(
  parameter FORMAT          = 18,
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter CONVERT_LATENCY = 1
) (
  input  wire                              clk,
  input  wire [31:0]                       word_i,
  input  wire [`FFD_EXPONENT_W-1:0]        exponent_i,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]  coordinate_o,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]  coefficient_o,
  output wire [`FFD_POINT_W(FORMAT)-1:0]   point_o,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  a_i,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  b_i,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]  c_i,
  input  wire [`FFD_POINT_W(FORMAT)-1:0]   factor_i,
  input  wire [1:0]                        shift_i,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]  mul_o,
  output wire [`FFD_SUM_W(FORMAT)-1:0]     term_o,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]  step_o,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]  scale_o,
  input  wire [`FFD_SUM_W(FORMAT)-1:0]     sum_a_i,
  input  wire [`FFD_SUM_W(FORMAT)-1:0]     sum_b_i,
  output wire [`FFD_SUM_W(FORMAT)-1:0]     add_o,
  output wire [`FFD_POINT_W(FORMAT)-1:0]   narrow_o,
  output wire [31:0]                       out_o,
  output wire                              out_saturated_o,
  output wire                              out_nan_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);

  genvar r;
  generate
    for (r = 0; r < 3; r = r + 1) begin : gen_role
      localparam [1:0] ROLE = r;
      wire [`FFD_POINT_W(FORMAT)-1:0] number;
      wire                            nan;
      wire                            outside;
      ffd_num_in #(
        .FORMAT(FORMAT)
      ) u_in (
        .clk       (clk),
        .role_i    (ROLE),
        .clear_i   (1'b0),
        .clamp_i   (1'b0),
        .one_i     (1'b0),
        .word_i    (word_i),
        .exponent_i(exponent_i),
        .number_o  (number),
        .nan_o     (nan),
        .outside_o (outside)
      );
      wire unused_ok = &{1'b0, number, nan, outside};
    end
  endgenerate
  assign coordinate_o  = gen_role[`FFD_ROLE_COORDINATE].number[WEIGHT_W-1:0];
  assign coefficient_o = gen_role[`FFD_ROLE_COEFFICIENT].number[WEIGHT_W-1:0];
  assign point_o       = gen_role[`FFD_ROLE_POINT].number;

  ffd_num_mul #(
    .FORMAT (FORMAT),
    .LATENCY(MUL_LATENCY)
  ) u_mul (
    .clk      (clk),
    .a_i      (a_i),
    .b_i      (b_i),
    .product_o(mul_o)
  );
  ffd_num_term #(
    .FORMAT (FORMAT),
    .LATENCY(MUL_LATENCY)
  ) u_term (
    .clk     (clk),
    .weight_i(a_i),
    .point_i (factor_i),
    .term_o  (term_o)
  );
  ffd_num_step #(
    .FORMAT     (FORMAT),
    .MUL_LATENCY(MUL_LATENCY),
    .ADD_LATENCY(ADD_LATENCY)
  ) u_step (
    .clk          (clk),
    .coefficient_i(c_i),
    .coordinate_i (a_i),
    .weight_i     (b_i),
    .weight_o     (step_o)
  );
  ffd_num_scale #(
    .FORMAT (FORMAT),
    .LATENCY(CONVERT_LATENCY)
  ) u_scale (
    .clk     (clk),
    .weight_i(a_i),
    .shift_i (shift_i),
    .weight_o(scale_o)
  );
  ffd_num_add #(
    .FORMAT (FORMAT),
    .LATENCY(ADD_LATENCY)
  ) u_add (
    .clk  (clk),
    .a_i  (sum_a_i),
    .b_i  (sum_b_i),
    .sum_o(add_o)
  );
  ffd_num_narrow #(
    .FORMAT (FORMAT),
    .LATENCY(CONVERT_LATENCY)
  ) u_narrow (
    .clk    (clk),
    .sum_i  (sum_a_i),
    .point_o(narrow_o)
  );
  ffd_num_out #(
    .FORMAT (FORMAT),
    .LATENCY(CONVERT_LATENCY)
  ) u_out (
    .clk        (clk),
    .sum_i      (sum_a_i),
    .exponent_i (exponent_i),
    .word_o     (out_o),
    .saturated_o(out_saturated_o),
    .nan_o      (out_nan_o)
  );
endmodule

`default_nettype wire
