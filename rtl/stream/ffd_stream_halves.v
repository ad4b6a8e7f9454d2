// ffd_stream_halves: results of packets with the flag H, two vertices a beat
//
// Between the encoder's register and ffd_stream_marks. A vertex of such a packet becomes half a
// beat, {blank, folded, outside, saturated, z, y, x}, its words rounded to 20 bits; with results 2
// its det J comes as the flag folded. The first vertex of a beat waits for the second one; the last
// of a packet does not, and an empty half has all bits set. Other results pass as they are.
//
// Formats:    words as ffd_num_half rounds them; s_beat_data as hwffd_stream has it, whose flag S
//             knows already where rounding saturates.
// Pipeline:   1 clock, II 1; without FFD_FEATURE_HALVES all of it is wires.
// Freezes:    while m_beat_ready is 0.
// Parameters: FORMAT as in ffd_num.vh, fixed point where FEATURES has halves; FEATURES as in
//             ffd_stream.vh.
// Model:      golden/include/hwffd/stream/halves.hpp.  Test: tests/system/halves_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_stream.vh"

module ffd_stream_halves #(
  parameter FORMAT   = 18,
  parameter FEATURES = `FFD_FEATURES
) (
  input  wire         clk,
  input  wire         rst,
  input  wire         s_beat_valid,
  output wire         s_beat_ready,
  input  wire [127:0] s_beat_data,
  input  wire         s_beat_last,
  input  wire         s_beat_half,   // of a packet with H
  input  wire         s_beat_blank,
  input  wire         s_beat_first,  // of its vertex
  input  wire         s_beat_final,
  output wire         m_beat_valid,
  input  wire         m_beat_ready,
  output wire [127:0] m_beat_data,
  output wire         m_beat_last
);
  generate
    if (`FFD_FEATURE_HALVES(FEATURES) == 0) begin : gen_none
      assign s_beat_ready = m_beat_ready;
      assign m_beat_valid = s_beat_valid;
      assign m_beat_data  = s_beat_data;
      assign m_beat_last  = s_beat_last;
      wire unused_ok = &{1'b0, clk, rst, s_beat_half, s_beat_blank, s_beat_first, s_beat_final};
    end else begin : gen_halves
      reg          valid_q;
      reg          last_q;
      reg  [127:0] data_q;
      reg          low_q;      // the first vertex of a beat waits
      reg  [62:0]  position_q; // of a vertex whose det J comes next, but for the flag folded
      reg  [63:0]  waiting_q;
      wire         free = !valid_q || m_beat_ready;
      wire         take = s_beat_valid && free;
      assign s_beat_ready = free;
      assign m_beat_valid = valid_q;
      assign m_beat_data  = data_q;
      assign m_beat_last  = last_q;

      // ---- half of a vertex's result

      wire [59:0] rounded;
      genvar c;
      for (c = 0; c < 3; c = c + 1) begin : gen_component
        wire saturated;
        ffd_num_half #(
          .FORMAT(FORMAT)
        ) u_half (
          .word_i     (s_beat_data[32*c +: 32]),
          .half_o     (rounded[20*c +: 20]),
          .saturated_o(saturated)
        );
        wire unused_ok = &{1'b0, saturated};
      end
      wire [62:0] position = s_beat_first
                           ? {s_beat_blank, s_beat_data[96+19], s_beat_data[96+16], rounded}
                           : position_q;
      wire        folded   = !s_beat_first && s_beat_data[96+22];
      wire [63:0] half     = {position[62], folded, position[61:0]};
      wire        whole    = !s_beat_half || s_beat_final;  // a result, or a half of one
      wire        leave    = whole && (!s_beat_half || low_q || s_beat_last);

      always @(posedge clk) begin
        if (rst) begin
          valid_q <= 1'b0;
          low_q   <= 1'b0;
        end else begin
          if (free) valid_q <= s_beat_valid && leave;
          if (take && s_beat_half && s_beat_final) low_q <= !low_q && !s_beat_last;
        end
      end
      always @(posedge clk) begin
        if (take) begin
          if (s_beat_first) position_q <= position;
          if (s_beat_final && !low_q) waiting_q <= half;
          last_q <= s_beat_last;
          data_q <= !s_beat_half ? s_beat_data
                  : low_q ? {half, waiting_q} : {{64{1'b1}}, half};
        end
      end
    end
  endgenerate
endmodule

`default_nettype wire
