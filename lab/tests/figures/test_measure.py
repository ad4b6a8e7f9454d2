"""Running a study, stamping its report, and taking it into the folder that is committed.

SPDX-License-Identifier: Apache-2.0
"""

import json
import sys

import pytest
from figures import check, measure, sources
from figures.catalogue import REPORTS
from figures.reports import COMMITTED, Reports
from rtl import ROOT

WRITE = """import json, pathlib, sys
path = pathlib.Path("build/reports/plates.json")
path.parent.mkdir(parents=True, exist_ok=True)
path.write_text(json.dumps({report!r}))
sys.exit({status})
"""
FRESH, KEPT = "build/reports/plates.json", "docs/reports/plates.json"
PLATES = {"plates": [{"file": f"plate{i}.png", "vertices": 1000 + i, "mismatches": 0}
                     for i in range(10)]}


@pytest.fixture
def figures(checkout):
    """Exit status and what is printed."""
    checkout.link("rtl", "geometry", "apps")

    def run(*words):
        status, out, errors = checkout.script("figures", "--root", checkout.root, *words)
        return status, out + errors
    return run


@pytest.fixture
def study(checkout, figures):
    """The same of a program that writes a report and ends so."""
    def run(report=None, status=0):
        checkout.put({"program.py": WRITE.format(report=report, status=status)
                      if report else f"import sys; sys.exit({status})"})
        return figures("measure", "--quiet", "plates", "--", sys.executable, "program.py")
    return run


def test_a_run_that_ends_well_is_stamped_and_can_be_taken(checkout, figures, study):
    assert study(PLATES) == (0, "")
    fresh = json.loads(checkout.text(FRESH))
    assert fresh["measured"] == {"command": "make plates",
                                 "sources": sources.key(ROOT, REPORTS["plates"].sources)}
    assert figures("adopt", "plates") == (0, f"wrote {KEPT}\n")
    assert json.loads(checkout.text(KEPT)) == fresh
    row = '\n    {"file": "plate0.png", "vertices": 1000, "mismatches": 0},\n'
    assert row in checkout.text(KEPT)


def test_a_run_that_fails_is_not(checkout, figures, study):
    assert study(PLATES, 3)[0] == 3
    assert "measured" not in json.loads(checkout.text(FRESH))
    status, text = figures("adopt", "plates")
    assert (status, text.count("\n")) == (1, 1)
    assert "is not of a run that ended well: make plates" in text


def test_a_run_that_falls_short_of_its_aims_and_says_so_is_stamped(checkout, figures, study):
    assert study({**PLATES, "short": ["plate0: a mismatch"]}, 1)[0] == 1
    assert "measured" in json.loads(checkout.text(FRESH))
    assert figures("adopt", "plates")[0] == 0


def test_a_run_that_writes_nothing_leaves_the_old_report(checkout, study):
    study(PLATES)
    before = checkout.text(FRESH)
    assert study(status=2)[0] == 2
    assert checkout.text(FRESH) == before


def test_what_is_not_whole_or_old_is_not_taken(checkout, figures, study):
    study({"plates": PLATES["plates"][:3]})
    assert "is not whole: plates: make plates" in figures("adopt", "plates")[1]
    assert figures("adopt", "--part", "plates") == (0, f"wrote {KEPT}\n")
    assert f"{KEPT} lacks plates: make plates" in figures("check")[1]
    study(PLATES)
    report = json.loads(checkout.text(FRESH))
    report["measured"]["sources"] = "0" * 16
    checkout.put({FRESH: report})
    assert "is older than its sources: make plates" in figures("adopt", "plates")[1]
    assert "there is no report yet: make words" in figures("adopt", "words")[1]
    assert "no report 'x'" in figures("adopt", "x")[1]


def test_rows_that_were_not_measured_again_stay(checkout, figures):
    def row(name, clock, **more):
        return {"name": name, "top": "hwffd_stream", "target": "ecp5", "fmax_mhz": clock, **more}

    checkout.link("synth")
    key = sources.key(ROOT, REPORTS["pnr"].sources)

    def report(*rows):
        return {"measured": {"command": "make pnr", "sources": key}, "rows": rows}

    committed = "docs/reports/pnr.json"
    checkout.put({committed: report(row("a", 1.0), row("b", 2.0)),
                  "build/reports/pnr.json": report(row("c", 4.0), row("b", 3.0))})
    assert figures("adopt", "--part", "pnr") == (0, f"wrote {committed}\n")
    assert json.loads(checkout.text(committed))["rows"] == [
        row("a", 1.0, older=True), row("b", 3.0), row("c", 4.0)]
    reports = Reports(checkout.root, COMMITTED)
    assert reports.older("pnr") == 1
    assert measure.with_older(reports.get("pnr"), reports.get("pnr"), "pnr")["rows"] == list(
        reports.rows("pnr"))


def test_what_differs_from_run_to_run_is_not_committed():
    report = {"wanted": 1, "rows": [{"name": "a", "lut": 3, "seconds": 1.5, "kinds": {"X": 1}}]}
    assert json.loads(measure.committed_form(report, "synth")) == {
        "wanted": 1, "rows": [{"name": "a", "lut": 3}]}
