"""Mutants of a model against the tests that `make test` has: a number, a run.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import subprocess
import sys

from lab.mutants.built import MutantError, link
from lab.mutants.netlist import write

ROOT = pathlib.Path(__file__).resolve().parents[2]
LEAST, TIMES = 10, 5  # a run may take so many seconds, or so many times what the tests take without a mutant
QUICK = 0.3  # seconds of a test that runs before the slower ones
CHOICE = """#include <cstdlib>
extern "C" int hwffd_mutant() {
  const char* number = std::getenv("HWFFD_MUTANT");
  return number != nullptr ? std::atoi(number) : 0;
}
"""


def _shell(command, folder):
    result = subprocess.run(command, cwd=folder, check=False, capture_output=True, text=True)
    if result.returncode:
        raise MutantError(f"{command[0]}: {(result.stderr or result.stdout).strip().splitlines()[-1]}")
    return result.stdout.strip()


def program(build, subject, model, mutants, folder):
    """The test program with the mutants in place of the model, and these mutants. One is left out with
    which, behind those before it, the tests fail though none is chosen: yosys writes loops through the
    bits of a vector, which Verilator does not always order."""
    while mutants:
        path = _built(build, subject, model, mutants, folder)
        if passes(path, subject["tests"], 0):
            return path, mutants
        good, bad = 0, len(mutants)  # so many of the first: the tests pass with some, and fail with others
        while bad - good > 1:
            half = (good + bad) // 2
            if passes(_built(build, subject, model, mutants[:half], folder), subject["tests"], 0):
                good = half
            else:
                bad = half
        print(f"mutants: {subject['name']}: left out: {mutants[good]}", file=sys.stderr, flush=True)
        mutants = [*mutants[:good], *mutants[bad:]]
    raise MutantError(f"{folder / 'tests'}: the tests fail without a mutant")


def _built(build, subject, model, mutants, folder):
    source = write(ROOT, model, mutants, folder)
    (folder / "choice.cpp").write_text(CHOICE)
    runtime = _shell(["verilator", "--getenv", "VERILATOR_ROOT"], folder) + "/include"
    _shell([ROOT / "cmake" / "verilate.sh", model.name, "verilator", "--cc", "-O3", "--x-initial",
            "unique", "--x-assign", "unique", "-Wno-lint", "-Wno-fatal", "--top-module", model.top,
            "--prefix", model.name, *model.control, source], folder)
    for name in (model.name, "choice"):
        _shell(["c++", *model.flags, f"-I{runtime}", f"-I{runtime}/vltstd", "-c", f"{name}.cpp"], folder)
    library = folder / "libmutants.a"
    library.unlink(missing_ok=True)
    _shell(["ar", "rcs", library, f"{model.name}.o", "choice.o"], folder)
    return link(build, subject["program"], subject["library"], library, folder / "tests")


def _parts(path, tests, folder):
    """(filter, seconds without a mutant) of the quick tests, then of the others."""
    report = folder / "tests.json"
    report.unlink(missing_ok=True)
    subprocess.run([path, f"--gtest_filter={tests}", f"--gtest_output=json:{report}"], check=False,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    suites = json.loads(report.read_text(encoding="utf-8"))["testsuites"] if report.exists() else []
    seconds = {f"{suite['name']}.{test['name']}": float(test["time"].rstrip("s"))
               for suite in suites for test in suite["testsuite"]}
    groups = ([name for name in seconds if seconds[name] <= QUICK],
              [name for name in seconds if seconds[name] > QUICK])
    return [(":".join(part), sum(seconds[name] for name in part)) for part in groups if part]


def passes(path, tests, number, limit=None):
    """Whether the tests pass with a mutant; a run that does not end does not pass."""
    try:
        return subprocess.run(
            [path, "--gtest_brief=1", "--gtest_fail_fast", f"--gtest_filter={tests}"], check=False,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=limit,
            env={**os.environ, "HWFFD_MUTANT": str(number)}).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def late(build, subject, folder):
    """The program of the subject's late tests, with the mutants that `program` has."""
    return link(build, subject["late"], subject["library"], folder / "libmutants.a", folder / "late")


def unseen(path, tests, numbers, tested, jobs):
    """Those of the mutants with these numbers that the tests did not see."""
    groups = _parts(path, tests, path.parent)
    if not groups:
        raise MutantError(f"{path}: no test is called {tests}")
    passed = tested.of(numbers, lambda number: all(
        passes(path, part, number, max(LEAST, TIMES * seconds)) for part, seconds in groups), jobs, "mutant")
    return [number for number, alive in passed.items() if alive]
