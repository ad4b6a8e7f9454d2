"""What ffd_channel_check sees of a channel and ffd_stream_packet_check of packets, in a simulator that knows X, and that
they are empty elsewhere.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from tools.project_root import ROOT
from tools.rtl import rtl_sources

# Clocks of {valid, ready, payload}, behind a reset of two.
BENCH = """
module bench;
  reg clk = 1'b0, rst = 1'b1, valid = 1'b0, ready = 1'b0;
  reg [3:0] payload = 4'd0;
  ffd_channel_check #(.WIDTH(4)) u_check (
    .clk(clk), .rst(rst), .valid_i(valid), .ready_i(ready), .payload_i(payload));
  always #5 clk = !clk;
  task next(input v, input r, input [3:0] p);
    begin valid <= v; ready <= r; payload <= p; @(posedge clk); end
  endtask
  initial begin
    repeat (2) @(posedge clk);
    rst <= 1'b0;
{}
    repeat (2) @(posedge clk);
    $display("at the end");
    $finish;
  end
endmodule
"""
GOOD = (("1'b0", "1'b1", "4'd3"), ("1'b1", "1'b0", "4'd5"), ("1'b1", "1'b0", "4'd5"), ("1'b1", "1'b1", "4'd5"),
        ("1'b1", "1'b1", "4'd6"), ("1'b0", "1'b0", "4'd1"), ("1'b0", "1'b0", "4'd2"), ("1'b1", "1'b0", "4'bx"),
        ("1'b1", "1'b1", "4'bx"))
BAD = {
    "valid_is_unknown": (2, ("1'bx", "1'b0", "4'd5")),
    "ready_is_unknown": (2, ("1'b1", "1'bx", "4'd5")),
    "valid_falls_before_ready": (2, ("1'b0", "1'b0", "4'd5")),
    "payload_changes_before_ready": (2, ("1'b1", "1'b0", "4'd7")),
}


def simulated(checkout, clocks, *flags):
    lines = "\n".join(f"    next({', '.join(clock)});" for clock in clocks)
    checkout.put({"bench.v": BENCH.format(lines)})
    status, _, errors = checkout.run("iverilog", "-g2005", "-Wall", *flags, f"-I{ROOT / 'rtl' / 'common'}", "-o", "bench", "-s",
                                     "bench", "bench.v", ROOT / "rtl" / "common" / "ffd_channel_check.v")
    assert status == 0 and "error" not in errors
    return checkout.run("vvp", "-n", "-N", "bench")


def test_what_keeps_the_rules_runs_to_its_end(checkout):
    status, printed, _ = simulated(checkout, GOOD, f"-D{rtl_sources.ASSERTIONS}")
    assert (status, printed.splitlines()) == (0, ["at the end"])


@pytest.mark.parametrize("rule", BAD)
def test_what_breaks_a_rule_ends(checkout, rule):
    place, clock = BAD[rule]
    clocks = (*GOOD[:place], clock, *GOOD[place + 1:])
    status, printed, _ = simulated(checkout, clocks, f"-D{rtl_sources.ASSERTIONS}")
    assert status != 0 and f"cannot happen: bench.u_check.{rule}" in printed and "at the end" not in printed
    assert simulated(checkout, clocks)[:2] == (0, "at the end\n")


PACKETS = """
module bench;
  reg clk = 1'b0, rst = 1'b1, stop = 1'b0;
  reg [15:0] events = 16'hFFFF;
  ffd_stream_packet_check u_check (
    .clk(clk), .rst(rst), .grid_stop_i(stop), .event_i(events), .packet_i(32'd7), .beat_i(32'd2));
  always #5 clk = !clk;
  initial begin
    repeat (2) @(posedge clk);
    rst <= 1'b0;
    stop <= {};
    events <= 16'd0;
    @(posedge clk);
    stop <= 1'b0;
    repeat (5) @(posedge clk);
    events <= 16'd1 << {};
    @(posedge clk);
    events <= 16'd0;
    @(posedge clk);
    events <= 16'd1 << {};
    repeat (2) @(posedge clk);
    $display("at the end");
    $finish;
  end
endmodule
"""
COMPUTED = (8, 9, 15)  # a coordinate that is clamped, a result that saturates, a page of sums
GRID = 13


def checked(checkout, stop, *numbers, flags=("-DFFD_PACKET_ASSERTIONS",)):
    """How the bench ends after two events, behind a stop or none, and what it prints."""
    checkout.put({"bench.v": PACKETS.format(f"1'b{int(stop)}", *numbers)})
    status, _, errors = checkout.run("iverilog", "-g2005", "-Wall", *flags, f"-I{ROOT / 'rtl' / 'stream'}", "-o", "bench", "-s",
                                     "bench", "bench.v", ROOT / "rtl" / "stream" / "ffd_stream_packet_check.v")
    assert status == 0 and "error" not in errors
    return checkout.run("vvp", "-n", "-N", "bench")[:2]


@pytest.mark.parametrize("number", range(16))
def test_a_bad_packet_ends(checkout, number):
    status, printed = checked(checkout, False, number, number)
    if number in COMPUTED:
        assert (status, printed) == (0, "at the end\n")
    else:
        assert status != 0 and f"bad packet 7, beat 2: event {number}, bench.u_check" in printed
    assert checked(checkout, False, number, number, flags=()) == (0, "at the end\n")


def test_a_grid_that_is_stopped_is_none(checkout):
    assert checked(checkout, True, GRID, COMPUTED[0]) == (0, "at the end\n")
    for numbers in ((GRID, GRID), (COMPUTED[0], GRID - 1)):  # the next grid, and another event behind a stop
        status, printed = checked(checkout, True, *numbers)
        assert status != 0 and f"event {numbers[1]}, bench.u_check" in printed
