"""The soak on a program of a few lines: seeds go up, one that finds a fault is kept, nothing is an error.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = """#!/usr/bin/env python3
import json, os, sys, time
seed = int(os.environ["SEED"])
if seed == BREAKS:
    sys.exit(3)
bad = seed == FAILS
path = os.environ["GTEST_OUTPUT"].removeprefix("json:")
case = {"classname": "Few", "name": "Lines", "status": "RUN", **({"failures": [{}]} if bad else {})}
json.dump({"testsuites": [{"testsuite": [case]}]}, open(path, "w"))
print("small: 1 seeds, 5 results, 70 clocks")
time.sleep(0.02)
sys.exit(seed == ENDS)
"""


@pytest.fixture(name="build")
def _build(tmp_path):
    (tmp_path / "corpus.csv").write_text("traffic,seed,test\n")
    return tmp_path


def program(build, fails=-1, breaks=-1, ends=-1):
    path = build / "product" / "tests" / "bus" / "dma" / "dma_test"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(PROGRAM.replace("FAILS", str(fails)).replace("BREAKS", str(breaks)).replace("ENDS", str(ends)))
    path.chmod(0o755)


def call(build, *words):
    result = subprocess.run([sys.executable, "-B", "-m", "lab.soak", "--build", build, "--output", build,
                             "--only", "dma", "--corpus", build / "corpus.csv", *map(str, words)],
                            capture_output=True, text=True, check=False)
    report = build / "reports" / "soak.json"
    return result, json.loads(report.read_text()) if report.exists() else None


def soak(build, hours):
    return call(build, "--hours", hours)


def parts_of(build, *seeds):
    """A part of each seed."""
    paths = [build / f"{seed}.json" for seed in seeds]
    for seed, path in zip(seeds, paths):
        result, report = call(build, "--seed", seed, "--part", path)
        assert result.returncode == 0 and report is None, result.stderr
    return paths


def test_seeds_go_on_where_the_last_run_ended(build):
    program(build)
    result, report = soak(build, 0.0002)
    assert result.returncode == 0, result.stderr
    row, = report["rows"]
    assert row["seeds"] == row["tests"] > 1 and row["failed"] == report["faults"] == 0
    assert row["results"] == 5 * row["seeds"] and row["clocks"] == 70 * row["seeds"]
    assert json.loads((build / "soak" / "next.json").read_text()) == 1000 + 16 * row["seeds"]


def test_an_interrupted_soak_goes_on_with_what_it_had(build):
    program(build)
    with subprocess.Popen([sys.executable, "-B", "-m", "lab.soak", "--build", build, "--output", build, "--only", "dma",
                           "--corpus", build / "corpus.csv", "--hours", "1"]) as process:
        while not (kept := list((build / "soak").glob("interrupted-*.json"))) or json.loads(
                kept[0].read_text())["rows"][0]["seeds"] < 3:
            assert process.poll() is None
        process.kill()
    kept, = kept
    had, = json.loads(kept.read_text())["rows"]
    result, report = soak(build, 0.0000001)  # less than it had: no further seed
    assert result.returncode == 0 and report["rows"] == [had] and not kept.exists()
    assert json.loads((build / "soak" / "next.json").read_text()) in (1000 + 16 * had["seeds"], 1016 + 16 * had["seeds"])


def test_one_kind_takes_several_seeds_side_by_side(build):
    program(build)
    result, report = call(build, "--hours", 0.00001, "--jobs", 3)
    assert result.returncode == 0 and report["rows"][0]["seeds"] == 3
    assert json.loads((build / "soak" / "next.json").read_text()) == 1048


def test_what_another_program_counted_is_not_taken_over(build):
    program(build)
    (build / "soak").mkdir()
    (build / "soak" / "interrupted-other.json").write_text('{"hours": 7.0, "rows": [{"traffic": "dma", "seeds": 9}]}')
    result, report = soak(build, 0.00001)
    assert result.returncode == 0 and report["hours"] < 1 and report["rows"][0]["seeds"] == 1


@pytest.mark.parametrize("fault", ["fails", "breaks", "ends"])
def test_a_seed_that_finds_a_fault_is_kept_and_runs_first(build, fault):
    program(build, **{fault: 1016})
    result, report = soak(build, 0.0002)
    assert result.returncode == 1 and report["faults"] == 1 and "SEED=1016" in result.stderr
    lines = (build / "corpus.csv").read_text().splitlines()
    assert len(lines) == 2 and lines[1].startswith("dma,1016,")
    again, report = soak(build, 0)
    assert again.returncode == 1 and report["rows"][0]["seeds"] == 1
    program(build)
    mended, report = soak(build, 0)
    assert mended.returncode == 0 and report["faults"] == 0


def test_nothing_run_is_an_error(build):
    program(build)
    result, report = soak(build, 0)
    assert result.returncode == 1 and "nothing was run" in result.stderr and report is None


def test_a_program_that_is_not_there_is_an_error(build):
    result, _ = soak(build, 0.001)
    assert result.returncode == 1 and "make -C lab soak builds it" in result.stderr


def test_parts_are_joined_to_what_one_run_reports(build):
    program(build)
    result, report = call(build, "--join", *parts_of(build, 1000, 1016, 1032))
    assert result.returncode == 0, result.stderr
    row, = report["rows"]
    assert row == {"traffic": "dma", "seeds": 3, "tests": 3, "failed": 0, "results": 15, "clocks": 210}
    assert json.loads((build / "soak" / "next.json").read_text()) == 1048
    _, single = soak(build, 0.00001)
    assert set(single) == set(report) and set(single["rows"][0]) == set(row)
    assert single["rows"][0]["seeds"] == 1 and json.loads((build / "soak" / "next.json").read_text()) == 1064
    assert call(build, "--join", build / "1000.json")[0].returncode == 0
    assert json.loads((build / "soak" / "next.json").read_text()) == 1064


@pytest.mark.parametrize("fault", ["fails", "breaks"])
def test_a_fault_in_a_part_is_kept_by_who_joins(build, fault):
    program(build, **{fault: 1016})
    paths = parts_of(build, 1000, 1016)
    assert len((build / "corpus.csv").read_text().splitlines()) == 1
    result, report = call(build, "--join", *paths)
    assert result.returncode == 1 and report["faults"] == report["corpus"] == 1
    assert (build / "corpus.csv").read_text().splitlines()[1].startswith("dma,1016,")


def test_parts_that_make_no_report_are_refused(build):
    program(build)
    first, second = parts_of(build, 1000, 1016)
    (build / "other.json").write_text(second.read_text().replace('"dma"', '"bus"'))
    (build / "less.json").write_text('{"seed": 1}')
    (build / "none.json").write_text("{")
    for names, message in (((first, first), "a seed is in two parts: 1000 1000"),
                           ((first, build / "other.json"), "not every part has dma"),
                           ((first, build / "less.json"), "less.json: a part without hours, rows, found: measure"),
                           ((first, build / "none.json"), "none.json: no part: "),
                           ((first, build / "gone.json"), "gone.json: no part: ")):
        result, report = call(build, "--join", *names)
        assert result.returncode == 1 and report is None
        assert message in result.stderr and len(result.stderr.splitlines()) == 1
    for words in ("--seed", 7), ("--part", build / "x"), ("--seed", 7, "--join", first):
        result, _ = call(build, *words)
        assert result.returncode == 2 and "--seed and --part go together" in result.stderr
