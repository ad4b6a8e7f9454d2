// ffd_eval_sequencer: the counter of fig. 1, once for each of CONTEXTS vertices in turn
//
// Every INTERVAL clocks is a turn, and turns go round the contexts. In its turn a context emits
// the next step of its vertex, 0 to STEPS-1; an idle one takes in a vertex and emits its step 0 at
// once. So CONTEXTS vertices are a barrel: successive steps of one are CONTEXTS * INTERVAL clocks
// apart, none waits for a later one, and they leave in the order in which they came. Starts are
// spread over the barrel's time, at least START_GAP clocks apart, so that points are fetched and
// results leave evenly: with four steps and more three turns or more apart, which leaves
// ffd_eval_words time for three words one after the other.
//
// Pipeline:   step_* are registered: 1 clock after the turn, II INTERVAL.
// Freezes:    never; a context without a vertex leaves a bubble.
// Parameters: PAYLOAD_W >= 1, STEPS 1 to 64, CONTEXTS >= 1, INTERVAL >= 1. ALIGNED 1: turns keep
//             to one grid of INTERVAL clocks (the iterative evaluator wants it); 0: an idle
//             sequencer starts at once.
// Model:      none (order only).  Test: tests/unit/sequencer.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_eval_sequencer #(
  parameter PAYLOAD_W = 8,
  parameter STEPS     = 64,
  parameter CONTEXTS  = 1,
  parameter INTERVAL  = 1,
  parameter ALIGNED   = 1,
  parameter START_GAP = INTERVAL * (STEPS >= CONTEXTS + 2 ? STEPS - CONTEXTS + 1 :
                                    STEPS >= 4 ? 3 : STEPS > CONTEXTS ? 2 : 1),
  parameter STEP_W    = STEPS > 1 ? $clog2(STEPS) : 1
) (
  input  wire                 clk,
  input  wire                 rst,
  input  wire                 s_vertex_valid,
  output wire                 s_vertex_ready,
  input  wire [PAYLOAD_W-1:0] s_vertex_data,
  output reg                  step_valid_o,
  output reg                  step_first_o,
  output reg                  step_last_o,
  output wire [STEP_W-1:0]    step_o,
  output wire [PAYLOAD_W-1:0] payload_o
);
  generate
    if (STEPS < 1 || STEPS > 64) begin : gen_bad_steps
      ERROR_ffd_eval_sequencer_steps_must_be_from_1_to_64 u_error ();
    end
    if (CONTEXTS < 1 || INTERVAL < 1) begin : gen_bad_contexts
      ERROR_ffd_eval_sequencer_contexts_and_interval_must_be_at_least_1 u_error ();
    end
  endgenerate

  localparam              TOP  = STEPS - 1;
  localparam [STEP_W-1:0] LAST = TOP[STEP_W-1:0];

  wire turn;

  // The contexts shift through a ring; the first is the one whose turn it is, the last the one that
  // had it, whose step is shown. (A ring of none, refused above, would stop Verilator before it
  // comes to the refusal.)
  localparam RING = CONTEXTS < 1 ? 1 : CONTEXTS;
  wire                 head_active = gen_context[0].active_q;
  wire [STEP_W-1:0]    head_step   = gen_context[0].step_q;
  wire [PAYLOAD_W-1:0] head_data   = gen_context[0].data_q;
  wire                 may_start;
  wire                 start       = s_vertex_valid && s_vertex_ready;
  wire                 emit        = start || (turn && head_active);
  wire [STEP_W-1:0]    step        = head_active ? head_step + 1'b1 : {STEP_W{1'b0}};
  wire                 last        = step == LAST;
  wire [PAYLOAD_W-1:0] data        = head_active ? head_data : s_vertex_data;

  assign s_vertex_ready = turn && !head_active && may_start;

  generate
    if (INTERVAL == 1) begin : gen_every_clock
      assign turn = 1'b1;
    end else begin : gen_phase
      localparam               PHASE_W    = $clog2(INTERVAL);
      localparam               TOP_PHASE  = INTERVAL - 1;
      localparam [PHASE_W-1:0] LAST_PHASE = TOP_PHASE[PHASE_W-1:0];
      reg [PHASE_W-1:0] phase_q;
      reg               turn_q;     // phase_q is 0
      wire              stays = turn_q && ALIGNED == 0 && !emit;
      always @(posedge clk) begin
        if (rst || phase_q == LAST_PHASE) phase_q <= {PHASE_W{1'b0}};
        else if (!stays) phase_q <= phase_q + 1'b1;
        turn_q <= rst || phase_q == LAST_PHASE || stays;
      end
      assign turn = turn_q;
    end
  endgenerate

  generate
    if (START_GAP == 1 || (CONTEXTS == 1 && START_GAP <= INTERVAL * STEPS)) begin : gen_at_once
      assign may_start = 1'b1;
    end else begin : gen_spread
      localparam              WAIT_W = $clog2(START_GAP + 1);
      localparam              LEFT   = START_GAP - 1;
      localparam [WAIT_W-1:0] WAIT   = LEFT[WAIT_W-1:0];
      reg [WAIT_W-1:0] wait_q;
      reg              may_start_q;    // wait_q is 0
      always @(posedge clk) begin
        if (rst) begin
          wait_q      <= {WAIT_W{1'b0}};
          may_start_q <= 1'b1;
        end else if (start) begin
          wait_q      <= WAIT;
          may_start_q <= LEFT == 0;
        end else if (!may_start) begin
          wait_q      <= wait_q - 1'b1;
          may_start_q <= wait_q == 1;
        end
      end
      assign may_start = may_start_q;
    end
  endgenerate

  genvar i;
  generate
    for (i = 0; i < RING; i = i + 1) begin : gen_context
      reg                  active_q;
      reg  [STEP_W-1:0]    step_q;
      reg  [PAYLOAD_W-1:0] data_q;
      wire                 active_d;
      wire [STEP_W-1:0]    step_d;
      wire [PAYLOAD_W-1:0] data_d;

      if (i == RING - 1) begin : gen_back
        assign active_d = emit && !last;
        assign step_d   = step;
        assign data_d   = data;
      end else begin : gen_shift
        assign active_d = gen_context[i+1].active_q;
        assign step_d   = gen_context[i+1].step_q;
        assign data_d   = gen_context[i+1].data_q;
      end

      always @(posedge clk) begin
        if (rst) active_q <= 1'b0;
        else if (turn) active_q <= active_d;
      end
      always @(posedge clk) begin
        if (turn) begin
          step_q <= step_d;
          data_q <= data_d;
        end
      end
    end
  endgenerate

  always @(posedge clk) begin
    if (rst) step_valid_o <= 1'b0;
    else step_valid_o <= emit;
  end
  always @(posedge clk) begin
    step_first_o <= !head_active;
    step_last_o  <= last;
  end
  assign step_o    = gen_context[RING-1].step_q;
  assign payload_o = gen_context[RING-1].data_q;
endmodule

`default_nettype wire
