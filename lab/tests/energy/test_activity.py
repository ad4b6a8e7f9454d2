"""Toggles counted in a file of a simulator.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from lab.energy import activity

HEAD = """$timescale 1ps $end
$scope module cells $end
$var wire 1 ! n1 $end
$var wire 1 " n2 $end
$var wire 3 # bus [2:0] $end
$upscope $end
$enddefinitions $end
"""
# Three clocks of 10 from 4 on. n1 has a glitch in the second: up, down and up.
WHOLE = HEAD + """$dumpoff
x!
x"
bx #
$end
#2
1!
#4
$dumpon
0!
1"
b10 #
$end
#6
1!
#14
b101 #
#15
0!
#16
1!
#17
0!
#18
1!
0"
#25
0!
#34
$dumpoff
x!
x"
bx #
$end
#40
0!
1!
"""


def counted(text, period=10):
    return activity.read(text.splitlines(keepends=True), period)


def of(net):
    return net.toggles, net.settled, net.high


def test_changes_between_on_and_off():
    activity = counted(WHOLE)
    assert activity.clocks(10) == 3
    assert of(activity.nets["n1"]) == (6, 2, 9 + 1 + 7)
    assert of(activity.nets["n2"]) == (1, 1, 14)
    assert not activity.unknown()


def test_each_bit_of_a_bus_is_a_net():
    nets = counted(WHOLE).nets
    assert [of(nets[f"bus[{bit}]"]) for bit in (2, 1, 0)] == [(1, 1, 20), (1, 1, 10), (1, 1, 20)]


def test_a_change_and_back_in_one_clock_is_a_glitch_alone():
    net = counted(HEAD + '$dumpon\n0!\n0"\nb0 #\n$end\n#3\n1!\n#4\n0!\n#10\n$dumpoff\nx!\n').nets["n1"]
    assert of(net) == (2, 0, 1)


def test_the_same_value_again_is_no_change():
    net = counted(HEAD + '$dumpon\n1!\n0"\nb0 #\n$end\n#3\n1!\n#10\n$dumpoff\n').nets["n1"]
    assert of(net) == (0, 0, 10)


@pytest.mark.parametrize("spoil, unknown", ((("b10 #", "b1x0 #"), 1), (("0!\n1\"", "x!\n1\""), 1),
                                            (("#16\n1!", "#16\nx!"), 1), (("b10 #", "bx #"), 3)))
def test_what_has_no_value_is_known(spoil, unknown):
    assert counted(WHOLE.replace(*spoil, 1)).unknown() == unknown


@pytest.mark.parametrize("text", (HEAD, WHOLE.replace("#34", "#33"), HEAD + "#4\n$dumpon\n"))
def test_only_whole_clocks_count(text):
    with pytest.raises(activity.ActivityError, match="not for whole clocks"):
        counted(text).clocks(10)
