"""Running a study and showing its report: its exit status, what is printed, what stays.

SPDX-License-Identifier: Apache-2.0
"""

import sys

import pytest

from tests.support import report_samples as samples

WRITE = """import json, pathlib, sys
path = pathlib.Path("build/reports/plates.json")
path.parent.mkdir(parents=True, exist_ok=True)
path.write_text(json.dumps({report!r}))
sys.exit({status})
"""
PLATES = {"plates": [{"file": f"plate{i}.png", "vertices": 1000 + i, "mismatches": 0} for i in range(10)]}


@pytest.fixture
def study(checkout):
    """Exit status and what is printed of a program that writes a report and ends so."""
    def run(*options, report=PLATES, status=0, name="plates"):
        checkout.put({"program.py": WRITE.replace("plates", name).format(report=report, status=status)
                      if report else f"import sys; sys.exit({status})"})
        status, out, errors = checkout.run(
            sys.executable, "-B", "-m", "lab.figures", "--root", checkout.root, "run", *options, name, "--",
            sys.executable, "program.py")
        return status, out + errors
    return run


def test_a_report_is_printed(study):
    status, text = study()
    assert status == 0 and "plate9.png" in text


def test_a_report_without_a_module_is_printed_as_it_is(study):
    status, text = study(name="newest", report={"rows": [{"mesh": "cat", "folds": 12}, {"mesh": "horse", "folds": 3}]})
    assert (status, text.split()) == (0, "mesh folds cat 12 horse 3".split())


def test_a_run_that_fails_prints_what_it_wrote(study):
    status, text = study(status=3)
    assert status == 3 and "plate9.png" in text


@pytest.mark.parametrize("status", (0, 3))
def test_a_report_of_which_no_table_is_made_is_kept(checkout, study, status):
    """Else hours of measuring would go with it."""
    ended, text = study(report={"plates": [{"file": "plate0.png"}]}, status=status)
    assert ended == status and text.endswith("figures: plates: measured, but not shown: see above\n")
    assert "plate0.png" in checkout.text("build/reports/plates.json")


def test_nothing_is_printed_where_it_is_asked_not_to_be_or_nothing_was_written(checkout, study):
    assert study("--quiet") == (0, "")
    before = checkout.text("build/reports/plates.json")
    assert study(report=None, status=2) == (2, "")
    assert checkout.text("build/reports/plates.json") == before


def test_another_report_that_is_none_leaves_out_a_picture_only(checkout, study):
    checkout.put({"build/reports/synth.json": '{"tests": 61}'})
    status, text = study(name="organizations", report=samples.ORGANIZATIONS)
    assert status == 0 and "no areas" in text and "no pictures: synth has no rows" in text
