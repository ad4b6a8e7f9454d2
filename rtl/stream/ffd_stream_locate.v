// ffd_stream_locate: the place of a point in a page as indices along its axes
//
// place = (i n_t + j) n_u + k, so k is the remainder of a division by n_u, and j that of its
// quotient by n_t: two divisions, a bit a clock, one behind the other in the same registers.
//
// Formats:    tops are n - 1, {i, j, k}; place below n_s n_t n_u, else the indices mean nothing.
// Pipeline:   done_o 2 x 3 x AXIS_W clocks behind start_i, until the next start.
// Parameters: AXIS_W >= 1.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system/pages_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_stream_locate #(
  parameter AXIS_W  = 4,
  parameter PLACE_W = 3 * AXIS_W
) (
  input  wire                clk,
  input  wire                start_i,
  input  wire [PLACE_W-1:0]  place_i,
  input  wire [PLACE_W-1:0]  tops_i,
  output wire                done_o,
  output wire [PLACE_W-1:0]  indices_o  // {i, j, k}
);
  localparam                STEP_W = $clog2(PLACE_W);
  localparam                TOP    = PLACE_W - 1;
  localparam [STEP_W-1:0]   LAST   = TOP[STEP_W-1:0];

  reg  [STEP_W-1:0]  step_q;
  reg                second_q;     // the division by n_t
  reg                done_q;
  reg  [PLACE_W-1:0] quotient_q;   // of the bits that are done, below those that are not
  reg  [AXIS_W-1:0]  remainder_q;
  reg  [AXIS_W-1:0]  k_q;

  // The next bit comes down; the divisor is top + 1.
  wire [AXIS_W-1:0]  top    = second_q ? tops_i[AXIS_W +: AXIS_W] : tops_i[0 +: AXIS_W];
  wire [AXIS_W:0]    down   = {remainder_q, quotient_q[PLACE_W-1]};
  wire               fits   = down > {1'b0, top};
  wire [AXIS_W:0]    rest   = fits ? down - {1'b0, top} - 1'b1 : down;
  wire               finish = step_q == LAST;

  always @(posedge clk) begin
    if (start_i) begin
      step_q      <= {STEP_W{1'b0}};
      second_q    <= 1'b0;
      done_q      <= 1'b0;
      quotient_q  <= place_i;
      remainder_q <= {AXIS_W{1'b0}};
    end else if (!done_q) begin
      step_q      <= finish ? {STEP_W{1'b0}} : step_q + 1'b1;
      second_q    <= second_q || finish;
      done_q      <= second_q && finish;
      quotient_q  <= {quotient_q[PLACE_W-2:0], fits};
      remainder_q <= finish && !second_q ? {AXIS_W{1'b0}} : rest[AXIS_W-1:0];
    end
  end
  always @(posedge clk) if (finish && !second_q) k_q <= rest[AXIS_W-1:0];

  assign done_o    = done_q;
  assign indices_o = {quotient_q[AXIS_W-1:0], remainder_q, k_q};

  wire unused_ok = &{1'b0, tops_i, rest[AXIS_W]};
endmodule

`default_nettype wire
