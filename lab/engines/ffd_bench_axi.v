// ffd_bench_axi: hwffd_axi between memory and the steps of a driver, with real X
//
// For the study of engines only. What software does is in steps.hex: 4 bits of a kind (of STEP_*),
// 12 of an address, 32 of data. Behind the last step RESULTS words of memory from FIRST on go to
// results.txt, in the words of the recordings (tests/recorded). Requests pause at random, and what is
// beside them is X while none is there. Reset lasts RESET edges, in front of which all is X.
//
// What of the outputs is X and must be known, ffd_bench_known tells; what breaks a rule of
// docs/registers.md section 1 or docs/interface.md sections 8 and 9 is told as
// `broken RULE clock N`.
//
// Parameters: a row of configurations.csv; STEPS, WORDS of memory, RESULTS and FIRST; RESET; SEED of
//             the pauses; PATIENCE, clocks in which nothing is taken on its buses.
// Test:       lab/tests/engines.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`timescale 1ns/1ns
`include "ffd_eval.vh"

module ffd_bench_axi #(
  `include "ffd_row_parameters.vh"
  parameter STEPS    = 1,
  parameter WORDS    = 1,
  parameter RESULTS  = 1,
  parameter FIRST    = 0,
  parameter RESET    = 1,
  parameter SEED     = 1,
  parameter PATIENCE = 20000
);
  localparam ADDRESS_WIDTH = 64;
  localparam DATA_WIDTH    = 128;
  localparam CLEARING      = 18;  // clocks after reset in which no request is taken
  localparam SETTLING      = 4;   // registers.py

  localparam [3:0] STEP_END   = 4'd0;
  localparam [3:0] STEP_WRITE = 4'd1;
  localparam [3:0] STEP_READ  = 4'd2;
  localparam [3:0] STEP_EQUAL = 4'd3;  // a read, of that data
  localparam [3:0] STEP_WAIT  = 4'd4;  // for the interrupt

  reg          aclk;
  reg          aresetn;
  wire         irq;
  wire         sleep;

  reg          s_axil_awvalid;
  wire         s_axil_awready;
  reg  [11:0]  s_axil_awaddr;
  wire [2:0]   s_axil_awprot = 3'd0;
  reg          s_axil_wvalid;
  wire         s_axil_wready;
  reg  [31:0]  s_axil_wdata;
  reg  [3:0]   s_axil_wstrb;
  wire         s_axil_bvalid;
  reg          s_axil_bready;
  wire [1:0]   s_axil_bresp;
  reg          s_axil_arvalid;
  wire         s_axil_arready;
  reg  [11:0]  s_axil_araddr;
  wire [2:0]   s_axil_arprot = 3'd0;
  wire         s_axil_rvalid;
  reg          s_axil_rready;
  wire [31:0]  s_axil_rdata;
  wire [1:0]   s_axil_rresp;

  wire         m_axi_arvalid;
  wire         m_axi_arready;
  wire [63:0]  m_axi_araddr;
  wire [7:0]   m_axi_arlen;
  wire [2:0]   m_axi_arsize;
  wire [1:0]   m_axi_arburst;
  wire [3:0]   m_axi_arcache;
  wire [2:0]   m_axi_arprot;
  wire         m_axi_rvalid;
  wire         m_axi_rready;
  wire [127:0] m_axi_rdata;
  wire [1:0]   m_axi_rresp;
  wire         m_axi_rlast;
  wire         m_axi_awvalid;
  wire         m_axi_awready;
  wire [63:0]  m_axi_awaddr;
  wire [7:0]   m_axi_awlen;
  wire [2:0]   m_axi_awsize;
  wire [1:0]   m_axi_awburst;
  wire [3:0]   m_axi_awcache;
  wire [2:0]   m_axi_awprot;
  wire         m_axi_wvalid;
  wire         m_axi_wready;
  wire [127:0] m_axi_wdata;
  wire [15:0]  m_axi_wstrb;
  wire         m_axi_wlast;
  wire         m_axi_bvalid;
  wire         m_axi_bready;
  wire [1:0]   m_axi_bresp;
  wire         m_axi_arid;
  wire         m_axi_awid;

  hwffd_axi #(
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
  ) u_core (
    .aclk          (aclk),
    .aresetn       (aresetn),
    .irq_o         (irq),
    .sleep_o       (sleep),
    .m_axi_arid    (m_axi_arid),
    .m_axi_awid    (m_axi_awid),
    .s_axil_awvalid(s_axil_awvalid),
    .s_axil_awready(s_axil_awready),
    .s_axil_awaddr (s_axil_awaddr),
    .s_axil_awprot (s_axil_awprot),
    .s_axil_wvalid (s_axil_wvalid),
    .s_axil_wready (s_axil_wready),
    .s_axil_wdata  (s_axil_wdata),
    .s_axil_wstrb  (s_axil_wstrb),
    .s_axil_bvalid (s_axil_bvalid),
    .s_axil_bready (s_axil_bready),
    .s_axil_bresp  (s_axil_bresp),
    .s_axil_arvalid(s_axil_arvalid),
    .s_axil_arready(s_axil_arready),
    .s_axil_araddr (s_axil_araddr),
    .s_axil_arprot (s_axil_arprot),
    .s_axil_rvalid (s_axil_rvalid),
    .s_axil_rready (s_axil_rready),
    .s_axil_rdata  (s_axil_rdata),
    .s_axil_rresp  (s_axil_rresp),
    .m_axi_arvalid (m_axi_arvalid),
    .m_axi_arready (m_axi_arready),
    .m_axi_araddr  (m_axi_araddr),
    .m_axi_arlen   (m_axi_arlen),
    .m_axi_arsize  (m_axi_arsize),
    .m_axi_arburst (m_axi_arburst),
    .m_axi_arcache (m_axi_arcache),
    .m_axi_arprot  (m_axi_arprot),
    .m_axi_rvalid  (m_axi_rvalid),
    .m_axi_rready  (m_axi_rready),
    .m_axi_rdata   (m_axi_rdata),
    .m_axi_rresp   (m_axi_rresp),
    .m_axi_rlast   (m_axi_rlast),
    .m_axi_awvalid (m_axi_awvalid),
    .m_axi_awready (m_axi_awready),
    .m_axi_awaddr  (m_axi_awaddr),
    .m_axi_awlen   (m_axi_awlen),
    .m_axi_awsize  (m_axi_awsize),
    .m_axi_awburst (m_axi_awburst),
    .m_axi_awcache (m_axi_awcache),
    .m_axi_awprot  (m_axi_awprot),
    .m_axi_wvalid  (m_axi_wvalid),
    .m_axi_wready  (m_axi_wready),
    .m_axi_wdata   (m_axi_wdata),
    .m_axi_wstrb   (m_axi_wstrb),
    .m_axi_wlast   (m_axi_wlast),
    .m_axi_bvalid  (m_axi_bvalid),
    .m_axi_bready  (m_axi_bready),
    .m_axi_bresp   (m_axi_bresp)
  );

  ffd_bench_memory #(
    .WORDS(WORDS),
    .SEED (SEED)
  ) u_memory (
    .clk      (aclk),
    .rst      (!aresetn),
    .arvalid_i(m_axi_arvalid),
    .arready_o(m_axi_arready),
    .araddr_i (m_axi_araddr),
    .arlen_i  (m_axi_arlen),
    .rvalid_o (m_axi_rvalid),
    .rready_i (m_axi_rready),
    .rdata_o  (m_axi_rdata),
    .rresp_o  (m_axi_rresp),
    .rlast_o  (m_axi_rlast),
    .awvalid_i(m_axi_awvalid),
    .awready_o(m_axi_awready),
    .awaddr_i (m_axi_awaddr),
    .wvalid_i (m_axi_wvalid),
    .wready_o (m_axi_wready),
    .wdata_i  (m_axi_wdata),
    .wstrb_i  (m_axi_wstrb),
    .wlast_i  (m_axi_wlast),
    .bvalid_o (m_axi_bvalid),
    .bready_i (m_axi_bready),
    .bresp_o  (m_axi_bresp)
  );

  // What must be known: outputs from the first edge in reset on, registers SETTLING edges later.
  integer clocks;
  reg     watched;
  wire    settled = watched && clocks > SETTLING;
  wire [2:0] s_ready = {s_axil_awready, s_axil_wready, s_axil_arready};
  wire [1:0] s_valid = {s_axil_bvalid, s_axil_rvalid};
  wire [2:0] m_valid = {m_axi_arvalid, m_axi_awvalid, m_axi_wvalid};
  wire [1:0] m_ready = {m_axi_rready, m_axi_bready};
  wire check_b  = watched && s_axil_bvalid;
  wire check_r  = watched && s_axil_rvalid;
  wire check_ar = watched && m_axi_arvalid;
  wire check_aw = watched && m_axi_awvalid;
  wire check_w  = watched && m_axi_wvalid;
  ffd_bench_known #(2, "irq_o, sleep_o")         k_irq  (aclk, watched, {irq, sleep});
  ffd_bench_known #(3, "s_axil readies")         k_ready(aclk, watched, s_ready);
  ffd_bench_known #(2, "s_axil valids")          k_valid(aclk, watched, s_valid);
  ffd_bench_known #(3, "m_axi valids")           k_asks (aclk, watched, m_valid);
  ffd_bench_known #(2, "m_axi readies")          k_takes(aclk, watched, m_ready);
  ffd_bench_known #(18, "constants")             k_same (aclk, watched,
    {m_axi_arid, m_axi_awid, m_axi_arcache, m_axi_arprot, m_axi_awcache, m_axi_awprot, 2'b00});
  ffd_bench_known #(2, "s_axil_bresp")           k_b    (aclk, check_b, s_axil_bresp);
  ffd_bench_known #(34, "s_axil_rdata, rresp")   k_r    (aclk, check_r,
    {s_axil_rdata, s_axil_rresp});
  ffd_bench_known #(77, "m_axi_ar")              k_ar   (aclk, check_ar,
    {m_axi_araddr, m_axi_arlen, m_axi_arsize, m_axi_arburst});
  ffd_bench_known #(77, "m_axi_aw")              k_aw   (aclk, check_aw,
    {m_axi_awaddr, m_axi_awlen, m_axi_awsize, m_axi_awburst});
  ffd_bench_known #(145, "m_axi_w")              k_w    (aclk, check_w,
    {m_axi_wdata, m_axi_wstrb, m_axi_wlast});

  integer since;  // reset, in clocks
  integer still;
  wire    taken = |{m_valid & {m_axi_arready, m_axi_awready, m_axi_wready},
                    m_ready & {m_axi_rvalid, m_axi_bvalid},
                    s_ready & {s_axil_awvalid, s_axil_wvalid, s_axil_arvalid},
                    s_valid & {s_axil_bready, s_axil_rready}};

  always #5 aclk = !aclk;

  always @(posedge aclk) begin
    if (still == PATIENCE) begin
      $display("broken patience clock %0d", clocks);
      leave;
    end
    clocks  <= clocks + 1;
    since   <= aresetn ? since + 1 : 0;
    still   <= taken === 1'b1 ? 0 : still + 1;
    watched <= watched || !aresetn;
    if (watched && since == 0 && (s_valid != 0 || m_valid != 0)) begin
      $display("broken valid_in_reset clock %0d", clocks);
    end
    if (watched && since < CLEARING && s_ready != 0) begin
      $display("broken ready_while_cleared clock %0d", clocks);
    end
    if (watched && since > 1 && m_ready != 2'b11) begin
      $display("broken answers_are_taken clock %0d", clocks);
    end
  end

  // What software does.
  reg  [47:0] steps [0:STEPS-1];
  reg  [47:0] step;
  integer     seed;
  integer     at;
  integer     file;

  task pause;
    while ($random(seed) % 4 == 0) @(posedge aclk);
  endtask

  task write;
    begin
      {s_axil_awvalid, s_axil_awaddr}              <= {1'b1, step[43:32]};
      {s_axil_wvalid, s_axil_wdata, s_axil_wstrb}  <= {1'b1, step[31:0], 4'hF};
      @(posedge aclk);
      while (s_axil_awvalid || s_axil_wvalid) begin
        if (s_axil_awready) {s_axil_awvalid, s_axil_awaddr} <= {1'b0, 12'bx};
        if (s_axil_wready) {s_axil_wvalid, s_axil_wdata, s_axil_wstrb} <= {1'b0, 36'bx};
        @(posedge aclk);
      end
      pause;
      s_axil_bready <= 1'b1;
      @(posedge aclk);
      while (!s_axil_bvalid) @(posedge aclk);
      if (s_axil_bresp != 0) $display("broken write_%h clock %0d", step[43:32], clocks);
      s_axil_bready <= 1'b0;
    end
  endtask

  task read;
    begin
      {s_axil_arvalid, s_axil_araddr} <= {1'b1, step[43:32]};
      @(posedge aclk);
      while (!s_axil_arready) @(posedge aclk);
      {s_axil_arvalid, s_axil_araddr} <= {1'b0, 12'bx};
      pause;
      s_axil_rready <= 1'b1;
      @(posedge aclk);
      while (!s_axil_rvalid) @(posedge aclk);
      if (step[47:44] == STEP_EQUAL && s_axil_rdata !== step[31:0]) begin
        $display("broken read_%h_is_%h clock %0d", step[43:32], s_axil_rdata, clocks);
      end
      s_axil_rready <= 1'b0;
    end
  endtask

  task wait_for_interrupt;
    while (irq !== 1'b1) @(posedge aclk);
  endtask

  task leave;
    begin
      file = $fopen("results.txt", "w");
      for (at = 0; at < RESULTS; at = at + 1) begin
        step = FIRST + at;
        $fdisplay(file, "0_%h_%h_%h_%h", u_memory.words[step][127:96],
                  u_memory.words[step][95:64], u_memory.words[step][63:32],
                  u_memory.words[step][31:0]);
      end
      $display("clocks %0d", clocks);
      $finish;
    end
  endtask

  initial begin
    $readmemh("steps.hex", steps);
    {aclk, aresetn, watched}                    = 3'b000;
    {s_axil_awvalid, s_axil_awaddr}             = {1'b0, 12'bx};
    {s_axil_wvalid, s_axil_wdata, s_axil_wstrb} = {1'b0, 36'bx};
    {s_axil_arvalid, s_axil_araddr}             = {1'b0, 12'bx};
    {s_axil_bready, s_axil_rready}              = 2'b00;
    {clocks, since, still, at}                  = {4{32'd0}};
    seed                                        = SEED;
    repeat (RESET) @(posedge aclk);
    aresetn <= 1'b1;
    @(posedge aclk);
    step = steps[0];
    while (step[47:44] != STEP_END) begin
      if (step[47:44] == STEP_WRITE) write;
      if (step[47:44] == STEP_READ || step[47:44] == STEP_EQUAL) read;
      if (step[47:44] == STEP_WAIT) wait_for_interrupt;
      at   = at + 1;
      step = steps[at];
    end
    leave;
  end
endmodule

`default_nettype wire
