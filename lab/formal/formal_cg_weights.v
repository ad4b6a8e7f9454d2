// formal_cg_weights: a combination is made of the three weights of its step and of its vertex
//
// What stands in for the summation shows what it is given. Tokens follow which weight is where: on
// its way from the polynomials to its bank, or in the bank. Of each vertex inside it is known what
// entered (known_q), and the assertion says where it is: its set is the one given out as many
// vertices ago as have entered since, no two have one set, and all of its weights that have come
// out of the polynomials are in its set's banks. It holds in the next clock if it holds in this one.
//
// Abstractions: arithmetic is cut away; a polynomial takes four clocks, the fewest that there are.
// Stand-ins: tokens.v model_memory.v model_summation.v
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module formal_cg_weights #(
  parameter SIZE = 1
) (
  input wire        clk,
  input wire        rst,
  input wire        want_vertex,
  input wire        colour,
  input wire [11:0] cell_index
);
  localparam              POLYNOMIALS = 12 / SIZE;
  localparam              FILL_W      = $clog2(POLYNOMIALS);
  localparam              TOP         = POLYNOMIALS - 1;
  localparam [FILL_W-1:0] LAST        = TOP[FILL_W-1:0];
  localparam              LATENCY     = 4;
  localparam              AHEAD       = LATENCY - 1;  // where a full set is announced
  localparam              SETS        = 3;

  // ---- a vertex, {cell, colour}, and what is made of it

  wire [12:0] entering = {cell_index, colour};

  function [26:0] coordinates_of(input [12:0] vertex);
    coordinates_of = {4'd0, vertex[10:9], 2'd2, vertex[0], 4'd0, vertex[6:5], 2'd1, vertex[0],
                      4'd0, vertex[2:1], 2'd0, vertex[0]};
  endfunction

  function [8:0] weight_of_bank(input [12:0] vertex, input [1:0] axis, input [1:0] index);
    weight_of_bank = {1'b1, vertex[0], 1'b0, axis, 2'd0, index};
  endfunction

  // A place is {axis, function}.
  function [8:0] weight_of(input [12:0] vertex, input [3:0] place);
    weight_of = weight_of_bank(vertex, place[3:2], place[1:0]
                               + (place[3] ? vertex[10:9] : place[2] ? vertex[6:5] : vertex[2:1]));
  endfunction

  // The set that was given out so many vertices before that one will be.
  function [1:0] before(input [1:0] set, input [2:0] vertices);
    integer n;
    begin
      before = set;
      for (n = 0; n < 7; n = n + 1) begin
        if (n < vertices) before = before == 2'd0 ? 2'd2 : before - 2'd1;
      end
    end
  endfunction

  wire         ready;
  wire         combined;
  wire [68:0]  combination;

  ffd_org_cg #(
    .SIZE           (SIZE),
    .FORMAT         (8),
    .N              (1),
    .PORTS          (1),
    .SCHEDULE       (`FFD_SCHEDULE_OVERLAPPED),
    .EVALUATOR      (`FFD_EVALUATOR_PIPELINED),
    .MUL_LATENCY    (1),
    .ADD_LATENCY    (1),
    .FMA_LATENCY    (1),
    .CONVERT_LATENCY(0),
    .READ_LATENCY   (2),
    .SOURCE_W       (1),
    .SPANS          (1)
  ) u_org (
    .clk                 (clk),
    .rst                 (rst),
    .load_i              (1'b0),
    .load_axis_i         (2'd0),
    .load_address_i      (4'd0),
    .load_entry_i        (38'd0),
    .s_vertex_valid      (want_vertex),
    .s_vertex_ready      (ready),
    .s_vertex_coordinates(coordinates_of(entering)),
    .s_vertex_cell       (cell_index),
    .s_vertex_source     (colour),
    .s_vertex_bank       ({6{colour}}),
    .s_vertex_changed    (1'b0),
    .s_vertex_second     (9'd0),
    .read_o              (),
    .read_last_o         (),
    .read_source_o       (),
    .read_cell_o         (),
    .read_index_o        (),
    .read_points_i       (27'd0),
    .result_valid_o      (combined),
    .result_sum_o        (combination),
    .result_jacobian_o   (),
    .result_second_o     ()
  );

  // ---- names of registers

  (* hierconn *) wire [1:0] \u_org.set_q ;
  (* hierconn *) wire [2:0] \u_org.used_q ;
  (* hierconn *) wire \u_org.u_fill.gen_context[0].active_q ;
  (* hierconn *) wire \u_org.u_fill.step_valid_o ;
  (* hierconn *) wire \u_org.u_fill.step_last_o ;
  (* hierconn *) wire [FILL_W-1:0] \u_org.u_fill.gen_context[0].step_q ;
  (* hierconn *) wire [47:0] \u_org.u_fill.gen_context[0].data_q ;
  (* hierconn *) wire [1:0] \u_org.u_ahead_valid.gen_stage[0].data_q ;
  (* hierconn *) wire [14:0] \u_org.u_ahead.gen_stage[0].data_q ;
  (* hierconn *) wire [1:0] \u_org.u_ahead_valid.gen_stage[1].data_q ;
  (* hierconn *) wire [14:0] \u_org.u_ahead.gen_stage[1].data_q ;
  (* hierconn *) wire [1:0] \u_org.u_ahead_valid.gen_stage[2].data_q ;
  (* hierconn *) wire [14:0] \u_org.u_ahead.gen_stage[2].data_q ;
  (* hierconn *) wire \u_org.u_weight_valid.gen_stage[0].data_q ;
  (* hierconn *) wire [1:0] \u_org.u_weight_set.gen_stage[0].data_q ;
  (* hierconn *) wire [8:0] \u_org.gen_evaluator[0].u_poly.u_weight.gen_stage[0].data_q ;
  (* hierconn *) wire [3:0] \u_org.gen_evaluator[0].u_place.gen_stage[0].data_q ;
  (* hierconn *) wire [8:0] \u_org.gen_evaluator[0].u_poly.u_weight.gen_stage[1].data_q ;
  (* hierconn *) wire [3:0] \u_org.gen_evaluator[0].u_place.gen_stage[1].data_q ;
  (* hierconn *) wire [8:0] \u_org.gen_evaluator[0].u_poly.u_weight.gen_stage[2].data_q ;
  (* hierconn *) wire [3:0] \u_org.gen_evaluator[0].u_place.gen_stage[2].data_q ;
  (* hierconn *) wire [8:0] \u_org.gen_evaluator[0].u_poly.u_weight.gen_stage[3].data_q ;
  (* hierconn *) wire [3:0] \u_org.gen_evaluator[0].u_place.gen_stage[3].data_q ;
  (* hierconn *) wire [8:0] \u_org.gen_evaluator[1].u_poly.u_weight.gen_stage[0].data_q ;
  (* hierconn *) wire [3:0] \u_org.gen_evaluator[1].u_place.gen_stage[0].data_q ;
  (* hierconn *) wire [8:0] \u_org.gen_evaluator[1].u_poly.u_weight.gen_stage[1].data_q ;
  (* hierconn *) wire [3:0] \u_org.gen_evaluator[1].u_place.gen_stage[1].data_q ;
  (* hierconn *) wire [8:0] \u_org.gen_evaluator[1].u_poly.u_weight.gen_stage[2].data_q ;
  (* hierconn *) wire [3:0] \u_org.gen_evaluator[1].u_place.gen_stage[2].data_q ;
  (* hierconn *) wire [8:0] \u_org.gen_evaluator[1].u_poly.u_weight.gen_stage[3].data_q ;
  (* hierconn *) wire [3:0] \u_org.gen_evaluator[1].u_place.gen_stage[3].data_q ;
  (* hierconn *) wire [8:0] \u_org.gen_evaluator[2].u_poly.u_weight.gen_stage[0].data_q ;
  (* hierconn *) wire [3:0] \u_org.gen_evaluator[2].u_place.gen_stage[0].data_q ;
  (* hierconn *) wire [8:0] \u_org.gen_evaluator[2].u_poly.u_weight.gen_stage[1].data_q ;
  (* hierconn *) wire [3:0] \u_org.gen_evaluator[2].u_place.gen_stage[1].data_q ;
  (* hierconn *) wire [8:0] \u_org.gen_evaluator[2].u_poly.u_weight.gen_stage[2].data_q ;
  (* hierconn *) wire [3:0] \u_org.gen_evaluator[2].u_place.gen_stage[2].data_q ;
  (* hierconn *) wire [8:0] \u_org.gen_evaluator[2].u_poly.u_weight.gen_stage[3].data_q ;
  (* hierconn *) wire [3:0] \u_org.gen_evaluator[2].u_place.gen_stage[3].data_q ;
  (* hierconn *) wire [2:0] \u_org.u_filled.write_q ;
  (* hierconn *) wire [2:0] \u_org.u_filled.read_q ;
  (* hierconn *) wire [59:0] \u_org.u_filled.u_memory.words_q ;
  (* hierconn *) wire \u_org.u_steps.gen_context[0].active_q ;
  (* hierconn *) wire \u_org.u_steps.step_valid_o ;
  (* hierconn *) wire \u_org.u_steps.step_last_o ;
  (* hierconn *) wire [5:0] \u_org.u_steps.gen_context[0].step_q ;
  (* hierconn *) wire [14:0] \u_org.u_steps.gen_context[0].data_q ;
  (* hierconn *) wire [107:0] \u_org.u_generator.gen_bank[0].u_bank.words_q ;
  (* hierconn *) wire [107:0] \u_org.u_generator.gen_bank[1].u_bank.words_q ;
  (* hierconn *) wire [107:0] \u_org.u_generator.gen_bank[2].u_bank.words_q ;

  reg first_q = 1'b1;
  always @(posedge clk) first_q <= 1'b0;
  always @* if (first_q) assume (rst);

  wire [1:0]  set  = \u_org.set_q ;
  wire [2:0]  used = \u_org.used_q ;
  reg  [12:0] known_q [0:3];
  always @(posedge clk) if (want_vertex && ready) known_q[set] <= entering;

  // ---- a vertex whose polynomials begin: {coordinates, vertex, places, set}

  wire              fill_valid = \u_org.u_fill.step_valid_o ;
  wire              fill_last  = \u_org.u_fill.step_last_o ;
  wire [FILL_W-1:0] fill       = \u_org.u_fill.gen_context[0].step_q ;
  wire [26:0]       fill_coordinates;
  wire [12:0]       fill_vertex;
  wire [5:0]        fill_places;
  wire [1:0]        fill_set;
  assign {fill_coordinates, fill_vertex, fill_places, fill_set} =
      \u_org.u_fill.gen_context[0].data_q ;

  // ---- weights on their way, by the stage; of evaluator e from 8 e on

  wire        way_valid [1:LATENCY];
  wire        way_last  [1:LATENCY];
  wire [1:0]  way_set   [1:LATENCY];
  wire [12:0] way_vertex[1:LATENCY];
  wire [3:0]  way_place [0:SIZE*8-1];
  wire [8:0]  way_weight[0:SIZE*8-1];
  assign {way_valid[1], way_last[1]} = \u_org.u_ahead_valid.gen_stage[0].data_q ;
  assign {way_set[1], way_vertex[1]} = \u_org.u_ahead.gen_stage[0].data_q ;
  assign {way_valid[2], way_last[2]} = \u_org.u_ahead_valid.gen_stage[1].data_q ;
  assign {way_set[2], way_vertex[2]} = \u_org.u_ahead.gen_stage[1].data_q ;
  assign {way_valid[3], way_last[3]} = \u_org.u_ahead_valid.gen_stage[2].data_q ;
  assign {way_set[3], way_vertex[3]} = \u_org.u_ahead.gen_stage[2].data_q ;
  assign way_valid[4]  = \u_org.u_weight_valid.gen_stage[0].data_q ;
  assign way_last[4]   = way_valid[4] && way_place[4] == LAST;
  assign way_set[4]    = \u_org.u_weight_set.gen_stage[0].data_q ;
  assign way_vertex[4] = known_q[way_set[4]];
  generate
    if (SIZE > 0) begin : gen_way_0
      assign way_weight[1] = \u_org.gen_evaluator[0].u_poly.u_weight.gen_stage[0].data_q ;
      assign way_place[1] = \u_org.gen_evaluator[0].u_place.gen_stage[0].data_q ;
      assign way_weight[2] = \u_org.gen_evaluator[0].u_poly.u_weight.gen_stage[1].data_q ;
      assign way_place[2] = \u_org.gen_evaluator[0].u_place.gen_stage[1].data_q ;
      assign way_weight[3] = \u_org.gen_evaluator[0].u_poly.u_weight.gen_stage[2].data_q ;
      assign way_place[3] = \u_org.gen_evaluator[0].u_place.gen_stage[2].data_q ;
      assign way_weight[4] = \u_org.gen_evaluator[0].u_poly.u_weight.gen_stage[3].data_q ;
      assign way_place[4] = \u_org.gen_evaluator[0].u_place.gen_stage[3].data_q ;
    end
    if (SIZE > 1) begin : gen_way_1
      assign way_weight[9] = \u_org.gen_evaluator[1].u_poly.u_weight.gen_stage[0].data_q ;
      assign way_place[9] = \u_org.gen_evaluator[1].u_place.gen_stage[0].data_q ;
      assign way_weight[10] = \u_org.gen_evaluator[1].u_poly.u_weight.gen_stage[1].data_q ;
      assign way_place[10] = \u_org.gen_evaluator[1].u_place.gen_stage[1].data_q ;
      assign way_weight[11] = \u_org.gen_evaluator[1].u_poly.u_weight.gen_stage[2].data_q ;
      assign way_place[11] = \u_org.gen_evaluator[1].u_place.gen_stage[2].data_q ;
      assign way_weight[12] = \u_org.gen_evaluator[1].u_poly.u_weight.gen_stage[3].data_q ;
      assign way_place[12] = \u_org.gen_evaluator[1].u_place.gen_stage[3].data_q ;
    end
    if (SIZE > 2) begin : gen_way_2
      assign way_weight[17] = \u_org.gen_evaluator[2].u_poly.u_weight.gen_stage[0].data_q ;
      assign way_place[17] = \u_org.gen_evaluator[2].u_place.gen_stage[0].data_q ;
      assign way_weight[18] = \u_org.gen_evaluator[2].u_poly.u_weight.gen_stage[1].data_q ;
      assign way_place[18] = \u_org.gen_evaluator[2].u_place.gen_stage[1].data_q ;
      assign way_weight[19] = \u_org.gen_evaluator[2].u_poly.u_weight.gen_stage[2].data_q ;
      assign way_place[19] = \u_org.gen_evaluator[2].u_place.gen_stage[2].data_q ;
      assign way_weight[20] = \u_org.gen_evaluator[2].u_poly.u_weight.gen_stage[3].data_q ;
      assign way_place[20] = \u_org.gen_evaluator[2].u_place.gen_stage[3].data_q ;
    end
  endgenerate

  // ---- banks by axis, in them set and function; full sets that wait, {set, vertex}

  wire [107:0] bank [0:2];
  assign bank[0] = \u_org.u_generator.gen_bank[0].u_bank.words_q ;
  assign bank[1] = \u_org.u_generator.gen_bank[1].u_bank.words_q ;
  assign bank[2] = \u_org.u_generator.gen_bank[2].u_bank.words_q ;
  wire [59:0] waiting  = \u_org.u_filled.u_memory.words_q ;
  wire [2:0]  write_at = \u_org.u_filled.write_q ;
  wire [2:0]  waits    = write_at - \u_org.u_filled.read_q ;

  // ---- the vertex whose combinations are made

  wire        step_valid = \u_org.u_steps.step_valid_o ;
  wire        step_last  = \u_org.u_steps.step_last_o ;
  wire [5:0]  step       = \u_org.u_steps.gen_context[0].step_q ;
  wire [12:0] step_vertex;
  wire [1:0]  step_set;
  assign {step_set, step_vertex} = \u_org.u_steps.gen_context[0].data_q ;

  // ---- where everything is

  wire       emitting = fill_valid && !fill_last;
  reg        ordered;      // one behind the other, each in the set of its turn
  reg        own;          // everything belongs to the vertex that entered with its set
  reg  [2:0] younger;      // vertices whose last weight is on its way behind this one
  reg  [2:0] announced;    // the same of the stage that announces
  reg        to_come;
  reg  [1:0] at;
  reg  [14:0] waiting_one;
  integer    i;
  integer    e;
  integer    k;
  integer    p;

  always @* begin
    ordered = set != 2'd3 && used <= 3'd3
           && \u_org.u_fill.gen_context[0].active_q == emitting
           && \u_org.u_steps.gen_context[0].active_q == (step_valid && !step_last)
           && (!step_valid || step_last == (step == 6'd63));
    own     = 1'b1;
    if (fill_valid) begin
      ordered = ordered && fill_last == (fill == LAST) && fill <= LAST
             && fill_set == before(set, 3'd1)
             && (fill == 0 || (way_valid[1] && way_place[1] == fill - 1'b1));
      own     = own && fill_vertex == known_q[fill_set] && fill_places == {6{fill_vertex[0]}}
             && fill_coordinates == coordinates_of(fill_vertex);
    end
    younger   = {2'd0, fill_valid && fill_last};
    announced = younger;
    for (i = 1; i <= LATENCY; i = i + 1) begin
      if (way_valid[i]) begin
        ordered = ordered && way_place[i] <= LAST && way_last[i] == (way_place[i] == LAST)
               && way_set[i] == before(set, {2'd0, emitting} + younger + {2'd0, way_last[i]});
        if (i == 1) begin
          ordered = ordered && (way_last[i] || (fill_valid && fill == way_place[i] + 1'b1));
        end else begin
          ordered = ordered && (way_last[i]
                                || (way_valid[i-1] && way_place[i-1] == way_place[i] + 1'b1));
        end
        if (i < LATENCY) begin
          ordered = ordered && (way_place[i] == 0 || (way_valid[i+1]
                                                      && way_place[i+1] == way_place[i] - 1'b1));
        end
        own = own && way_vertex[i] == known_q[way_set[i]];
        for (e = 0; e < SIZE; e = e + 1) begin
          own = own && way_place[8*e+i] == e * POLYNOMIALS + way_place[i]
             && way_weight[8*e+i] == weight_of(known_q[way_set[i]], e * POLYNOMIALS + way_place[i]);
        end
      end else begin
        ordered = ordered && !way_last[i];
      end
      younger = younger + {2'd0, way_last[i]};
      if (i <= AHEAD) announced = younger;
    end
    // Who waits, from the last that came on, and who is at its combinations.
    ordered = ordered && waits <= 3'd3 && (!way_last[LATENCY] || waits != 3'd0)
           && used == {2'd0, emitting} + announced + waits + {2'd0, step_valid};
    for (i = 0; i < 3; i = i + 1) begin
      at          = write_at[1:0] - 2'd1 - i;
      waiting_one = waiting[15*at +: 15];
      if (i < waits) begin
        ordered = ordered
               && waiting_one[14:13] == before(set, {2'd0, emitting} + announced + i + 3'd1);
        own     = own && waiting_one[12:0] == known_q[waiting_one[14:13]];
      end
    end
    if (step_valid) begin
      ordered = ordered && step_set == before(set, used);
      own     = own && step_vertex == known_q[step_set];
    end
    for (k = 0; k < SETS; k = k + 1) begin
      for (p = 0; p < 12; p = p + 1) begin
        to_come = (used != 3'd3 && set == k) || (used < 3'd2 && before(set, 3'd2) == k)
               || (used == 3'd0 && before(set, 3'd1) == k)
               || (fill_valid && fill_set == k && p % POLYNOMIALS >= fill);
        for (i = 1; i <= LATENCY; i = i + 1) begin
          to_come = to_come || (way_valid[i] && way_set[i] == k && way_place[i] == p % POLYNOMIALS);
        end
        own = own && (to_come || bank[p>>2][9*(4*k+(p&3)) +: 9] == weight_of(known_q[k], p));
      end
    end
  end

  // ---- what the summation is given: {vertex, step, weights}

  reg         late_q;
  reg  [12:0] late_vertex_q;
  reg  [5:0]  late_step_q;
  always @(posedge clk) begin
    late_q        <= step_valid && !rst;
    late_vertex_q <= step_vertex;
    late_step_q   <= step;
  end

  wire right = combination[45:0] == {late_vertex_q, late_step_q,
                                     weight_of_bank(late_vertex_q, 2'd2, late_step_q[1:0]),
                                     weight_of_bank(late_vertex_q, 2'd1, late_step_q[3:2]),
                                     weight_of_bank(late_vertex_q, 2'd0, late_step_q[5:4])};
  wire good  = ordered && own && combined == late_q && (!combined || right);

  always @* if (!first_q && !rst) begin
    if (SIZE == 1) cg1_weights: assert (good);
    if (SIZE == 3) cg3_weights: assert (good);
  end
endmodule

`default_nettype wire
