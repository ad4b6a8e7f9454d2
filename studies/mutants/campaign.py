"""Mutants of a model against the tests that `make test` has: a number, a run.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import subprocess
import sys
import time

from built import MutantError, link
from netlist import write

ROOT = pathlib.Path(__file__).resolve().parents[2]
LEAST, TIMES = 10, 5  # a run may take so many seconds, or so many times what the tests take without a mutant
CHOICE = """#include <cstdlib>
extern "C" int hwffd_mutant() {
  const char* number = std::getenv("HWFFD_MUTANT");
  return number != nullptr ? std::atoi(number) : 0;
}
"""


def _shell(command, folder):
    done = subprocess.run(command, cwd=folder, check=False, capture_output=True, text=True)
    if done.returncode:
        raise MutantError(f"{command[0]}: {(done.stderr or done.stdout).strip().splitlines()[-1]}")
    return done.stdout.strip()


def program(build, subject, model, mutants, folder):
    """The test program with the mutants in place of the model, these mutants, and the seconds that the
    tests take without one. Those are left out with which the tests fail though none is chosen: yosys
    writes loops through the bits of a vector, which Verilator does not always order."""
    def fails(some):
        return not passes(_built(build, subject, model, some, folder), subject["tests"], 0)

    while mutants:
        path = _built(build, subject, model, mutants, folder)
        start = time.monotonic()
        if passes(path, subject["tests"], 0):
            return path, mutants, time.monotonic() - start
        part = mutants
        while len(part) > 1:
            half = len(part) // 2
            part = next((some for some in (part[:half], part[half:]) if fails(some)), part[:0])
        if not part:
            break
        print(f"mutants: {subject['name']}: left out: {part[0]}", file=sys.stderr, flush=True)
        mutants = [mutant for mutant in mutants if mutant != part[0]]
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


def _names(path, tests):
    """Tests of these names."""
    listed = subprocess.run([path, "--gtest_list_tests", f"--gtest_filter={tests}"], check=False,
                            capture_output=True, text=True).stdout
    return [line.strip() for line in listed.splitlines() if line.startswith("  ")]


def passes(path, tests, number, limit=None):
    """Whether the tests pass with a mutant; a run that does not end does not pass."""
    try:
        return subprocess.run(
            [path, "--gtest_brief=1", "--gtest_fail_fast", f"--gtest_filter={tests}"], check=False,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=limit,
            env={**os.environ, "HWFFD_MUTANT": str(number)}).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def unseen(path, subject, mutants, seconds, tested, jobs):
    """The numbers of those that the tests did not see."""
    if not _names(path, subject["tests"]):
        raise MutantError(f"{path}: no test is called {subject['tests']}")
    limit = max(LEAST, TIMES * seconds)
    passed = tested.of(range(1, len(mutants) + 1),
                       lambda number: passes(path, subject["tests"], number, limit), jobs, "mutant")
    return [number for number, alive in passed.items() if alive]
