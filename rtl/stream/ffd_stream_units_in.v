// ffd_stream_units_in: beats of a bus of 64 or 256 bits become units of 16 bytes
//
// With WIDTH 64 two beats are a unit, low half first; where the first of them is the packet's last,
// the unit's high half is 0. With WIDTH 256 a beat is two units, low one first, but the last of a
// packet where s_beat_upper is 0: then the upper half is left out.
//
// Pipeline:   1 clock from the beat that makes a unit whole; a beat a clock with WIDTH 64, one
//             every two with 256, which is a unit a clock.
// Freezes:    when m_unit_ready is 0, with one unit inside, with WIDTH 256 two.
// Cuts:       data, valid and last leave registers. s_beat_ready is 0 in reset; it follows
//             m_unit_ready through a gate.
// Not checked: s_beat_upper on any beat but a packet's last.
// Parameters: WIDTH 64 or 256.
// Model:      none (transport only).  Test: tests/system/width_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_stream_units_in #(
  parameter WIDTH = 64
) (
  input  wire             clk,
  input  wire             rst,
  output wire             idle_o,
  input  wire             s_beat_valid,
  output wire             s_beat_ready,
  input  wire [WIDTH-1:0] s_beat_data,
  input  wire             s_beat_upper,
  input  wire             s_beat_last,
  output wire             m_unit_valid,
  input  wire             m_unit_ready,
  output wire [127:0]     m_unit_data,
  output wire             m_unit_last
);
  generate
    if (WIDTH != 64 && WIDTH != 256) begin : gen_bad_width
      ERROR_ffd_stream_units_in_width_must_be_64_or_256 u_error ();
    end
  endgenerate

  reg  open_q;      // not in reset
  reg  valid_q;     // a unit is offered
  reg  last_q;      // of its beats
  wire take = s_beat_valid && s_beat_ready;
  always @(posedge clk) open_q <= !rst;
  always @(posedge clk) if (take) last_q <= s_beat_last;

  assign m_unit_valid = valid_q;

  generate
    if (WIDTH == 64) begin : gen_halves
      reg         half_q;    // the low half is there
      reg [127:0] unit_q;

      assign s_beat_ready = open_q && (!valid_q || m_unit_ready);
      assign m_unit_data  = unit_q;
      assign m_unit_last  = last_q;
      assign idle_o       = !half_q && !valid_q;

      always @(posedge clk) begin
        if (rst) begin
          half_q  <= 1'b0;
          valid_q <= 1'b0;
        end else begin
          if (take) half_q <= !half_q && !s_beat_last;
          valid_q <= (take && (half_q || s_beat_last)) || (valid_q && !m_unit_ready);
        end
      end

      always @(posedge clk) begin
        if (take && !half_q) unit_q <= {64'd0, s_beat_data};
        if (take && half_q) unit_q[127:64] <= s_beat_data;
      end

      wire unused_ok = &{1'b0, s_beat_upper};
    end else begin : gen_pair
      reg               upper_q;    // another unit is behind the one that is offered
      reg [WIDTH-1:0]   pair_q;
      wire              move = valid_q && m_unit_ready;

      assign s_beat_ready = open_q && (!valid_q || (m_unit_ready && !upper_q));
      assign m_unit_data  = pair_q[127:0];
      assign m_unit_last  = last_q && !upper_q;
      assign idle_o       = !valid_q;

      always @(posedge clk) begin
        if (rst) valid_q <= 1'b0;
        else valid_q <= take || (valid_q && !(move && !upper_q));
      end

      always @(posedge clk) begin
        if (take) begin
          pair_q  <= s_beat_data;
          upper_q <= s_beat_upper || !s_beat_last;
        end else if (move) begin
          pair_q[127:0] <= pair_q[WIDTH-1 -: 128];
          upper_q       <= 1'b0;
        end
      end
    end
  endgenerate
endmodule

`default_nettype wire
