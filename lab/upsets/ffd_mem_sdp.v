// ffd_mem_sdp: that of rtl/common, of which a bit can be flipped
//
// While upset_here is 1, bit upset_bit of word upset_address is inverted at the clock's edge, of what
// is written then if that word is written. The three have no driver: netlist.py connects them.
//
// Pipeline:   as that of rtl/common.
// Parameters: as that of rtl/common.
// Not checked: an upset_address of DEPTH or more inverts nothing.
// Model:      none (storage only).  Test: lab/tests/upsets.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_mem_sdp #(
  parameter WIDTH        = 32,
  parameter DEPTH        = 16,
  parameter READ_LATENCY = 1,
  parameter ADDRESS_W    = $clog2(DEPTH)
) (
  input  wire                 clk,
  input  wire                 write_i,
  input  wire [ADDRESS_W-1:0] write_address_i,
  input  wire [WIDTH-1:0]     write_data_i,
  input  wire                 read_i,
  input  wire [ADDRESS_W-1:0] read_address_i,
  output wire [WIDTH-1:0]     read_data_o
);
  (* keep *) wire        upset_here;
  (* keep *) wire [31:0] upset_address;
  (* keep *) wire [15:0] upset_bit;

  reg  [WIDTH-1:0]     memory_q [0:DEPTH-1];
  wire [ADDRESS_W-1:0] place = upset_address[ADDRESS_W-1:0];
  wire                 meets = write_i && write_address_i == place;
  wire [WIDTH-1:0]     word  = meets ? write_data_i : memory_q[place];
  wire [WIDTH-1:0]     mask  = {{(WIDTH - 1) {1'b0}}, 1'b1} << upset_bit;

  always @(posedge clk) begin
    if (write_i) memory_q[write_address_i] <= write_data_i;
    if (upset_here) memory_q[place] <= word ^ mask;
  end

  generate
    if (READ_LATENCY == 0) begin : gen_combinational
      wire unused_ok = &{1'b0, read_i};
      assign read_data_o = memory_q[read_address_i];
    end else begin : gen_registered
      reg  [WIDTH-1:0] read_q;
      wire             clash = write_i && write_address_i == read_address_i;
      always @(posedge clk) begin
        if (read_i) read_q <= clash ? ~memory_q[read_address_i] : memory_q[read_address_i];
      end
      assign read_data_o = read_q;
    end
  endgenerate
endmodule

`default_nettype wire
