// ffd_stream_ingress: what stands in front of the decoder
//
// Beats of the stream become framed beats that the decoder takes: ffd_stream_opcode,
// ffd_stream_expand, in a core with grids or packed vertices, ffd_stream_framer and
// ffd_stream_intake.
//
// Bad input:  as in these.
// Formats:    frame_o as FFD_FRAME_*.
// Pipeline:   as ffd_stream_intake; with ffd_stream_expand a clock more.
// Freezes:    s_beat_ready is 0 while a beat is held, and while ffd_stream_expand has other beats.
// Parameters: those of ffd_stream_expand, GRID_LIMIT guarded here, PAIRS 1 with grids only; SPANS
//             as in ffd_stream_functions, BESIDE in ffd_stream_framer.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_stream.vh"

module ffd_stream_ingress #(
  parameter FORMAT     = 18,
  parameter FEATURES   = `FFD_FEATURES_USUAL,
  parameter AXIS       = 16,
  parameter SPANS      = 1,
  parameter GRID_LIMIT = 48,
  parameter BESIDE     = 0,
  parameter PAIRS      = 0,
  parameter PLACE_W    = 3 * `FFD_AXIS_W(AXIS)
) (
  input  wire                     clk,
  input  wire                     rst,
  input  wire                     s_beat_valid,
  output wire                     s_beat_ready,
  input  wire [127:0]             s_beat_data,
  input  wire                     s_beat_last,
  output wire                     beat_valid_o,
  output wire [127:0]             beat_data_o,
  output wire                     beat_last_o,
  output wire [32:0]              beat_second_o,  // as in ffd_stream_expand
  output wire [`FFD_FRAME_W-1:0]  frame_o,
  output wire                     held_o,       // the beat, until it can go on
  input  wire                     go_i,
  input  wire                     refuse_i,
  input  wire                     place_valid_i,
  input  wire [PLACE_W-1:0]       place_i,
  input  wire [PLACE_W-1:0]       tops_i,
  input  wire                     slot_free_i,
  input  wire                     rooms_i,
  input  wire                     loaded_i,     // the lattice of the header that went on last
  input  wire [PLACE_W-1:0]       last_cell_i,
  input  wire                     pairs_i,
  input  wire                     grid_stop_i,
  output wire                     idle_o
);
  // Here, since a core without grids has no ffd_stream_grid.
  generate
    if (GRID_LIMIT < 0 || GRID_LIMIT > 48) begin : gen_bad_limit
      ERROR_ffd_stream_ingress_grid_limit_must_be_0_to_48 u_error ();
    end
  endgenerate

  wire                    valid;
  wire                    ready;
  wire [127:0]            data;
  wire [127:0]            header;    // the same where it is one
  wire                    last;
  wire [32:0]             second;
  wire [2:0]              as;
  wire                    expects;
  wire                    nothing;   // inside ffd_stream_expand
  wire [`FFD_FRAME_W-1:0] frame;
  wire                    claims;
  wire                    between;

  wire [`FFD_PACKET_W-1:0] s_packet;
  wire [`FFD_PACKET_W-1:0] packet;
  ffd_stream_opcode #(
    .FEATURES(FEATURES),
    .SCATTER (BESIDE)
  ) u_opcode (
    .opcode_i(s_beat_data[7:0]),
    .packet_o(s_packet)
  );

  generate
    if (`FFD_FEATURE_EXPANDED(FEATURES)) begin : gen_expand
      ffd_stream_expand #(
        .FORMAT    (FORMAT),
        .FEATURES  (FEATURES),
        .AXIS      (AXIS),
        .GRID_LIMIT(GRID_LIMIT),
        .PAIRS     (PAIRS)
      ) u_expand (
        .clk          (clk),
        .rst          (rst),
        .s_beat_valid (s_beat_valid),
        .s_beat_ready (s_beat_ready),
        .s_beat_data  (s_beat_data),
        .s_beat_packet(s_packet),
        .s_beat_last  (s_beat_last),
        .m_beat_valid (valid),
        .m_beat_ready (ready),
        .m_beat_data  (data),
        .m_beat_header(header),
        .m_beat_packet(packet),
        .m_beat_last  (last),
        .m_beat_second(second),
        .as_o         (as),
        .expects_i    (expects),
        .header_i     (beat_valid_o && frame_o[`FFD_FRAME_HEADER]),
        .loaded_i     (loaded_i),
        .last_cell_i  (last_cell_i),
        .pairs_i      (pairs_i),
        .grid_stop_i  (grid_stop_i),
        .idle_o       (nothing)
      );
    end else begin : gen_as_it_is
      assign valid        = s_beat_valid;
      assign s_beat_ready = ready;
      assign data         = s_beat_data;
      assign header       = s_beat_data;
      assign packet       = s_packet;
      assign last         = s_beat_last;
      assign second       = 33'd0;
      assign as           = `FFD_AS_IT_IS;
      assign nothing      = 1'b1;
      wire unused_ok = &{1'b0, expects, loaded_i, last_cell_i, pairs_i, grid_stop_i};
    end
  endgenerate

  ffd_stream_framer #(
    .AXIS    (AXIS),
    .FEATURES(FEATURES),
    .SPANS   (SPANS),
    .BESIDE  (BESIDE)
  ) u_framer (
    .clk     (clk),
    .rst     (rst),
    .take_i  (valid && ready),
    .data_i  (header),
    .packet_i(packet),
    .last_i  (last),
    .as_i    (as),
    .refuse_i(refuse_i),
    .place_valid_i(place_valid_i),
    .place_i (place_i),
    .tops_i  (tops_i),
    .frame_o (frame),
    .claims_o(claims),
    .expects_o(expects),
    .idle_o  (between)
  );

  wire waits = frame[`FFD_FRAME_BANK] || frame[`FFD_FRAME_BUFFER] || frame[`FFD_FRAME_PAGE]
            || (claims && !slot_free_i) || (frame[`FFD_FRAME_FINISH] && !rooms_i);

  localparam BEAT_W = `FFD_FRAME_W + 129 + 33 * PAIRS;
  wire [`FFD_FRAME_W+161:0] beat = {second, frame, last, data};
  wire [`FFD_FRAME_W+161:0] taken;
  generate
    if (PAIRS == 0) begin : gen_no_second
      assign taken[`FFD_FRAME_W+161 -: 33] = 33'd0;
      wire unused_second = &{1'b0, beat};
    end
  endgenerate
  assign {beat_second_o, frame_o, beat_last_o, beat_data_o} = taken;

  ffd_stream_intake #(
    .WIDTH(BEAT_W)
  ) u_in (
    .clk         (clk),
    .rst         (rst),
    .s_beat_valid(valid),
    .s_beat_ready(ready),
    .s_beat_waits(waits),
    .s_beat_data (beat[BEAT_W-1:0]),
    .go_i        (go_i),
    .held_o      (held_o),
    .beat_valid_o(beat_valid_o),
    .beat_data_o (taken[BEAT_W-1:0])
  );

  assign idle_o = nothing && between && !beat_valid_o && !held_o;
endmodule

`default_nettype wire
