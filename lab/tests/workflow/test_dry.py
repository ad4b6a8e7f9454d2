"""The workflow without running it, with each profile: as many jobs of each rule as the tables say. What is
there is not measured again, and what is broken is seen.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import re

import pytest

from tools.synth import placement, synthesis
from conftest import WORKFLOW, counted

PROFILES = ("kubernetes", "local", "slurm")
REPORTS = ("synth", "pnr", "mutants", "upsets", "soak")


def expected(root):
    """Jobs of each rule, from the tables."""
    subjects = synthesis.of_checkout(root)
    aims = [aim.subject for aim in placement.read(root / placement.TABLE, subjects)]
    packed = [aim for aim in aims if aim.top == synthesis.CORE and aim.target in synthesis.CORE_TARGETS]
    measures = [placement.Measure(target) for target in dict.fromkeys(aim.target for aim in aims)
                if not placement.unknown(target)]
    placed = [*measures, *aims]

    def seeds(some):
        return sum(len(placement.DEVICES[aim.target].seeds) for aim in some)

    with (root / "lab" / "mutants" / "subjects.csv").open(encoding="utf-8") as file:
        mutants = sum(row["mutants"] != "0" for row in csv.DictReader(file))
    jobs = {"map": len(subjects), "count": len(subjects),
            "standard_cells": sum(subject.target == synthesis.CELLS for subject in subjects), "flatten": len(placed),
            "chain": sum(placement.DEVICES[subject.target].chained for subject in placed),
            "route": seeds(subject for subject in placed if subject not in packed), "chip_route": seeds(packed),
            "chip_pack": len(packed), "mutants": mutants, "upsets": 2, "soak": 16, "build": 1, "reports": 1,
            **{f"report_{name}": 1 for name in REPORTS}}
    return {**jobs, "total": sum(jobs.values())}


def test_all_profiles_are_looked_at():
    assert sorted(path.name for path in (WORKFLOW / "profiles").iterdir()) == list(PROFILES)


@pytest.mark.parametrize("profile", PROFILES)
def test_jobs_are_those_of_the_tables(tree, profile):
    status, output = tree.snakemake(profile, "--dry-run")
    assert status == 0, output[-2000:]
    jobs = counted(output)
    assert jobs == expected(tree.root)
    assert jobs["total"] > 600 and min(jobs.values()) > 0


def test_a_row_more_is_a_job_more(tree):
    lines = tree.text("lab/mutants/subjects.csv").splitlines()
    before = counted(tree.snakemake("local", "--dry-run", work="mutants")[1])
    tree.put({"lab/mutants/subjects.csv": "\n".join([*lines, lines[-1].replace("stream,", "other,", 1)]) + "\n"})
    after = counted(tree.snakemake("local", "--dry-run", work="mutants")[1])
    assert before["mutants"] == len(lines) - 1
    assert after == {**before, "mutants": before["mutants"] + 1, "total": before["total"] + 1}


def test_only_what_is_missing_is_measured(tree):
    _, output = tree.snakemake("local", "--dry-run", work="soak upsets", soak_seeds=5)
    paths = sorted(set(re.findall(r"workflow/\w+/\w+\.\w{16}\.part", output)))
    assert len(paths) == 5 + 2
    tree.put({f"build/{part}": {} for part in paths[:4]})
    assert counted(tree.snakemake("local", "--dry-run", work="soak upsets", soak_seeds=5)[1]) == {
        "build": 1, "soak": 1, "upsets": 2, "report_soak": 1, "report_upsets": 1, "reports": 1, "total": 7}
    tree.put({f"build/{part}": {} for part in paths})
    assert counted(tree.snakemake("local", "--dry-run", work="soak upsets", soak_seeds=5)[1]) == {
        "report_soak": 1, "report_upsets": 1, "reports": 1, "total": 3}


@pytest.mark.parametrize("right, wrong, message", (
    ('output: "workflow/soak/{part}', 'output: "workflow/soaks/{part}', "MissingInputException in rule report_soak"),
    ('output: "workflow/soak.{key}', 'output: "workflow/soak.{part}', "contain the same wildcards"),
    ('missing("soak")', 'absent("soak")', "name 'absent' is not defined"),
    ('rule soak:', 'rule soak', "SyntaxError")))
def test_a_broken_rule_is_seen(tree, checkout, right, wrong, message):
    checkout.copy("tools", "lab/figures", "lab/workflow")
    text = tree.text("lab/workflow/Snakefile")
    assert right in text
    tree.put({"lab/workflow/Snakefile": text.replace(right, wrong, 1)})
    status, output = tree.snakemake("local", "--dry-run", snakefile=tree.root / "lab/workflow/Snakefile",
                                    work="soak")
    assert status == 1 and message in output


def test_work_that_there_is_not_is_refused(tree):
    status, output = tree.snakemake("local", "--dry-run", work="soak rest")
    assert status == 1 and "WORK=rest: any of synth pnr mutants upsets soak" in output
