"""The report: a median, aims that are reached or missed, what is missing; and its tables.

SPDX-License-Identifier: Apache-2.0
"""

import copy
import json
import re

import numpy
import pytest

from lab.align import __main__ as study
from lab.align import core, pairs, programs, report, run
from lab.figures.studies import align as tables

OWN, PEER, SLOW, LOST = "own", "quick peer", "slow peer", "lost peer"


def program(name, **more):
    return programs.Program(name, "numpy", "L-BFGS", "nowhere", "nothing", "its own count", **more)


PROGRAMS = (program(OWN, hwffd=True), program(PEER, rate_aim=3), program(SLOW, rate_aim=100), program(LOST))
SECONDS = {OWN: 1.0, PEER: 4.0, SLOW: 50.0}
ERRORS = {OWN: 0.10, PEER: 0.15, SLOW: 0.05}


def small():
    return pairs.phantom_pair(16)


@pytest.fixture
def measured(monkeypatch, tmp_path):
    """The report of a study whose programs are stand-ins: a field that is off by a known length."""
    monkeypatch.setattr(programs, "PROGRAMS", PROGRAMS)
    monkeypatch.setattr(programs.Program, "version", "1.0")
    monkeypatch.setattr(study, "PAIRS", ((small, 8),))
    monkeypatch.setattr(core, "estimate", lambda reports, counts, cells: {
        "counts": counts, "cells": cells, "voxels_per_s": 5e7, "halves": [
            {"what": "positions", "top": "hwffd_stream", "name": "walk", "mhz": 100.0, "routed": False, "clocks": 4096,
             "seconds": 4.1e-5}]})
    calls = []

    def start(which, job, processors, _=None):
        calls.append((which.name, job.threads, job.iterations, len(processors)))
        if which.name == LOST:
            return {"absent": "it does not compile"}, None
        field = small().truth + numpy.array([ERRORS[which.name], 0, 0])
        if which.name == PEER and job.threads == 5:
            field[0, 0, 0, 0] = numpy.nextafter(field[0, 0, 0, 0], 9)
        number = sum(call[0] == which.name for call in calls)
        row = {"evaluations": 10, "voxel_evaluations": 40960, "seconds": SECONDS[which.name] * (1 + number % 3),
               "share": 1.0, "peak_mb": 50.0, "all_s": 2 * SECONDS[which.name], "stopped": False}
        return row, field
    monkeypatch.setattr(run, "start", start)
    monkeypatch.setattr("sys.argv", ["align", "--output", str(tmp_path), "--pair", "0"])
    status = study.main()
    return status, json.loads((tmp_path / "reports" / "align.json").read_text(encoding="utf-8")), calls


def test_runs_take_turns_and_the_median_counts(measured):
    status, data, calls = measured
    assert status == 0
    assert [name for name, *_ in calls[:8]] == [OWN, PEER, SLOW, LOST, OWN, PEER, OWN, PEER]
    rows = {row["program"]: row for row in data["rows"]}
    assert rows[OWN]["runs"] == 3 and rows[OWN]["seconds"] == 2.0 and rows[OWN]["voxels_per_s"] == 20480
    assert rows[SLOW]["runs"] == 1  # all of it took longer than LONG
    assert rows[OWN]["error"] == pytest.approx(0.10) and rows[PEER]["error"] == pytest.approx(0.15)
    assert all(set(report.FIELDS) <= set(row) for row in data["rows"])


def test_bits_are_compared_over_threads(measured):
    _, data, calls = measured
    assert {threads for name, threads, *_ in calls if name == OWN} == {1, 2, 5}
    assert {row["program"]: row["differing"] for row in data["bits"]} == {
        OWN: {"again": 0, "2 threads": 0, "5 threads": 0}, SLOW: {"again": 0, "2 threads": 0, "5 threads": 0},
        PEER: {"again": 0, "2 threads": 0, "5 threads": data["bits"][1]["differing"]["5 threads"]}}
    assert data["bits"][1]["differing"]["5 threads"] >= 1
    assert data["bits"][0]["of"] == 16**3 * 3 * 64
    assert all(iterations == study.BITS_ITERATIONS for _, _, iterations, _ in calls[8:])
    assert {processors for _, threads, _, processors in calls if threads == 1} == {1}


