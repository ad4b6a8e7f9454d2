// ffd_stream_functions: which blending functions are in use, and where those that come are loaded
//
// There are two banks. A packet of coefficients fills the one that is not in use and takes it into
// use with its last beat. With spans it gives all spans of all axes the same functions.
//
// With SPANS above 1 packets of spans (opcode 9) bring functions of some spans of one axis, and one
// with the flag E takes all that came into use. So each span has two halves of its own, and a table
// says which is in use, whether the other one is filled, and whether the span has functions of its
// own at all or those of the last packet of coefficients, which have a place and two halves too.
// What a set does not bring, stays: nothing is copied. The table is a memory, so a change of all
// spans walks through it; until then an entry of the epoch before says that it is still to change.
//
// Bad input:  a span that came only in part is not part of the set, and a packet that was cut short
//             takes nothing into use. A packet of coefficients drops what came of a set. SUMS 1:
//             functions of an axis that do not sum up are told, and taken.
// Formats:    places FFD_PLACES_W, loads FFD_OWN_W in ffd_eval.vh; cell {k, j, i}, origin {u, t,
//             s}, an entry of the table {epoch, filled, own, half}.
// Pipeline:   beats are taken; loads go with their numbers, LATENCY clocks later; a vertex that is
//             there in one clock has its places in the next, as they were when it was taken.
// Freezes:    never. busy_o is 1 from a change on until all spans know of it, SPANS clocks; until
//             then no packet of functions comes.
// Parameters: SPANS 1 to 128; LATENCY >= 1, with spans 1 to 4; AXIS as in ffd_stream_header; SUMS
//             0 or 1.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module ffd_stream_functions #(
  parameter SPANS   = 1,
  parameter LATENCY = 1,
  parameter AXIS    = 16,
  parameter SUMS    = 0
) (
  input  wire                               clk,
  input  wire                               rst,
  input  wire                               take_i,
  input  wire [127:0]                       data_i,
  input  wire [`FFD_FRAME_W-1:0]            frame_i,
  output wire [1:0]                         degree_o,        // of the function that is taken
  output wire                               change_o,        // others are in use after this beat
  output wire                               busy_o,
  output reg                                bank_o,          // changes with each of them
  output reg                                loaded_o,
  output reg                                derivatives_o,
  output wire                               sum_fault_o,     // of the functions of an axis
  input  wire [11:0]                        place_there_i,   // as FFD_FRAME_INDEX
  output wire [1:0]                         load_axis_o,
  output wire [`FFD_OWN_W(SPANS)-1:0]       load_address_o,
  output wire [1:0]                         load_shift_o,
  input  wire [3*`FFD_AXIS_W(AXIS)-1:0]     cell_i,          // of a vertex, with its beat
  input  wire [20:0]                        origin_i,        // of its page, likewise
  input  wire                               cell_there_i,
  output wire [`FFD_PLACES_W(SPANS)-1:0]    places_o
);
  wire        header        = frame_i[`FFD_FRAME_HEADER];
  wire        function_beat = frame_i[`FFD_FRAME_FUNCTION];
  wire        top           = frame_i[`FFD_FRAME_TOP];
  wire [11:0] index         = frame_i[`FFD_FRAME_INDEX];  // function, axis, derivative
  wire        done          = take_i && function_beat && top;  // all, or a span

  // ---- what the header says, word 2

  // Two bits an axis, from the one on that the next function is of.
  reg  [5:0] degree_q;
  reg  [5:0] shift_q;
  reg  [5:0] derivative_shift_q;
  reg        twice_q;
  wire       turns;     // to the next axis
  always @(posedge clk) begin
    if (take_i && header) begin
      degree_q           <= data_i[69:64];
      shift_q            <= data_i[77:72];
      derivative_shift_q <= data_i[85:80];
      twice_q            <= data_i[95];
    end else if (turns) begin
      degree_q           <= {degree_q[1:0], degree_q[5:2]};
      shift_q            <= {shift_q[1:0], shift_q[5:2]};
      derivative_shift_q <= {derivative_shift_q[1:0], derivative_shift_q[5:2]};
    end
  end

  assign degree_o = degree_q[1:0];

  always @(posedge clk) begin
    if (rst) bank_o <= 1'b0;
    else if (change_o) bank_o <= !bank_o;
  end

  // ---- whether they sum up

  wire [1:0] function_shift;
  wire       of_derivative;
  generate
    if (SUMS != 0) begin : gen_sums
      ffd_stream_sums #(
        .LATENCY(LATENCY)
      ) u_sums (
        .clk         (clk),
        .rst         (rst),
        .take_i      (take_i && function_beat),
        .words_i     (data_i),
        .function_i  (index[1:0]),
        .degree_i    (degree_o),
        .shift_i     (function_shift),
        .derivative_i(of_derivative),
        .fault_o     (sum_fault_o)
      );
    end else begin : gen_no_sums
      assign sum_fault_o = 1'b0;
      wire unused_ok = &{1'b0, function_shift, of_derivative};
    end
  endgenerate

  generate
    if (SPANS == 1) begin : gen_single
      assign function_shift = index[8] ? derivative_shift_q[1:0] : shift_q[1:0];
      assign of_derivative  = index[8];
      assign turns    = take_i && function_beat && index[1:0] == 2'd3;
      assign change_o = done;
      assign busy_o   = 1'b0;
      assign places_o = bank_o;

      always @(posedge clk) begin
        if (rst) begin
          loaded_o      <= 1'b0;
          derivatives_o <= 1'b0;
        end else if (change_o) begin
          loaded_o      <= 1'b1;
          derivatives_o <= twice_q;
        end
      end

      ffd_num_delay #(
        .WIDTH  (3),
        .LATENCY(LATENCY)
      ) u_load (
        .clk(clk),
        .rst(1'b0),
        .d_i({!bank_o, function_shift}),
        .q_o({load_address_o[2], load_shift_o})
      );
      assign load_axis_o         = place_there_i[5:4];
      assign load_address_o[3]   = place_there_i[8];
      assign load_address_o[1:0] = place_there_i[1:0];

      wire unused_ok = &{1'b0, place_there_i, cell_there_i, cell_i, origin_i, data_i, frame_i,
                         index};
    end else begin : gen_spans
      localparam               SPAN_W   = `FFD_SPAN_W(SPANS);
      localparam               PLACE_W  = 2 + SPAN_W;
      localparam               ENTRY_W  = 4;
      localparam [31:0]        TOP_SPAN = SPANS - 1;
      localparam [SPAN_W-1:0]  LAST     = TOP_SPAN[SPAN_W-1:0];
      localparam [31:0]        NONE     = 0;

      // ---- the packet

      wire [`FFD_PACKET_W-1:0] packet = frame_i[`FFD_FRAME_PACKET];
      reg              spans_q;  // else of every cell
      reg              ends_q;
      reg [1:0]        axis_q;
      reg [SPAN_W-1:0] span_q;
      always @(posedge clk) begin
        if (take_i && header) begin
          spans_q <= packet[`FFD_PACKET_SPANS];
          ends_q  <= data_i[16];
          axis_q  <= data_i[87:86];
        end
      end
      always @(posedge clk) begin
        if (take_i && header) span_q <= data_i[72 +: SPAN_W];
        else if (done) span_q <= span_q + 1'b1;
      end

      wire [1:0] axis       = spans_q ? axis_q : index[5:4];
      wire       derivative = spans_q ? index[4] : index[8];
      wire [1:0] own_shift  = spans_q ? degree_q[5:4] : shift_q[1:0];
      wire [1:0] its_shift  = spans_q ? derivative_shift_q[3:2] : derivative_shift_q[1:0];
      assign function_shift = derivative ? its_shift : own_shift;
      assign of_derivative  = derivative;
      assign turns    = take_i && function_beat && index[1:0] == 2'd3 && !spans_q;
      assign change_o = done && (!spans_q || (ends_q && frame_i[`FFD_FRAME_FINAL]));

      reg plain_q;  // a span of this set has no derivatives
      always @(posedge clk) begin
        if (rst || change_o) plain_q <= 1'b0;
        else if (done && !twice_q) plain_q <= 1'b1;
      end
      always @(posedge clk) begin
        if (rst) begin
          loaded_o      <= 1'b0;
          derivatives_o <= 1'b0;
        end else if (change_o) begin
          loaded_o      <= loaded_o || !spans_q;
          derivatives_o <= twice_q && (!spans_q || (derivatives_o && !plain_q));
        end
      end

      // ---- the change: vertices before it have their places, since they came five beats before

      if (LATENCY > 4) begin : gen_bad_latency
        ERROR_ffd_stream_functions_latency_must_be_1_to_4_with_spans u_error ();
      end
      wire turn_uniform = change_o && !spans_q;

      reg              walk_q;
      reg              uniform_walk_q;
      reg              epoch_q;
      reg              uniform_half_q;
      reg [SPAN_W-1:0] at_q;
      wire             walked = walk_q && at_q == LAST;
      assign busy_o = walk_q;
      always @(posedge clk) begin
        if (rst) begin
          walk_q         <= 1'b0;
          uniform_walk_q <= 1'b0;
          epoch_q        <= 1'b0;
          uniform_half_q <= 1'b0;
        end else begin
          walk_q         <= change_o || (walk_q && !walked);
          uniform_walk_q <= turn_uniform || (uniform_walk_q && !walked);
          epoch_q        <= epoch_q ^ (change_o && !turn_uniform);
          uniform_half_q <= uniform_half_q ^ turn_uniform;
        end
      end
      always @(posedge clk) at_q <= walk_q ? at_q + 1'b1 : {SPAN_W{1'b0}};

      localparam AXIS_W = `FFD_AXIS_W(AXIS);
      wire [3*AXIS_W-1:0] cell_there;
      wire [20:0]         origin_there;
      ffd_num_delay #(
        .WIDTH  (3 * AXIS_W + 21),
        .LATENCY(LATENCY)
      ) u_cell (
        .clk(clk),
        .rst(1'b0),
        .d_i({cell_i, origin_i}),
        .q_o({cell_there, origin_there})
      );

      // ---- the table, once for vertices and once for what changes it

      wire [SPAN_W-1:0] edit = walk_q ? at_q : span_q;
      wire [2:0]        half;

      genvar a;
      for (a = 0; a < 3; a = a + 1) begin : gen_axis
        localparam [1:0] NUMBER = a;
        wire [ENTRY_W-1:0] old;
        wire [ENTRY_W-1:0] changed;
        wire               filled = old[2] && !uniform_walk_q;
        wire               unused_epoch = old[3];
        assign half[a] = old[0];
        assign changed = walk_q ? {epoch_q, 1'b0, filled || (old[1] && !uniform_walk_q),
                                   (old[0] && !uniform_walk_q) ^ filled}
                                : {epoch_q, top, old[1:0]};

        wire [7:0]         sum  = {{(8 - AXIS_W) {1'b0}}, cell_there[AXIS_W*a +: AXIS_W]}
                                + {1'b0, origin_there[7*a +: 7]};
        reg  [SPAN_W-1:0]  read_q;
        wire [ENTRY_W-1:0] entry;
        always @(posedge clk) begin
          if (cell_there_i) read_q <= sum > TOP_SPAN[7:0] ? LAST : sum[SPAN_W-1:0];
        end

        genvar copy;
        for (copy = 0; copy < 2; copy = copy + 1) begin : gen_copy
          wire [ENTRY_W-1:0] read;
          ffd_mem_sdp #(
            .WIDTH       (ENTRY_W),
            .DEPTH       (1 << SPAN_W),
            .READ_LATENCY(0)
          ) u_table (
            .clk            (clk),
            .write_i        (walk_q || (take_i && function_beat && spans_q && axis_q == NUMBER)),
            .write_address_i(edit),
            .write_data_i   (changed),
            .read_i         (1'b1),
            .read_address_i (copy == 0 ? edit : read_q),
            .read_data_o    (read)
          );
        end
        assign old   = gen_copy[0].read;
        assign entry = gen_copy[1].read;

        wire turned  = entry[3] != epoch_q && entry[2];  // still to change
        wire own     = (entry[1] || turned) && loaded_o && !uniform_walk_q;
        assign places_o[PLACE_W*a +: PLACE_W] = {!own, read_q & {SPAN_W{own}},
                                                 own ? entry[0] ^ turned : uniform_half_q};
      end

      // ---- where a function goes

      wire [SPAN_W-1:0] place = spans_q ? span_q : NONE[SPAN_W-1:0];
      wire              free  = !(spans_q ? half[axis] : uniform_half_q);
      ffd_num_delay #(
        .WIDTH  (4 + `FFD_OWN_W(SPANS)),
        .LATENCY(LATENCY)
      ) u_load (
        .clk(clk),
        .rst(1'b0),
        .d_i({axis, function_shift, !spans_q, place, derivative, free,
              index[1:0]}),
        .q_o({load_axis_o, load_shift_o, load_address_o})
      );

      wire unused_ok = &{1'b0, place_there_i, data_i, frame_i, packet, index};
    end
  endgenerate
endmodule

`default_nettype wire
