// ffd_eval_generator: the combination generator: three banks of four weights (paper, fig. 6, 3.4)
//
// Takes the weights of SIZE evaluators, each with its place {axis, function}, into the banks of a
// set, and gives the three weights of a combination: step {l, m, n} of the global index modulo 4,
// function (bank - cell) mod 4 of each axis. Of SETS sets one is read while others are filled.
//
// Pipeline:   1 clock, II 1. A weight can be read in the clock after the one in which it comes;
//             with FORWARD in that very clock.
// Parameters: WEIGHT_W >= 1, SIZE 1 or 3, SETS >= 2, FORWARD 0 or 1. At most one evaluator fills an
//             axis at a time.
// Model:      golden/include/hwffd/model/org_cg.hpp.  Test: tests/evaluator.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_eval_generator #(
  parameter WEIGHT_W = 19,
  parameter SIZE     = 1,
  parameter SETS     = 3,
  parameter FORWARD  = 0,
  parameter SET_W    = $clog2(SETS)
) (
  input  wire                     clk,
  input  wire                     weight_valid_i,
  input  wire [SET_W-1:0]         weight_set_i,
  input  wire [SIZE*4-1:0]        weight_places_i,
  input  wire [SIZE*WEIGHT_W-1:0] weights_i,
  input  wire [SET_W-1:0]         step_set_i,
  input  wire [11:0]              step_cell_i,
  input  wire [5:0]               step_i,
  output wire [3*WEIGHT_W-1:0]    combination_o
);
  generate
    if (SIZE != 1 && SIZE != 3) begin : gen_bad_size
      ERROR_ffd_eval_generator_size_must_be_1_or_3 u_error ();
    end
  endgenerate

  genvar a;
  genvar e;
  generate
    for (a = 0; a < 3; a = a + 1) begin : gen_bank
      localparam [1:0] AXIS = a;
      wire [SIZE-1:0]          here;
      wire [SIZE*WEIGHT_W-1:0] masked_weights;
      wire [SIZE*2-1:0]        masked_functions;
      reg  [WEIGHT_W-1:0]      weight;
      reg  [1:0]               function_index;
      integer                  i;

      for (e = 0; e < SIZE; e = e + 1) begin : gen_masked
        assign here[e] = weight_valid_i && weight_places_i[4*e+2 +: 2] == AXIS;
        assign masked_weights[e*WEIGHT_W +: WEIGHT_W] =
            weights_i[e*WEIGHT_W +: WEIGHT_W] & {WEIGHT_W{here[e]}};
        assign masked_functions[e*2 +: 2] = weight_places_i[4*e +: 2] & {2{here[e]}};
      end

      always @* begin
        weight         = {WEIGHT_W{1'b0}};
        function_index = 2'd0;
        for (i = 0; i < SIZE; i = i + 1) begin
          weight         = weight | masked_weights[i*WEIGHT_W +: WEIGHT_W];
          function_index = function_index | masked_functions[i*2 +: 2];
        end
      end

      wire [1:0]          blending = step_i[4-2*a +: 2] - step_cell_i[4*a +: 2];
      wire [SET_W+1:0]    write_at = {weight_set_i, function_index};
      wire [SET_W+1:0]    read_at  = {step_set_i, blending};
      wire [WEIGHT_W-1:0] stored;

      ffd_mem_sdp #(
        .WIDTH       (WEIGHT_W),
        .DEPTH       (SETS * 4),
        .READ_LATENCY(1),
        .ADDRESS_W   (SET_W + 2)
      ) u_bank (
        .clk            (clk),
        .write_i        (|here),
        .write_address_i(write_at),
        .write_data_i   (weight),
        .read_i         (1'b1),
        .read_address_i (read_at),
        .read_data_o    (stored)
      );

      if (FORWARD != 0) begin : gen_forward
        reg                fresh_q;
        reg [WEIGHT_W-1:0] weight_q;
        always @(posedge clk) begin
          fresh_q  <= |here && write_at == read_at;
          weight_q <= weight;
        end
        assign combination_o[a*WEIGHT_W +: WEIGHT_W] = fresh_q ? weight_q : stored;
      end else begin : gen_stored
        assign combination_o[a*WEIGHT_W +: WEIGHT_W] = stored;
      end
    end
  endgenerate

  wire unused_ok = &{1'b0, step_cell_i};
endmodule

`default_nettype wire
