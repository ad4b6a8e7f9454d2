// What cannot happen, where a simulator looks
//
// A simulator that defines FFD_ASSERTIONS ends at the first clock in which a condition is 0 after
// the module's first reset, and names the instance and what went wrong. It wants clk and rst of the
// module; what is not known (X) does not count. Synthesis sees nothing of it.
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_ASSERT_VH
`define FFD_ASSERT_VH

`ifdef FFD_ASSERTIONS

// NAME, a word, is what cannot happen.
`define FFD_ASSERT(NAME, CONDITION) \
  if (1) begin : NAME \
    reg was_reset_q; \
    initial was_reset_q = 1'b0; \
    always @(posedge clk) begin \
      if (rst === 1'b1) was_reset_q <= 1'b1; \
      if (was_reset_q && rst === 1'b0 && (CONDITION) === 1'b0) begin \
        $display("cannot happen: %m"); \
        $stop; \
      end \
    end \
  end

// The clocks that a module takes, told by the module itself; and whether they are those on which
// whoever uses its instance PART counts.
`define FFD_TAKES(CLOCKS) \
  localparam TAKES = CLOCKS; \
  wire unused_takes = TAKES != 0;
`define FFD_ASSERT_TAKES(PART, COUNTED) \
  initial begin \
    if (PART.TAKES != (COUNTED)) begin \
      $display("%m: PART takes %0d clocks, and %0d are counted", PART.TAKES, COUNTED); \
      $stop; \
    end \
  end

`else
`define FFD_ASSERT(NAME, CONDITION)
`define FFD_TAKES(CLOCKS)
`define FFD_ASSERT_TAKES(PART, COUNTED)
`endif

`endif
