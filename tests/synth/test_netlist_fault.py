"""tools/synth/netlist_fault.py: one LUT of the unit is inverted, nothing else; where there is none it
says so.

SPDX-License-Identifier: Apache-2.0
"""

import re

import pytest

LUT = "  LUT4 #(\n    .INIT(16'h{})\n  ) a (.A(x), .Z(y));\n"


def module(name, *tables):
    return "".join([f"module {name} (x, y);\n", *map(LUT.format, tables), "endmodule\n"])


@pytest.fixture
def spoil(checkout):
    """Exit status, complaints, the copy or None."""
    def spoiled(text):
        checkout.put({"good.v": text})
        status, _, errors = checkout.module("tools.synth.netlist_fault", "good.v", "fault.v")
        return status, errors.splitlines(), (
            checkout.text("fault.v") if (checkout.root / "fault.v").exists() else None)
    return spoiled


def test_the_first_lut_of_the_unit_is_inverted(spoil):
    term = r"\$paramod$61b70be1\ffd_num_term"
    others = module("other", "1234"), module("last", "ffff")
    assert spoil(others[0] + module(term, "00fe", "8001") + others[1]) == (
        0, [], others[0] + module(term, "ff01", "8001") + others[1])


def test_the_lut_of_another_module_is_left_alone(spoil):
    status, (error,), copy = spoil(module("ffd_num_term") + module("other", "1234"))
    assert (status, copy) == (1, None)
    assert re.search("no LUT4 in ffd_num_term", error)


def test_a_netlist_that_is_not_there_is_one_line(spoil):
    status, errors, copy = spoil(None)
    assert (status, len(errors), copy) == (1, 1, None)
