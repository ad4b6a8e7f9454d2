"""What `make soc` makes of the program's figures: each fault is one.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from soc import simulate

GOOD = {"vertices": 10, "mismatches_polled": 0, "mismatches_interrupt": 0, "core_clocks": 64032,
        "interrupt_clocks": 64100, "embedding_clocks": 99000, "lattice_clocks": 6000, "software_clocks": 9000000,
        "software_vertices": 5, "software_mismatches": 0, "refusals": 4, "resets": 20, "resets_caught": 19,
        "resets_silent": 0, "resets_results": 320, "resets_mismatches": 0, "hangs": 0, "status": 0}


def test_a_good_run_has_no_fault():
    soc = simulate.report(GOOD)
    assert simulate.faults(soc, 20) == []
    assert (soc["clocks_per_vertex"], soc["software_clocks_per_vertex"]) == (64.032, 9000)
    assert soc["compared"] == 20


@pytest.mark.parametrize("name, value", (
    ("vertices", 0), ("mismatches_polled", 1), ("mismatches_interrupt", 1), ("software_vertices", 0),
    ("software_mismatches", 1), ("refusals", 3), ("resets", 19), ("resets_caught", 9), ("resets_silent", 1),
    ("resets_mismatches", 1), ("hangs", 1), ("status", 1)))
def test_each_fault_is_seen(name, value):
    (fault,) = simulate.faults(simulate.report({**GOOD, name: value}), 20)
    assert "\n" not in fault


def test_a_run_that_ends_early_is_told():
    soc = simulate.report({"vertices": 10, "status": 1})
    assert len(simulate.faults(soc, 20)) >= 4
    assert simulate.text(soc)
    assert simulate.ended_early(soc)
    assert not simulate.ended_early(simulate.report(GOOD))
    assert not simulate.ended_early(simulate.report({**GOOD, "refusals": 3, "status": 1}))
