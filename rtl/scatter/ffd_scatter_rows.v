// ffd_scatter_rows: vertices of a row are expanded along s, and added up by layer
//
//   H[i'] = sum over the vertices of the row with i <= i' <= i + 3 of their part for bank i' mod 4
//
// The transpose of what ffd_eval_walk does. A row is vertices that differ in s only; the last says
// so. A *layer* is the 16 points that a row has at one index i' along s. A register for each bank
// of s has the sum of the layer that is open in that bank. It goes to the bank's queue when the
// next vertex has another layer there, or the row has ended: in the next row, or without one, all
// four go one clock after its last vertex. So nothing shifts, and a bank never sends two at once.
//
// Order:      rows leave one after the other, so that what was inside at some moment has left when
//             as many rows have. Each has a layer in every bank: that of a bank which says that it
//             is the row's last there keeps the bank's next ones back, until all four have.
// Formats:    coordinates {u, t, s} as weights, cell {k, j, i}, gradient {z, y, x} as points; sums
//             {z, y, x} of 35 bits in units of a part, modulo 2^35; a layer's cell {k, j, i'}.
// Rounding:   that of ffd_scatter_expand.
// Pipeline:   vertex | which layers it opens | FFD_SCATTER_OWN_WEIGHTS_LATENCY: weights of s |
//             FFD_SCATTER_EXPAND_LATENCY: parts | added_o, in H | 3: a layer is queued |
//             chosen | offered. A vertex a clock, a layer every second one.
// Freezes:    nothing inside ever stops. s_vertex_ready is 0 while a vertex waits that opens a
//             layer in a bank which has FFD_SCATTER_ROWS_INSIDE open or queued: as many as its
//             queue has room for.
// Bad input:  by FFD_ASSERTIONS: a vertex of a row that differs from the one before in more than s.
// Parameters: FORMAT 12 to 18, EVALUATOR not iterative, latencies >= 1, AXIS 4 to 64, PAGE_W >= 1.
// Model:      golden/include/hwffd/model/scatter.hpp.  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_scatter.vh"

