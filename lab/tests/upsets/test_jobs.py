"""Parts of the campaign, one for each top, make the report that one run makes: on stand-ins for the programs
that flip bits and for yosys.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import sys

import pytest
import stand_ins
from stand_ins import BAD, GOOD

ROOT = pathlib.Path(__file__).resolve().parents[3]
TOPS = (("stream", "stream-hardened"), ("axi", "axi-hardened"))


@pytest.fixture(name="study")
def _study(checkout):
    """Runs the study: (exit status, complaints, report)"""
    def run(*words, outcomes=GOOD):
        checkout.put(stand_ins.programs("programs", "designs", outcomes), 0o755)
        report = checkout.root / "reports" / "upsets.json"
        report.unlink(missing_ok=True)
        status, _, errors = checkout.run(
            sys.executable, "-B", "-m", "lab.upsets", "--programs", "programs", "--designs", "designs", "--output", ".",
            "--flips", "12", *words, env={**os.environ, "PATH": f"{checkout.root}/bin:{os.environ['PATH']}"})
        complaints = [line for line in errors.splitlines() if "flips in" not in line and "costs" not in line]
        return status, complaints, json.loads(report.read_text()) if report.exists() else None

    checkout.put({"bin/yosys": stand_ins.yosys()}, 0o755)
    return run


def measured(study, **more):
    """A part of each top."""
    for names in TOPS:
        cores = [word for name in names for word in ("--core", name)]
        assert study(*cores, "--part", f"{names[0]}.json", **more) == (0, [], None)
    return [f"{names[0]}.json" for names in TOPS]


def test_joined_parts_are_the_report_of_one_run(study):
    whole = study()
    assert whole[:2] == (0, []) and len(whole[2]["rows"]) == 8 and len(whole[2]["cost"]) == 4
    assert sum(row["flips"] for row in whole[2]["rows"]) == 96
    assert study("--join", *measured(study)) == whole


def test_who_joins_judges(study):
    whole = study(outcomes=BAD)
    assert whole[0] == 1 and len(whole[1]) == 4
    assert study("--join", *measured(study, outcomes=BAD)) == whole


def test_parts_that_make_no_report_are_refused(study, checkout):
    stream, axi = measured(study)
    checkout.put({"seed.json": checkout.text(axi).replace('"seed": 1', '"seed": 2'),
                  "flips.json": checkout.text(axi).replace('"flips": 12', '"flips": 13')})
    for names, message in (((stream,), "parts have 4 rows, not each kind of bits of each core once"),
                           ((stream, stream), "parts have 8 rows"),
                           ((stream, "seed.json"), "parts differ in seed: 1, 2"),
                           ((stream, "flips.json"), "parts differ in flips: 12, 13"),
                           ((stream, "gone.json"), "gone.json: no part: ")):
        status, (complaint,), report = study("--join", *names)
        assert status == 1 and report is None and message in complaint
