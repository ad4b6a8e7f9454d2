// formal_dma_watch: ffd_dma_watch beside any master and any slave
//
// What each channel has waited is counted anew, from bursts that are open by their own counts.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_dma_watch #(
  parameter TIMEOUT = 3,
  parameter READS   = 2,
  parameter WRITES  = 2
) (
  input wire       clk,
  input wire       rst,
  input wire       arvalid,
  input wire       arready,
  input wire       rvalid,
  input wire       rready,
  input wire       rlast,
  input wire       awvalid,
  input wire       awready,
  input wire       wvalid,
  input wire       wready,
  input wire       wlast,
  input wire       bvalid,
  input wire       bready
);
  wire [4:0] late;
  wire [4:0] timeout;

  ffd_dma_watch #(
    .TIMEOUT(TIMEOUT),
    .READS  (READS),
    .WRITES (WRITES)
  ) u_dut (
    .clk      (clk),
    .rst      (rst),
    .arvalid_i(arvalid),
    .arready_i(arready),
    .rvalid_i (rvalid),
    .rready_i (rready),
    .rlast_i  (rlast),
    .awvalid_i(awvalid),
    .awready_i(awready),
    .wvalid_i (wvalid),
    .wready_i (wready),
    .wlast_i  (wlast),
    .bvalid_i (bvalid),
    .bready_i (bready),
    .late_o   (late),
    .timeout_o(timeout)
  );

  // Bursts asked for and read, addresses and data sent, answers: modulo 8, none more than allowed.
  reg        first_q = 1'b1;
  reg  [2:0] asked_q;
  reg  [2:0] reads_done_q;
  reg  [2:0] addressed_q;
  reg  [2:0] written_q;
  reg  [2:0] answered_q;
  wire [2:0] reads     = asked_q - reads_done_q;
  wire [2:0] addresses = addressed_q - answered_q;
  wire [2:0] bursts    = written_q - answered_q;
  wire       read_done = rvalid && rready && rlast && reads != 0;
  wire       answered  = bvalid && bready && addresses != 0 && bursts != 0;
  wire [4:0] waits     = {addresses != 0 && bursts != 0 && !bvalid, wvalid && !wready,
                          awvalid && !awready, reads != 0 && !rvalid, arvalid && !arready};
  always @(posedge clk) begin
    first_q <= 1'b0;
    if (rst) begin
      asked_q      <= 0;
      reads_done_q <= 0;
      addressed_q  <= 0;
      written_q    <= 0;
      answered_q   <= 0;
    end else begin
      asked_q      <= asked_q + (arvalid && arready);
      reads_done_q <= reads_done_q + read_done;
      addressed_q  <= addressed_q + (awvalid && awready);
      written_q    <= written_q + (wvalid && wready && wlast);
      answered_q   <= answered_q + answered;
    end
  end
  always @* begin
    if (first_q) assume (rst);
    assume (!arvalid || reads < READS);
    assume (!awvalid || addresses < WRITES);
    assume (!wvalid || bursts < WRITES);
  end

  wire [4:0] due;       // has waited so long
  wire [4:0] due_now;   // in this clock for the first time
  genvar c;
  generate
    for (c = 0; c < 5; c = c + 1) begin : gen_channel
      reg [2:0] waited_q;     // up to TIMEOUT + 1
      always @(posedge clk) begin
        if (rst || !waits[c]) waited_q <= 0;
        else waited_q <= waited_q + (waited_q <= TIMEOUT);
      end
      assign due[c]     = waited_q >= TIMEOUT;
      assign due_now[c] = waited_q == TIMEOUT;
    end
  endgenerate

  always @* if (!first_q && !rst) begin
    exact: assert (late == due);
    once: assert (timeout == due_now);
  end
endmodule

`default_nettype wire
