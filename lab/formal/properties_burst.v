// properties_burst: what ffd_dma_address holds, and a burst on an address channel, beside the window
//
// holds_o is what leads from state to state: where bursts are cut, window's first <= next <= last <=
// window's last, and what was looked up ahead is true.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module properties_burst #(
  parameter MAX_BURST = 256,
  parameter BURST_W   = $clog2(MAX_BURST)
) (
  input  wire [2:0]         state_i,
  input  wire [59:0]        next_i,   // of 16 bytes each
  input  wire [59:0]        last_i,
  input  wire [27:0]        more_i,
  input  wire               misaligned_i,
  input  wire               none_i,
  input  wire               wraps_i,
  input  wire               below_i,
  input  wire               above_i,
  input  wire               same_i,
  input  wire [BURST_W-1:0] left_i,
  input  wire [BURST_W-1:0] offer_i,
  input  wire [63:0]        window_first_i,
  input  wire [63:0]        window_last_i,
  input  wire [63:0]        address_i,
  input  wire [7:0]         len_i,
  output reg                holds_o,
  output wire               inside_o, // the burst lies in the window
  output wire               page_o    // and in one page
);
  localparam [2:0] CHECK = 3'd2;
  localparam [2:0] JUDGE = 3'd3;
  localparam [2:0] BURST = 3'd4;
  localparam [2:0] NEXT  = 3'd5;

  wire [60:0]        next   = {1'b0, next_i};
  wire [60:0]        last   = {1'b0, last_i};
  wire [64:0]        end_of = {1'b0, address_i} + {53'd0, len_i, 4'd15};
  wire [60:0]        span   = last - next;
  wire [BURST_W-1:0] left   = last_i[BURST_W-1:0] - next_i[BURST_W-1:0];
  wire               near   = next <= last && span < (61'd1 << 28);
  wire               below  = {next, 4'h0} < {1'b0, window_first_i};
  wire               above  = {last, 4'hf} > {1'b0, window_last_i};
  wire               block  = next_i[59:BURST_W] == last_i[59:BURST_W];
  wire               bad    = misaligned_i || none_i || wraps_i;
  wire               fits   = !bad && !below_i && !below && !above && near;

  always @* begin
    case (state_i)
      CHECK: holds_o = bad || (near && below_i == below);
      JUDGE: holds_o = bad || (near && below_i == below && above_i == above && same_i == block
                               && left_i == left);
      BURST: holds_o = fits && same_i == block
                    && offer_i == (block ? left : ~next_i[BURST_W-1:0]);
      NEXT: holds_o = fits && next + more_i < last && more_i < MAX_BURST;
      default: holds_o = state_i < CHECK;
    endcase
  end

  assign inside_o = address_i >= window_first_i && end_of <= {1'b0, window_last_i};
  assign page_o   = {1'b0, address_i[11:0]} + {1'b0, len_i, 4'd15} < 13'd4096;
endmodule

`default_nettype wire