module ffd_scatter_rows #(
  parameter FORMAT      = 17,
  parameter EVALUATOR   = `FFD_EVALUATOR_PIPELINED,
  parameter MUL_LATENCY = 4,
  parameter ADD_LATENCY = 1,
  parameter AXIS        = 16,
  parameter PAGE_W      = 1,
  parameter AXIS_W      = `FFD_AXIS_W(AXIS)
) (
  input  wire                                            clk,
  input  wire                                            rst,
  input  wire                                            load_i,
  input  wire [1:0]                                      load_axis_i,
  input  wire [`FFD_OWN_W(1)-1:0]                        load_address_i,
  input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,
  input  wire                                            s_vertex_valid,
  output wire                                            s_vertex_ready,
  input  wire [3*`FFD_WEIGHT_W(FORMAT)-1:0]              s_vertex_coordinates,
  input  wire [3*AXIS_W-1:0]                             s_vertex_cell,
  input  wire [3*`FFD_PLACE_W(1)-1:0]                    s_vertex_bank,
  input  wire [PAGE_W-1:0]                               s_vertex_page,
  input  wire [3*`FFD_POINT_W(FORMAT)-1:0]               s_vertex_gradient,
  input  wire                                            s_vertex_saturated,
  input  wire                                            s_vertex_last,     // of its row
  // For a clock, of each vertex in order: it is in the sums of its layers.
  output wire                                            added_o,
  output wire [PAGE_W-1:0]                               added_page_o,
  output wire                                            added_saturated_o,
  output wire                                            m_layer_valid,
  input  wire                                            m_layer_ready,
  output wire [2*`FFD_WEIGHT_W(FORMAT)-1:0]              m_layer_coordinates,  // {u, t}
  output wire [3*AXIS_W-1:0]                             m_layer_cell,
  output wire [2*`FFD_PLACE_W(1)-1:0]                    m_layer_bank,
  output wire [PAGE_W-1:0]                               m_layer_page,
  output wire [3*`FFD_WIDE_W-1:0]                        m_layer_sums,
  output wire                                            m_layer_last          // of its row
);
  localparam W        = `FFD_FIXED_W(FORMAT);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam PART_W   = `FFD_PART_W(FORMAT);
  localparam WIDE_W   = `FFD_WIDE_W;
  localparam PLACE_W  = `FFD_PLACE_W(1);
  localparam HIGH_W   = `FFD_SCATTER_HIGH_W(AXIS);
  localparam DEPTH    = `FFD_SCATTER_ROWS_INSIDE;
  localparam COUNT_W  = $clog2(DEPTH) + 1;
  localparam WEIGHTS  = `FFD_SCATTER_OWN_WEIGHTS_LATENCY(EVALUATOR, MUL_LATENCY, ADD_LATENCY);
  localparam EXPAND   = `FFD_SCATTER_EXPAND_LATENCY(0, MUL_LATENCY, ADD_LATENCY);
  localparam ROW_W    = PAGE_W + 2 * (PLACE_W + AXIS_W + WEIGHT_W);  // what a row shares
  localparam LAYER_W  = 1 + HIGH_W + 3 * WIDE_W;

  // ---- the next vertex waits in registers, where it is known which layers it opens

  wire [ROW_W-1:0]     offered = {s_vertex_page, s_vertex_bank[PLACE_W +: 2*PLACE_W],
                                  s_vertex_cell[AXIS_W +: 2*AXIS_W],
                                  s_vertex_coordinates[WEIGHT_W +: 2*WEIGHT_W]};
  reg                  held_q;
  reg                  begins_q;   // the next row
  reg                  first_q;    // of its row
  reg                  last_q;
  reg  [ROW_W-1:0]     row_q;
  reg  [WEIGHT_W-1:0]  s_q;
  reg  [AXIS_W-1:0]    i_q;
  reg  [PLACE_W-1:0]   bank_q;
  reg  [3*W-1:0]       gradient_q;
  reg                  saturated_q;
  reg  [3:0]           opens_q;
  reg                  waits_q;    // a bank that it opens a layer in is full
  wire [4*HIGH_W-1:0]  highs_offered;
  wire [4*HIGH_W-1:0]  highs;
  wire [4*HIGH_W-1:0]  highs_there;
  wire [3:0]           full;       // banks that will have as many layers as they may
  wire                 row_ready;  // always
  wire [3:0]           to_open;    // of the vertex that is offered
  wire                 go     = held_q && !waits_q;
  wire                 accept = s_vertex_valid && s_vertex_ready;
  wire [AXIS_W-1:0]    i_there;

  assign s_vertex_ready = !held_q || !waits_q;

  always @(posedge clk) begin
    if (rst) held_q <= 1'b0;
    else if (s_vertex_ready) held_q <= s_vertex_valid;
  end
  always @(posedge clk) begin
    if (rst) begins_q <= 1'b1;
    else if (accept) begins_q <= s_vertex_last;
  end
  always @(posedge clk) begin
    if (accept) begin
      first_q     <= begins_q;
      last_q      <= s_vertex_last;
      row_q       <= offered;
      s_q         <= s_vertex_coordinates[0 +: WEIGHT_W];
      i_q         <= s_vertex_cell[0 +: AXIS_W];
      bank_q      <= s_vertex_bank[0 +: PLACE_W];
      gradient_q  <= {s_vertex_gradient[2*POINT_W +: W], s_vertex_gradient[1*POINT_W +: W],
                      s_vertex_gradient[0*POINT_W +: W]};
      saturated_q <= s_vertex_saturated || s_vertex_gradient[2*POINT_W+W]
                     || s_vertex_gradient[1*POINT_W+W] || s_vertex_gradient[0*POINT_W+W];
    end
  end

  // The layers that a cell has: of a vertex that is offered, of the one before, and of one whose
  // parts are here.
  ffd_scatter_places #(
    .AXIS(AXIS)
  ) u_offered (
    .cell_i  (s_vertex_cell[0 +: AXIS_W]),
    .places_o(highs_offered)
  );
  ffd_scatter_places #(
    .AXIS(AXIS)
  ) u_before (
    .cell_i  (i_q),
    .places_o(highs)
  );
  ffd_scatter_places #(
    .AXIS(AXIS)
  ) u_there (
    .cell_i  (i_there),
    .places_o(highs_there)
  );

  genvar b;
  generate
    for (b = 0; b < 4; b = b + 1) begin : gen_opens
      assign to_open[b] = begins_q
                       || highs_offered[b*HIGH_W +: HIGH_W] != highs[b*HIGH_W +: HIGH_W];
    end
  endgenerate
  always @(posedge clk) begin
    if (accept) opens_q <= to_open;
    waits_q <= (full & (s_vertex_ready ? to_open : opens_q)) != 4'd0;
  end

  `FFD_ASSERT(a_vertex_of_a_row_differs_in_more_than_s,
              !accept || begins_q || offered == row_q)

  // ---- what a row shares waits until its last layer has gone

  wire             row_valid;
  wire [ROW_W-1:0] row;
  reg              moves_q;      // a layer, from its queue to where it is offered
  reg              row_moves_q;  // that was its last

  ffd_stream_queue #(
    .WIDTH(ROW_W),
    .DEPTH(DEPTH)
  ) u_rows (
    .clk         (clk),
    .rst         (rst),
    .s_word_valid(go && first_q),
    .s_word_ready(row_ready),
    .s_word_data (row_q),
    .m_word_valid(row_valid),
    .m_word_ready(row_moves_q),
    .m_word_data (row)
  );
  `FFD_ASSERT(a_row_begins_and_the_queue_is_full, !(go && first_q) || row_ready)
  `FFD_ASSERT(a_layer_is_offered_of_no_row, !moves_q || row_valid)

  // ---- weights of s, and the parts of the four banks of s

  wire [4*WEIGHT_W-1:0] evaluated;
  wire [3*WEIGHT_W-1:0] weights;
  wire                  whole;
  wire [3*W-1:0]        gradient;
  wire                  gradient_saturated;
  wire                  earlier_saturated;
  wire [2:0]            part_saturated;
  wire [3*4*PART_W-1:0] parts;       // {z, y, x}, each that of bank 0 lowest

  ffd_eval_axis_weights #(
    .AFFINE         (1),
    .FORMAT         (FORMAT),
    .EVALUATOR      (EVALUATOR),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (0),
    .CONVERT_LATENCY(`FFD_SCATTER_CONVERT_LATENCY),
    .SPANS          (1)
  ) u_axis (
    .clk           (clk),
    .load_i        (load_i && load_axis_i == 2'd0),
    .load_axis_i   (load_axis_i),
    .load_address_i(load_address_i),
    .load_entry_i  (load_entry_i),
    .start_i       (1'b1),
    .axis_i        (2'd0),
    .coordinate_i  (s_q),
    .residue_i     (i_q[1:0]),
    .bank_i        (bank_q),
    .weights_o     (evaluated)
  );

  ffd_scatter_cumulative #(
    .FORMAT     (FORMAT),
    .ADD_LATENCY(ADD_LATENCY)
  ) u_cumulative (
    .clk      (clk),
    .weights_i(evaluated),
    .sums_o   (weights),
    .whole_o  (whole)
  );

  ffd_num_delay #(
    .WIDTH  (1 + 3 * W),
    .LATENCY(WEIGHTS)
  ) u_gradient (
    .clk(clk),
    .rst(1'b0),
    .d_i({saturated_q, gradient_q}),
    .q_o({gradient_saturated, gradient})
  );

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(EXPAND)
  ) u_earlier (
    .clk(clk),
    .rst(1'b0),
    .d_i(gradient_saturated || weights[3*WEIGHT_W-1]),
    .q_o(earlier_saturated)
  );

  genvar c;
  generate
    for (c = 0; c < 3; c = c + 1) begin : gen_component
      ffd_scatter_expand #(
        .FORMAT     (FORMAT),
        .MUL_LATENCY(MUL_LATENCY),
        .ADD_LATENCY(ADD_LATENCY)
      ) u_expand (
        .clk        (clk),
        .weights_i  (weights),
        .whole_i    (whole),
        .part_i     ({gradient[(c+1)*W-1], gradient[c*W +: W]}),
        .parts_o    (parts[4*c*PART_W +: 4*PART_W]),
        .saturated_o(part_saturated[c])
      );
      `FFD_ASSERT_TAKES(u_expand, EXPAND)
    end
  endgenerate

  // ---- what is known of the vertex comes with them

  wire       there;
  wire       last_there;
  wire [3:0] opens_there;

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(WEIGHTS + EXPAND),
    .RESET  (1)
  ) u_valid (
    .clk(clk),
    .rst(rst),
    .d_i(go),
    .q_o(there)
  );

  ffd_num_delay #(
    .WIDTH  (PAGE_W + 1 + 4 + AXIS_W),
    .LATENCY(WEIGHTS + EXPAND)
  ) u_vertex (
    .clk(clk),
    .rst(1'b0),
    .d_i({row_q[ROW_W-1 -: PAGE_W], last_q, opens_q, i_q}),
    .q_o({added_page_o, last_there, opens_there, i_there})
  );

  assign added_o           = there;
  assign added_saturated_o = earlier_saturated || (|part_saturated);

  // ---- a layer of each bank: the registers have those of a row, which may have ended

  reg  open_q;
  reg  ended_q;
  always @(posedge clk) begin
    if (rst) begin
      open_q <= 1'b0;
      ended_q    <= 1'b0;
    end else begin
      open_q <= there || (open_q && !ended_q);
      ended_q    <= there && last_there;
    end
  end

  // Layers of the oldest row go first: banks that have given its last one wait for the others. One
  // is chosen where it will have room, and moves in the next clock.
  wire [4*LAYER_W-1:0] layers;
  wire [3:0]           queued;
  wire [3:0]           ends;       // the row's last of that bank
  reg  [3:0]           done_q;
  reg  [3:0]           chosen_q;   // the one that moves, or none
  reg                  offered_q;
  wire [3:0]           wants    = queued & ~done_q;
  wire                 choose   = !moves_q && (!offered_q || m_layer_ready);
  wire [3:0]           done     = done_q | (chosen_q & ends);
  wire                 ends_row = done == 4'b1111;

  assign m_layer_valid = offered_q;

  always @(posedge clk) begin
    if (rst) begin
      chosen_q    <= 4'd0;
      moves_q     <= 1'b0;
      row_moves_q <= 1'b0;
      offered_q   <= 1'b0;
      done_q      <= 4'd0;
    end else begin
      chosen_q    <= wants & (~wants + 4'd1) & {4{choose}};
      moves_q     <= choose && wants != 4'd0;
      row_moves_q <= ends_row;
      offered_q   <= moves_q || (offered_q && !m_layer_ready);
      done_q      <= done & {4{!ends_row}};
    end
  end

  generate
    for (b = 0; b < 4; b = b + 1) begin : gen_bank
      reg  [COUNT_W-1:0]  ahead_q;    // layers that are open or queued
      reg  [HIGH_W-1:0]   high_q;
      reg  [3*WIDE_W-1:0] sums_q;
      wire                queue_ready;
      wire                opens = go && opens_q[b];
      wire                takes = chosen_q[b];
      wire                sends = open_q && (ended_q || (there && opens_there[b]));

      assign full[b] = (ahead_q[COUNT_W-1] || (opens && &ahead_q[COUNT_W-2:0])) && !takes;
      assign ends[b] = layers[(b+1)*LAYER_W-1];

      always @(posedge clk) begin
        if (rst) ahead_q <= {COUNT_W{1'b0}};
        else if (opens && !takes) ahead_q <= ahead_q + 1'b1;
        else if (takes && !opens) ahead_q <= ahead_q - 1'b1;
      end

      always @(posedge clk) begin
        if (there && opens_there[b]) high_q <= highs_there[b*HIGH_W +: HIGH_W];
      end
      for (c = 0; c < 3; c = c + 1) begin : gen_sum
        wire [PART_W-1:0] part = parts[(4*c+b)*PART_W +: PART_W];
        wire [WIDE_W-1:0] sum  = sums_q[c*WIDE_W +: WIDE_W] & {WIDE_W{!opens_there[b]}};
        always @(posedge clk) begin
          if (there) begin
            sums_q[c*WIDE_W +: WIDE_W] <= sum + {{(WIDE_W - PART_W) {part[PART_W-1]}}, part};
          end
        end
      end

      ffd_stream_queue #(
        .WIDTH(LAYER_W),
        .DEPTH(DEPTH)
      ) u_queue (
        .clk         (clk),
        .rst         (rst),
        .s_word_valid(sends),
        .s_word_ready(queue_ready),
        .s_word_data ({ended_q, high_q, sums_q}),
        .m_word_valid(queued[b]),
        .m_word_ready(takes),
        .m_word_data (layers[b*LAYER_W +: LAYER_W])
      );
      `FFD_ASSERT(a_layer_comes_and_its_queue_is_full, !sends || queue_ready)
      `FFD_ASSERT(more_layers_have_left_than_were_opened, !takes || ahead_q != {COUNT_W{1'b0}})
      wire unused_ok = &{1'b0, queue_ready};
    end
  endgenerate

  // ---- the one that is offered

  // (An index that is computed would be given a multiplier.)
  wire [LAYER_W-1:0] layer = (layers[0*LAYER_W +: LAYER_W] & {LAYER_W{chosen_q[0]}})
                           | (layers[1*LAYER_W +: LAYER_W] & {LAYER_W{chosen_q[1]}})
                           | (layers[2*LAYER_W +: LAYER_W] & {LAYER_W{chosen_q[2]}})
                           | (layers[3*LAYER_W +: LAYER_W] & {LAYER_W{chosen_q[3]}});
  reg  [LAYER_W-1:0] layer_q;
  reg  [1:0]         residue_q;
  reg  [ROW_W-1:0]   layer_row_q;
  reg                ends_row_q;
  wire [AXIS_W-1:0]  i_layer;
  always @(posedge clk) begin
    if (moves_q) begin
      layer_q     <= layer;
      residue_q   <= {chosen_q[3] || chosen_q[2], chosen_q[3] || chosen_q[1]};
      layer_row_q <= row;
      ends_row_q  <= ends_row;
    end
  end
  assign i_layer[HIGH_W+1:0] = {layer_q[3*WIDE_W +: HIGH_W], residue_q};
  generate
    if (AXIS_W > HIGH_W + 2) begin : gen_above
      assign i_layer[AXIS_W-1:HIGH_W+2] = {(AXIS_W - HIGH_W - 2) {1'b0}};
    end
  endgenerate

  assign m_layer_sums        = layer_q[0 +: 3*WIDE_W];
  assign m_layer_coordinates = layer_row_q[0 +: 2*WEIGHT_W];
  assign m_layer_cell        = {layer_row_q[2*WEIGHT_W +: 2*AXIS_W], i_layer};
  assign m_layer_bank        = layer_row_q[2*WEIGHT_W+2*AXIS_W +: 2*PLACE_W];
  assign m_layer_page        = layer_row_q[ROW_W-1 -: PAGE_W];
  assign m_layer_last        = ends_row_q;

  wire unused_ok = &{1'b0, row_ready, row_valid, layer_q[LAYER_W-1]};
endmodule

`default_nettype wire
