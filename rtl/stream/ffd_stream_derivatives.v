// ffd_stream_derivatives: a vertex is evaluated once, three or four times, each perhaps twice
//
// Between decoder and evaluator. By what its packet asks for (docs/interface.md section 2) a vertex
// goes on as it is, or four times with the same coordinates, cell and points: the position, then
// the derivatives along s, t and u, for which that axis takes its derivative functions; or, for det
// J alone, three times, without the position. With a
// fourth component each of them goes twice, the second time for that component alone. The vertex
// waits in the decoder until the last time.
//
// An evaluator that gives the Jacobian in one pass takes a vertex once and knows by its places,
// those of derivatives on all axes, what is wanted. Only with a fourth component it goes as often
// as elsewhere, since its results alternate with those of that component.
//
// Formats:    bank {u, t, s}, each FFD_PLACE_W; source {again, that of the decoder}: 1 where
//             the points are read once more, so that a slot is freed behind the last time; column 0
//             a result of its own, 1 to 3 a column of J, from whose three comes one result; of one
//             pass 3: det J too, 2: det J alone; user {result_final, that of the decoder}: 1 with
//             the vertex's last evaluation. The bit of source that asks for the fourth component
//             (ffd_stream.vh) becomes the one that says that this evaluation is of it.
// Pipeline:   combinational but for the count of evaluations.
// Freezes:    s_vertex_ready is 0 until the last evaluation is taken.
// Parameters: FEATURES as in ffd_stream.vh; SOURCE_W >= 3: of the decoder's source; USER_W >= 1
//             likewise; SPANS >= 1; JACOBIAN 1: of an evaluator that gives it in one pass.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module ffd_stream_derivatives #(
  parameter FEATURES = `FFD_FEATURES_USUAL,
  parameter SOURCE_W = 2,
  parameter USER_W   = 27,
  parameter SPANS    = 1,
  parameter JACOBIAN = 0
) (
  input  wire                 clk,
  input  wire                 rst,
  input  wire                 s_vertex_valid,
  output wire                 s_vertex_ready,
  input  wire [SOURCE_W-1:0]  s_vertex_source,
  input  wire [`FFD_PLACES_W(SPANS)-1:0]   s_vertex_bank,
  input  wire [1:0]           s_vertex_results,
  input  wire [USER_W-1:0]    s_vertex_user,
  output wire                 m_vertex_valid,
  input  wire                 m_vertex_ready,
  output wire [SOURCE_W:0]    m_vertex_source,
  output wire [3*`FFD_PLACE_W(SPANS)-1:0]  m_vertex_bank,
  output wire [1:0]           m_vertex_column,
  output wire                 m_vertex_fourth,
  output wire [USER_W:0]      m_vertex_user
);
  // 0 the position, 1 to 3 the derivative along s, t, u.
  reg  [1:0] part_q;
  wire       alone      = `FFD_FEATURE_DETERMINANT(FEATURES) != 0
                       && s_vertex_results == `FFD_RESULTS_ALONE;
  wire [1:0] part       = alone && part_q == 2'd0 ? 2'd1 : part_q;
  wire       position   = `FFD_FEATURE_DERIVATIVES(FEATURES) == 0
                       || s_vertex_results == `FFD_RESULTS_POSITION;
  wire       whole;  // position and derivatives at once
  wire       part_final = position || whole || part == 2'd3;
  wire       part_whole;
  wire       fourth;
  wire       result_final = part_final && part_whole;
  wire       next = m_vertex_valid && m_vertex_ready;

  always @(posedge clk) begin
    if (rst) part_q <= 2'd0;
    else if (next && part_whole) part_q <= part_final ? 2'd0 : part + 2'd1;
  end

  wire [SOURCE_W-1:0] source;
  generate
    if (`FFD_FEATURE_FOURTH(FEATURES) != 0) begin : gen_fourth
      reg fourth_q;
      always @(posedge clk) begin
        if (rst) fourth_q <= 1'b0;
        else if (next) fourth_q <= !part_whole;
      end
      assign part_whole = fourth_q || !s_vertex_source[SOURCE_W-2];
      assign whole      = JACOBIAN != 0 && !position && !s_vertex_source[SOURCE_W-2];
      assign fourth     = fourth_q;
      assign source     = {s_vertex_source[SOURCE_W-1], fourth_q, s_vertex_source[SOURCE_W-3:0]};
    end else begin : gen_no_fourth
      assign part_whole = 1'b1;
      assign whole      = JACOBIAN != 0 && !position;
      assign fourth     = 1'b0;
      assign source     = s_vertex_source;
    end
  endgenerate

  assign s_vertex_ready  = m_vertex_ready && result_final;
  assign m_vertex_valid  = s_vertex_valid;
  assign m_vertex_source = {!result_final, source};
  assign m_vertex_fourth = fourth;
  wire determinant = `FFD_FEATURE_DETERMINANT(FEATURES) != 0
                  && s_vertex_results == `FFD_RESULTS_DETERMINANT;
  assign m_vertex_column = !determinant && !alone ? 2'd0
                         : whole ? {1'b1, !alone} : part;

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      localparam [1:0] PART = a + 1;
      wire derivative = whole || part == PART;
      if (SPANS == 1) begin : gen_bank
        assign m_vertex_bank[2*a +: 2] = {derivative, s_vertex_bank};
      end else begin : gen_place
        localparam PLACE_W = `FFD_PLACE_W(SPANS);
        wire [PLACE_W-2:0] place = s_vertex_bank[(PLACE_W-1)*a +: PLACE_W-1];
        assign m_vertex_bank[PLACE_W*a +: PLACE_W] = {place[PLACE_W-2:1], derivative, place[0]};
      end
    end
  endgenerate

  assign m_vertex_user = {result_final, s_vertex_user};
endmodule

`default_nettype wire
