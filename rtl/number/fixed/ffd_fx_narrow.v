// ffd_fx_narrow: value_o = saturate(floor(value_i / 2^DROP + 1/2)) with registers, flags beside it
//
// ffd_fx_round where a wide number is brought back to a narrow one: from sums to points and words.
//
// Formats:    as in ffd_fx_round; flags_o is flags_i, bit 0 raised where the value is saturated.
// Pipeline:   LATENCY registers, II 1, never frozen: from 2 on one between rounding and saturation;
//             of the others half in front (rounded down), the rest behind.
// Parameters: IN_W >= 2, DROP >= 0, OUT_W >= 2, FLAGS_W >= 1, LATENCY >= 0.
// Model:      golden/include/hwffd/numerics/fixed.hpp (round_to).  Test: tests/unit/fixed.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_fx_narrow #(
  parameter IN_W    = 42,
  parameter DROP    = 16,
  parameter OUT_W   = 18,
  parameter FLAGS_W = 1,
  parameter LATENCY = 1
) (
  input  wire                    clk,
  input  wire signed [IN_W-1:0]  value_i,
  input  wire [FLAGS_W-1:0]      flags_i,
  output wire signed [OUT_W-1:0] value_o,
  output wire [FLAGS_W-1:0]      flags_o
);
  localparam MIDDLE  = LATENCY > 1 ? 1 : 0;
  localparam BEFORE  = (LATENCY - MIDDLE) / 2;
  localparam AFTER   = LATENCY - MIDDLE - BEFORE;
  localparam WHOLE_W = (IN_W > OUT_W + DROP ? IN_W - DROP : OUT_W) + 1;  // holds what is rounded

  wire signed [IN_W-1:0]    value;
  wire [FLAGS_W-1:0]        flags;
  wire signed [WHOLE_W-1:0] rounded;
  wire                      never;
  wire signed [WHOLE_W-1:0] whole;
  wire [FLAGS_W-1:0]        late_flags;
  wire signed [OUT_W-1:0]   narrow;
  wire                      saturated;
  reg  [FLAGS_W-1:0]        raised;

  ffd_num_delay #(
    .WIDTH  (FLAGS_W + IN_W),
    .LATENCY(BEFORE)
  ) u_value (
    .clk(clk),
    .rst(1'b0),
    .d_i({flags_i, value_i}),
    .q_o({flags, value})
  );

  ffd_fx_round #(
    .IN_W (IN_W),
    .DROP (DROP),
    .OUT_W(WHOLE_W)
  ) u_round (
    .value_i    (value),
    .addend_i   ({WHOLE_W{1'b0}}),
    .value_o    (rounded),
    .saturated_o(never)
  );

  ffd_num_delay #(
    .WIDTH  (FLAGS_W + WHOLE_W),
    .LATENCY(MIDDLE)
  ) u_whole (
    .clk(clk),
    .rst(1'b0),
    .d_i({flags, rounded}),
    .q_o({late_flags, whole})
  );

  ffd_fx_round #(
    .IN_W (WHOLE_W),
    .DROP (0),
    .OUT_W(OUT_W)
  ) u_saturate (
    .value_i    (whole),
    .addend_i   ({OUT_W{1'b0}}),
    .value_o    (narrow),
    .saturated_o(saturated)
  );

  always @* begin
    raised    = late_flags;
    raised[0] = late_flags[0] | saturated;
  end

  ffd_num_delay #(
    .WIDTH  (FLAGS_W + OUT_W),
    .LATENCY(AFTER)
  ) u_rounded (
    .clk(clk),
    .rst(1'b0),
    .d_i({raised, narrow}),
    .q_o({flags_o, value_o})
  );

  wire unused_ok = &{1'b0, never};
endmodule

`default_nettype wire
