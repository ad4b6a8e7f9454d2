// ffd_stream_decoder: packets become coefficients, control points and vertices
//
// A packet is a header beat and its payload, ended by tlast (docs/interface.md section 2):
//   1 coefficients   12 beats, one a blending function: into the bank that is not in use, which
//                    becomes the one in use when all 12 have come. The header waits until no vertex
//                    inside reads that bank: vertices before it see the old, after it the new.
//   4 interleaved    count vertices of 49 beats: the vertex, then its 64 points into a free slot.
// A vertex goes on when its last point has come; until it is taken, the next one is loaded.
//
// Bad input:  an unknown opcode, and beats after a packet's end, are dropped up to tlast. tlast in
//             the middle of a vertex ends it: it goes on marked truncated. Coefficients cut short
//             never come into use. A vertex before any coefficients is marked unloaded.
// Formats:    coordinates and coefficients leave as weights of FORMAT; m_vertex_user is
//             {last of packet, unloaded, truncated, tag[15:0]}.
// Pipeline:   a vertex leaves in the clock after its last beat; II 49 beats.
// Freezes:    s_ready is 0 when a header waits for its bank, a vertex for a slot, or a finished
//             vertex for the one before it.
// Parameters: FORMAT as in ffd_num.vh, SLOTS >= 2, IN_FLIGHT the most vertices behind the decoder.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_stream_decoder #(
  parameter FORMAT    = 18,
  parameter SLOTS     = 3,
  parameter SLOT_W    = $clog2(SLOTS),
  parameter IN_FLIGHT = 16
) (
  input  wire                                            clk,
  input  wire                                            rst,
  input  wire                                            s_beat_valid,
  output reg                                             s_beat_ready,
  input  wire [127:0]                                    s_beat_data,
  input  wire                                            s_beat_last,
  output wire                                            load_o,
  output wire [1:0]                                      load_axis_o,
  output wire [2:0]                                      load_address_o,
  output wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_o,
  output wire                                            write_o,
  output wire [SLOT_W-1:0]                               write_slot_o,
  output wire [11:0]                                     write_cell_o,
  output wire [3:0]                                      write_group_o,
  output wire [1:0]                                      write_phase_o,
  output wire [127:0]                                    write_words_o,
  output reg                                             m_vertex_valid,
  input  wire                                            m_vertex_ready,
  output reg  [3*`FFD_WEIGHT_W(FORMAT)-1:0]              m_vertex_coordinates,
  output reg  [11:0]                                     m_vertex_cell,
  output reg  [SLOT_W-1:0]                               m_vertex_slot,
  output reg                                             m_vertex_bank,
  output reg  [18:0]                                     m_vertex_user,
  input  wire                                            slot_free_i,
  input  wire                                            retire_i,
  input  wire                                            retire_bank_i
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);

  localparam [7:0] OPCODE_COEFFICIENTS = 8'd1;
  localparam [7:0] OPCODE_INTERLEAVED  = 8'd4;

  localparam [2:0] HEADER       = 3'd0;
  localparam [2:0] COEFFICIENTS = 3'd1;
  localparam [2:0] VERTEX       = 3'd2;
  localparam [2:0] POINTS       = 3'd3;
  localparam [2:0] DROP         = 3'd4;

  localparam [3:0] LAST_FUNCTION = 4'd11;
  localparam [1:0] LAST_PHASE    = 2'd2;

  reg  [2:0]  state_q;
  reg  [3:0]  group_q;
  reg  [1:0]  phase_q;
  reg  [31:0] count_q;
  wire        take            = s_beat_valid && s_beat_ready;
  wire [7:0]  opcode          = s_beat_data[7:0];
  wire [31:0] count           = s_beat_data[63:32];
  wire        is_coefficients = opcode == OPCODE_COEFFICIENTS;
  wire        is_interleaved  = opcode == OPCODE_INTERLEAVED;
  wire        last_phase      = phase_q == LAST_PHASE;
  wire        last_point      = &group_q && last_phase;
  wire        last_function   = group_q == LAST_FUNCTION;
  wire        last_vertex     = count_q == 32'd1;

  // Both the last point and a tlast that comes too early finish a vertex.
  wire vertex_ends = (state_q == POINTS && (last_point || s_beat_last)) ||
                     (state_q == VERTEX && s_beat_last);
  wire finish      = take && vertex_ends;
  wire truncated   = state_q == VERTEX || !last_point;

  // ---- where the next beat belongs

  reg [2:0] state_d;
  always @* begin
    state_d = state_q;
    case (state_q)
      HEADER:
        if (is_coefficients) state_d = COEFFICIENTS;
        else if (is_interleaved && count != 32'd0) state_d = VERTEX;
        else state_d = DROP;
      COEFFICIENTS: if (last_function) state_d = DROP;
      VERTEX:       state_d = POINTS;
      POINTS:       if (last_point) state_d = last_vertex ? DROP : VERTEX;
      default:      state_d = DROP;
    endcase
    if (s_beat_last) state_d = HEADER;
  end

  always @(posedge clk) begin
    if (rst) state_q <= HEADER;
    else if (take) state_q <= state_d;
  end

  // Beats of a payload: blending functions one by one, points in groups of three beats.
  always @(posedge clk) begin
    if (take) begin
      if (state_q == HEADER || state_q == VERTEX) begin
        group_q <= 4'd0;
        phase_q <= 2'd0;
      end else begin
        if (state_q == COEFFICIENTS || last_phase) group_q <= group_q + 4'd1;
        phase_q <= last_phase ? 2'd0 : phase_q + 2'd1;
      end
      if (state_q == HEADER) count_q <= count;
      else if (finish) count_q <= count_q - 32'd1;
    end
  end

  // ---- when it may come

  wire bank_free;
  wire slot_free;
  always @* begin
    case (state_q)
      HEADER:  s_beat_ready = !is_coefficients || bank_free;
      VERTEX:  s_beat_ready = slot_free && (!s_beat_last || !m_vertex_valid);
      POINTS:  s_beat_ready = !vertex_ends || !m_vertex_valid;
      default: s_beat_ready = 1'b1;
    endcase
  end

  // ---- coefficients: degree and shift of each axis from the header, then 3 x 4 functions

  reg        bank_q;
  reg        loaded_q;
  reg  [5:0] degree_q;
  reg  [5:0] shift_q;
  wire       loads = take && state_q == COEFFICIENTS;

  always @(posedge clk) begin
    if (rst) begin
      bank_q   <= 1'b0;
      loaded_q <= 1'b0;
    end else if (loads && last_function) begin
      bank_q   <= !bank_q;
      loaded_q <= 1'b1;
    end
  end
  always @(posedge clk) begin
    if (take && state_q == HEADER) begin
      degree_q <= s_beat_data[69:64];
      shift_q  <= s_beat_data[77:72];
    end
  end

  wire [1:0] axis   = group_q[3:2];
  wire [2:0] terms  = {1'b0, degree_q[2*axis +: 2]} + 3'd1;
  assign load_o         = loads;
  assign load_axis_o    = axis;
  assign load_address_o = {!bank_q, group_q[1:0]};
  assign load_entry_o[4*WEIGHT_W +: 2] = shift_q[2*axis +: 2];

  genvar p;
  generate
    for (p = 0; p < 4; p = p + 1) begin : gen_power
      localparam [2:0] POWER = p;
      wire [WEIGHT_W-1:0] number;
      ffd_num_in #(
        .FORMAT(FORMAT),
        .ROLE  (`FFD_ROLE_COEFFICIENT)
      ) u_in (
        .word_i  (s_beat_data[32*p +: 32]),
        .number_o(number)
      );
      assign load_entry_o[p*WEIGHT_W +: WEIGHT_W] = terms > POWER ? number : {WEIGHT_W{1'b0}};
    end
  endgenerate

  // Vertices that have not retired, by bank: those behind the decoder and the one it offers.
  localparam READING_W = $clog2(IN_FLIGHT + 2);
  wire [1:0] bank_read;
  genvar b;
  generate
    for (b = 0; b < 2; b = b + 1) begin : gen_bank
      localparam [0:0] BANK = b;
      reg  [READING_W-1:0] reading_q;
      wire                 begins = finish && bank_q == BANK;
      wire                 ends   = retire_i && retire_bank_i == BANK;
      always @(posedge clk) begin
        if (rst) reading_q <= {READING_W{1'b0}};
        else if (begins && !ends) reading_q <= reading_q + 1'b1;
        else if (ends && !begins) reading_q <= reading_q - 1'b1;
      end
      assign bank_read[b] = reading_q != {READING_W{1'b0}};
    end
  endgenerate
  assign bank_free = !bank_read[!bank_q];

  // ---- slots: handed out and freed in turn, because vertices keep their order

  localparam              TOP       = SLOTS - 1;
  localparam [SLOT_W-1:0] LAST_SLOT = TOP[SLOT_W-1:0];
  localparam [SLOT_W:0]   ALL_SLOTS = SLOTS[SLOT_W:0];
  reg  [SLOT_W-1:0] slot_q;
  reg  [SLOT_W:0]   used_q;
  wire              claim = take && state_q == VERTEX;
  assign slot_free = used_q != ALL_SLOTS;

  always @(posedge clk) begin
    if (rst) begin
      slot_q <= {SLOT_W{1'b0}};
      used_q <= {(SLOT_W + 1) {1'b0}};
    end else begin
      if (finish) slot_q <= slot_q == LAST_SLOT ? {SLOT_W{1'b0}} : slot_q + 1'b1;
      used_q <= used_q + {{SLOT_W{1'b0}}, claim} - {{SLOT_W{1'b0}}, slot_free_i};
    end
  end

  assign write_o       = take && state_q == POINTS;
  assign write_slot_o  = slot_q;
  assign write_group_o = group_q;
  assign write_phase_o = phase_q;
  assign write_words_o = s_beat_data;

  // ---- vertex: kept while its points come, then offered

  wire [3*WEIGHT_W-1:0] coordinates;
  reg  [3*WEIGHT_W-1:0] coordinates_q;
  reg  [27:0]           word_q;
  wire [3*WEIGHT_W-1:0] coordinates_now = state_q == VERTEX ? coordinates : coordinates_q;
  wire [27:0]           word_now        = state_q == VERTEX ? s_beat_data[123:96] : word_q;

  assign write_cell_o = word_q[27:16];

  genvar a;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_axis
      ffd_num_in #(
        .FORMAT(FORMAT),
        .ROLE  (`FFD_ROLE_COORDINATE)
      ) u_in (
        .word_i  (s_beat_data[32*a +: 32]),
        .number_o(coordinates[a*WEIGHT_W +: WEIGHT_W])
      );
    end
  endgenerate

  always @(posedge clk) begin
    if (claim) begin
      coordinates_q <= coordinates;
      word_q        <= s_beat_data[123:96];
    end
  end

  always @(posedge clk) begin
    if (rst) m_vertex_valid <= 1'b0;
    else if (finish) m_vertex_valid <= 1'b1;
    else if (m_vertex_ready) m_vertex_valid <= 1'b0;
  end
  always @(posedge clk) begin
    if (finish) begin
      m_vertex_coordinates <= coordinates_now;
      m_vertex_cell        <= word_now[27:16];
      m_vertex_slot        <= slot_q;
      m_vertex_bank        <= bank_q;
      m_vertex_user        <= {last_vertex || s_beat_last, !loaded_q, truncated, word_now[15:0]};
    end
  end
endmodule

`default_nettype wire
