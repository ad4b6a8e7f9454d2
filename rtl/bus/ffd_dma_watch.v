// ffd_dma_watch: how long each channel of an AXI master's bus has waited for the slave
//
// Looks on only. AR, AW and W wait while valid is 1 and ready is 0; R while a read burst whose
// address was taken is not wholly answered and no data comes; B while a write burst whose address
// and last beat were taken has no answer. A channel that has waited TIMEOUT clocks without a break
// is late: late_o until it waits no more, timeout_o in the first clock of that.
//
// Channels:   bit 0 AR, 1 R, 2 AW, 3 W, 4 B.
// Pipeline:   late_o after TIMEOUT clocks of waiting, 1 clock after the last of them.
// Parameters: TIMEOUT 2 to 2^30 clocks, or 0: none, then nothing is built. READS and WRITES, the
//             most bursts that are open each way.
// Model:      none (control only).  Test: tests/bus/dma/timeout_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_dma_watch #(
  parameter TIMEOUT = 0,
  parameter READS   = 8,
  parameter WRITES  = 8
) (
  input  wire       clk,
  input  wire       rst,
  input  wire       arvalid_i,
  input  wire       arready_i,
  input  wire       rvalid_i,
  input  wire       rready_i,
  input  wire       rlast_i,
  input  wire       awvalid_i,
  input  wire       awready_i,
  input  wire       wvalid_i,
  input  wire       wready_i,
  input  wire       wlast_i,
  input  wire       bvalid_i,
  input  wire       bready_i,
  output wire [4:0] late_o,
  output wire [4:0] timeout_o
);
  generate
    if (TIMEOUT != 0 && (TIMEOUT < 2 || TIMEOUT > (1 << 30))) begin : gen_bad_timeout
      ERROR_ffd_dma_watch_timeout_must_be_0_or_2_to_1073741824 u_error ();
    end
  endgenerate

  generate
    if (TIMEOUT == 0) begin : gen_none
      assign late_o    = 5'd0;
      assign timeout_o = 5'd0;
      wire unused_ok = &{1'b0, clk, rst, arvalid_i, arready_i, rvalid_i, rready_i, rlast_i,
                         awvalid_i, awready_i, wvalid_i, wready_i, wlast_i, bvalid_i, bready_i};
    end else begin : gen_watch
      localparam COUNT_W = $clog2(TIMEOUT);
      localparam READ_W  = $clog2(READS + 1);
      localparam WRITE_W = $clog2(WRITES + 1);
      // Counts up to 2^COUNT_W, a bit of its own, from as many below as TIMEOUT says.
      localparam BELOW = (1 << COUNT_W) - TIMEOUT;
      localparam [COUNT_W:0] FIRST = BELOW[COUNT_W:0];

      // Bursts that the slave has yet to answer; an answer too many is none.
      reg  [READ_W-1:0]  reads_q;
      reg  [WRITE_W-1:0] addresses_q;
      reg  [WRITE_W-1:0] bursts_q;
      wire               read_open  = reads_q != {READ_W {1'b0}};
      wire               write_open = addresses_q != {WRITE_W {1'b0}}
                                   && bursts_q != {WRITE_W {1'b0}};
      wire               asked      = arvalid_i && arready_i;
      wire               completed       = rvalid_i && rready_i && rlast_i && read_open;
      wire               addressed  = awvalid_i && awready_i;
      wire               written    = wvalid_i && wready_i && wlast_i;
      wire               answered   = bvalid_i && bready_i && write_open;

      always @(posedge clk) begin
        if (rst) begin
          reads_q     <= {READ_W {1'b0}};
          addresses_q <= {WRITE_W {1'b0}};
          bursts_q    <= {WRITE_W {1'b0}};
        end else begin
          if (asked != completed) reads_q <= asked ? reads_q + 1'b1 : reads_q - 1'b1;
          if (addressed != answered) begin
            addresses_q <= addressed ? addresses_q + 1'b1 : addresses_q - 1'b1;
          end
          if (written != answered) bursts_q <= written ? bursts_q + 1'b1 : bursts_q - 1'b1;
        end
      end

      wire [4:0] waits = {write_open && !bvalid_i, wvalid_i && !wready_i, awvalid_i && !awready_i,
                          read_open && !rvalid_i, arvalid_i && !arready_i};
      genvar c;
      for (c = 0; c < 5; c = c + 1) begin : gen_channel
        reg [COUNT_W:0] count_q;
        reg             known_q;
        wire            late_c = count_q[COUNT_W];

        always @(posedge clk) begin
          if (rst || !waits[c]) count_q <= FIRST;
          else if (!late_c) count_q <= count_q + 1'b1;
          known_q <= late_c;
        end

        assign late_o[c]    = late_c;
        assign timeout_o[c] = late_c && !known_q;
      end
    end
  endgenerate
endmodule

`default_nettype wire
