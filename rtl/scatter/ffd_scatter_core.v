// ffd_scatter_core: adds gradients of vertices up at the control points that made them
//
//   G[i+l][j+m][k+n] += g B_l(s) B_m(t) B_n(u)        l, m, n = 0..3
//
// The transpose of `affine` folded by three (docs/numerics.md section 11): a component of a vertex
// a clock is expanded into 64 parts, one for each bank of sums (ffd_scatter_sums). A page is a
// lattice of sums; pages are read out, and left zero, by a collect, and made zero by a begin.
//
// With ROWS 1 vertices come in rows, and what has a slot of three clocks is not a vertex but a
// layer of a row (ffd_scatter_rows): a component a clock is expanded into the 16 parts of the banks
// of that layer. A row takes as many clocks as it has vertices, or three for each layer, whichever
// is more.
//
// Formats:    fxW only, W 12 to 18. Coordinates {u, t, s} as weights, cell {k, j, i}, gradient
//             {z, y, x} as points; words of a collect of 32 bits, {z, y, x}.
// Rounding:   that of ffd_scatter_expand and ffd_scatter_collect, half up. Sums are exact modulo
//             2^35: 2^(34-W) vertices of a page fit, whatever they are.
// Pipeline:   a vertex every third clock: vertex | FFD_SCATTER_WEIGHTS_LATENCY: weights of s,
//             gradient | 3 FFD_SCATTER_EXPAND_LATENCY: parts | 1 | sums. added_o and left_o come
//             FFD_SCATTER_ADDED_LATENCY clocks after the vertex. With ROWS this is the way of a
//             layer, along t and u; added_o is that of ffd_scatter_rows, and left_o comes with a
//             row's last layer.
// Freezes:    nothing inside ever stops. s_vertex_ready is 1 in one of three clocks; in one of six
//             after a vertex while a collect wants a slot; 0 while sums are cleared after reset.
//             With ROWS that is so of layers, and s_vertex_ready is 1 where ffd_scatter_rows has
//             room. A collect asks for no slots while 8 of its points wait for m_word_ready.
// Sweeps:     sweeping_o is 1 from the clock after reset or begin_i on, for 3 clocks a place and
//             those of vertices and points, which go first.
// Idle:       no vertex, no collect, no word is inside, no sweep under way.
// Bad input:  by FFD_ASSERTIONS: a begin during a sweep, or of a page that has a vertex inside or
//             is collected; a collect of a page that has a vertex inside; a vertex of a page that
//             is collected; a vertex whose s_vertex_along is not what s_vertex_bank says. Not
//             checked: cells and pages beyond the last. Functions before they are loaded are any.
//             A begin, a collect or a reload of functions in the middle of a row is not checked.
// Parameters: FORMAT 12 to 18; EVALUATOR pipelined or powers; latencies >= 1; AXIS 4 to 64;
//             PAGES >= 1. Parts of it look at them. ROWS 0 or 1.
// Model:      golden/include/hwffd/model/scatter.hpp.  Test: tests/scatter.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"
`include "ffd_scatter.vh"

module ffd_scatter_core #(
  parameter FORMAT      = 17,
  parameter EVALUATOR   = `FFD_EVALUATOR_PIPELINED,
  parameter MUL_LATENCY = 4,
  parameter ADD_LATENCY = 1,
  parameter AXIS        = 16,
  parameter PAGES       = 2,
  parameter ROWS        = 0,
  parameter AXIS_W      = `FFD_AXIS_W(AXIS),
  parameter PAGE_W      = `FFD_PAGE_NUMBER_W(PAGES)
) (
  input  wire                                            clk,
  input  wire                                            rst,

  input  wire                                            load_i,
  input  wire [1:0]                                      load_axis_i,
  input  wire [`FFD_OWN_W(1)-1:0]                        load_address_i,
  input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,

  // A vertex, and what it is the gradient of: along is 0 of the position, 1 to 3 of a derivative.
  input  wire                                            s_vertex_valid,
  output wire                                            s_vertex_ready,
  input  wire [3*`FFD_WEIGHT_W(FORMAT)-1:0]              s_vertex_coordinates,
  input  wire [3*AXIS_W-1:0]                             s_vertex_cell,
  input  wire [3*`FFD_PLACE_W(1)-1:0]                    s_vertex_bank,
  input  wire [1:0]                                      s_vertex_along,
  input  wire [PAGE_W-1:0]                               s_vertex_page,
  input  wire [3*`FFD_POINT_W(FORMAT)-1:0]               s_vertex_gradient,
  input  wire                                            s_vertex_saturated,
  input  wire                                            s_vertex_last,  // of its row

  // For a clock, of each vertex in order: it has added, to a page or to its row.
  output wire                                            added_o,
  output wire [PAGE_W-1:0]                               added_page_o,
  output wire                                            added_saturated_o,
  // For a clock, of each vertex or each row in order: all it adds is in the sums.
  output wire                                            left_o,
  // For a clock, of a layer that saturated.
  output wire                                            layer_saturated_o,
  output wire [PAGE_W-1:0]                               layer_page_o,

  input  wire                                            begin_i,
  input  wire [PAGE_W-1:0]                               begin_page_i,
  output wire                                            sweeping_o,

  input  wire                                            s_collect_valid,
  output wire                                            s_collect_ready,
  input  wire [PAGE_W-1:0]                               s_collect_page,
  input  wire [1:0]                                      s_collect_shift,
  input  wire [3*AXIS_W-1:0]                             s_collect_tops,
  output wire                                            collecting_o,
  output wire [PAGE_W-1:0]                               collecting_page_o,

  output wire                                            m_word_valid,
  input  wire                                            m_word_ready,
  output wire [95:0]                                     m_word_data,
  output wire                                            m_word_saturated,
  output wire                                            m_word_last,

  output wire                                            idle_o
);
  localparam W        = `FFD_FIXED_W(FORMAT);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam PLACE_W  = `FFD_PLACE_W(1);
  localparam AXES     = `FFD_SCATTER_AXES(ROWS);
  localparam PART_W   = ROWS == 0 ? `FFD_PART_W(FORMAT) : `FFD_WIDE_W;
  localparam VALUE_W  = ROWS == 0 ? W : `FFD_WIDE_W;  // of a component that is expanded
  localparam BANKS    = 1 << (2 * AXES);              // that have a part of it
  localparam WEIGHTS  = `FFD_SCATTER_WEIGHTS_LATENCY(EVALUATOR, MUL_LATENCY, ADD_LATENCY);
  localparam EXPAND   = `FFD_SCATTER_EXPAND_LATENCY(ROWS, MUL_LATENCY, ADD_LATENCY);
  // Clocks from the first step of what is held to where it asks for its slot: its parts come with
  // the words that the slot reads. That clock is of component 2, which says what the first after
  // reset is of.
  localparam SLOT     = WEIGHTS + AXES * EXPAND - 3;
  localparam FIRST    = (2 + 2 * SLOT) % 3;
  // From the slot's last component to its sum in memory.
  localparam WRITTEN  = 4;
  `FFD_TAKES(`FFD_SCATTER_ADDED_LATENCY(ROWS, EVALUATOR, MUL_LATENCY, ADD_LATENCY))

  generate
    if (ROWS != 0 && ROWS != 1) begin : gen_bad_rows
      ERROR_ffd_scatter_core_rows_must_be_0_or_1 u_error ();
    end
  endgenerate

  // ---- what is given slots: a vertex, or a layer of a row. Its axes, the lowest first, are those
  // along which it is expanded: s, t, u, or t, u and one that nobody looks at.

  wire                  item_valid;
  wire                  item_ready;
  wire [3*WEIGHT_W-1:0] item_coordinates;
  wire [5:0]            item_residues;
  wire [3*PLACE_W-1:0]  item_bank;
  wire [3*AXIS_W-1:0]   item_cell;
  wire [PAGE_W-1:0]     item_page;
  wire [3*VALUE_W-1:0]  item_values;
  wire                  item_saturated;
  wire                  item_last;        // nothing inside is of the same vertex or row
  wire [1:0]            item_load_axis;
  wire                  written;          // it is in the sums
  wire [PAGE_W-1:0]     written_page;
  wire                  written_saturated;
  wire                  written_last;

  generate
    if (ROWS == 0) begin : gen_vertices
      assign item_valid       = s_vertex_valid;
      assign s_vertex_ready   = item_ready;
      assign item_coordinates = s_vertex_coordinates;
      assign item_residues    = {s_vertex_cell[2*AXIS_W +: 2], s_vertex_cell[AXIS_W +: 2],
                                 s_vertex_cell[0 +: 2]};
      assign item_bank        = s_vertex_bank;
      assign item_cell        = s_vertex_cell;
      assign item_page        = s_vertex_page;
      assign item_values      = {s_vertex_gradient[2*POINT_W +: W],
                                 s_vertex_gradient[1*POINT_W +: W],
                                 s_vertex_gradient[0*POINT_W +: W]};
      assign item_saturated   = s_vertex_saturated || s_vertex_gradient[2*POINT_W+W]
                                || s_vertex_gradient[1*POINT_W+W] || s_vertex_gradient[0*POINT_W+W];
      assign item_last        = 1'b1;
      assign item_load_axis   = load_axis_i;

      assign added_o           = written;
      assign added_page_o      = written_page;
      assign added_saturated_o = written_saturated;
      assign layer_saturated_o = 1'b0;
      wire unused_ok = &{1'b0, s_vertex_last};
    end else begin : gen_rows
      wire [2*WEIGHT_W-1:0] coordinates;
      wire [2*PLACE_W-1:0]  bank;

      ffd_scatter_rows #(
        .FORMAT     (FORMAT),
        .EVALUATOR  (EVALUATOR),
        .MUL_LATENCY(MUL_LATENCY),
        .ADD_LATENCY(ADD_LATENCY),
        .AXIS       (AXIS),
        .PAGE_W     (PAGE_W)
      ) u_rows (
        .clk                 (clk),
        .rst                 (rst),
        .load_i              (load_i),
        .load_axis_i         (load_axis_i),
        .load_address_i      (load_address_i),
        .load_entry_i        (load_entry_i),
        .s_vertex_valid      (s_vertex_valid),
        .s_vertex_ready      (s_vertex_ready),
        .s_vertex_coordinates(s_vertex_coordinates),
        .s_vertex_cell       (s_vertex_cell),
        .s_vertex_bank       (s_vertex_bank),
        .s_vertex_page       (s_vertex_page),
        .s_vertex_gradient   (s_vertex_gradient),
        .s_vertex_saturated  (s_vertex_saturated),
        .s_vertex_last       (s_vertex_last),
        .added_o             (added_o),
        .added_page_o        (added_page_o),
        .added_saturated_o   (added_saturated_o),
        .m_layer_valid       (item_valid),
        .m_layer_ready       (item_ready),
        .m_layer_coordinates (coordinates),
        .m_layer_cell        (item_cell),
        .m_layer_bank        (bank),
        .m_layer_page        (item_page),
        .m_layer_sums        (item_values),
        .m_layer_last        (item_last)
      );

      assign item_coordinates = {{WEIGHT_W{1'b0}}, coordinates};
      assign item_residues    = {2'd0, item_cell[2*AXIS_W +: 2], item_cell[AXIS_W +: 2]};
      assign item_bank        = {{PLACE_W{1'b0}}, bank};
      assign item_saturated   = 1'b0;
      assign item_load_axis   = load_axis_i == 2'd0 ? 2'd2 : load_axis_i - 2'd1;

      assign layer_saturated_o = written && written_saturated;
    end
  endgenerate
  assign layer_page_o = written_page;
  assign left_o       = written && written_last;

  // ---- it stays for three steps, of an axis and of a component each

  reg  [1:0]            step_q;
  reg                   ready_q;
  reg                   held_q;
  reg  [3*WEIGHT_W-1:0] coordinates_q;
  reg  [5:0]            residues_q;
  reg  [3*AXIS_W-1:0]   cell_q;
  reg  [3*PLACE_W-1:0]  bank_q;
  reg  [PAGE_W-1:0]     page_q;
  reg  [3*VALUE_W-1:0]  values_q;
  reg                   saturated_q;
  reg                   last_q;
  wire                  clearing;
  wire                  point_valid;
  wire                  last_step = step_q == 2'd2;
  wire                  enter     = s_vertex_valid && s_vertex_ready;

  assign item_ready = ready_q;

  always @(posedge clk) begin
    if (rst) step_q <= 2'd0;
    else step_q <= last_step ? 2'd0 : step_q + 2'd1;
  end
  always @(posedge clk) begin
    if (rst) ready_q <= 1'b0;
    else ready_q <= step_q == 2'd1 && !clearing && !(held_q && point_valid);
  end
  always @(posedge clk) begin
    if (rst) held_q <= 1'b0;
    else if (last_step) held_q <= item_valid && item_ready;
  end
  always @(posedge clk) begin
    if (last_step) begin
      coordinates_q <= item_coordinates;
      residues_q    <= item_residues;
      cell_q        <= item_cell;
      bank_q        <= item_bank;
      page_q        <= item_page;
      values_q      <= item_values;
      saturated_q   <= item_saturated;
      last_q        <= item_last;
    end
  end

  // ---- its weights, and its parts

  wire [9*WEIGHT_W-1:0]     weights;
  wire [2:0]                whole;
  wire                      weights_saturated;
  wire                      of_axis;          // the step is one of an axis that is expanded
  wire                      item_flag;
  wire [VALUE_W-1:0]        value;
  wire [PART_W-1:0]         part;
  wire [BANKS*PART_W-1:0]   parts;
  wire                      parts_saturated;

  ffd_scatter_weights #(
    .FORMAT     (FORMAT),
    .EVALUATOR  (EVALUATOR),
    .MUL_LATENCY(MUL_LATENCY),
    .ADD_LATENCY(ADD_LATENCY),
    .DISTANCE   (EXPAND)
  ) u_weights (
    .clk           (clk),
    .load_i        (load_i),
    .load_axis_i   (item_load_axis),
    .load_address_i(load_address_i),
    .load_entry_i  (load_entry_i),
    .step_i        (step_q),
    .coordinates_i (coordinates_q),
    .residues_i    (residues_q),
    .bank_i        (bank_q),
    .weights_o     (weights),
    .whole_o       (whole),
    .saturated_o   (weights_saturated)
  );
  `FFD_ASSERT_TAKES(u_weights, WEIGHTS)

  ffd_num_delay #(
    .WIDTH  (2 + VALUE_W),
    .LATENCY(WEIGHTS)
  ) u_value (
    .clk(clk),
    .rst(1'b0),
    .d_i({saturated_q, AXES == 3 || !last_step,
          step_q == 2'd0 ? values_q[0*VALUE_W +: VALUE_W] :
          step_q == 2'd1 ? values_q[1*VALUE_W +: VALUE_W] : values_q[2*VALUE_W +: VALUE_W]}),
    .q_o({item_flag, of_axis, value})
  );

  // A gradient is a part.
  assign part = {{(PART_W - VALUE_W + 1) {value[VALUE_W-1]}}, value[VALUE_W-2:0]};

  ffd_scatter_parts #(
    .ROWS       (ROWS),
    .FORMAT     (FORMAT),
    .MUL_LATENCY(MUL_LATENCY),
    .ADD_LATENCY(ADD_LATENCY)
  ) u_parts (
    .clk        (clk),
    .weights_i  (weights[3*AXES*WEIGHT_W-1:0]),
    .whole_i    (whole[AXES-1:0]),
    .gradient_i (part),
    .saturated_i((weights_saturated && of_axis) || item_flag),
    .parts_o    (parts),
    .saturated_o(parts_saturated)
  );
  `FFD_ASSERT_TAKES(u_parts, AXES * EXPAND)

  // ---- its slot, or another's

  wire                vertex_valid;
  wire [PAGE_W-1:0]   vertex_page;
  wire [3*AXIS_W-1:0] vertex_cell;
  wire                vertex_last;
  wire [PAGE_W-1:0]   point_page;
  wire [3*AXIS_W-1:0] point_cell;
  wire                point_take;
  wire                sweeping;
  wire [PAGE_W-1:0]   sweep_page;
  wire [3*AXIS_W-1:0] sweep_cell;
  wire                sweep_take;
  wire [(1<<PAGE_W)-1:0] epochs;
  wire                slot_valid;
  wire                slot_vertex;
  wire                slot_point;
  wire                slot_sweep;
  wire [1:0]          slot_component;  // 0 to 2
  wire                slot_third = slot_component[1];
  wire [PAGE_W-1:0]   slot_page;
  wire [3*AXIS_W-1:0] slot_cell;
  wire                slot_last;
  wire                collect_idle;
  wire [`FFD_SCATTER_WORD_W-1:0] word;

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(SLOT),
    .RESET  (1)
  ) u_vertex_valid (
    .clk(clk),
    .rst(rst),
    .d_i(held_q),
    .q_o(vertex_valid)
  );

  ffd_num_delay #(
    .WIDTH  (1 + PAGE_W + 3 * AXIS_W),
    .LATENCY(SLOT)
  ) u_vertex (
    .clk(clk),
    .rst(1'b0),
    .d_i({last_q, page_q, cell_q}),
    .q_o({vertex_last, vertex_page, vertex_cell})
  );

  ffd_scatter_slots #(
    .CELL_W(1 + 3 * AXIS_W),
    .PAGE_W(PAGE_W),
    .FIRST (FIRST)
  ) u_slots (
    .clk             (clk),
    .rst             (rst),
    .vertex_valid_i  (vertex_valid),
    .vertex_page_i   (vertex_page),
    .vertex_cell_i   ({vertex_last, vertex_cell}),
    .point_valid_i   (point_valid),
    .point_page_i    (point_page),
    .point_cell_i    ({1'b0, point_cell}),
    .point_take_o    (point_take),
    .sweep_valid_i   (sweeping),
    .sweep_clear_i   (clearing),
    .sweep_page_i    (sweep_page),
    .sweep_cell_i    ({1'b0, sweep_cell}),
    .sweep_take_o    (sweep_take),
    .slot_valid_o    (slot_valid),
    .slot_vertex_o   (slot_vertex),
    .slot_point_o    (slot_point),
    .slot_sweep_o    (slot_sweep),
    .slot_component_o(slot_component),
    .slot_page_o     (slot_page),
    .slot_cell_o     ({slot_last, slot_cell})
  );

  ffd_scatter_sweep #(
    .AXIS (AXIS),
    .PAGES(PAGES)
  ) u_sweep (
    .clk         (clk),
    .rst         (rst),
    .begin_i     (begin_i),
    .begin_page_i(begin_page_i),
    .epochs_o    (epochs),
    .sweeping_o  (sweeping),
    .clearing_o  (clearing),
    .page_o      (sweep_page),
    .cell_o      (sweep_cell),
    .take_i      (sweep_take)
  );
  assign sweeping_o = sweeping;

  // The epoch of the slot's page is that of the slot's first clock.
  reg  epoch_q;
  wire slot_epoch = slot_component == 2'd0 ? epochs[slot_page] : epoch_q;
  always @(posedge clk) epoch_q <= slot_epoch;

  ffd_scatter_sums #(
    .ROWS  (ROWS),
    .FORMAT(FORMAT),
    .AXIS  (AXIS),
    .PAGES (PAGES)
  ) u_sums (
    .clk             (clk),
    .rst             (rst),
    .slot_valid_i    (slot_valid),
    .slot_vertex_i   (slot_vertex),
    .slot_sweep_i    (slot_sweep),
    .slot_point_i    (slot_point),
    .slot_component_i(slot_component),
    .slot_page_i     (slot_page),
    .slot_epoch_i    (slot_epoch),
    .slot_cell_i     (slot_cell),
    .parts_i         (parts),
    .word_o          (word)
  );
  `FFD_ASSERT_TAKES(u_sums, `FFD_SCATTER_READ_LATENCY)

  ffd_scatter_collect #(
    .AXIS  (AXIS),
    .PAGE_W(PAGE_W)
  ) u_collect (
    .clk             (clk),
    .rst             (rst),
    .hold_i          (clearing),
    .s_collect_valid (s_collect_valid),
    .s_collect_ready (s_collect_ready),
    .s_collect_page  (s_collect_page),
    .s_collect_shift (s_collect_shift),
    .s_collect_tops  (s_collect_tops),
    .collecting_o    (collecting_o),
    .page_o          (point_page),
    .point_valid_o   (point_valid),
    .point_cell_o    (point_cell),
    .point_take_i    (point_take),
    .slot_point_i    (slot_valid && slot_point),
    .slot_third_i    (slot_third),
    .slot_epoch_i    (slot_epoch),
    .word_i          (word),
    .m_word_valid    (m_word_valid),
    .m_word_ready    (m_word_ready),
    .m_word_data     (m_word_data),
    .m_word_saturated(m_word_saturated),
    .m_word_last     (m_word_last),
    .idle_o          (collect_idle)
  );
  assign collecting_page_o = point_page;

  // ---- it is written; what saturated of its three components is known a clock before

  reg [2:0] parts_saturated_q;
  reg       written_saturated_q;
  always @(posedge clk) begin
    parts_saturated_q   <= {parts_saturated, parts_saturated_q[2:1]};
    written_saturated_q <= |parts_saturated_q;
  end
  assign written_saturated = written_saturated_q;

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(WRITTEN),
    .RESET  (1)
  ) u_written (
    .clk(clk),
    .rst(rst),
    .d_i(slot_valid && slot_vertex && slot_third),
    .q_o(written)
  );

  ffd_num_delay #(
    .WIDTH  (1 + PAGE_W),
    .LATENCY(WRITTEN)
  ) u_written_page (
    .clk(clk),
    .rst(1'b0),
    .d_i({slot_last, slot_page}),
    .q_o({written_last, written_page})
  );

  // Vertices or rows inside: a row comes with its last vertex.
  localparam               MOST    = `FFD_SCATTER_MOST(ROWS, EVALUATOR, MUL_LATENCY, ADD_LATENCY);
  localparam               COUNT_W = $clog2(MOST + 1);
  localparam [COUNT_W-1:0] NONE    = 0;
  reg  [COUNT_W-1:0]       inside_q;
  reg                      within_q;  // a row of which the last vertex has not come
  wire                     comes = enter && (ROWS == 0 || s_vertex_last);
  always @(posedge clk) begin
    if (rst) inside_q <= NONE;
    else if (comes && !left_o) inside_q <= inside_q + 1'b1;
    else if (left_o && !comes) inside_q <= inside_q - 1'b1;
  end
  always @(posedge clk) begin
    if (rst) within_q <= 1'b0;
    else if (enter) within_q <= !comes;
  end
  assign idle_o = inside_q == NONE && !within_q && !sweeping && collect_idle;

`ifdef FFD_ASSERTIONS
  wire [2:0] derivative = {s_vertex_bank[2*PLACE_W+1], s_vertex_bank[PLACE_W+1], s_vertex_bank[1]};
  wire [3:0] along      = 4'd1 << s_vertex_along;  // that of none lowest
  `FFD_ASSERT(a_vertex_says_two_things_of_its_derivative,
              !enter || {derivative, derivative == 3'd0} == along)
  `FFD_ASSERT(a_vertex_comes_of_a_page_that_is_collected,
              !(enter && collecting_o) || s_vertex_page != point_page)
  `FFD_ASSERT(a_page_begins_that_is_collected,
              !(begin_i && collecting_o) || begin_page_i != point_page)
  `FFD_ASSERT(more_vertices_are_inside_than_are_counted, !(comes && !left_o) || !(&inside_q))
  `FFD_ASSERT(more_vertices_have_left_than_came, !left_o || inside_q != NONE)

  genvar p;
  generate
    for (p = 0; p < PAGES; p = p + 1) begin : gen_inside
      localparam [PAGE_W-1:0] PAGE = p;
      reg  [COUNT_W-1:0] count_q;
      wire               own  = comes && s_vertex_page == PAGE;
      wire               goes = left_o && layer_page_o == PAGE;
      always @(posedge clk) begin
        if (rst) count_q <= NONE;
        else if (own && !goes) count_q <= count_q + 1'b1;
        else if (goes && !own) count_q <= count_q - 1'b1;
      end
      `FFD_ASSERT(a_page_begins_that_has_a_vertex_inside,
                  !begin_i || begin_page_i != PAGE || count_q == NONE)
      `FFD_ASSERT(a_page_is_collected_that_has_a_vertex_inside,
                  !(s_collect_valid && s_collect_ready) || s_collect_page != PAGE
                  || (count_q == NONE && !own))
    end
  endgenerate
`endif

  wire unused_ok = &{1'b0, s_vertex_along, weights, whole};
endmodule

`default_nettype wire
