// ffd_stream_vertex: the beat of a vertex becomes what the evaluator takes
//
// Checks cell and coordinates, and by the mode of the packet (docs/interface.md section 2) clamps
// them into the lattice, passes them or blanks the result. A cell of the resident lattice is always
// brought inside, whatever the mode: nothing reads beyond the lattice.
//
// Formats:    coordinates {u, t, s} as stream words; results FFD_RESULTS_*;
//             user {last, blank, status, tag}, status {unloaded, truncated, outside, NaN, clamped,
//             0}.
// Pipeline:   vertex_i while the beat of a vertex is due, taken or not; an interleaved vertex waits
//             here for its points; the vertex is offered in the clock after finish_i.
// Freezes:    finish_i only while no vertex is offered, or the one that is is taken.
// Parameters: FORMAT as in ffd_num.vh, SOURCE_W >= 1.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_stream_vertex #(
  parameter FORMAT   = 18,
  parameter SOURCE_W = 2
) (
  input  wire                                clk,
  input  wire                                rst,
  input  wire                                header_i,
  input  wire                                vertex_i,
  input  wire                                finish_i,
  input  wire [127:0]                        data_i,
  input  wire                                bounded_i,
  input  wire [11:0]                         last_cell_i,
  input  wire                                truncated_i,
  input  wire                                unloaded_i,
  input  wire                                last_i,
  input  wire [SOURCE_W-1:0]                 source_i,
  input  wire                                bank_i,
  input  wire                                changed_i,
  input  wire [1:0]                          results_i,
  input  wire [`FFD_EXPONENT_W-1:0]          exponent_i,
  output wire [11:0]                         cell_o,
  output reg                                 m_vertex_valid,
  input  wire                                m_vertex_ready,
  output reg  [95:0]                         m_vertex_coordinates,
  output reg  [11:0]                         m_vertex_cell,
  output reg  [SOURCE_W-1:0]                 m_vertex_source,
  output reg                                 m_vertex_bank,
  output reg                                 m_vertex_changed,
  output reg  [1:0]                          m_vertex_results,
  output reg  [`FFD_EXPONENT_W-1:0]          m_vertex_exponent,
  output reg  [23:0]                         m_vertex_user,
  output wire                                nan_o,
  output wire                                outside_o,
  output wire                                cell_outside_o
);
  localparam VERTEX_W = 96 + 12 + 3 + 16;

  localparam [1:0] MODE_CLAMP = 2'd0;
  localparam [1:0] MODE_PASS  = 2'd1;

  reg [1:0] mode_q;
  always @(posedge clk) begin
    if (header_i) mode_q <= data_i[65:64];
  end
  wire clamp = mode_q == MODE_CLAMP;

  // ---- the beat

  wire [95:0] coordinates;
  wire [11:0] cell_index;
  wire [2:0]  nan;
  wire [2:0]  outside;
  wire [2:0]  beyond;

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      wire [31:0] clamped;
      wire [3:0]  asked = data_i[112+4*a +: 4];
      wire [3:0]  last  = last_cell_i[4*a +: 4];
      assign beyond[a] = bounded_i && asked > last;
      assign cell_index[4*a +: 4] = beyond[a] ? last : asked;

      ffd_num_range #(
        .FORMAT(FORMAT)
      ) u_range (
        .word_i   (data_i[32*a +: 32]),
        .nan_o    (nan[a]),
        .outside_o(outside[a]),
        .clamped_o(clamped)
      );

      assign coordinates[32*a +: 32] = !clamp    ? data_i[32*a +: 32]
                                     : beyond[a] ? `FFD_ONE_WORD(FORMAT) : clamped;
    end
  endgenerate

  // ---- kept until its points have come

  wire [VERTEX_W-1:0] beat = {coordinates, cell_index, |nan, |outside, |beyond, data_i[111:96]};
  reg  [VERTEX_W-1:0] beat_q;
  always @(posedge clk) begin
    if (vertex_i) beat_q <= beat;
  end
  wire [VERTEX_W-1:0] now = vertex_i ? beat : beat_q;

  wire [95:0] now_coordinates;
  wire [11:0] now_cell;
  wire        now_nan;
  wire        now_outside;
  wire        now_beyond;
  wire [15:0] now_tag;
  assign {now_coordinates, now_cell, now_nan, now_outside, now_beyond, now_tag} = now;

  assign cell_o         = beat_q[19 +: 12];
  assign nan_o          = finish_i && now_nan;
  assign outside_o      = finish_i && now_outside;
  assign cell_outside_o = finish_i && now_beyond;

  // ---- offered

  wire       out     = now_outside || now_beyond;
  wire       refused = out && !clamp && mode_q != MODE_PASS;
  wire       blank   = truncated_i || unloaded_i || now_nan || refused;
  wire [5:0] status  = {unloaded_i, truncated_i, out, now_nan, out && clamp, 1'b0};

  always @(posedge clk) begin
    if (rst) m_vertex_valid <= 1'b0;
    else if (finish_i) m_vertex_valid <= 1'b1;
    else if (m_vertex_ready) m_vertex_valid <= 1'b0;
  end
  // Whatever is here while nothing is offered, a vertex or not.
  always @(posedge clk) begin
    if (!m_vertex_valid || m_vertex_ready) begin
      m_vertex_coordinates <= now_coordinates;
      m_vertex_cell        <= now_cell;
      m_vertex_source      <= source_i;
      m_vertex_bank        <= bank_i;
      m_vertex_changed     <= changed_i;
      m_vertex_results     <= results_i;
      m_vertex_exponent    <= exponent_i;
      m_vertex_user        <= {last_i, blank, status, now_tag};
    end
  end

  wire unused_ok = &{1'b0, data_i};
endmodule

`default_nettype wire
