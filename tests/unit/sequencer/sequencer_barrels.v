// sequencer_barrels: sequencers of 1 to 64 steps, with barrels of 1 to BARRELS vertices, side by side
//
// Instance 8 * log2(steps) + vertices - 1 has that bit, or that byte, of each port. A vertex is the
// number that it came with.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module sequencer_barrels #(
  parameter SIZES   = 7,
  parameter BARRELS = 8,
  parameter COUNT   = SIZES * BARRELS
) (
  input  wire               clk,
  input  wire               rst,
  input  wire [COUNT-1:0]   valid_i,
  input  wire [8*COUNT-1:0] vertex_i,
  output wire [COUNT-1:0]   ready_o,
  output wire [COUNT-1:0]   valid_o,
  output wire [COUNT-1:0]   first_o,
  output wire [COUNT-1:0]   last_o,
  output wire [8*COUNT-1:0] step_o,
  output wire [8*COUNT-1:0] vertex_o
);
  genvar i;
  generate
    for (i = 0; i < COUNT; i = i + 1) begin : gen_barrel
      localparam STEPS  = 1 << (i / BARRELS);
      localparam STEP_W = STEPS > 1 ? $clog2(STEPS) : 1;
      wire [STEP_W-1:0] step;
      assign step_o[8*i +: 8] = {{(8 - STEP_W) {1'b0}}, step};

      ffd_eval_sequencer #(
        .PAYLOAD_W(8),
        .STEPS    (STEPS),
        .CONTEXTS (i % BARRELS + 1)
      ) u_sequencer (
        .clk           (clk),
        .rst           (rst),
        .s_vertex_valid(valid_i[i]),
        .s_vertex_ready(ready_o[i]),
        .s_vertex_data (vertex_i[8*i +: 8]),
        .step_valid_o  (valid_o[i]),
        .step_first_o  (first_o[i]),
        .step_last_o   (last_o[i]),
        .step_o        (step),
        .payload_o     (vertex_o[8*i +: 8])
      );
    end
  endgenerate
endmodule

`default_nettype wire