def test_aims_are_reached_or_missed(measured):
    assert [(row["aim"].split(",")[0], round(row["value"], 3), row["reached"]) for row in measured[1]["aims"]] == [
        ("error of own by that of slow peer", 2.0, False), ("times the rate of quick peer", 4.0, True),
        ("times the rate of slow peer", 50.0, False), ("differing bits of own", 0, True)]


def test_a_program_that_is_not_there_is_said_to_be(measured):
    data = measured[1]
    assert {row["program"]: row["absent"] for row in data["programs"]}[LOST] == "it does not compile"
    assert report.faults(data) == []
    silent = copy.deepcopy(data)
    silent["programs"][3]["absent"] = None
    assert report.faults(silent) == ["lost peer: neither measured nor said to be absent"]


@pytest.mark.parametrize("change, fault", (
    ({"error": 9.0}, r"own, phantom 16\^3: an error of 9.000 voxels, and 1\.\d+ before"),
    ({"evaluations": 0}, r"own, phantom 16\^3: 0 evaluations in 2.0 s"),
    ({"folds": None}, r"own, phantom 16\^3: no folds")))
def test_what_cannot_be_is_a_fault(measured, change, fault):
    data = copy.deepcopy(measured[1])
    for field, value in change.items():
        if value is None:
            del data["rows"][0][field]
        else:
            data["rows"][0][field] = value
    faults = report.faults(data)
    assert len(faults) == 1 and re.fullmatch(fault, faults[0])


class Reports:
    """One report."""

    def __init__(self, data):
        self.data = data

    def get(self, name):
        assert name == "align"
        return self.data


def test_tables(measured):
    data = Reports(measured[1])
    assert [line[1] for line in tables.programs(data).rows] == [
        "before", "slow peer 1.0", "own 1.0", "quick peer 1.0", "lost peer: it does not compile"]
    assert tables.bits(data).heads == ["program", "bits of the field", "again", "2 threads", "5 threads"]
    assert [line[-1] for line in tables.aims(data).rows] == ["missed", "yes", "missed", "yes"]
    assert "lost peer" in tables.printed(data) and "5 threads" in tables.printed(data)
    figures = {name: figure(data) for name, figure in tables.FIGURES.items()}
    assert figures.pop("others_differing") >= 1
    assert figures == {"missed": 2, "aims": 4, "differing": 0, "core_rate": 50.0}
    assert tables.missing(data) == LOST


def test_a_report_without_a_result_of_hwffd_is_not_whole(measured):
    """Although the command, which ends with 1, has a report to publish."""
    data = copy.deepcopy(measured[1])
    data["programs"][3]["absent"] = None
    data["rows"] = [row for row in data["rows"] if row["program"] != OWN]
    data["failed"] = [{"program": name, "pair": "phantom 16^3", "why": "ended with -11"} for name in (OWN, PEER)]
    assert tables.missing(Reports(data)) == f"{OWN}, {LOST}"
    data["programs"][3]["absent"], data["rows"] = LOST, measured[1]["rows"]
    assert tables.missing(Reports(data)) == f"{LOST}, {OWN} on phantom 16^3"


def test_what_an_earlier_report_has_of_others_stays(measured, monkeypatch, tmp_path):
    before = measured[1]
    monkeypatch.setitem(ERRORS, OWN, 0.01)
    monkeypatch.setattr("sys.argv", ["align", "--output", str(tmp_path), "--pair", "0", "--program", "0"])
    assert study.main() == 0
    data = json.loads((tmp_path / "reports" / "align.json").read_text(encoding="utf-8"))
    rows = [{row["program"]: row for row in of["rows"]} for of in (before, data)]
    assert rows[1][PEER] == rows[0][PEER] and rows[1][OWN]["error"] == pytest.approx(0.01)
    assert [len(data[name]) for name in ("rows", "bits", "pairs")] == [3, 3, 1]
    assert [row["reached"] for row in data["aims"]] == [True, True, False, True]
