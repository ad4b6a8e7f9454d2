// ffd_bench_evaluator: an evaluator whose control points come from a memory of whole supports
//
// For benches only: measures organizations at their read port, where the interleaved stream is too
// slow for them. Coefficients, supports and vertices come as stream words; a support is written
// point by point in local order and read back by bank, N points a clock and port, READ_LATENCY 2.
//
// Formats:    results of a vertex side by side, the position lowest; those that the organization
//             does not give in one pass are 0. The result of a second vertex stands in the second
//             place.
// Parameters: a row of configurations.csv; 256 supports.
// Model:      golden/include/hwffd/model/evaluator.hpp.  Test: tests/evaluator.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_bench_evaluator #(
  parameter ORG             = 0,
  parameter N               = 1,
  parameter FORMAT          = 18,
  parameter SCHEDULE        = `FFD_SCHEDULE_OVERLAPPED,
  parameter EVALUATOR       = `FFD_EVALUATOR_PIPELINED,
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 1
) (
  input  wire         clk,
  input  wire         rst,
  input  wire         load_i,
  input  wire [1:0]   load_axis_i,
  input  wire [3:0]   load_address_i,
  input  wire [1:0]   load_shift_i,
  input  wire [127:0] load_words_i,
  input  wire         write_i,
  input  wire [7:0]   write_support_i,
  input  wire [5:0]   write_index_i,
  input  wire [95:0]  write_words_i,
  input  wire [9:0]   write_exponent_i,
  input  wire         s_vertex_valid,
  output wire         s_vertex_ready,
  input  wire [95:0]  s_vertex_words,
  input  wire [31:0]  s_vertex_second,  // s of a second vertex
  input  wire [11:0]  s_vertex_cell,
  input  wire [7:0]   s_vertex_support,
  input  wire [5:0]   s_vertex_bank,
  input  wire         s_vertex_changed,
  input  wire [9:0]   s_vertex_exponent,
  input  wire [15:0]  s_vertex_tag,
  output wire         m_result_valid,
  input  wire         m_result_ready,
  output wire [383:0] m_result_words,
  output wire [7:0]   m_result_flags,  // {nan, saturated} of each
  output wire [15:0]  m_result_tag,
  output wire         evaluating_o         // vertices are inside, or were a clock ago
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam PORTS    = `FFD_ORG_PORTS(ORG);

  wire [`FFD_ENTRY_W(WEIGHT_W)-1:0] entry;
  wire [3*POINT_W-1:0]              point;
  wire [3*WEIGHT_W-1:0]             coordinates;

  // The words that come, and their roles: coordinates, points, coefficients from the lowest on, and
  // the second coordinate.
  wire [11*32-1:0]      words = {s_vertex_second, load_words_i, write_words_i, s_vertex_words};
  wire [11*POINT_W-1:0] numbers;

  genvar i;
  generate
    for (i = 0; i < 11; i = i + 1) begin : gen_number
      wire nan;
      wire outside;
      ffd_num_in #(
        .FORMAT(FORMAT)
      ) u_in (
        .clk       (clk),
        .role_i    (i < 3 || i == 10 ? `FFD_ROLE_COORDINATE : i < 6 ? `FFD_ROLE_POINT : `FFD_ROLE_COEFFICIENT),
        .clear_i   (1'b0),
        .clamp_i   (1'b0),
        .one_i     (1'b0),
        .word_i    (words[32*i +: 32]),
        .exponent_i(write_exponent_i),
        .number_o  (numbers[i*POINT_W +: POINT_W]),
        .nan_o     (nan),
        .outside_o (outside)
      );
      wire unused_ok = &{1'b0, nan, outside};
    end
    for (i = 0; i < 3; i = i + 1) begin : gen_coordinate
      assign coordinates[i*WEIGHT_W +: WEIGHT_W] = numbers[i*POINT_W +: WEIGHT_W];
    end
    for (i = 0; i < 4; i = i + 1) begin : gen_coefficient
      assign entry[i*WEIGHT_W +: WEIGHT_W] = numbers[(6+i)*POINT_W +: WEIGHT_W];
    end
  endgenerate
  assign point = numbers[3*POINT_W +: 3*POINT_W];
  assign entry[4*WEIGHT_W +: 2] = load_shift_i;

  // The source is the support mixed with all bits of the cell, so that one that comes back wrong reads
  // elsewhere.
  function [7:0] mixed;
    input [11:0] cell_i;
    mixed = cell_i[7:0] ^ {cell_i[11:8], 4'd0};
  endfunction

  // Supports by local index; read by bank of a cell, one lookup a point.
  reg [3*POINT_W-1:0] support_q [0:256*64-1];
  always @(posedge clk) begin
    if (write_i) support_q[{write_support_i, write_index_i}] <= point;
  end

  localparam RESULTS = `FFD_RESULTS(`FFD_ORG_JACOBIAN(ORG));
  localparam PAIRS   = `FFD_ORG_PAIRS(ORG) ? 1 : 0;
  wire [RESULTS*96-1:0] result_words;
  wire [RESULTS*3-1:0]  result_flags;
  wire [97:0]           result_second;
  wire [15:0] result_tag;
  wire        determinant;
  wire        result_two;
  wire        result_last;
  wire [PORTS-1:0]    read;
  wire [PORTS-1:0]    read_last;
  wire [PORTS*8-1:0]  read_source;
  wire [PORTS*12-1:0] read_cell;
  wire [PORTS*6-1:0]  read_index;
  reg  [PORTS*N*3*POINT_W-1:0] read_q;
  reg  [PORTS*N*3*POINT_W-1:0] points_q;
  always @(posedge clk) points_q <= read_q;

  genvar p;
  generate
    for (p = 0; p < PORTS * N; p = p + 1) begin : gen_point
      localparam PORT   = p / N;
      localparam OFFSET = p % N;
      wire [5:0] bank = read_index[6*PORT +: 6] + OFFSET[5:0];
      wire [1:0] l    = bank[5:4] - read_cell[12*PORT +: 2];
      wire [1:0] m    = bank[3:2] - read_cell[12*PORT+4 +: 2];
      wire [1:0] n    = bank[1:0] - read_cell[12*PORT+8 +: 2];
      wire [7:0] support = read_source[8*PORT +: 8] ^ mixed(read_cell[12*PORT +: 12]);
      always @(posedge clk) begin
        read_q[p*3*POINT_W +: 3*POINT_W] <= support_q[{support, l, m, n}];
      end
    end
  endgenerate

  ffd_eval_stream #(
    `include "ffd_row_arguments.vh"
    .READ_LATENCY   (2),
    .SOURCE_W       (8),
    .USER_W         (16),
    .IN_FLIGHT      (256),
    .RESULTS        (RESULTS),
    .DETERMINANT    (0),
    .PAIRS          (PAIRS)
  ) u_evaluator (
    .clk                 (clk),
    .rst                 (rst),
    .load_i              (load_i),
    .load_axis_i         (load_axis_i),
    .load_address_i      (load_address_i),
    .load_entry_i        (entry),
    .s_vertex_valid      (s_vertex_valid),
    .s_vertex_ready      (s_vertex_ready),
    .s_vertex_coordinates(coordinates),
    .s_vertex_cell       (s_vertex_cell),
    .s_vertex_source     (s_vertex_support ^ mixed(s_vertex_cell)),
    .s_vertex_bank       (s_vertex_bank),
    .s_vertex_exponent   (s_vertex_exponent),
    .s_vertex_changed    (s_vertex_changed),
    .s_vertex_second     (numbers[10*POINT_W +: WEIGHT_W]),
    .s_vertex_column     (2'd0),
    .s_vertex_user       (s_vertex_tag),
    .read_o              (read),
    .read_last_o         (read_last),
    .read_source_o       (read_source),
    .read_cell_o         (read_cell),
    .read_index_o        (read_index),
    .read_points_i       (points_q),
    .evaluating_o        (evaluating_o),
    .m_result_valid      (m_result_valid),
    .m_result_ready      (m_result_ready),
    .m_result_words      (result_words),
    .m_result_flags      (result_flags),
    .m_result_determinant(determinant),
    .m_result_two        (result_two),
    .m_result_last       (result_last),
    .m_result_user       (result_tag),
    .m_result_second     (result_second)
  );

  // What goes with a result is 0 where there is none.
  assign m_result_tag = result_tag & {16{m_result_valid}};
  genvar r;
  generate
    for (r = 0; r < 4; r = r + 1) begin : gen_result
      if (r < RESULTS) begin : gen_given
        assign m_result_words[96*r +: 96] = result_words[96*r +: 96] & {96{m_result_valid}};
        assign m_result_flags[2*r +: 2]   = result_flags[3*r +: 2] & {2{m_result_valid}};
      end else if (r == 1 && PAIRS != 0) begin : gen_second
        assign m_result_words[96*r +: 96] = result_second[95:0] & {96{m_result_valid}};
        assign m_result_flags[2*r +: 2]   = result_second[97:96] & {2{m_result_valid}};
      end else begin : gen_not
        assign m_result_words[96*r +: 96] = 96'd0;
        assign m_result_flags[2*r +: 2]   = 2'd0;
      end
    end
  endgenerate

  wire unused_ok = &{1'b0, determinant, result_two, result_last, result_flags, read, read_last, read_cell, numbers,
                     result_second};
endmodule

`default_nettype wire
