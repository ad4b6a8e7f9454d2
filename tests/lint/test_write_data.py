"""What a slave of a bus of 256 bits sees in a simulation with X: bytes with a strobe are known, others are what
was there last, and unknown before anything was.

SPDX-License-Identifier: Apache-2.0
"""

from tools.rtl import rtl_sources

MODULE = "ffd_dma_width_write"
LOW, HIGH = "a" * 32, "b" * 32
# Halves that the engine writes: {upper, last, data}.
HALVES = ((0, 1, LOW), (0, 0, LOW), (1, 0, HIGH), (1, 1, LOW), (0, 1, HIGH))
# What the bus has of them: {strobes, last, data of the upper half, data of the lower one}.
BEATS = (("0000ffff", "1", "x" * 32, LOW), ("ffffffff", "0", HIGH, LOW), ("ffff0000", "1", LOW, LOW),
         ("0000ffff", "1", LOW, HIGH))

BENCH = """`timescale 1ns/1ns
module bench;
  reg clk = 0, rst = 1, valid = 0, last = 0, upper = 0;
  reg [127:0] data = 0;
  wire ready, wvalid, wlast;
  wire [255:0] wdata;
  wire [31:0] wstrb;
  ffd_dma_width_write #(.DATA_WIDTH(256)) u_write (
    .clk(clk), .rst(rst), .s_beat_valid(valid), .s_beat_ready(ready), .s_beat_data(data),
    .s_beat_last(last), .s_beat_upper(upper), .m_axi_wvalid(wvalid), .m_axi_wready(1'b1),
    .m_axi_wdata(wdata), .m_axi_wstrb(wstrb), .m_axi_wlast(wlast));
  always #5 clk = !clk;
  always @(posedge clk) if (!rst && wvalid)
    $display("%h %b %h %h", wstrb, wlast, wdata[255:128], wdata[127:0]);
  task half(input upper_i, input last_i, input [127:0] data_i);
    begin {{valid, upper, last, data}} = {{1'b1, upper_i, last_i, data_i}}; @(negedge clk); end
  endtask
  initial begin
    repeat (3) @(negedge clk);
    rst = 0;
{halves}
    valid = 0;
    repeat (3) @(negedge clk);
    $finish;
  end
endmodule
"""


def test_bytes_without_a_strobe_are_what_was_there_last(checkout):
    halves = "\n".join(f"    half({upper}, {last}, 128'h{data});" for upper, last, data in HALVES)
    checkout.put({"bench.v": BENCH.format(halves=halves)})
    files = rtl_sources.Sources().needed(MODULE)
    assert checkout.run("iverilog", "-g2005", "-o", "bench.vvp", "bench.v", *files) == (0, "", "")
    status, output, _ = checkout.run("vvp", "-n", "bench.vvp")
    assert status == 0
    assert [tuple(line.split()) for line in output.splitlines() if len(line.split()) == 4] == list(BEATS)
