// ffd_bench_stream: beats through hwffd_stream in an event-driven simulator, with real X
//
// For the study of engines only. Beats come from beats.hex; results go to results.txt and counts of
// events to events.txt, in the words of the recordings (tests/recorded). Both sides pause at random,
// and data is X while nothing is offered. Reset lasts RESET edges, in front of which all is X.
//
// What of the outputs is X and must be known, ffd_bench_known tells; what breaks a rule of
// docs/interface.md section 6 is told as `broken RULE clock N`.
//
// Parameters: a row of configurations.csv; BEATS, how many there are; RESULTS, after which it ends;
//             RESET; SEED of the pauses; PATIENCE, clocks without a beat or a result.
// Macros:     FFD_NETLIST: the core is a netlist, which has no parameters.
// Test:       lab/tests/engines.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`timescale 1ns/1ns
`include "ffd_eval.vh"
`include "ffd_events.vh"

module ffd_bench_stream #(
  `include "ffd_row_parameters.vh"
  parameter BEATS    = 1,
  parameter RESULTS  = 1,
  parameter RESET    = 1,
  parameter SEED     = 1,
  parameter PATIENCE = 20000
);
  localparam EVENTS   = `FFD_EVENTS;
  localparam TAIL     = 256;  // clocks in which no result may come any more
  localparam SETTLING = 4;    // registers.py

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
  wire [EVENTS-1:0] events;
  wire [31:0]  event_packet;
  wire [31:0]  event_beat;
  wire         vertex;
  wire [2:0]   waits;
  wire         idle;
  wire         upset;

  hwffd_stream
`ifndef FFD_NETLIST
  #(
    .ORG            (ORG),
    .N              (N),
    .FORMAT         (FORMAT),
    .SCHEDULE       (SCHEDULE),
    .EVALUATOR      (EVALUATOR),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (FMA_LATENCY),
    .CONVERT_LATENCY(CONVERT_LATENCY),
    .DERIVATIVES    (1),
    .DETERMINANT    (1)
  )
`endif
  u_core (
    .aclk          (aclk),
    .aresetn       (aresetn),
    .s_axis_tvalid (s_valid),
    .s_axis_tready (s_ready),
    .s_axis_tdata  (s_beat[127:0]),
    .s_axis_tlast  (s_beat[128]),
    .m_axis_tvalid (m_valid),
    .m_axis_tready (m_ready),
    .m_axis_tdata  (m_data),
    .m_axis_tlast  (m_last),
    .m_axis_tuser  (m_user),
    .grid_stop_i   (1'b0),
    .event_o       (events),
    .event_packet_o(event_packet),
    .event_beat_o  (event_beat),
    .vertex_o      (vertex),
    .wait_o        (waits),
    .idle_o        (idle),
    .upset_o       (upset)
  );

  // What must be known: outputs from the first edge in reset on, registers SETTLING edges later.
  integer clocks;
  reg     watched;
  wire    settled = watched && clocks > SETTLING;
  wire    check_m = watched && m_valid;
  wire    check_e = watched && events != 0;
  ffd_bench_known #(1, "tready")                 k_ready (aclk, watched, s_ready);
  ffd_bench_known #(1, "tvalid")                 k_valid (aclk, watched, m_valid);
  ffd_bench_known #(EVENTS, "event_o")           k_event (aclk, watched, events);
  ffd_bench_known #(1, "vertex_o")               k_vertex(aclk, watched, vertex);
  ffd_bench_known #(3, "wait_o")                 k_wait  (aclk, watched, waits);
  ffd_bench_known #(1, "idle_o")                 k_idle  (aclk, watched, idle);
  ffd_bench_known #(1, "upset_o")                k_upset (aclk, watched, upset);
  ffd_bench_known #(130, "tdata, tlast, tuser")  k_result(aclk, check_m, {m_user, m_last, m_data});
  ffd_bench_known #(64, "place of an event")     k_place (aclk, check_e,
    {event_packet, event_beat});

  reg  [128:0] beats [0:BEATS-1];
  integer      of_kind [0:EVENTS-1];
  integer      at;
  integer      got;
  integer      still;
  integer      kind;
  integer      seed;
  integer      results;
  integer      counts;
  reg          was_reset;
  wire         done = at == BEATS && !s_valid && got >= RESULTS;

  always #5 aclk = !aclk;

  // In reset and in the first clock after it, and from the very first edge on.
  always @(posedge aclk) begin
    was_reset <= !aresetn;
    watched   <= watched || !aresetn;
    if (watched && was_reset && (s_ready || m_valid)) begin
      $display("broken low_in_reset clock %0d", clocks);
    end
    if (m_valid && m_user !== 1'b0) $display("broken tuser clock %0d", clocks);
  end

  // The first beat is offered in the first clock after reset.
  always @(posedge aclk) begin
    if (aresetn && (!s_valid || s_ready)) begin
      if (at < BEATS && (at == 0 || $random(seed) % 4 != 0)) begin
        {s_valid, s_beat} <= {1'b1, beats[at]};
        at                <= at + 1;
      end else begin
        {s_valid, s_beat} <= {1'b0, 129'bx};
      end
    end
    m_ready <= $random(seed) % 4 != 0;
  end

  always @(posedge aclk) begin
    clocks <= clocks + 1;
    still  <= s_valid && s_ready === 1'b1 || m_valid === 1'b1 && m_ready ? 0 : still + 1;
    if (aresetn) begin
      if (m_valid && m_ready) begin
        $fdisplay(results, "%b_%h_%h_%h_%h", m_last, m_data[127:96], m_data[95:64],
                  m_data[63:32], m_data[31:0]);
        got <= got + 1;
      end
      for (kind = 0; kind < EVENTS; kind = kind + 1) begin
        if (events[kind]) of_kind[kind] = of_kind[kind] + 1;
      end
      if (still > (done ? TAIL : PATIENCE)) begin
        for (kind = 0; kind < EVENTS; kind = kind + 1) begin
          $fwrite(counts, "%0d%0s", of_kind[kind], kind + 1 == EVENTS ? "\n" : " ");
        end
        $display("clocks %0d beats %0d results %0d", clocks, at, got);
        $finish;
      end
    end
  end

  initial begin
    $readmemh("beats.hex", beats);
    results = $fopen("results.txt", "w");
    counts  = $fopen("events.txt", "w");
    {aclk, aresetn, s_valid, s_beat, m_ready} = {3'b000, 129'bx, 1'b0};
    {watched, was_reset} = 2'b00;
    {clocks, at, got, still} = {4{32'd0}};
    seed = SEED;
    for (kind = 0; kind < EVENTS; kind = kind + 1) of_kind[kind] = 0;
    repeat (RESET) @(posedge aclk);
    aresetn <= 1'b1;
  end
endmodule

`default_nettype wire
