// ffd_mem_sdp: a memory with one write port and one read port
//
// The one memory of the core, inferred: read data is combinational with READ_LATENCY 0 (small, for
// distributed memory) and registered with 1 (block memory). A registered read in the clock of a
// write to the same address is undefined, so that no way round a block memory is built. Where a
// simulator defines FFD_SIMULATION it gives the complement of the old word, which no test could
// take for right; no tool that makes hardware defines it.
//
// Pipeline:   READ_LATENCY registers, II 1, never frozen; contents are not reset.
// Parameters: WIDTH >= 1, DEPTH >= 2 words, READ_LATENCY 0 or 1; RAM_STYLE, what synthesis is told:
//             "auto", or a word that the tool knows, as "block" or "distributed".
// Not checked: an address of DEPTH or more reads an undefined word; that none is written there, by
//             FFD_ASSERTIONS.
// Model:      none (storage only).  Test: every system test.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"

module ffd_mem_sdp #(
  parameter WIDTH        = 32,
  parameter DEPTH        = 16,
  parameter READ_LATENCY = 1,
  parameter ADDRESS_W    = $clog2(DEPTH),
  parameter RAM_STYLE    = "auto"
) (
  input  wire                 clk,
  input  wire                 write_i,
  input  wire [ADDRESS_W-1:0] write_address_i,
  input  wire [WIDTH-1:0]     write_data_i,
  input  wire                 read_i,  // a registered read; what was read stays without it
  input  wire [ADDRESS_W-1:0] read_address_i,
  output wire [WIDTH-1:0]     read_data_o
);
  generate
    if (DEPTH < 2) begin : gen_bad_depth
      ERROR_ffd_mem_sdp_depth_must_be_at_least_2 u_error ();
    end
    if (READ_LATENCY < 0 || READ_LATENCY > 1) begin : gen_bad_latency
      ERROR_ffd_mem_sdp_read_latency_must_be_0_or_1 u_error ();
    end
  endgenerate

  // A memory that is deeper than a block of 16 Kbit at 9 bits a word is cut into slices as wide as
  // such a block at that depth: so none is put together of shallow blocks with a multiplexer behind
  // them. A simulator is faster without.
`ifdef FFD_SIMULATION
  localparam MOST = WIDTH;
`else
  localparam MOST = DEPTH > 8192 ? 1 : DEPTH > 4096 ? 2 : DEPTH > 2048 ? 4 : WIDTH;
`endif
  localparam SLICES = (WIDTH + MOST - 1) / MOST;
  wire unused_style = &{1'b0, RAM_STYLE};  // to simulators

`ifdef FFD_ASSERTIONS
  // It has no reset: what a pipeline held before its own has left it after some clocks.
  reg  [6:0] clocks_q = 7'd0;
  wire       rst      = !clocks_q[6];
  always @(posedge clk) if (rst) clocks_q <= clocks_q + 1'b1;
  `FFD_ASSERT(a_word_is_written_beyond_the_last,
              !write_i || {{(32 - ADDRESS_W) {1'b0}}, write_address_i} < DEPTH)
`endif

  genvar s;
  generate
    for (s = 0; s < SLICES; s = s + 1) begin : gen_slice
      localparam LOW     = s * MOST;
      localparam SLICE_W = WIDTH - LOW < MOST ? WIDTH - LOW : MOST;
      (* no_rw_check, ram_style = RAM_STYLE *)
      reg [SLICE_W-1:0] memory_q [0:DEPTH-1];

      always @(posedge clk) begin
        if (write_i) memory_q[write_address_i] <= write_data_i[LOW +: SLICE_W];
      end

      if (READ_LATENCY == 0) begin : gen_combinational
        wire unused_ok = &{1'b0, read_i};
        assign read_data_o[LOW +: SLICE_W] = memory_q[read_address_i];
      end else begin : gen_registered
        reg [SLICE_W-1:0] read_q;
`ifdef FFD_SIMULATION
        wire clash = write_i && write_address_i == read_address_i;
        always @(posedge clk) begin
          if (read_i) read_q <= clash ? ~memory_q[read_address_i] : memory_q[read_address_i];
        end
`else
        always @(posedge clk) if (read_i) read_q <= memory_q[read_address_i];
`endif
        assign read_data_o[LOW +: SLICE_W] = read_q;
      end
    end
  endgenerate
endmodule

`default_nettype wire
