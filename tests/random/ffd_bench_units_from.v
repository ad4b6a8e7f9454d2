// ffd_bench_units_from: beats of a bus of another width as units of 16 bytes, the way back of ffd_bench_units_to
//
// A beat that docs/interface.md section 1 does not allow is told as `broken RULE`.
//
// Parameters: WIDTH, 64, 128 or 256.
// Test:       tests/random.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_bench_units_from #(
  parameter WIDTH = 128
) (
  input  wire               clk,
  input  wire               s_valid,
  output wire               s_ready,
  input  wire [WIDTH-1:0]   s_data,
  input  wire [WIDTH/8-1:0] s_keep,
  input  wire               s_last,
  input  wire               s_user,
  output wire               m_valid,
  input  wire               m_ready,
  output wire [127:0]       m_unit,
  output wire               m_last,
  output wire               m_user
);
  reg        second_q = 1'b0;
  reg [63:0] half_q;
  generate
    if (WIDTH == 64) begin : gen_halves
      assign m_valid = s_valid && second_q;
      assign s_ready = m_ready || !second_q;
      assign m_unit  = {s_data, half_q};
      assign m_last  = s_last;
      assign m_user  = s_user;
      always @(posedge clk) begin
        if (s_valid === 1'b1 && s_ready) begin
          half_q   <= s_data;
          second_q <= !second_q;
          if (!second_q && s_last !== 1'b0) $display("broken last_in_a_unit");
        end
      end
    end else if (WIDTH == 256) begin : gen_pairs
      wire more = s_keep[16] && !second_q;
      assign m_valid = s_valid;
      assign s_ready = m_ready && !more;
      assign m_unit  = second_q ? s_data[255:128] : s_data[127:0];
      assign m_last  = s_last && !more;
      assign m_user  = s_user && !more;
      always @(posedge clk) begin
        if (s_valid === 1'b1 && m_ready) begin
          second_q <= more;
          if (s_keep !== {{16{s_keep[16]}}, 16'hFFFF} || (!s_keep[16] && s_last !== 1'b1)) begin
            $display("broken keep");
          end
        end
      end
    end else begin : gen_same
      assign m_valid = s_valid;
      assign s_ready = m_ready;
      assign m_unit  = s_data;
      assign m_last  = s_last;
      assign m_user  = s_user;
    end
  endgenerate
endmodule

`default_nettype wire
