"""The rows that `make synth` maps in this tree.

SPDX-License-Identifier: Apache-2.0
"""

from tools.project_root import ROOT
from tools.synth import chips, placement, synthesis
from tools.tables import configurations


def test_rows_of_this_tree():
    subjects = synthesis.of_checkout(ROOT)
    names = [subject.name for subject in subjects]
    assert len(names) == len(set(names)) >= 40
    assert {subject.target for subject in subjects} == set(synthesis.TARGETS)
    assert {subject.top for subject in subjects} == {
        synthesis.ORGANIZATION, synthesis.CORE, synthesis.BUS, synthesis.SYSTEM, synthesis.SCATTER,
        synthesis.ADJOINT,
        *synthesis.FLOAT_UNITS}
    assert {subject.row.name for subject in subjects if subject.top == synthesis.SYSTEM} >= {
        row.name for row in configurations.read() if row.top == "axi" and row.schedule == "overlapped"}
    few = synthesis.of_set(subjects, "ci")
    assert {subject.target for subject in few} == set(synthesis.TARGETS) - {
        "hx8k", *chips.TARGETS}
    assert {subject.row.org for subject in few} == {
        subject.row.org for subject in subjects if subject.row.format == "fx18"} - {"unit"}
    guarded = synthesis.of_set(subjects, "baseline")
    assert [subject for subject in guarded if subject in few] == few
    assert {(subject.top, subject.target) for subject in guarded if subject not in few} == {
        (top, target) for top in synthesis.FLOAT_UNITS for target in synthesis.UNIT_TARGETS}


def test_chips_have_the_rows_that_are_routed():
    subjects = synthesis.of_checkout(ROOT)
    routed = [aim.subject for aim in placement.read(ROOT / placement.TABLE, subjects)]
    assert [subject for subject in subjects if subject.target in chips.TARGETS] == [
        subject for subject in routed if subject.target in chips.TARGETS]
    cores = [subject for subject in routed if subject.top == synthesis.CORE]
    assert {subject.target for subject in cores} == set(placement.DEVICES)
