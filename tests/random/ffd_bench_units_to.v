// ffd_bench_units_to: units of 16 bytes onto a bus of another width, as docs/interface.md section 1 has it
//
// Nothing is kept but the first of two units, so that what is offered and taken waits for nothing else.
//
// Parameters: WIDTH, 64, 128 or 256.
// Test:       tests/random.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_bench_units_to #(
  parameter WIDTH = 128
) (
  input  wire               clk,
  input  wire               s_valid,
  output wire               s_ready,
  input  wire [127:0]       s_unit,
  input  wire               s_last,
  output wire               m_valid,
  input  wire               m_ready,
  output wire [WIDTH-1:0]   m_data,
  output wire [WIDTH/8-1:0] m_keep,
  output wire               m_last
);
  reg         second_q = 1'b0;  // half of a unit, or unit of a beat
  reg [127:0] first_q;
  generate
    if (WIDTH == 64) begin : gen_halves
      assign m_valid = s_valid;
      assign s_ready = m_ready && second_q;
      assign m_data  = second_q ? s_unit[127:64] : s_unit[63:0];
      assign m_keep  = 8'hFF;
      assign m_last  = s_last && second_q;
      always @(posedge clk) if (m_valid && m_ready === 1'b1) second_q <= !second_q;
    end else if (WIDTH == 256) begin : gen_pairs
      wire whole = second_q || s_last;
      assign m_valid = s_valid && whole;
      assign s_ready = !whole || m_ready;
      assign m_data  = second_q ? {s_unit, first_q} : {128'bx, s_unit};
      assign m_keep  = {{16{second_q}}, 16'hFFFF};
      assign m_last  = s_last;
      always @(posedge clk) begin
        if (s_valid && s_ready === 1'b1) begin
          first_q  <= s_unit;
          second_q <= !whole;
        end
      end
    end else begin : gen_same
      assign m_valid = s_valid;
      assign s_ready = m_ready;
      assign m_data  = s_unit;
      assign m_keep  = 16'hFFFF;
      assign m_last  = s_last;
    end
  endgenerate
endmodule

`default_nettype wire
