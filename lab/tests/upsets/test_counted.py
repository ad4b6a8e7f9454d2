"""Counts and intervals of lines that are written by hand.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from lab.upsets import counted

HEAD = "# clocks 100 registers 8 memory_bits 64\n"
COLUMNS = "clock,module,name,word,bit,outcome,recovered,restarted,outside_read\n"
LINES = ("3,ffd_a,u_a.x_q[2],0,0,no_effect,1,1,0\n", "4,ffd_a,u_a.x_q[3],0,0,hang_stuck,0,1,0\n",
         "5,ffd_b,u_b.y_q,0,0,outside_window,0,0,1\n", "6,ffd_b,u_b.y_q,0,0,hang_stuck,0,1,0\n")


@pytest.fixture(name="file")
def _file(tmp_path):
    def write(*lines):
        (tmp_path / "flips.csv").write_text("".join(lines))
        return tmp_path / "flips.csv"
    return write


def test_lines_are_counted(file):
    flips = counted.read(file(HEAD, COLUMNS, *LINES))
    assert (flips.clocks, flips.bits("registers"), flips.bits("memories")) == (100, 8, 64)
    row = counted.row(flips.lines)
    assert (row["flips"], row["no_effect"], row["hang_stuck"], row["outside_window"]) == (4, 1, 2, 1)
    assert sum(row[outcome] for outcome in counted.OUTCOMES) == row["flips"]
    assert row["places"] == {"hang_stuck": {"u_a.x_q": 1, "u_b.y_q": 1}, "outside_window": {"u_b.y_q": 1}}
    assert (row["reset_does_not_help"], row["restart_does_not_help"], row["outside_read"]) == (3, 1, 1)
    assert [(module, len(lines)) for module, lines in counted.by_module(flips.lines)] == \
        [("ffd_a", 2), ("ffd_b", 2)]


@pytest.mark.parametrize("lines, message", (
    ((), "0 flips"), ((HEAD, COLUMNS), "0 flips"), ((COLUMNS, *LINES), "0 flips"),
    ((HEAD, COLUMNS, LINES[0].replace("no_effect", "well")), "called well")))
def test_a_campaign_that_measured_nothing_is_an_error(file, lines, message):
    with pytest.raises(counted.UpsetError, match=message):
        counted.read(file(*lines))


def test_intervals_are_those_of_wilson():
    # By hand: 10 of 100, z = 1.96.
    assert counted.interval(10, 100) == [5.523, 17.437]
    assert counted.interval(0, 9604) == [0.0, 0.04]
    assert counted.interval(9604, 9604) == [99.96, 100.0]
    low, high = counted.interval(4802, 9604)
    assert high - low <= 2.0
