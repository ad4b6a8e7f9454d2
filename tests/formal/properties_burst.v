// properties_burst: what ffd_dma_address holds, and a burst on an address channel, beside the window
//
// From the first burst on: window's first <= next <= last <= window's last.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module properties_burst (
  input  wire [59:0] next_i,   // of 16 bytes each
  input  wire [59:0] last_i,
  input  wire [27:0] beats_i,
  input  wire        wraps_i,
  input  wire [63:0] window_first_i,
  input  wire [63:0] window_last_i,
  input  wire [63:0] address_i,
  input  wire [7:0]  len_i,
  output wire        sum_o,    // next, beats and last agree
  output wire        fits_o,   // all that is left lies in the window
  output wire        inside_o, // the burst lies in the window
  output wire        page_o    // and in one page
);
  wire [60:0] next   = {1'b0, next_i};
  wire [60:0] last   = {1'b0, last_i};
  wire [64:0] end_of = {1'b0, address_i} + {53'd0, len_i, 4'd15};

  assign sum_o    = {wraps_i, last_i} == next + beats_i - 61'd1;
  assign fits_o   = {next, 4'h0} >= {1'b0, window_first_i} && next <= last
                 && {last, 4'hf} <= {1'b0, window_last_i};
  assign inside_o = address_i >= window_first_i && end_of <= {1'b0, window_last_i};
  assign page_o   = {1'b0, address_i[11:0]} + {1'b0, len_i, 4'd15} < 13'd4096;
endmodule

`default_nettype wire
