// ffd_stream_ending: the last register of results, and what a packet asks for behind them
//
// With the flag R the last result of a packet is not its last beat: one more comes, {all ones, 0,
// 0, results of the packet}. With I m_beat_mark comes with the last beat. With UNITS 2 a beat
// may be two results; a count comes alone.
//
// Formats:    flags {I, R} are those of the packet whose results come, from the first one until
//             ended_o; beats as those of hwffd_stream. number_o counts the results of the packet
//             before the one that comes.
// Pipeline:   1 clock; II 1, and one more for a count. ended_o: in the next clock the packet's last
//             beat is in the register.
// Freezes:    while m_beat_ready is 0.
// Parameters: UNITS 1 or 2, the most units of 16 bytes in a beat.
// Model:      golden/include/hwffd/model/stream_model.hpp, scatter_stream.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_stream_ending #(
  parameter UNITS = 1
) (
  input  wire         clk,
  input  wire         rst,
  input  wire [1:0]   flags_i,
  output wire [31:0]  number_o,
  output wire         ended_o,
  input  wire         s_beat_valid,
  output wire         s_beat_ready,
  input  wire [128*UNITS-1:0] s_beat_data,
  input  wire         s_beat_two,
  input  wire         s_beat_last,
  output wire         m_beat_valid,
  input  wire         m_beat_ready,
  output wire [128*UNITS-1:0] m_beat_data,
  output wire         m_beat_two,
  output wire         m_beat_last,
  output wire         m_beat_mark
);
  reg          valid_q;
  reg          last_q;
  reg          mark_q;
  reg  [127:0] data_q;
  reg          due_q;    // the count comes next
  reg          first_q;  // the next result is the first of its packet
  reg  [31:0]  count_q;
  wire         free = !valid_q || m_beat_ready;
  wire         take = s_beat_valid && s_beat_ready;
  wire         last = due_q || (s_beat_last && !flags_i[0]);
  wire         two  = UNITS == 2 && s_beat_two;

  assign s_beat_ready = free && !due_q;
  assign number_o     = first_q ? 32'd0 : count_q;
  assign ended_o      = (take || (free && due_q)) && last;
  assign m_beat_valid = valid_q;
  assign m_beat_data[127:0] = data_q;
  assign m_beat_last  = last_q;
  assign m_beat_mark  = mark_q;

  always @(posedge clk) begin
    if (rst) begin
      valid_q <= 1'b0;
      due_q   <= 1'b0;
      first_q <= 1'b1;
    end else begin
      if (free) valid_q <= s_beat_valid || due_q;
      if (free) due_q <= take && s_beat_last && flags_i[0];
      if (take) first_q <= s_beat_last;
    end
  end
  always @(posedge clk) begin
    if (take) count_q <= number_o + (two ? 32'd2 : 32'd1);
    if (free) begin
      data_q <= due_q ? {32'hFFFF_FFFF, 64'd0, count_q} : s_beat_data[127:0];
      last_q <= last;
      mark_q <= last && flags_i[1];
    end
  end

  generate
    if (UNITS == 2) begin : gen_two
      reg         two_q;
      reg [127:0] upper_q;
      always @(posedge clk) begin
        if (free) {two_q, upper_q} <= {two && !due_q, s_beat_data[255:128]};
      end
      assign m_beat_two           = two_q;
      assign m_beat_data[255:128] = upper_q;
    end else begin : gen_one
      assign m_beat_two = 1'b0;
      wire unused_ok = &{1'b0, s_beat_two};
    end
  endgenerate
endmodule

`default_nettype wire
