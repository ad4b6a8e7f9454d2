// ffd_org_factored: q by contracting one axis at a time, 64 -> 16 -> 4 -> 1 (beyond the paper)
//
// The 64 points of a cell are read at once, one from each bank, and the four weights of each axis
// are rotated into the order of the banks: 12 polynomials and 84 multiplications a component, and
// a vertex a clock from any cell. Folded by two or four, 32 or 16 banks a clock on a part of it,
// the fold in the memory; by three, one component a clock on a third of it; by six, both. What is
// folded by three reads points in one of three clocks, so that up to three such lanes share one
// store of points; lanes folded by four read in every clock, each from a store of its own, at a
// port of its own. Vertices are dealt to the lanes in turn; all take equally long, so results keep
// the order.
//
// With the Jacobian a pass gives q and its three derivatives, which share most of their sums: 192
// multiplications a component, and weights of functions and of derivatives. Bits are those of four
// passes without. Derivatives along two axes at once are not built.
//
// Schedule:   overlapped only, LANES vertices in FOLD clocks; the paper has no such organization.
// Pipeline:   ffd_eval_factored; of several lanes, a clock where their reads meet, if they do,
//             within that pipeline, and one where their sums meet, behind it.
// Freezes:    never. Results leave in the order of the vertices and are not held back: who offers a
//             vertex must have room for its result.
// Parameters: those of every organization (docs/architecture.md); SCHEDULE overlapped, EVALUATOR
//             not iterative; FOLD 1, 2, 3, 6, if AFFINE 4, with the same bits; N 64, of FOLD 2 and
//             6 32, of 4 16; LANES 1, of FOLD 3 to 3, of 4 to 4; PORTS as many of FOLD 4, else 1;
//             AFFINE 1: ffd_org_affine; JACOBIAN 0, of FOLD 3 and a lane also 1.
// Model:      golden/include/hwffd/model/org_factored.hpp.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_org_factored #(
  parameter FOLD            = 1,
  parameter LANES           = 1,
  parameter AFFINE          = 0,
  parameter JACOBIAN        = 0,
  parameter FORMAT          = 18,
  parameter N               = 64,
  parameter PORTS           = 1,
  `include "ffd_org_parameters.vh"
) (
  `include "ffd_org_ports.vh"
);
  localparam WIDTH    = 3 * `FFD_SUM_W(FORMAT);
  localparam POINTS_W = N * 3 * `FFD_POINT_W(FORMAT);

  generate
    if (`FFD_FOLD_BAD(FOLD)) begin : gen_bad_fold
      ERROR_ffd_org_factored_fold_must_be_1_2_3_4_or_6 u_error ();
    end
    if (LANES < 1 || LANES > (FOLD == 3 || FOLD == 4 ? FOLD : 1)) begin : gen_bad_lanes
      ERROR_ffd_org_factored_lanes_must_be_1_with_fold_3_or_4_to_that u_error ();
    end
    if (PORTS != (FOLD == 4 ? LANES : 1)) begin : gen_bad_ports
      ERROR_ffd_org_factored_ports_must_be_1_with_fold_4_as_many_as_lanes u_error ();
    end
    if (JACOBIAN != 0 && (FOLD != 3 || LANES != 1)) begin : gen_bad_jacobian
      ERROR_ffd_org_factored_jacobian_wants_fold_3_and_a_lane u_error ();
    end
    if (N != 64 / `FFD_FOLD_PARTS(FOLD) && !(FOLD == 3 && LANES == 1 && N == 32)) begin : gen_bad_n
      ERROR_ffd_org_factored_n_must_be_64_by_its_parts_folded_by_3_also_32 u_error ();
    end
    if (SCHEDULE != `FFD_SCHEDULE_OVERLAPPED) begin : gen_bad_schedule
      ERROR_ffd_org_factored_schedule_must_be_overlapped u_error ();
    end
  endgenerate

  // Where lanes meet: one of them at most has something in a clock.
  wire [LANES-1:0]          turn;  // of taking a vertex
  wire [LANES-1:0]          ready;
  wire [LANES-1:0]          read;
  wire [LANES-1:0]          read_last;
  wire [LANES*SOURCE_W-1:0] read_source;
  wire [LANES*12-1:0]       read_cell;
  wire [LANES*6-1:0]        read_index;
  wire [LANES-1:0]          sum_valid;
  wire [LANES*WIDTH-1:0]    sum;
  wire [LANES*3*WIDTH-1:0]  jacobian;
  wire [LANES*WIDTH-1:0]    second;  // all 0

  genvar lane;
  generate
    for (lane = 0; lane < LANES; lane = lane + 1) begin : gen_lane
      ffd_eval_factored #(
        .FOLD           (FOLD),
        .AFFINE         (AFFINE),
        .JACOBIAN       (JACOBIAN),
        .FORMAT         (FORMAT),
        .N              (N),
        .SCHEDULE       (SCHEDULE),
        .EVALUATOR      (EVALUATOR),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .READ_LATENCY   (LANES == PORTS ? READ_LATENCY : READ_LATENCY + 1),
        .SOURCE_W       (SOURCE_W),
        .SPANS          (SPANS)
      ) u_lane (
        .clk                 (clk),
        .rst                 (rst),
        .load_i              (load_i),
        .load_axis_i         (load_axis_i),
        .load_address_i      (load_address_i),
        .load_entry_i        (load_entry_i),
        .s_vertex_valid      (s_vertex_valid && turn[lane]),
        .s_vertex_ready      (ready[lane]),
        .s_vertex_coordinates(s_vertex_coordinates),
        .s_vertex_cell       (s_vertex_cell),
        .s_vertex_source     (s_vertex_source),
        .s_vertex_bank       (s_vertex_bank),
        .s_vertex_changed    (s_vertex_changed),
        .s_vertex_second     (s_vertex_second),
        .read_o              (read[lane]),
        .read_last_o         (read_last[lane]),
        .read_source_o       (read_source[lane*SOURCE_W +: SOURCE_W]),
        .read_cell_o         (read_cell[lane*12 +: 12]),
        .read_index_o        (read_index[lane*6 +: 6]),
        .read_points_i       (read_points_i[POINTS_W*(lane % PORTS) +: POINTS_W]),
        .result_valid_o      (sum_valid[lane]),
        .result_sum_o        (sum[lane*WIDTH +: WIDTH]),
        .result_jacobian_o   (jacobian[lane*3*WIDTH +: 3*WIDTH]),
        .result_second_o     (second[lane*WIDTH +: WIDTH])
      );
    end
  endgenerate

  assign s_vertex_ready  = |(ready & turn);
  assign result_second_o = second[0 +: WIDTH];
  wire unused_second = &{1'b0, second};
  generate
    if (LANES == PORTS) begin : gen_own_reads
      assign read_o        = read;
      assign read_last_o   = read_last;
      assign read_source_o = read_source;
      assign read_cell_o   = read_cell;
      assign read_index_o  = read_index;
    end else begin : gen_shared_reads
      reg                read_q;
      reg                read_last_q;
      reg [SOURCE_W-1:0] source_d, source_q;
      reg [11:0]         cell_d, cell_q;

      integer i;
      always @* begin
        source_d = {SOURCE_W{1'b0}};
        cell_d   = 12'd0;
        for (i = 0; i < LANES; i = i + 1) begin
          source_d = source_d | ({SOURCE_W{read[i]}} & read_source[i*SOURCE_W +: SOURCE_W]);
          cell_d   = cell_d | ({12{read[i]}} & read_cell[i*12 +: 12]);
        end
      end
      always @(posedge clk) begin
        read_q      <= |read && !rst;
        read_last_q <= |read_last && !rst;
        source_q    <= source_d;
        cell_q      <= cell_d;
      end

      assign read_o        = read_q;
      assign read_last_o   = read_last_q;
      assign read_source_o = source_q;
      assign read_cell_o   = cell_q;
      assign read_index_o  = 6'd0;
      wire unused_ok = &{1'b0, read_index};
    end
  endgenerate

  generate
    if (LANES == 1) begin : gen_alone
      assign turn              = 1'b1;
      assign result_valid_o    = sum_valid;
      assign result_sum_o      = sum;
      assign result_jacobian_o = jacobian;
    end else begin : gen_together
      localparam [LANES-1:0] FIRST = 1;
      reg [LANES-1:0] turn_q;
      reg             sum_valid_q;
      reg [WIDTH-1:0] sum_d, sum_q;

      integer i;
      always @* begin
        sum_d = {WIDTH{1'b0}};
        for (i = 0; i < LANES; i = i + 1) begin
          sum_d = sum_d | ({WIDTH{sum_valid[i]}} & sum[i*WIDTH +: WIDTH]);
        end
      end
      always @(posedge clk) begin
        if (rst) turn_q <= FIRST;
        else if (s_vertex_valid && s_vertex_ready) turn_q <= {turn_q[LANES-2:0], turn_q[LANES-1]};
        sum_valid_q <= |sum_valid && !rst;
        sum_q       <= sum_d;
      end

      assign turn              = turn_q;
      assign result_valid_o    = sum_valid_q;
      assign result_sum_o      = sum_q;
      assign result_jacobian_o = {3 * WIDTH{1'b0}};
      wire unused_ok = &{1'b0, jacobian};
    end
  endgenerate
endmodule

`default_nettype wire
