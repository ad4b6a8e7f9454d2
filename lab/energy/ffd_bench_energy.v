// ffd_bench_energy: vertices through an evaluator whose organization is a netlist of cells
//
// For the study of energy only. It takes its steps from steps.hex (lab/energy/main.cpp): control
// points, while the netlist sleeps, then coefficients, then vertices, one whenever the netlist is
// ready. It compares each result with results.hex. Inputs change at the falling edge.
//
// What the nets of the netlist do is written to nets.vcd from the clock in which vertex FIRST is
// taken to the one in which the last is: whole clocks, each from QUIET before its rising edge, of
// whole vertices, while the evaluator is full.
//
// Parameters: a row of configurations.csv; how many STEPS and VERTICES there are.
// Model:      golden/include/hwffd/model/evaluator.hpp.  Test: lab/tests/energy.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`timescale 1ns/1ps
`include "ffd_eval.vh"

module ffd_bench_energy #(
  `include "ffd_row_parameters.vh"
  parameter STEPS    = 1,
  parameter VERTICES = 1,
  parameter FIRST    = 0
);
  localparam HALF_PERIOD = 5;  // ns, of synth/osu018.tcl
  localparam QUIET       = 1;
  localparam PATIENCE    = 4000;  // clocks behind the last vertex
  localparam RESET       = 4;

  localparam [3:0] STEP_END    = 4'd0;
  localparam [3:0] STEP_LOAD   = 4'd1;
  localparam [3:0] STEP_WRITE  = 4'd2;
  localparam [3:0] STEP_VERTEX = 4'd3;

  reg          clk;
  reg          rst;
  reg          asleep;
  reg  [163:0] steps [0:STEPS-1];
  reg  [95:0]  wanted [0:VERTICES-1];
  reg  [163:0] step;
  wire [3:0]   kind  = step[163:160];
  wire [31:0]  place = step[159:128];

  wire         ready;
  wire         result_valid;
  wire [383:0] result_words;
  wire [7:0]   result_flags;
  wire [15:0]  result_tag;

  ffd_bench_evaluator #(
    .ORG            (ORG),
    .N              (N),
    .FORMAT         (FORMAT),
    .SCHEDULE       (SCHEDULE),
    .EVALUATOR      (EVALUATOR),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (FMA_LATENCY),
    .CONVERT_LATENCY(CONVERT_LATENCY)
  ) u_bench (
    .clk              (clk),
    .rst              (rst),
    .load_i           (kind == STEP_LOAD),
    .load_axis_i      (place[7:6]),
    .load_address_i   (place[5:2]),
    .load_shift_i     (place[1:0]),
    .load_words_i     (step[127:0]),
    .write_i          (kind == STEP_WRITE),
    .write_support_i  (place[13:6]),
    .write_index_i    (place[5:0]),
    .write_words_i    (step[95:0]),
    .write_exponent_i (10'd0),
    .s_vertex_valid   (kind == STEP_VERTEX),
    .s_vertex_ready   (ready),
    .s_vertex_words   (step[95:0]),
    .s_vertex_second  (32'd0),
    .s_vertex_cell    (place[11:0]),
    .s_vertex_support (place[19:12]),
    .s_vertex_bank    (6'd0),
    .s_vertex_changed (place[20]),
    .s_vertex_exponent(10'd0),
    .s_vertex_tag     ({8'd0, place[19:12]}),
    .m_result_valid   (result_valid),
    .m_result_ready   (1'b1),
    .m_result_words   (result_words),
    .m_result_flags   (result_flags),
    .m_result_tag     (result_tag)
  );

  integer at;
  integer taken;
  integer got;
  integer wrong;
  integer waited;

  always #HALF_PERIOD clk = !clk;

  always @(negedge clk) begin
    if (result_valid === 1'b1) begin
      if (got >= VERTICES) wrong = wrong + 1;
      else if (result_words[95:0] !== wanted[got] || result_tag !== got[15:0]) wrong = wrong + 1;
      got = got + 1;
    end
  end

  // One step of one clock, and of a vertex as many as it waits.
  task take;
    reg done;
    begin
      done = 1'b0;
      while (!done) begin
        #(HALF_PERIOD - QUIET) done = kind != STEP_VERTEX || ready === 1'b1;
        if (kind == STEP_VERTEX && done) begin
          if (taken == FIRST) $dumpon;
          if (taken == VERTICES - 1) $dumpoff;
          taken = taken + 1;
        end
        @(negedge clk);
      end
    end
  endtask

  task wake;
    begin
      asleep = 1'b0;
      repeat (RESET) @(negedge clk);
      rst = 1'b0;
    end
  endtask

  initial begin
    $readmemh("steps.hex", steps);
    $readmemh("results.hex", wanted);
    $dumpfile("nets.vcd");
    $dumpvars(1, u_bench.u_evaluator.u_org.gen_cells.u_cells);
    $dumpoff;
    {clk, rst, asleep, step} = {1'b0, 1'b1, 1'b1, 164'd0};
    {at, taken, got, wrong, waited} = {5{32'd0}};
    @(negedge clk);
    while (steps[at][163:160] != STEP_END) begin
      if (asleep && steps[at][163:160] != STEP_WRITE) wake;
      step = steps[at];
      take;
      at = at + 1;
    end
    step = 164'd0;
    while (got < VERTICES && waited < PATIENCE) begin
      @(negedge clk);
      waited = waited + 1;
    end
    repeat (16) @(negedge clk);
    $display("compared %0d wrong %0d", got, wrong);
    $finish;
  end

  wire unused_ok = &{1'b0, result_flags, result_words[383:96]};
endmodule

`default_nettype wire
