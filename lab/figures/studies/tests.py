"""make test: how many tests there are of what, and the steps that take longest. What is committed
keeps the seconds: they are meant as those of one machine.

SPDX-License-Identifier: Apache-2.0
"""

import json
import xml.etree.ElementTree

from figures.reports import FRESH, RequestError
from figures.table import listing

LONGEST = 10


def collect(root):
    """Makes the report of what ctest wrote, by suite: the part of a test's name before a dot."""
    source, target = (root / FRESH / f"tests.{suffix}" for suffix in ("xml", "json"))
    if not source.is_file():
        return
    try:
        cases = [{"name": case.get("name"), "seconds": float(case.get("time")), "status": case.get("status")}
                 for case in xml.etree.ElementTree.parse(source).iter("testcase")]
    except (xml.etree.ElementTree.ParseError, TypeError, ValueError) as error:
        raise RequestError(f"{source}: not what ctest writes: {error}") from error
    suites = {}
    for case in cases:
        suite = suites.setdefault(case["name"].split(".")[0], {"tests": 0, "seconds": 0})
        suite["tests"] += 1
        suite["seconds"] = round(suite["seconds"] + case["seconds"], 1)
    longest = sorted(cases, key=lambda case: -case["seconds"])[:LONGEST]
    target.write_text(json.dumps({
        "tests": len(cases), "failed": sum(case["status"] == "fail" for case in cases),
        "skipped": sum(case["status"] not in ("run", "fail") for case in cases),
        "suites": [{"suite": name, **suite} for name, suite in sorted(suites.items())],
        "longest": [{"name": case["name"], "seconds": round(case["seconds"], 1)}
                    for case in longest]}), encoding="utf-8")
    source.unlink()


def suites(reports):
    return listing(reports.rows("tests"), "suite | `suite`", "tests | tests",
                   "seconds | seconds:,.0f")


def longest(reports):
    return listing(reports.get("tests")["longest"], "step | `name`", "seconds | seconds:,.0f")


def missing(reports):
    """What is committed is of all tests: a run by hand may have left some out."""
    return "" if len(reports.rows("tests")) >= 15 else "suites"


TABLES = {"suites": suites, "longest": longest}
