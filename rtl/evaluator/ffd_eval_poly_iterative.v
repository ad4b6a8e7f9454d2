// ffd_eval_poly_iterative: weight = ((c3 x + c2) x + c1) x + c0 in three loops (paper, fig. 4)
//
// One multiplier and one adder. c3 is multiplexed into the loop, each pass multiplies by x and adds
// the next coefficient. With one-clock units a polynomial takes the paper's 6 clocks. In the
// overlapped schedule polynomials interleave in the loop: each passes its entry three times, so one
// may start every 3 clocks, whatever the latencies, and the multiplier is never idle.
//
// Where the file is registered, the last registers of the coefficients of other passes are cleared,
// and the choice is an OR.
//
// Formats, rounding: those of ffd_num_step and ffd_num_scale.
// Pipeline:   start_i and the address | FILE_LATENCY: the coordinate | 3 loops |
//             CONVERT_LATENCY: FFD_POLY_LATENCY in all; II 3: starts must be a multiple of 3 clocks
//             apart. The loop's length L is no multiple of 3, so 0, L and 2L differ modulo 3 and
//             the passes of polynomials a multiple of 3 clocks apart never meet. Never frozen.
// Parameters: FORMAT as in ffd_num.vh, FILE_LATENCY 0 to 2, CONVERT_LATENCY >= 0, other latencies
//             >= 1, ADDRESS_W >= 3.
// Not checked: a start that is neither a multiple of 3 clocks after another nor behind its end.
// Model:      golden/include/hwffd/model/coefficients.hpp (polynomial).
// Test:       tests/unit/polynomial, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_poly_iterative #(
  parameter FORMAT          = 18,
  parameter FILE_LATENCY    = 0,
  parameter MUL_LATENCY     = 1,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 0,
  parameter ADDRESS_W       = 4
) (
  input  wire                                            clk,
  input  wire                                            load_i,
  input  wire [ADDRESS_W-1:0]                            load_address_i,
  input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,
  input  wire                                            start_i,
  input  wire [`FFD_WEIGHT_W(FORMAT)-1:0]                coordinate_i,
  input  wire [ADDRESS_W-1:0]                            address_i,
  output wire [`FFD_WEIGHT_W(FORMAT)-1:0]                weight_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam STEP     = `FFD_STEP_LATENCY(MUL_LATENCY, ADD_LATENCY, FMA_LATENCY);
  localparam LOOP     = `FFD_LOOP_LATENCY(STEP);

  localparam LAST     = FILE_LATENCY > 0 ? 1 : 0;  // register behind the file
  localparam READ     = FILE_LATENCY - LAST;

  // What is read: a new polynomial, or one that comes round with its pass counted, 0 to 2; what has
  // ended goes on round and is nothing.
  wire                 odd_back;  // the lowest bit of its pass
  wire [ADDRESS_W-1:0] address_back;
  wire [1:0]           pass    = start_i ? 2'd0 : {odd_back, !odd_back};
  wire [ADDRESS_W-1:0] address = start_i ? address_i : address_back;

  // What goes into the loop FILE_LATENCY later.
  wire                 started;
  wire [WEIGHT_W-1:0]  coordinate_back;
  wire [WEIGHT_W-1:0]  coordinate = started ? coordinate_i : coordinate_back;
  wire [WEIGHT_W-1:0]  leading;
  wire [WEIGHT_W-1:0]  coefficient;
  wire [WEIGHT_W-1:0]  weight_back;
  wire [WEIGHT_W-1:0]  weight     = started ? leading : weight_back;
  wire [WEIGHT_W-1:0]  weight_next;

  ffd_num_delay #(
    .WIDTH  (1 + ADDRESS_W),
    .LATENCY(LOOP)
  ) u_read (
    .clk(clk),
    .rst(1'b0),
    .d_i({pass[0], address}),
    .q_o({odd_back, address_back})
  );

  ffd_num_delay #(
    .WIDTH  (1),
    .LATENCY(FILE_LATENCY)
  ) u_started (
    .clk(clk),
    .rst(1'b0),
    .d_i(start_i),
    .q_o(started)
  );

  // ---- coefficients of the pass

  wire [4*WEIGHT_W-1:0] coefficients;
  wire [WEIGHT_W-1:0]   c0 = coefficients[0*WEIGHT_W +: WEIGHT_W];
  wire [WEIGHT_W-1:0]   c1 = coefficients[1*WEIGHT_W +: WEIGHT_W];
  wire [WEIGHT_W-1:0]   c2 = coefficients[2*WEIGHT_W +: WEIGHT_W];
  wire [WEIGHT_W-1:0]   c3 = coefficients[3*WEIGHT_W +: WEIGHT_W];
  wire [1:0]            shift_read;
  wire [1:0]            shift;
  wire [1:0]            pass_read;

  ffd_eval_coefficient_file #(
    .FORMAT      (FORMAT),
    .PORTS       (1),
    .READ_LATENCY(READ),
    .ADDRESS_W   (ADDRESS_W)
  ) u_file (
    .clk            (clk),
    .load_i         (load_i),
    .load_address_i (load_address_i),
    .load_entry_i   (load_entry_i),
    .address_i      (address),
    .coefficient_o  (coefficients),
    .shift_address_i(address_back),
    .shift_o        (shift_read)
  );

  ffd_num_delay #(
    .WIDTH  (2),
    .LATENCY(READ)
  ) u_pass (
    .clk(clk),
    .rst(1'b0),
    .d_i(pass),
    .q_o(pass_read)
  );

  ffd_num_delay #(
    .WIDTH  (2 + WEIGHT_W),
    .LATENCY(LAST)
  ) u_leading (
    .clk(clk),
    .rst(1'b0),
    .d_i({shift_read, c3}),
    .q_o({shift, leading})
  );

  generate
    if (LAST == 0) begin : gen_choice
      assign coefficient = pass_read == 2'd0 ? c2 : pass_read == 2'd1 ? c1 : c0;
    end else begin : gen_cleared
      reg [WEIGHT_W-1:0] c0_q;
      reg [WEIGHT_W-1:0] c1_q;
      reg [WEIGHT_W-1:0] c2_q;
      always @(posedge clk) begin
        if (pass_read != 2'd0) c2_q <= {WEIGHT_W{1'b0}};
        else c2_q <= c2;
        if (pass_read != 2'd1) c1_q <= {WEIGHT_W{1'b0}};
        else c1_q <= c1;
        if (pass_read != 2'd2) c0_q <= {WEIGHT_W{1'b0}};
        else c0_q <= c0;
      end
      assign coefficient = c2_q | c1_q | c0_q;
    end
  endgenerate

  // ---- the loop

  ffd_num_step #(
    .FORMAT     (FORMAT),
    .MUL_LATENCY(MUL_LATENCY),
    .ADD_LATENCY(ADD_LATENCY),
    .FMA_LATENCY(FMA_LATENCY)
  ) u_step (
    .clk          (clk),
    .coefficient_i(coefficient),
    .coordinate_i (coordinate),
    .weight_i     (weight),
    .weight_o     (weight_next)
  );

  ffd_num_delay #(
    .WIDTH  (WEIGHT_W),
    .LATENCY(LOOP - STEP)
  ) u_weight (
    .clk(clk),
    .rst(1'b0),
    .d_i(weight_next),
    .q_o(weight_back)
  );

  ffd_num_delay #(
    .WIDTH  (WEIGHT_W),
    .LATENCY(LOOP)
  ) u_coordinate (
    .clk(clk),
    .rst(1'b0),
    .d_i(coordinate),
    .q_o(coordinate_back)
  );

  ffd_num_scale #(
    .FORMAT (FORMAT),
    .LATENCY(CONVERT_LATENCY)
  ) u_scale (
    .clk     (clk),
    .weight_i(weight_back),
    .shift_i (shift),
    .weight_o(weight_o)
  );
endmodule

`default_nettype wire
