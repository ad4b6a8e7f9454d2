// model_memory: in the place of a memory: all words are one register, which a harness can name
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_mem_sdp #(
  parameter WIDTH        = 8,
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
  reg  [WIDTH*DEPTH-1:0] words_q;
  wire [WIDTH-1:0]       word = words_q[WIDTH*read_address_i +: WIDTH];
  always @(posedge clk) if (write_i) words_q[WIDTH*write_address_i +: WIDTH] <= write_data_i;

  generate
    if (READ_LATENCY == 0) begin : gen_combinational
      assign read_data_o = word;
    end else begin : gen_registered
      reg [WIDTH-1:0] read_q;
      always @(posedge clk) if (read_i) read_q <= word;
      assign read_data_o = read_q;
    end
  endgenerate
endmodule

`default_nettype wire
