// ffd_eval_walk: `affine` along rows of vertices: a cell further along s, one new point of four
//
// Along a row of a grid t and u stay, and so does most of what lies before the contraction along s:
// four points, each of a *plane* of 4 x 4 control points, contracted along u and t. They are held
// by bank of s, so that in the next cell three of them stay where they are and one is replaced:
// nothing shifts. A plane is read in four clocks, the four points along u in each; four planes are
// a row's first cell, or that of a vertex of which anything but s and its cell along s is new.
//
// What is read is ahead of what is contracted along s: planes are read when the first vertex that
// wants them comes, and it waits in a queue until they are here, with those behind it. So the
// planes of the next rows are read while the vertices of this one pass, and a row takes as many
// clocks as it has vertices, or four for each plane that it wants, whichever is more.
//
// With PAIRS a second vertex of the same cell comes and goes with each one: evaluators and
// contractions along s are there twice, and the clocks of a row are those of its pairs.
//
// Formats, rounding: those of ffd_eval_affine and ffd_eval_quarters; docs/numerics.md section 4.
//             The bits are those of `affine`, however it is folded.
// Schedule:   a vertex every clock, a plane every four.
// Pipeline:   vertex | compared | queued .. taken | FFD_POLY_LATENCY: weights of s |
//             FFD_CONTRACT_LATENCY, not narrowed: sum. Beside it, for each plane: four steps |
//             FFD_CHOICE_LATENCY, FFD_POLY_LATENCY: weights of u, points | two contractions.
// Freezes:    never. Results leave in the order of the vertices and are not held back.
// Ring:       each bank of s has its last 16 points, numbered modulo 16; taking a vertex moves to
//             the next one of the banks that it replaces. Of each bank at most 15 planes are asked
//             for and not yet taken, so none overwrites a point that a vertex in the queue wants.
// Parameters: those of ffd_org_affine, which checks them; N 4. EVALUATOR not iterative. PAIRS 0, 1.
// Model:      golden/include/hwffd/model/org_affine.hpp.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_walk #(
  parameter PAIRS           = 0,
  parameter FORMAT          = 17,
  parameter N               = 4,
  parameter PORTS           = 1,
  `include "ffd_org_parameters.vh"
) (
  `include "ffd_org_ports.vh"
);
  localparam STEP_LATENCY = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);
  localparam FILE_LATENCY = `FFD_FILE_LATENCY(SCHEDULE, EVALUATOR);
  localparam POLY_LATENCY = `FFD_POLY_LATENCY(EVALUATOR, FILE_LATENCY, STEP_LATENCY,
                                              CONVERT_LATENCY);
  localparam CONTRACT     = `FFD_CONTRACT_LATENCY(1, MUL_LATENCY, ADD_LATENCY, FMA_LATENCY,
                                                  CONVERT_LATENCY);
  localparam CHOICE       = `FFD_CHOICE_LATENCY(4);
  localparam READ_DELAY   = CHOICE + POLY_LATENCY - READ_LATENCY - ADD_LATENCY;
  // Clocks from a step to its point of s; from a vertex that is taken to the reads of its points,
  // which must have been written in an earlier clock.
  localparam PLANE_DELAY  = READ_DELAY + READ_LATENCY + 2 * CONTRACT;
  localparam TAKEN_DELAY  = POLY_LATENCY - ADD_LATENCY;
  localparam WEIGHT_W     = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W      = `FFD_POINT_W(FORMAT);
  localparam SUM_W        = `FFD_SUM_W(FORMAT);
  localparam PLACE_W      = `FFD_PLACE_W(SPANS);
  localparam ROW_W        = 2 * WEIGHT_W + 8 + SOURCE_W + 2 * PLACE_W;  // what a row shares
  localparam OWN_W        = (1 + PAIRS) * WEIGHT_W + PLACE_W;
  localparam QUEUE        = 64;
  localparam REQUESTS     = 16;
  localparam RING         = 16;

  generate
    if (READ_DELAY < 0) begin : gen_bad_read_latency
      ERROR_ffd_eval_walk_read_latency_is_too_long u_error ();
    end
  endgenerate

  // ---- the next vertex waits in a register, where it is known which planes it wants

  wire [ROW_W-1:0] offered = {s_vertex_coordinates[WEIGHT_W +: 2*WEIGHT_W], s_vertex_cell[11:4],
                              s_vertex_source, s_vertex_bank[PLACE_W +: 2*PLACE_W]};
  wire [3:0]       i       = s_vertex_cell[3:0];
  wire [OWN_W-1:0] own;       // {coordinates of s, the second one on top, place of its functions}
  reg              held_q;
  reg  [ROW_W-1:0] row_q;     // of the vertex before: what a row shares
  reg  [3:0]       i_q;
  reg  [OWN_W-1:0] own_q;
  reg  [2:0]       count_q;   // of planes
  reg  [1:0]       first_q;   // of them, the lowest, from the cell on
  wire             take;         // a vertex leaves the queue
  reg              may_go_q;     // one that wants none
  reg              may_begin_q;  // one that wants planes
  wire             go     = held_q && (count_q == 3'd0 ? may_go_q : may_begin_q);
  wire             stays  = !s_vertex_changed && offered == row_q;
  // How many cells further, with its sign; beyond three nothing is shared.
  wire [4:0]       by     = {1'b0, i} - {1'b0, i_q};
  wire [3:0]       back   = i_q - i;
  wire             near   = by[4] ? back[3:2] == 2'd0 : by[3:2] == 2'd0;

  assign s_vertex_ready = !held_q || go;

  always @(posedge clk) begin
    if (rst) held_q <= 1'b0;
    else if (s_vertex_ready) held_q <= s_vertex_valid;
  end
  always @(posedge clk) begin
    if (s_vertex_ready && s_vertex_valid) begin
      row_q   <= offered;
      i_q     <= i;
      own_q   <= own;
      count_q <= !(stays && near) ? 3'd4 : by[4] ? {1'b0, back[1:0]} : {1'b0, by[1:0]};
      first_q <= !(stays && near) || by[4] ? 2'd0 : 2'd0 - by[1:0];
    end
  end

  // Which banks of s they are in: `count` from `first` on, turned by the cell.
  wire [3:0] upto    = count_q[2] ? 4'b1111 : {1'b0, &count_q[1:0], count_q[1], |count_q[1:0]};
  wire [1:0] turn    = first_q + i_q[1:0];
  wire [7:0] twice   = {4'd0, upto} << turn;
  wire [3:0] banks   = twice[3:0] | twice[7:4];

  // ---- what vertices want, and of each the planes, one after the other

  localparam REQUEST_W = ROW_W + 4 + 2 + 3;
  wire                 requests_ready;
  wire                 request_valid;
  wire                 request_ready;
  wire [REQUEST_W-1:0] request;
  wire                 plane_ready;
  reg  [2:0]           left_q;
  reg  [1:0]           bank_q;
  reg  [ROW_W-1:0]     walked_q;
  reg  [3:0]           walked_i_q;
  wire                 begins = go && count_q != 3'd0;

  assign request_ready = left_q == 3'd0 || (left_q == 3'd1 && plane_ready);

  // Whether there is room, whatever banks a vertex wants, is known a clock before, so that what is
  // in front waits for no more than that: there is room for one that goes meanwhile, too. One that
  // is taken from the queue makes room a clock later.
  localparam QUEUE_W    = $clog2(QUEUE);
  localparam REQUESTS_W = $clog2(REQUESTS);
  reg  [QUEUE_W:0]    queued_q;
  reg                 taken_valid_q;
  wire                queue_full = queued_q[QUEUE_W] || &queued_q[QUEUE_W-1:0];
  wire [3:0]          full;         // banks of which no more than one plane may be asked for
  reg  [REQUESTS_W:0] requests_q;   // that wait
  wire                request_goes = request_valid && request_ready;
  wire                requests_full = requests_q[REQUESTS_W] || &requests_q[REQUESTS_W-1:0];

  always @(posedge clk) begin
    if (rst) requests_q <= {(REQUESTS_W + 1) {1'b0}};
    else if (begins && !request_goes) requests_q <= requests_q + 1'b1;
    else if (request_goes && !begins) requests_q <= requests_q - 1'b1;
  end
  always @(posedge clk) begin
    if (rst) queued_q <= {(QUEUE_W + 1) {1'b0}};
    else if (go && !taken_valid_q) queued_q <= queued_q + 1'b1;
    else if (taken_valid_q && !go) queued_q <= queued_q - 1'b1;
    taken_valid_q <= take && !rst;
    may_go_q      <= !rst && !queue_full;
    may_begin_q   <= !rst && !queue_full && !requests_full && full == 4'd0;
  end
  `FFD_ASSERT(a_request_comes_and_the_queue_is_full, !begins || requests_ready)

  ffd_stream_fifo #(
    .WIDTH(REQUEST_W),
    .DEPTH(REQUESTS)
  ) u_requests (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(begins),
    .s_word_ready(requests_ready),
    .s_word_data ({row_q, i_q, turn, count_q}),
    .m_word_valid(request_valid),
    .m_word_ready(request_ready),
    .m_word_data (request)
  );

  always @(posedge clk) begin
    if (rst) left_q <= 3'd0;
    else if (request_ready) left_q <= request_valid ? request[2:0] : 3'd0;
    else if (plane_ready) left_q <= left_q - 3'd1;
  end
  always @(posedge clk) begin
    if (request_ready) {walked_q, walked_i_q, bank_q} <= request[REQUEST_W-1:3];
    else if (plane_ready) bank_q <= bank_q + 2'd1;
  end

  // ---- a plane in four steps: the banks of t from the last to the first

  wire                  step_valid;
  wire                  step_first;
  wire                  step_last;
  wire [1:0]            step;
  wire [2*WEIGHT_W-1:0] coordinates;
  wire [11:0]           cell_index;
  wire [SOURCE_W-1:0]   source;
  wire [2*PLACE_W-1:0]  places;
  wire [1:0]            bank;
  wire                  step_final;  // of the last plane that a vertex wants

  ffd_eval_sequencer #(
    .PAYLOAD_W(ROW_W + 4 + 3),
    .STEPS    (4),
    .CONTEXTS (1),
    .INTERVAL (1)
  ) u_sequencer (
    .clk           (clk),
    .rst           (rst),
    .s_vertex_valid(left_q != 3'd0),
    .s_vertex_ready(plane_ready),
    .s_vertex_data ({walked_i_q, bank_q, left_q == 3'd1, walked_q}),
    .step_valid_o  (step_valid),
    .step_first_o  (step_first),
    .step_last_o   (step_last),
    .step_o        (step),
    .payload_o     ({cell_index[3:0], bank, step_final, coordinates, cell_index[11:4], source,
                     places})
  );

  wire [3*4*WEIGHT_W-1:0] weights;

  ffd_eval_bank_weights #(
    .FOLD           (4),
    .AFFINE         (1),
    .FORMAT         (FORMAT),
    .EVALUATOR      (EVALUATOR),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (FMA_LATENCY),
    .CONVERT_LATENCY(CONVERT_LATENCY),
    .DISTANCE       (CONTRACT),
    .SPANS          (SPANS)
  ) u_weights (
    .clk           (clk),
    .load_i        (load_i),
    .load_axis_i   (load_axis_i),
    .load_address_i(load_address_i),
    .load_entry_i  (load_entry_i),
    .step_valid_i  (step_valid),
    .step_i        (step),
    .coordinates_i ({coordinates, {WEIGHT_W{1'b0}}}),
    .cell_i        (cell_index),
    .bank_i        ({places, {PLACE_W{1'b0}}}),
    .weights_o     (weights)
  );

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(READ_DELAY),
    .RESET  (1)
  ) u_read_valid (
    .clk(clk),
    .rst(rst),
    .d_i({step_valid, step_valid && step_last && step_final}),
    .q_o({read_o, read_last_o})
  );

  ffd_num_delay #(
    .WIDTH  (4 + SOURCE_W + 12),
    .LATENCY(READ_DELAY)
  ) u_read (
    .clk(clk),
    .rst(1'b0),
    .d_i({bank, ~step, source, cell_index}),
    .q_o({read_index_o[5:2], read_source_o, read_cell_o})
  );

  assign read_index_o[1:0] = 2'd0;

  wire [1:0] bank_t;       // of the point that comes along t
  wire       plane_valid;  // the last step of a plane leaves its point
  wire [1:0] plane_bank;
  wire       plane_counts; // it may be taken from the next clock on

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(READ_LATENCY + CONTRACT)
  ) u_bank_t (
    .clk(clk),
    .rst(1'b0),
    .d_i(read_index_o[3:2]),
    .q_o(bank_t)
  );

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(PLANE_DELAY - TAKEN_DELAY),
    .RESET  (1)
  ) u_plane_counts (
    .clk(clk),
    .rst(rst),
    .d_i(step_valid && step_last),
    .q_o(plane_counts)
  );

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(TAKEN_DELAY),
    .RESET  (1)
  ) u_plane_valid (
    .clk(clk),
    .rst(rst),
    .d_i(plane_counts),
    .q_o(plane_valid)
  );

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(PLANE_DELAY)
  ) u_plane_bank (
    .clk(clk),
    .rst(1'b0),
    .d_i(bank),
    .q_o(plane_bank)
  );

  // ---- vertices wait until their planes are here

  wire             queue_valid;
  wire             queue_ready;  // always
  wire [2:0]       queue_count;
  wire [3:0]       queue_banks;
  wire [1:0]       queue_residue;
  wire [OWN_W-1:0] queue_own;
  reg  [5:0]       here_q;  // planes that no vertex has taken

  assign take = queue_valid && here_q >= {3'd0, queue_count};

  ffd_stream_queue #(
    .WIDTH  (3 + 4 + 2 + OWN_W),
    .DEPTH  (QUEUE),
    .COUNTED(1)
  ) u_queue (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(go),
    .s_word_ready(queue_ready),
    .s_word_data ({count_q, banks, i_q[1:0], own_q}),
    .m_word_valid(queue_valid),
    .m_word_ready(take),
    .m_word_data ({queue_count, queue_banks, queue_residue, queue_own})
  );

  always @(posedge clk) begin
    if (rst) here_q <= 6'd0;
    else here_q <= here_q + {5'd0, plane_counts} - (take ? {3'd0, queue_count} : 6'd0);
  end

  reg  [OWN_W-1:0] taken_own_q;
  reg  [1:0]       taken_residue_q;
  always @(posedge clk) begin
    taken_own_q     <= queue_own;
    taken_residue_q <= queue_residue;
  end

  wire [(1+PAIRS)*4*WEIGHT_W-1:0] own_weights;  // of each vertex

  genvar v;
  generate
    for (v = 0; v <= PAIRS; v = v + 1) begin : gen_own
      ffd_eval_axis_weights #(
        .AFFINE         (1),
        .FORMAT         (FORMAT),
        .EVALUATOR      (EVALUATOR),
        .MUL_LATENCY    (MUL_LATENCY),
        .ADD_LATENCY    (ADD_LATENCY),
        .FMA_LATENCY    (FMA_LATENCY),
        .CONVERT_LATENCY(CONVERT_LATENCY),
        .SPANS          (SPANS)
      ) u_weights (
        .clk           (clk),
        .load_i        (load_i && load_axis_i == 2'd0),
        .load_axis_i   (load_axis_i),
        .load_address_i(load_address_i),
        .load_entry_i  (load_entry_i),
        .start_i       (1'b1),
        .axis_i        (2'd0),
        .coordinate_i  (taken_own_q[PLACE_W + v*WEIGHT_W +: WEIGHT_W]),
        .residue_i     (taken_residue_q),
        .bank_i        (taken_own_q[0 +: PLACE_W]),
        .weights_o     (own_weights[v*4*WEIGHT_W +: 4*WEIGHT_W])
      );
    end
  endgenerate

  // ---- the ring of each bank of s

  wire [3*POINT_W-1:0]   plane;     // the point that a plane leaves
  wire [4*3*POINT_W-1:0] points_d;
  reg  [4*3*POINT_W-1:0] points_q;

  genvar b;
  generate
    for (b = 0; b < 4; b = b + 1) begin : gen_bank
      localparam [1:0] BANK = b;
      reg  [3:0] ahead_q;    // points that were asked for and not taken
      reg  [3:0] written_q;  // the last point that came
      reg  [3:0] taken_q;    // that of the last vertex taken
      wire [3:0] read;
      wire       write   = plane_valid && plane_bank == BANK;
      wire [3:0] written = written_q + 4'd1;
      wire       asks    = begins && banks[b];
      wire       takes   = take && queue_banks[b];

      assign full[b] = &ahead_q[3:1];

      always @(posedge clk) begin
        if (rst) ahead_q <= 4'd0;
        else if (asks && !takes) ahead_q <= ahead_q + 4'd1;
        else if (takes && !asks) ahead_q <= ahead_q - 4'd1;
      end

      always @(posedge clk) begin
        if (rst) written_q <= 4'd0;
        else if (write) written_q <= written;
      end
      `FFD_ASSERT(a_point_is_taken_that_nobody_asked_for, !takes || ahead_q != 4'd0)
      `FFD_ASSERT(more_points_are_asked_for_than_the_ring_has, !asks || takes || !(&ahead_q))

      always @(posedge clk) begin
        if (rst) taken_q <= 4'd0;
        else if (takes) taken_q <= taken_q + 4'd1;
      end

      // taken_q is a clock behind, the memory's read and its register one in front.
      ffd_num_delay #(
        .WIDTH  (4),
        .LATENCY(TAKEN_DELAY - 1)
      ) u_read (
        .clk(clk),
        .rst(1'b0),
        .d_i(taken_q),
        .q_o(read)
      );

      ffd_mem_sdp #(
        .WIDTH       (3 * POINT_W),
        .DEPTH       (RING),
        .READ_LATENCY(0)
      ) u_ring (
        .clk            (clk),
        .write_i        (write),
        .write_address_i(written),
        .write_data_i   (plane),
        .read_i         (1'b1),
        .read_address_i (read),
        .read_data_o    (points_d[b*3*POINT_W +: 3*POINT_W])
      );
    end
  endgenerate

  always @(posedge clk) points_q <= points_d;

  // ---- the contractions of a component: along u, t and s

  wire [3*SUM_W-1:0]           sum;        // along t
  wire                         sum_valid;  // for whoever draws the schedule
  wire [(1+PAIRS)*3*SUM_W-1:0] sums;       // along s, of each vertex

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(PLANE_DELAY - CONVERT_LATENCY),
    .RESET  (1)
  ) u_sum_valid (
    .clk(clk),
    .rst(rst),
    .d_i(step_valid && step_last),
    .q_o(sum_valid)
  );

  genvar c;
  generate
    for (c = 0; c < 3; c = c + 1) begin : gen_component
      wire [4*POINT_W-1:0] points_u;
      wire [4*POINT_W-1:0] points_s;
      wire [SUM_W-1:0]     sum_u;
      wire [POINT_W-1:0]   point_t;

      for (b = 0; b < 4; b = b + 1) begin : gen_point
        assign points_u[b*POINT_W +: POINT_W] = read_points_i[(3*b+c)*POINT_W +: POINT_W];
        assign points_s[b*POINT_W +: POINT_W] = points_q[(3*b+c)*POINT_W +: POINT_W];
      end

      ffd_eval_affine #(
        .FORMAT     (FORMAT),
        .MUL_LATENCY(MUL_LATENCY),
        .ADD_LATENCY(ADD_LATENCY)
      ) u_along_u (
        .clk      (clk),
        .weights_i(weights[2*4*WEIGHT_W +: 4*WEIGHT_W]),
        .points_i (points_u),
        .sums_o   (sum_u)
      );
      `FFD_ASSERT_TAKES(u_along_u, CONTRACT - CONVERT_LATENCY)

      ffd_num_narrow #(
        .FORMAT (FORMAT),
        .LATENCY(CONVERT_LATENCY)
      ) u_narrow_u (
        .clk    (clk),
        .sum_i  (sum_u),
        .point_o(point_t)
      );

      ffd_eval_quarters #(
        .FORMAT     (FORMAT),
        .MUL_LATENCY(MUL_LATENCY),
        .ADD_LATENCY(ADD_LATENCY)
      ) u_along_t (
        .clk      (clk),
        .bank_i   (bank_t),
        .weights_i(weights[1*4*WEIGHT_W +: 4*WEIGHT_W]),
        .point_i  (point_t),
        .sum_o    (sum[c*SUM_W +: SUM_W])
      );
      `FFD_ASSERT_TAKES(u_along_t, CONTRACT - CONVERT_LATENCY)

      ffd_num_narrow #(
        .FORMAT (FORMAT),
        .LATENCY(CONVERT_LATENCY)
      ) u_narrow_t (
        .clk    (clk),
        .sum_i  (sum[c*SUM_W +: SUM_W]),
        .point_o(plane[c*POINT_W +: POINT_W])
      );

      for (v = 0; v <= PAIRS; v = v + 1) begin : gen_vertex
        ffd_eval_affine #(
          .FORMAT     (FORMAT),
          .MUL_LATENCY(MUL_LATENCY),
          .ADD_LATENCY(ADD_LATENCY)
        ) u_along_s (
          .clk      (clk),
          .weights_i(own_weights[v*4*WEIGHT_W +: 4*WEIGHT_W]),
          .points_i (points_s),
          .sums_o   (sums[(3*v+c)*SUM_W +: SUM_W])
        );
      end
    end
  endgenerate

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(1 + TAKEN_DELAY + CONTRACT - CONVERT_LATENCY),
    .RESET  (1)
  ) u_valid (
    .clk(clk),
    .rst(rst),
    .d_i(take),
    .q_o(result_valid_o)
  );

  generate
    if (PAIRS != 0) begin : gen_pairs
      assign own = {s_vertex_second, s_vertex_coordinates[0 +: WEIGHT_W],
                    s_vertex_bank[0 +: PLACE_W]};
      assign result_second_o = sums[3*SUM_W*PAIRS +: 3*SUM_W];
    end else begin : gen_alone
      assign own = {s_vertex_coordinates[0 +: WEIGHT_W], s_vertex_bank[0 +: PLACE_W]};
      assign result_second_o = {3 * SUM_W {1'b0}};
      wire unused_second = &{1'b0, s_vertex_second};
    end
  endgenerate
  assign result_sum_o      = sums[3*SUM_W-1:0];
  assign result_jacobian_o = {9 * SUM_W {1'b0}};
  wire unused_ok = &{1'b0, requests_ready, queue_ready, step_first, sum_valid,
                     weights[0 +: 4*WEIGHT_W]};

endmodule

`default_nettype wire
