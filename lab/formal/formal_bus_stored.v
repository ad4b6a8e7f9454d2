// formal_bus_stored: ffd_bus_stored and one word of it, chosen freely, beside a copy
//
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_bus_stored #(
  parameter WORDS  = 16,
  parameter SLOT_W = $clog2(WORDS)
) (
  input wire              clk,
  input wire              rst,
  input wire              write,
  input wire [SLOT_W-1:0] write_slot,
  input wire [31:0]       data,
  input wire [3:0]        strobe,
  input wire [SLOT_W-1:0] slot
);
  wire        clearing;
  wire [31:0] word;

  ffd_bus_stored #(
    .WORDS(WORDS)
  ) u_dut (
    .clk           (clk),
    .rst           (rst),
    .clearing_o    (clearing),
    .write_i       (write),
    .write_slot_i  (write_slot),
    .write_data_i  (data),
    .write_strobe_i(strobe),
    .read_slot_i   (slot),
    .word_o        (word)
  );

  (* hierconn *) wire [SLOT_W:0] \u_dut.cleared_q ;
  reg              first_q = 1'b1;
  reg [SLOT_W-1:0] slot_q;
  reg [31:0]       copy_q;
  wire             hit = write && write_slot == slot;
  integer          b;
  always @(posedge clk) begin
    first_q <= 1'b0;
    slot_q  <= slot;
    for (b = 0; b < 4; b = b + 1)
      if (rst || clearing) copy_q[8*b +: 8] <= 8'd0;
      else if (hit && strobe[b]) copy_q[8*b +: 8] <= data[8*b +: 8];
  end
  always @* begin
    if (first_q) assume (rst);
    else assume (slot == slot_q);
    assume (!write || (!rst && !clearing));
  end

  wire cleared = \u_dut.cleared_q > slot;
  always @* if (!first_q) begin
    kept: assert (\u_dut.cleared_q <= WORDS && clearing == (\u_dut.cleared_q != WORDS)
                  && (!clearing || copy_q == 0) && (!cleared || word == copy_q));
  end
endmodule

`default_nettype wire
