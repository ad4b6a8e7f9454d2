// ffd_bench_random: any packets through hwffd_stream_bus with any parameters, with real X
//
// Beats come from beats.hex, each with what its part of the stream asks for: to begin in an idle core,
// and how the source offers and the sink takes beats (words.cpp). A result is a line of results.txt; an
// idle core at the end of a part another, with the events, vertices and clocks of each wait since the
// last one. Data is X while nothing is offered.
//
// What of the outputs is X and must be known, ffd_bench_known tells; what breaks a rule of
// docs/interface.md is told as `broken RULE clock N`.
//
// Parameters: those of hwffd_stream_bus; BEATS, how many there are; SEED of the pauses; PATIENCE, clocks
//             without a beat or a result in a core that is not idle: one unit in the paper's schedule
//             takes some 7,000 for a vertex with its derivatives.
// Test:       tests/random.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`timescale 1ns/1ns
`include "ffd_num.vh"
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module ffd_bench_random #(
  `include "ffd_row_parameters.vh"
  parameter AXIS           = 16,
  parameter PAGES          = 2,
  parameter IN_FLIGHT      = 0,
  parameter WAITING        = 16,
  parameter RESIDENT       = 1,
  parameter INTERLEAVED    = 1,
  parameter PAGED          = 0,
  parameter FOURTH         = 0,
  parameter GRIDS          = 0,
  parameter PACKED         = 0,
  parameter MARKS          = 0,
  parameter DERIVATIVES    = 0,
  parameter DETERMINANT    = 0,
  parameter HALVES         = 0,
  parameter SPANS          = 1,
  parameter HARDENED       = 0,
  parameter RESET_REGISTER = 0,
  parameter DATA_WIDTH     = 128,
  parameter BEATS          = 1,
  parameter SEED           = 1,
  parameter PATIENCE       = 40000
);
  localparam GRID_LIMIT = 48;  // refuses none
  localparam STUCK = 300;  // clocks without a beat in, after which a late sink begins
  localparam TAIL  = 64;   // clocks in which no result may come any more

  reg          aclk;
  reg          aresetn;
  reg          s_valid;
  reg  [128:0] s_beat;
  wire         s_ready;
  wire         m_valid;
  reg          m_ready;
  wire [127:0] m_data;
  wire         m_last;
  wire         m_user;
  wire [`FFD_EVENTS-1:0] events;
  wire [31:0]  event_packet;
  wire [31:0]  event_beat;
  wire         vertex;
  wire [1:0]   second;
  wire [2:0]   waits;
  wire         idle;
  wire         upset;

  wire                    in_valid, in_ready, in_last;
  wire [DATA_WIDTH-1:0]   in_data;
  wire [DATA_WIDTH/8-1:0] in_keep;
  wire                    out_valid, out_ready, out_last, out_user;
  wire [DATA_WIDTH-1:0]   out_data;
  wire [DATA_WIDTH/8-1:0] out_keep;

  ffd_bench_units_to #(
    .WIDTH(DATA_WIDTH)
  ) u_to (
    .clk    (aclk),
    .s_valid(s_valid),
    .s_ready(s_ready),
    .s_unit (s_beat[127:0]),
    .s_last (s_beat[128]),
    .m_valid(in_valid),
    .m_ready(in_ready),
    .m_data (in_data),
    .m_keep (in_keep),
    .m_last (in_last)
  );

  ffd_bench_units_from #(
    .WIDTH(DATA_WIDTH)
  ) u_from (
    .clk    (aclk),
    .s_valid(out_valid),
    .s_ready(out_ready),
    .s_data (out_data),
    .s_keep (out_keep),
    .s_last (out_last),
    .s_user (out_user),
    .m_valid(m_valid),
    .m_ready(m_ready),
    .m_unit (m_data),
    .m_last (m_last),
    .m_user (m_user)
  );

  hwffd_stream_bus #(
    .RESET_REGISTER   (RESET_REGISTER),
    .DATA_WIDTH       (DATA_WIDTH),
    `include "ffd_stream_arguments.vh"
  ) u_core (
    .aclk          (aclk),
    .aresetn       (aresetn),
    .s_axis_tvalid (in_valid),
    .s_axis_tready (in_ready),
    .s_axis_tdata  (in_data),
    .s_axis_tkeep  (in_keep),
    .s_axis_tlast  (in_last),
    .m_axis_tvalid (out_valid),
    .m_axis_tready (out_ready),
    .m_axis_tdata  (out_data),
    .m_axis_tkeep  (out_keep),
    .m_axis_tlast  (out_last),
    .m_axis_tuser  (out_user),
    .grid_stop_i   (1'b0),
    .event_o       (events),
    .event_packet_o(event_packet),
    .event_beat_o  (event_beat),
    .vertex_o      (vertex),
    .second_o      (second),
    .wait_o        (waits),
    .idle_o        (idle),
    .upset_o       (upset)
  );

  reg  watched;
  wire check_m = watched && m_valid;
  wire check_e = watched && events != 0;
  ffd_bench_known #(9, "tready, tvalid, vertex_o, second_o, wait_o or idle_o") k_control(
      aclk, watched, {in_ready, out_valid, vertex, second, waits, idle});
  ffd_bench_known #(1, "upset_o")               k_upset (aclk, watched, upset);
  ffd_bench_known #(`FFD_EVENTS, "event_o")     k_event (aclk, watched, events);
  ffd_bench_known #(130, "tdata, tlast, tuser") k_result(aclk, check_m, {m_user, m_last, m_data});
  ffd_bench_known #(64, "place of an event")    k_place (aclk, check_e, {event_packet, event_beat});

  reg  [139:0]  beats [0:BEATS-1];  // {pace, drain}, tlast, data
  wire [139:0]  next = beats[at];
  integer       counts [0:`FFD_EVENTS+3];
  integer       at;
  integer       still;     // clocks without a beat in or out
  integer       unmoved;   // without one in
  integer       quiet;
  integer       clocks;
  integer       seed;
  integer       results;
  integer       k;
  reg           idle_q;
  reg           late;      // the sink waits no more
  reg           bursting;
  reg  [1:0]    sink;
  reg  [1:0]    source;
  reg  [129:0]  held;
  reg           holds;
  wire          drained = idle === 1'b1 && idle_q && !s_valid && m_valid === 1'b0;
  wire          ended   = at == BEATS;
  wire          barrier = !ended && next[132] && at != 0;
  reg           begun;     // the core was idle, and the next part may come

  always #5 aclk = !aclk;

  function pace;
    input [1:0] kind;
    case (kind)
      2'd0:    pace = 1'b1;
      2'd1:    pace = $random(seed) % 4 != 0;
      2'd2:    pace = $random(seed) % 8 == 0;
      default: pace = bursting;
    endcase
  endfunction

  task tell;
    begin
      $fwrite(results, "=");
      for (k = 0; k < `FFD_EVENTS + 4; k = k + 1) begin
        $fwrite(results, " %0d", counts[k]);
        counts[k] = 0;
      end
      $fwrite(results, "\n");
    end
  endtask

  always @(posedge aclk) begin
    clocks   <= clocks + 1;
    bursting <= $random(seed) % 16 == 0 ? !bursting : bursting;
    idle_q   <= idle === 1'b1;
    watched  <= watched || (!aresetn && clocks >= RESET_REGISTER);
    holds    <= aresetn && m_valid === 1'b1 && !m_ready;
    held     <= {m_user, m_last, m_data};
    unmoved  <= s_valid && s_ready === 1'b1 ? 0 : unmoved + 1;
    still    <= s_valid && s_ready === 1'b1 || m_valid === 1'b1 && m_ready ? 0 : still + 1;
    if (holds && (m_valid !== 1'b1 || held !== {m_user, m_last, m_data})) begin
      $display("broken held_result clock %0d", clocks);
    end
    if (watched && upset === 1'b1) $display("broken upset clock %0d", clocks);

    if (!s_valid || s_ready) begin
      {s_valid, s_beat} <= {1'b0, 129'bx};
      if (aresetn && !ended && (!barrier || begun) && pace(source)) begin
        {s_valid, s_beat} <= {1'b1, next[128:0]};
        at                <= at + 1;
        begun             <= 1'b0;
      end
    end
    if (unmoved > STUCK) late <= 1'b1;
    // A part begins in an idle core.
    if (aresetn && !begun && drained && (barrier || ended)) begin
      if (quiet == 0) tell;
      quiet <= quiet + 1;
      if (!ended) begin
        {source, sink} <= next[136:133];
        begun          <= 1'b1;
        late           <= 1'b0;
        unmoved        <= 0;
        quiet          <= 0;
      end
    end
    m_ready <= sink == 2'd3 ? late : pace(sink);

    if (aresetn) begin
      if (m_valid && m_ready) begin
        $fdisplay(results, "%b %b %h %h %h %h", m_user, m_last, m_data[127:96], m_data[95:64],
                  m_data[63:32], m_data[31:0]);
        if (quiet != 0) $display("broken quiet clock %0d", clocks);
      end
      for (k = 0; k < `FFD_EVENTS; k = k + 1) if (events[k]) counts[k] = counts[k] + 1;
      if (second[1]) counts[`FFD_EVENT_SATURATED] = counts[`FFD_EVENT_SATURATED] + 1;
      if (vertex) counts[`FFD_EVENTS] = counts[`FFD_EVENTS] + 1;
      if (second[0]) counts[`FFD_EVENTS] = counts[`FFD_EVENTS] + 1;
      for (k = 0; k < 3; k = k + 1) begin
        if (waits[k]) counts[`FFD_EVENTS+1+k] = counts[`FFD_EVENTS+1+k] + 1;
      end
    end
    if (quiet == TAIL || still == PATIENCE) begin
      if (quiet != TAIL) $display("broken hangs clock %0d", clocks);
      $display("clocks %0d beats %0d", clocks, at);
      $finish;
    end
  end

  initial begin
    $readmemh("beats.hex", beats);
    results = $fopen("results.txt", "w");
    {aclk, aresetn, s_valid, s_beat, m_ready}               = {3'b000, 129'bx, 1'b0};
    {watched, idle_q, late, bursting, holds, begun}         = 6'd0;
    {clocks, at, still, unmoved, quiet}                     = {5{32'd0}};
    {source, sink}                                          = beats[0][136:133];
    seed = SEED;
    for (k = 0; k < `FFD_EVENTS + 4; k = k + 1) counts[k] = 0;
    repeat (2) @(posedge aclk);
    aresetn <= 1'b1;
  end
endmodule

`default_nettype wire
