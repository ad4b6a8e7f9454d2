"""synth/baseline.csv: what has grown or shrunk, by hand, and on a copy of the tree, where the
binary32 adder passes as it is and fails when it is made wider.

SPDX-License-Identifier: Apache-2.0
"""

import re

import pytest

from tests.support import forked_snakemake
from tools.rtl import rtl_sources
from tools.synth import baseline, synthesis
from tools.tables import configurations

ADDER, LUTS = synthesis.Unit("add", 1), {"lut": 500, "lutram": 0, "ff": 32, "dsp": 0, "bram": 0}
SUBJECTS = [synthesis.Subject(ADDER, "ffd_fp_add", target) for target in synthesis.UNIT_TARGETS]
RESULTS = list(zip(SUBJECTS, ({**LUTS, "depth": 37},
                              {"area_um2": 50000, "cells": 2000, "ff": 32, "depth": 80})))
(ADDER_LUTS, ADDER_AREA), CURE = (result for _, result in RESULTS), "make synth-baseline"


@pytest.fixture
def compare(tmp_path):
    """With a baseline of RESULTS, or of this text."""
    def compared(*results, version="Yosys 1", everything=True, text=None):
        path = tmp_path / "baseline.csv"
        path.write_text(baseline.text("Yosys 1", RESULTS) if text is None else text)
        return baseline.compare(version, baseline.read(path), results or RESULTS, everything)
    return compared


def test_the_same_passes(compare):
    assert compare() == ([], [], 10)


@pytest.mark.parametrize("lut, grown, notes", (
    (515, 0, 0), (516, 1, 0), (485, 0, 0), (484, 0, 1), (0, 0, 1)))
def test_bounds(compare, lut, grown, notes):
    differences = compare((SUBJECTS[0], {**ADDER_LUTS, "lut": lut}), RESULTS[1])
    assert (len(differences[0]), len(differences[1])) == (grown, notes)


def test_lines_name_the_thing(compare):
    larger = {**ADDER_LUTS, "lut": 550, "dsp": 1, "depth": 38}
    assert compare((SUBJECTS[0], larger), RESULTS[1])[0] == [
        "add-fp32-latency1, ffd_fp_add, ecp5: lut 500 -> 550 (+10.0 %)",
        "add-fp32-latency1, ffd_fp_add, ecp5: dsp 0 -> 1 (new)"]
    smaller = {**ADDER_AREA, "area_um2": 40000}
    assert compare(RESULTS[0], (SUBJECTS[1], smaller))[1] == [
        f"add-fp32-latency1, ffd_fp_add, osu018: area_um2 50000 -> 40000 (-20.0 %): {CURE}"]


def test_rows_come_and_go(compare):
    assert compare(RESULTS[0])[0] == [
        f"add-fp32-latency1, ffd_fp_add, osu018: only in the baseline: {CURE}"]
    assert compare(RESULTS[0], everything=False)[0] == []
    new = synthesis.Subject(synthesis.Unit("add", 2), "ffd_fp_add", "ecp5")
    grown, notes, _ = compare(*RESULTS, (new, ADDER_LUTS), version="Yosys 2")
    assert grown == [f"{new}: not in the baseline: {CURE}"]
    assert notes == ["the baseline is of Yosys 1, this is Yosys 2"]


@pytest.mark.parametrize("old, new", (
    (None, ""), (None, "# Yosys 1\n"), ("500", "x"), ("depth", "deep")))
def test_bad_files_name_the_cure(compare, old, new):
    text = new if old is None else baseline.text("Yosys 1", RESULTS).replace(old, new)
    with pytest.raises(baseline.BaselineError, match=CURE):
        compare(text=text)


@pytest.fixture
def tree(checkout):
    """With one binary32 row, whose latencies are 1, so that there are few units to map."""
    checkout.copy("rtl", "synth")
    table = "rtl/configurations.csv"
    kept = [line for line in checkout.text(table).splitlines(True)
            if ",fp32," not in line or line.startswith("basic-fp32-overlapped,")]
    checkout.put({table: re.sub(r"(?m)^(basic-fp32-overlapped,(?:[^,]*,){5})[0-9]+,[0-9]+,", r"\g<1>1,1,", "".join(kept))})
    return checkout


@pytest.fixture
def run(tree):
    def called(command, *words):
        status, out, errors = forked_snakemake.module(tree.root, "tools.synth.synth_baseline", command, "--root", tree.root,
                                                      *words)
        return status, out.splitlines(), errors.splitlines()
    return called


@pytest.fixture
def renewed(tree):
    """The baseline of another yosys says nothing here."""
    path = tree.root / "synth" / "baseline.csv"
    version = rtl_sources.run(["yosys", "-V"])[1].strip()
    if baseline.read(path)[0] != version:
        work = synthesis.Synthesis(tree.root)
        wanted = [subject for subject in synthesis.subjects(configurations.read(
            tree.root / "rtl" / "configurations.csv"))
            if subject.row.org == "unit" and subject.target == "ecp5"]
        assert synthesis.run(work, wanted, 2) == []
        path.write_text(baseline.text(version, [(s, work.result(s)) for s in wanted]))


def test_a_wider_adder_fails(tree, run, renewed):
    check = ("check", "--org", "unit", "--target", "ecp5")
    status, lines, errors = run(*check)
    assert (status, errors) == (0, []), lines
    assert ", 0 more than 3 % above" in lines[-1]
    assert re.findall(r"(\d+) (?:rows|figures)", lines[-1]) == ["2", str(2 * 6)]

    adder = "rtl/number/float/ffd_fp_add.v"
    assert tree.text(adder).count("SIG_W   = 24") == 1
    tree.put({adder: tree.text(adder).replace("SIG_W   = 24", "SIG_W   = 27")})
    status, lines, errors = run(*check)
    assert status == 1
    assert all(", ffd_fp_add, ecp5: " in line for line in errors)
    assert any(": lut " in line for line in errors)
    assert f"{len(errors)} more than 3 % above" in lines[-1]


@pytest.mark.parametrize("words, status, message", (
    (("check", "--org", "x"), 2, "unknown ORG 'x'"),
    (("write", "--org", "unit"), 2, "write maps the whole set"),
    (("look",), 2, "argument command: invalid choice: 'look'")))
def test_bad_requests(run, words, status, message):
    exit_status, _, (error,) = run(*words)
    assert exit_status == status
    assert error.startswith(f"synth_baseline: {message}")
