// ffd_num_delay: q_o(t) = d_i(t - LATENCY)
//
// A word of WIDTH bits through LATENCY registers; a wire where LATENCY is 0. Every pipeline of the
// core is made of these, so that a latency is a parameter and never a habit.
//
// Pipeline:   LATENCY registers, II 1, never frozen.
// Reset:      RESET = 1 clears the registers (valid bits); 0 leaves data alone.
// Parameters: WIDTH >= 1, LATENCY >= 0, RESET 0 or 1.
// Model:      none (transport only).  Test: every test that depends on a latency.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_num_delay #(
  parameter WIDTH   = 1,
  parameter LATENCY = 1,
  parameter RESET   = 0
) (
  input  wire             clk,
  input  wire             rst,
  input  wire [WIDTH-1:0] d_i,
  output wire [WIDTH-1:0] q_o
);
  generate
    if (WIDTH < 1) begin : gen_bad_width
      ERROR_ffd_num_delay_width_must_be_at_least_1 u_error ();
    end
    if (LATENCY < 0) begin : gen_bad_latency
      ERROR_ffd_num_delay_latency_must_not_be_negative u_error ();
    end
  endgenerate

  genvar i;
  generate
    for (i = 0; i < LATENCY; i = i + 1) begin : gen_stage
      wire [WIDTH-1:0] data_d;
      reg  [WIDTH-1:0] data_q;
      if (i == 0) begin : gen_first
        assign data_d = d_i;
      end else begin : gen_next
        assign data_d = gen_stage[i-1].data_q;
      end
      if (RESET != 0) begin : gen_reset
        always @(posedge clk) begin
          if (rst) data_q <= {WIDTH{1'b0}};
          else data_q <= data_d;
        end
      end else begin : gen_free
        always @(posedge clk) data_q <= data_d;
      end
    end
    if (LATENCY < 1) begin : gen_wire
      assign q_o = d_i;
    end else begin : gen_output
      assign q_o = gen_stage[LATENCY-1].data_q;
    end
  endgenerate

  wire unused_ok = &{1'b0, clk, rst};
endmodule

`default_nettype wire
