"""make test: how many tests there are of what, how many were skipped, and the steps that take longest.

SPDX-License-Identifier: Apache-2.0
"""

import json
import xml.etree.ElementTree

from tools.reports.results import RequestError
from tools.reports.text_table import listing

LONGEST = 10


def collect(source, skipped):
    """Writes beside the XML of ctest the report by suite, which is the part of a test's name before a dot. Of
    them so many were skipped: ctest itself does not know those that say so in their output."""
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
    source.with_suffix(".json").write_text(json.dumps({
        "tests": len(cases), "failed": sum(case["status"] == "fail" for case in cases),
        "skipped": skipped,
        "suites": [{"suite": name, **suite} for name, suite in sorted(suites.items())],
        "longest": [{"name": case["name"], "seconds": round(case["seconds"], 1)}
                    for case in longest]}) + "\n", encoding="utf-8")


def suites(reports):
    return listing(reports.rows("tests"), "suite | `suite`", "tests | tests",
                   "seconds | seconds:,.0f")


def longest(reports):
    return listing(reports.get("tests")["longest"], "step | `name`", "seconds | seconds:,.0f")


def not_passed(reports):
    """Skipped and failed ones; 0.2.0 has their sum."""
    report = reports.get("tests")
    return report["not_passed"] if "not_passed" in report else report["skipped"] + report["failed"]


def missing(reports):
    """What is committed is of all tests: a run by hand may have left some out."""
    return "" if len(reports.rows("tests")) >= 15 else "suites"


TABLES = {"suites": suites, "longest": longest}
FIGURES = {"not_passed": not_passed}
