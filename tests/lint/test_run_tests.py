"""tools.checks.run_tests names what was skipped, before ctest's closing lines: with a stand-in for ctest.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

CLOSING = "100% tests passed, 0 tests failed out of 4\n\nTotal Test time (real) =   1.00 sec\n"
CTEST = """#!/bin/sh
echo '1/4 Test #1: a ... Passed'
cp tests.xml.given tests.xml
printf '{}'
exit "${{STATUS:-0}}"
""".format(CLOSING.replace("\n", "\\n").replace("%", "%%"))
CASE = '<testcase name="{}" time="0.5" status="{}"><system-out>{}</system-out></testcase>'


@pytest.fixture
def run(checkout):
    """(exit status, lines printed) for test cases (name, status, output)."""
    def ran(*cases, **variables):
        text = "".join(CASE.format(*case) for case in cases)
        checkout.put({"tests.xml.given": f"<testsuite>{text}</testsuite>"})
        checkout.put({"ctest": CTEST}, 0o755)
        environment = {"PATH": "/usr/bin:/bin", **variables}
        status, out, errors = checkout.module("tools.checks.run_tests", "tests.xml", "./ctest", env=environment)
        assert errors == ""
        assert out.endswith(CLOSING) and out.startswith("1/4 Test #1: a ... Passed\n")
        assert out.endswith(checkout.text("tests.closing"))
        return status, out.removesuffix(CLOSING).splitlines()[2:-1]
    return ran


PASSED = ("golden.a", "run", "[       OK ] a (1 ms)")
WHOLE = ("theorems.small", "notrun", "skipped: packages are missing in build/venv: run tools/install theorems")
IN_PYTEST = ("energy.power", "run", "SKIPPED [2] tests/x.py:178: no iverilog\n3 passed, 2 skipped in 1 s")
IN_UNITTEST = ("hwffd.install", "run", "test_a (x.Programs.test_a) ... skipped 'no models of glmark2'\nOK (skipped=1)")
BROWSER = ("web.page", "notrun", "skipped: chromium is not there: tools/install web")
ROUTE = ("synth.constraints", "run", "SKIPPED [1] tests/synth/test_constraints.py:112: no nextpnr-ecp5: run tools/install route")
SENSELESS = ("axi.Axi.A/fx18", "notrun", "[ RUN      ] Axi.A\n/x/a_test.cpp:95: Skipped\nits evaluator is slower\n\n[  SKIPPED ] Axi.A")
NO_MESH = ("geometry.Mesh.A", "notrun", "/x/a_test.cpp:95: Skipped\npackage glmark2-data is not installed\n[  SKIPPED ] Mesh.A")


def test_nothing_is_skipped(run):
    assert run(PASSED, CI="true") == (0, ["Skipped: nothing"])


def test_skips_are_named(run):
    status, lines = run(PASSED, WHOLE, SENSELESS, IN_PYTEST, IN_UNITTEST, BROWSER, SENSELESS, NO_MESH)
    assert status == 0
    assert lines == [
        "Skipped: 5 tests, and parts of others, 3. ctest counts them as passed:",
        "  2 that make no sense for their configuration: its evaluator is slower",
        "  theorems.small: packages are missing in build/venv: run tools/install theorems",
        "  energy.power, 2 of its parts: no iverilog",
        "  hwffd.install, 1 of its parts: no models of glmark2",
        "  web.page: chromium is not there: tools/install web (make web runs it)",
        "  geometry.Mesh.A: package glmark2-data is not installed"]


@pytest.mark.parametrize("case, status", ((WHOLE, 1), (IN_PYTEST, 1), (IN_UNITTEST, 1), (BROWSER, 0), (ROUTE, 0),
                                           (SENSELESS, 0), (NO_MESH, 1)))
def test_what_may_be_skipped_in_ci(run, case, status):
    assert run(PASSED, case)[0] == 0
    assert run(PASSED, case, CI="true")[0] == status


def test_status_is_ctests(run):
    assert run(PASSED, STATUS="8")[0] == 8
