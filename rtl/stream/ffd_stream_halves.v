// ffd_stream_halves: results of packets with the flag H, two vertices a beat
//
// Between the encoder's register and ffd_stream_marks. A vertex of such a packet becomes half a
// beat, {blank, folded, outside, saturated, z, y, x}, its words those of 20 bits; with results 2
// its det J comes as the flag folded. The first vertex of a beat waits for the second one; the last
// of a packet does not, and an empty half has all bits set. Other results pass as they are, with
// UNITS 2 also two at once. With PAIRS a second vertex may come with each one, so that two a clock
// are a beat a clock.
//
// Formats:    s_beat_data as hwffd_stream gives it, but for the position of a vertex with H, whose
//             words are rounded already (ffd_num_half): the upper 20 bits of each.
// Pipeline:   1 clock, II 1; 2 where a pair that ends its packet is in two beats. Without
//             FFD_FEATURE_HALVES all of it is wires.
// Freezes:    while m_beat_ready is 0.
// Parameters: FEATURES as in ffd_stream.vh; PAIRS 0, or 1 with halves; UNITS 1 or 2, the most
//             units of 16 bytes in a beat.
// Model:      golden/include/hwffd/stream/halves.hpp.  Test: tests/system/halves_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_stream.vh"

module ffd_stream_halves #(
  parameter FEATURES = `FFD_FEATURES_USUAL,
  parameter PAIRS    = 0,
  parameter UNITS    = 1
) (
  input  wire         clk,
  input  wire         rst,
  input  wire         s_beat_valid,
  output wire         s_beat_ready,
  input  wire [128*UNITS-1:0] s_beat_data,
  input  wire         s_beat_two,    // it has two units, and is not half a beat
  input  wire         s_beat_last,
  input  wire         s_beat_half,   // of a packet with H
  input  wire         s_beat_blank,
  input  wire         s_beat_first,  // of its vertex
  input  wire         s_beat_final,
  input  wire         s_beat_pair,    // of positions with H, neither of them blank or outside
  input  wire [60:0]  s_beat_second,  // {saturated, z, y, x} of the second vertex
  output wire         m_beat_valid,
  input  wire         m_beat_ready,
  output wire [128*UNITS-1:0] m_beat_data,
  output wire         m_beat_two,
  output wire         m_beat_last
);
  generate
    if (`FFD_FEATURE_HALVES(FEATURES) == 0) begin : gen_none
      assign s_beat_ready = m_beat_ready;
      assign m_beat_valid = s_beat_valid;
      assign m_beat_data  = s_beat_data;
      assign m_beat_two   = s_beat_two;
      assign m_beat_last  = s_beat_last;
      wire unused_ok = &{1'b0, clk, rst, s_beat_half, s_beat_blank, s_beat_first, s_beat_final,
                         s_beat_pair, s_beat_second};
    end else begin : gen_halves
      reg          valid_q;
      reg          last_q;
      reg  [127:0] data_q;
      reg          low_q;      // the first vertex of a beat waits
      reg  [62:0]  position_q; // of a vertex whose det J comes next, but for the flag folded
      reg  [63:0]  waiting_q;
      wire         rest;       // the last vertex of a packet waits, its beat has left
      wire         pair = PAIRS != 0 && s_beat_pair;
      wire         free = !valid_q || m_beat_ready;
      wire         take = s_beat_valid && s_beat_ready;
      assign s_beat_ready = free && !rest;
      assign m_beat_valid = valid_q;
      assign m_beat_data[127:0] = data_q;
      assign m_beat_last  = last_q;

      // ---- half of a vertex's result

      wire [62:0] position = s_beat_first
                           ? {s_beat_blank, s_beat_data[96+19], s_beat_data[96+16],
                              s_beat_data[64+12 +: 20], s_beat_data[32+12 +: 20],
                              s_beat_data[12 +: 20]}
                           : position_q;
      wire        folded   = !s_beat_first && s_beat_data[96+22];
      wire [63:0] half     = {position[62], folded, position[61:0]};
      wire        whole    = !s_beat_half || s_beat_final;  // a result, or a half of one
      wire        leave    = whole && (!s_beat_half || low_q || s_beat_last || pair);
      wire        split    = pair && low_q;  // over two beats
      wire [63:0] second   = {3'd0, s_beat_second};

      if (PAIRS != 0) begin : gen_rest
        reg rest_q;
        always @(posedge clk) begin
          if (rst) rest_q <= 1'b0;
          else if (free) rest_q <= take && split && s_beat_last;
        end
        assign rest = rest_q;
      end else begin : gen_no_rest
        assign rest = 1'b0;
        wire unused_second = &{1'b0, s_beat_pair};
      end

      if (UNITS == 2) begin : gen_two
        reg         two_q;
        reg [127:0] upper_q;
        always @(posedge clk) begin
          if (take) {two_q, upper_q} <= {s_beat_two, s_beat_data[255:128]};
        end
        assign m_beat_two           = two_q;
        assign m_beat_data[255:128] = upper_q;
      end else begin : gen_one
        assign m_beat_two = 1'b0;
        wire unused_two = &{1'b0, s_beat_two};
      end

      always @(posedge clk) begin
        if (rst) begin
          valid_q <= 1'b0;
          low_q   <= 1'b0;
        end else begin
          if (free) valid_q <= (s_beat_valid && leave) || rest;
          if (take && s_beat_half && s_beat_final) low_q <= (pair ? low_q : !low_q) && !s_beat_last;
        end
      end
      always @(posedge clk) begin
        if (take) begin
          if (s_beat_first) position_q <= position;
          if (s_beat_final && (!low_q || pair)) waiting_q <= pair ? second : half;
        end
        if (take || (rest && free)) begin
          last_q <= rest || (s_beat_last && !split);
          data_q <= rest ? {{64{1'b1}}, waiting_q} : !s_beat_half ? s_beat_data[127:0]
                  : low_q ? {half, waiting_q} : {pair ? second : {64{1'b1}}, half};
        end
      end
    end
  endgenerate
endmodule

`default_nettype wire
