// ffd_stream_units_out: units of 16 bytes become beats of a bus of 64 or 256 bits
//
// With WIDTH 64 a unit is two beats, low half first. With WIDTH 256 two units are a beat, the first
// one low; a packet's last unit goes alone where it has no partner: then m_beat_upper is 0, and the
// upper half means nothing. With UNITS 2 two units may come at once, which are a beat.
//
// Pipeline:   1 clock from a unit to its first beat, with WIDTH 256 from the unit that makes a beat
//             whole; a beat a clock with WIDTH 64, a unit or two at once a clock with 256.
// Freezes:    when m_beat_ready is 0, with one unit inside, with WIDTH 256 three.
// Cuts:       every output of the beat leaves a register.
// Not checked: two at once come where none waits for its partner (FFD_ASSERT).
// Parameters: WIDTH 64 or 256; UNITS 1, or 2 with WIDTH 256.
// Model:      none (transport only).  Test: tests/system/width_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"

module ffd_stream_units_out #(
  parameter WIDTH = 64,
  parameter UNITS = 1
) (
  input  wire             clk,
  input  wire             rst,
  output wire             idle_o,
  input  wire             s_unit_valid,
  output wire             s_unit_ready,
  input  wire [128*UNITS-1:0] s_unit_data,
  input  wire             s_unit_two,   // both are there, else the lower one
  input  wire             s_unit_last,
  input  wire             s_unit_user,  // 1 with the last unit of a packet only
  output reg              m_beat_valid,
  input  wire             m_beat_ready,
  output reg  [WIDTH-1:0] m_beat_data,
  output wire             m_beat_upper,
  output reg              m_beat_last,
  output reg              m_beat_user
);
  generate
    if (WIDTH != 64 && WIDTH != 256) begin : gen_bad_width
      ERROR_ffd_stream_units_out_width_must_be_64_or_256 u_error ();
    end
    if (UNITS != 1 && (UNITS != 2 || WIDTH != 256)) begin : gen_bad_units
      ERROR_ffd_stream_units_out_units_must_be_1_or_2_with_width_256 u_error ();
    end
  endgenerate

  wire free = !m_beat_valid || m_beat_ready;
  wire take = s_unit_valid && s_unit_ready;

  generate
    if (WIDTH == 64) begin : gen_halves
      reg        high_q;          // the high half waits
      reg        high_last_q;
      reg        high_user_q;
      reg [63:0] high_data_q;

      assign s_unit_ready = free && !high_q;
      assign m_beat_upper = 1'b1;
      assign idle_o       = !m_beat_valid && !high_q;

      always @(posedge clk) begin
        if (rst) begin
          high_q       <= 1'b0;
          m_beat_valid <= 1'b0;
        end else if (free) begin
          high_q       <= take;
          m_beat_valid <= take || high_q;
        end
      end

      always @(posedge clk) begin
        if (take) begin
          {high_user_q, high_last_q} <= {s_unit_user, s_unit_last};
          high_data_q                <= s_unit_data[127:64];
        end
        if (free) begin
          m_beat_data <= high_q ? high_data_q : s_unit_data[63:0];
          m_beat_last <= high_q && high_last_q;
          m_beat_user <= high_q && high_user_q;
        end
      end

      wire unused_ok = &{1'b0, s_unit_two};
    end else begin : gen_pair
      reg         low_q;          // the first unit of a beat waits
      reg [127:0] low_data_q;
      reg         upper_q;
      wire        two    = UNITS == 2 && s_unit_two;
      wire        whole  = low_q || s_unit_last || two;
      wire [127:0] first = s_unit_data[127:0];

      assign s_unit_ready = free || !whole;
      assign m_beat_upper = upper_q;
      assign idle_o       = !m_beat_valid && !low_q;

      always @(posedge clk) begin
        if (rst) begin
          low_q        <= 1'b0;
          m_beat_valid <= 1'b0;
        end else begin
          if (take) low_q <= !whole;
          if (free) m_beat_valid <= take && whole;
        end
      end

      always @(posedge clk) begin
        if (take && !low_q) low_data_q <= first;
        if (free) begin
          m_beat_data <= {two ? s_unit_data[128*UNITS-1 -: 128] : first,
                          low_q ? low_data_q : first};
          m_beat_last <= s_unit_last;
          m_beat_user <= s_unit_user;
          upper_q     <= low_q || two;
        end
      end

      if (UNITS == 1) begin : gen_one
        wire unused_ok = &{1'b0, s_unit_two};
      end
      `FFD_ASSERT(two_units_come_and_one_waits, !(s_unit_valid && two && low_q))
    end
  endgenerate
endmodule

`default_nettype wire
