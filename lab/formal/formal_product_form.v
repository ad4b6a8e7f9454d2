// formal_product_form: an organization in product form takes each point once, with its own weight
//
// Weights, points and sums are tokens (tokens.v): they say of what they are made. Vertices come
// whenever they can, each with any cell and a colour, which its coordinates, places and source bear;
// since colours are free, what belongs to two vertices differs in colour in some run. A result is
// right if it is the sum of a row of 64 banks from the first to the last, each point with the
// product of the three weights of its bank, all of one vertex, in one component.
//
// Behind a combination generator weights are those of their step: formal_cg_weights proves that.
// Abstractions: arithmetic is cut away; tokens are as wide as numbers of 8 bits.
// Stand-ins: tokens.v model_generator.v
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module formal_product_form #(
  parameter CG              = 0,  // evaluators of a combination generator; 0: a tree
  parameter N               = 1,
  parameter SERIAL          = 0,
  parameter SCHEDULE        = 0,
  parameter EVALUATOR       = 0,
  parameter MUL_LATENCY     = 1,
  parameter ADD_LATENCY     = 1,
  parameter CONVERT_LATENCY = 0,
  parameter READ_LATENCY    = 2,
  parameter COMPONENT       = 0
) (
  input wire             clk,
  input wire             rst,
  input wire             want_vertex,
  input wire             colour,
  input wire [11:0]      cell_index,
  input wire [N*3*9-1:0] other
);
  localparam FORMAT   = 8;
  localparam PORTS    = 1;
  localparam FMA_LATENCY = 0;
  localparam SOURCE_W = 1;
  localparam SPANS    = 1;

  wire              ready;
  wire [26:0]       coordinates;
  wire              read;
  wire              read_last;
  wire              read_source;
  wire [11:0]       read_cell;
  wire [5:0]        read_index;
  wire [N*3*9-1:0]  points;
  wire [N*3*9-1:0]  points_later;
  wire              result;
  wire [68:0]       sum;
  wire [206:0]      jacobian;

  genvar a;
  genvar e;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      localparam [1:0] AXIS = a;
      assign coordinates[9*a +: 9] = {4'd0, cell_index[4*a +: 2], AXIS, colour};
    end
    for (e = 0; e < 3 * N; e = e + 1) begin : gen_point
      localparam [5:0] UNIT = e / 3;
      tokens u_point (
        .read_i       (read),
        .bank_i       (read_index + UNIT),
        .source_i     (read_source),
        .cell_colour_i(read_cell[2]),
        .picked_i     (e % 3 == COMPONENT),
        .other_i      (other[9*e +: 9]),
        .point_o      (points[9*e +: 9])
      );
    end
  endgenerate

  ffd_num_delay #(
    .WIDTH  (N * 3 * 9),
    .LATENCY(READ_LATENCY)
  ) u_points (
    .clk(clk),
    .rst(1'b0),
    .d_i(points),
    .q_o(points_later)
  );

`define FORMAL_PARAMETERS \
    .FORMAT         (FORMAT), \
    .N              (N), \
    .PORTS          (PORTS), \
    .SCHEDULE       (SCHEDULE), \
    .EVALUATOR      (EVALUATOR), \
    .MUL_LATENCY    (MUL_LATENCY), \
    .ADD_LATENCY    (ADD_LATENCY), \
    .FMA_LATENCY    (FMA_LATENCY), \
    .CONVERT_LATENCY(CONVERT_LATENCY), \
    .READ_LATENCY   (READ_LATENCY), \
    .SOURCE_W       (SOURCE_W), \
    .SPANS          (SPANS)

`define FORMAL_PORTS \
    .clk                 (clk), \
    .rst                 (rst), \
    .load_i              (1'b0), \
    .load_axis_i         (2'd0), \
    .load_address_i      (4'd0), \
    .load_entry_i        (38'd0), \
    .s_vertex_valid      (want_vertex), \
    .s_vertex_ready      (ready), \
    .s_vertex_coordinates(coordinates), \
    .s_vertex_cell       (cell_index), \
    .s_vertex_source     (colour), \
    .s_vertex_bank       ({6{colour}}), \
    .s_vertex_changed    (1'b0), \
    .s_vertex_second     (coordinates[8:0]), \
    .read_o              (read), \
    .read_last_o         (read_last), \
    .read_source_o       (read_source), \
    .read_cell_o         (read_cell), \
    .read_index_o        (read_index), \
    .read_points_i       (points_later), \
    .result_valid_o      (result), \
    .result_sum_o        (sum), \
    .result_jacobian_o   (jacobian), \
    .result_second_o     ()

  generate
    if (CG != 0) begin : gen_cg
      ffd_org_cg #(
        .SIZE           (CG),
        `FORMAL_PARAMETERS
      ) u_org (
        `FORMAL_PORTS
      );
    end else begin : gen_tree
      ffd_org_tree #(
        .SERIAL         (SERIAL),
        `FORMAL_PARAMETERS
      ) u_org (
        `FORMAL_PORTS
      );
    end
  endgenerate

  reg first_q = 1'b1;
  always @(posedge clk) first_q <= 1'b0;

  wire [22:0] own = sum[23*COMPONENT +: 23];

  wire whole = own[22:14] == 9'd1 && own[12:0] == {7'd64, 6'd0};

  always @* begin
    if (first_q) assume (rst);
    assume (cell_index[2] == colour);
  end

  // One claim, by the names that the table of properties has for its rows.
  localparam TREE = CG == 0;
  localparam PAPER = SCHEDULE == `FFD_SCHEDULE_PAPER;
  always @* if (!first_q && !rst && result) begin
    if (TREE && N == 1 && SERIAL == 1) basic: assert (whole);
    if (TREE && N == 1 && SERIAL == 0) tree1: assert (whole);
    if (TREE && N == 2) tree2: assert (whole);
    if (TREE && N == 4) tree4: assert (whole);
    if (TREE && N == 8) tree8: assert (whole);
    if (TREE && N == 16 && !PAPER) tree16: assert (whole);
    if (TREE && N == 16 && PAPER) tree16_paper: assert (whole);
    if (TREE && N == 32 && !PAPER) tree32: assert (whole);
    if (TREE && N == 32 && PAPER) tree32_paper: assert (whole);
    if (TREE && N == 64 && !PAPER) parallel: assert (whole);
    if (TREE && N == 64 && PAPER) parallel_paper: assert (whole);
    if (CG == 1) cg1: assert (whole);
    if (CG == 3) cg3: assert (whole);
  end
endmodule

`default_nettype wire
