// ffd_bus_waits: why a core is slow, in clocks
//
// Five counts, from the lowest: no beat was offered, a bank or a buffer was still read, the
// evaluator had no room (all three as core_i says them); a read burst was open and no data came; a
// whole burst of results was out and no response came. Bursts are counted on the pins of the bus:
// after a slave that answers what nobody asked for, open_rst_i (a soft reset) makes the counts
// right again. Counts wrap.
//
// Pipeline:   2 clocks from what is counted to the count, from the bus's pins 3.
// Freezes:    never.
// Parameters: COUNT_WIDTH 8 to 32, or 0: no counts, and no hardware; OPEN 1 to 65535, at least the
//             most bursts that are open each way.
// Model:      none.  Test: tests/bus/axi/waits_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_bus_waits #(
  parameter COUNT_WIDTH = 32,
  parameter OPEN        = 8
) (
  input  wire         clk,
  input  wire         rst,
  input  wire         open_rst_i,
  input  wire         clear_i,
  input  wire [2:0]   core_i,
  input  wire         read_begins_i,   // an address is taken
  input  wire         read_beat_i,     // data is there
  input  wire         read_ends_i,     // the last of a burst
  input  wire         write_begins_i,  // the last data of a burst is taken
  input  wire         write_ends_i,    // a response is there
  output wire [159:0] counts_o
);
  generate
    if (COUNT_WIDTH != 0 && (COUNT_WIDTH < 8 || COUNT_WIDTH > 32)) begin : gen_bad_width
      ERROR_ffd_bus_waits_count_width_must_be_0_or_8_to_32 u_error ();
    end
    if (OPEN < 1 || OPEN > 65535) begin : gen_bad_open
      ERROR_ffd_bus_waits_open_must_be_1_to_65535 u_error ();
    end
  endgenerate

  localparam OPEN_W = $clog2(OPEN + 2);

  genvar i;
  generate
    if (COUNT_WIDTH != 0) begin : gen_counts
      reg  [4:0]        pins_q;
      reg  [OPEN_W-1:0] reads_q;
      reg  [OPEN_W-1:0] writes_q;
      reg  [4:0]        event_q;
      wire [4:0]        event_d;

      assign event_d = {writes_q != {OPEN_W{1'b0}} && !pins_q[0],
                        reads_q != {OPEN_W{1'b0}} && !pins_q[3], core_i};

      always @(posedge clk) begin
        if (rst || open_rst_i) begin
          pins_q   <= 5'd0;
          reads_q  <= {OPEN_W{1'b0}};
          writes_q <= {OPEN_W{1'b0}};
        end else begin
          pins_q   <= {read_begins_i, read_beat_i, read_ends_i, write_begins_i, write_ends_i};
          reads_q  <= reads_q + {{(OPEN_W - 1) {1'b0}}, pins_q[4]}
                              - {{(OPEN_W - 1) {1'b0}}, pins_q[2]};
          writes_q <= writes_q + {{(OPEN_W - 1) {1'b0}}, pins_q[1]}
                               - {{(OPEN_W - 1) {1'b0}}, pins_q[0]};
        end
      end
      always @(posedge clk) event_q <= rst ? 5'd0 : event_d;

      for (i = 0; i < 5; i = i + 1) begin : gen_count
        reg [COUNT_WIDTH-1:0] count_q;
        always @(posedge clk) begin
          if (rst || clear_i) count_q <= {COUNT_WIDTH{1'b0}};
          else count_q <= count_q + {{(COUNT_WIDTH - 1) {1'b0}}, event_q[i]};
        end
        assign counts_o[32*i +: COUNT_WIDTH] = count_q;
        if (COUNT_WIDTH < 32) begin : gen_above
          assign counts_o[32*i+COUNT_WIDTH +: 32-COUNT_WIDTH] = {(32 - COUNT_WIDTH) {1'b0}};
        end
      end
    end else begin : gen_none
      assign counts_o = 160'd0;
      wire unused_ok = &{1'b0, clk, rst, open_rst_i, clear_i, core_i, read_begins_i, read_beat_i,
                         read_ends_i, write_begins_i, write_ends_i};
    end
  endgenerate
endmodule

`default_nettype wire
