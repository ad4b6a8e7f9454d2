// ffd_bench_memory: memory behind an AXI4 slave of 128 bits, which pauses at random
//
// For the study of engines only. One burst of reads and one of writes at a time, whole beats at
// rising addresses. What nobody has written is X, and so are data and responses while they are not
// valid.
//
// Parameters: WORDS of 16 bytes; FILE, what is in them at first, for $readmemh; SEED of the pauses.
// Test:       lab/tests/engines.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_bench_memory #(
  parameter WORDS = 1,
  parameter FILE  = "memory.hex",
  parameter SEED  = 1
) (
  input  wire         clk,
  input  wire         rst,
  input  wire         arvalid_i,
  output reg          arready_o,
  input  wire [63:0]  araddr_i,
  input  wire [7:0]   arlen_i,
  output reg          rvalid_o,
  input  wire         rready_i,
  output reg  [127:0] rdata_o,
  output reg  [1:0]   rresp_o,
  output reg          rlast_o,
  input  wire         awvalid_i,
  output reg          awready_o,
  input  wire [63:0]  awaddr_i,
  input  wire         wvalid_i,
  output reg          wready_o,
  input  wire [127:0] wdata_i,
  input  wire [15:0]  wstrb_i,
  input  wire         wlast_i,
  output reg          bvalid_o,
  input  wire         bready_i,
  output reg  [1:0]   bresp_o
);
  reg [127:0] words [0:WORDS-1];
  integer     seed;

  initial begin
    $readmemh(FILE, words);
    seed = SEED;
  end

  function willing;
    input integer unused;
    willing = $random(seed) % 4 != 0;
  endfunction

  // A burst that has been taken is `left` beats, of which the next is at `from`.
  integer left;
  integer from;

  always @(posedge clk) begin
    if (rst) begin
      {arready_o, rvalid_o}         <= 2'b00;
      {rdata_o, rresp_o, rlast_o}   <= {131{1'bx}};
      left                          <= 0;
    end else begin
      if (arvalid_i && arready_o) begin
        left      <= arlen_i + 1;
        from      <= araddr_i[63:4];
        arready_o <= 1'b0;
      end else begin
        arready_o <= left == 0 && !rvalid_o && (arready_o || willing(0));
      end
      if (!rvalid_o || rready_i) begin
        if (left != 0 && willing(0)) begin
          {rvalid_o, rdata_o, rresp_o, rlast_o} <= {1'b1, words[from], 2'b00, left == 1};
          left                                  <= left - 1;
          from                                  <= from + 1;
        end else begin
          {rvalid_o, rdata_o, rresp_o, rlast_o} <= {1'b0, {131{1'bx}}};
        end
      end
    end
  end

  // While `writing`, the next beat goes to `to`.
  reg     writing;
  integer to;
  integer b;

  always @(posedge clk) begin
    if (rst) begin
      {awready_o, wready_o, bvalid_o, writing} <= 4'b0000;
      bresp_o                                  <= 2'bxx;
    end else begin
      if (awvalid_i && awready_o) begin
        to        <= awaddr_i[63:4];
        writing   <= 1'b1;
        awready_o <= 1'b0;
      end else begin
        awready_o <= !writing && !bvalid_o && (awready_o || willing(0));
      end
      wready_o <= writing && !(wvalid_i && wready_o && wlast_i) && willing(0);
      if (wvalid_i && wready_o) begin
        for (b = 0; b < 16; b = b + 1) begin
          if (wstrb_i[b]) words[to][8*b +: 8] <= wdata_i[8*b +: 8];
        end
        to <= to + 1;
        if (wlast_i) {writing, bvalid_o, bresp_o} <= 4'b0100;
      end
      if (bvalid_o && bready_i) {bvalid_o, bresp_o} <= {1'b0, 2'bxx};
    end
  end
endmodule

`default_nettype wire
