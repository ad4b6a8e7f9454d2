"""What a four-state simulator says of a hardened gate of addresses: every output is known from reset on, before a burst
has come.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = tuple(ROOT / "rtl" / name for name in (
    "bus/ffd_dma_gate.v", "common/ffd_hard_triple.v", "common/ffd_hard_copy.v"))
CLOCKS = 40
BENCH = f"""
module bench;
  reg         clk = 0, rst = 1;
  wire [63:0] first, last, address;
  wire [7:0]  len;
  wire        taken, raised, raise, refused, differs;
  always #1 clk = !clk;
  ffd_dma_gate u_gate (.clk(clk), .rst(rst), .stop_i(1'b0), .go_i(1'b1), .locked_i(1'b0), .window_first_i(64'd4096),
    .window_last_i(64'd8191), .window_first_o(first), .window_last_o(last), .s_burst_valid(1'b0), .s_burst_ready(taken),
    .s_burst_address(64'dx), .s_burst_len(8'dx), .m_burst_valid(raised), .m_burst_ready(1'b1), .m_burst_address(address),
    .m_burst_len(len), .raise_o(raise), .refused_o(refused), .differs_o(differs));
  integer n;
  initial begin
    for (n = 0; n < 4; n = n + 1) @(negedge clk);
    rst = 0;
    for (n = 0; n < {CLOCKS}; n = n + 1) begin
      @(negedge clk) $display("%b", {{differs, refused, raise, raised, taken, address, len, first, last}});
    end
    $finish;
  end
endmodule
"""


def shown(tmp_path, sources):
    """The outputs of each clock, a row of bits."""
    (tmp_path / "bench.v").write_text(BENCH)
    subprocess.run(["iverilog", "-g2005", "-o", tmp_path / "bench", tmp_path / "bench.v", *sources], check=True)
    return subprocess.run(["vvp", tmp_path / "bench"], check=True, capture_output=True, text=True).stdout.split()


def test_all_is_known_before_the_first_burst(tmp_path):
    rows = shown(tmp_path, SOURCES)
    assert len(rows) == CLOCKS
    assert {len(row) for row in rows} == {5 + 64 + 8 + 64 + 64}
    assert not [row for row in rows if set(row) - {"0", "1"}]


def test_a_triple_without_reset_is_found(tmp_path):
    planted = tmp_path / "ffd_dma_gate.v"
    text = SOURCES[0].read_text()
    assert text.count(" & {72{!rst}}") == 1
    planted.write_text(text.replace(" & {72{!rst}}", ""))
    rows = shown(tmp_path, (planted, *SOURCES[1:]))
    assert [row for row in rows if "x" in row]
