"""Runs ctest, and says what was skipped before its closing lines: ctest counts as passed what a machine cannot run.

    python3 -m tools.checks.run_tests REPORT CTEST WORD...

REPORT is the file that ctest is told to write (--output-junit); beside it are the report by suite, REPORT.json, and the
last lines, REPORT.closing. Skipped
is a test that says so by its exit status, a test of GoogleTest that does, and a part of one in Python. Tests of
GoogleTest say so where they make no sense for a configuration, unless their reason speaks of a package. Where the variable
CI is set, any other skip that is not in ALLOWED fails: there the packages of all tests are to be installed.

SPDX-License-Identifier: Apache-2.0
"""

import collections
import os
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree

from tools.reports import tests_tables

# Tests that want more than `make test` installs, and the command that installs it and runs them.
ALLOWED = {r"web\..*": "make web", r"synth\.constraints": "make pnr", r"soc\..*": "make soc"}
_CLOSING = re.compile(r"^\d+% tests passed")
_SKIPPED = re.compile(r"^(?:SKIPPED \[(?P<count>\d+)\] \S+ (?P<reason>.*)|(?:\S+ \(.*\)|.*) \.\.\. skipped '(?P<why>.*)'"
                      r"|skipped: (?P<whole>.*))$", re.MULTILINE)
_OF_CONFIGURATION = re.compile(r"^\S+:\d+: Skipped\n(?P<reason>(?!.*package).*)$", re.MULTILINE)
_OF_PACKAGE = re.compile(r"^\S+:\d+: Skipped\n(?P<reason>.*package.*)$", re.MULTILINE)


def run(words):
    """(ctest's exit status, its closing lines); the lines before them are printed as they come."""
    closing = []
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True, errors="replace") as process:
        for line in process.stdout:
            if closing or _CLOSING.match(line):
                closing.append(line)
            else:
                sys.stdout.write(line)
                sys.stdout.flush()
    return process.returncode, "".join(closing)


def skips(report):
    """Of what ctest has written, [(test, how many of it, why)], and {why: how many tests of configurations}."""
    skipped, senseless = [], collections.Counter()
    for case in xml.etree.ElementTree.parse(report).iter("testcase"):
        output = case.findtext("system-out") or ""
        if (other := _OF_CONFIGURATION.search(output)):
            senseless[other["reason"]] += 1
            continue
        if (package := _OF_PACKAGE.search(output)):
            skipped.append((case.get("name"), 0, package["reason"]))
            continue
        reasons = [(int(match["count"] or 1), match["reason"] or match["why"] or match["whole"])
                   for match in _SKIPPED.finditer(output)]
        if case.get("status") in ("notrun", "disabled"):
            skipped.append((case.get("name"), 0, reasons[0][1] if reasons else "it says so by its exit status"))
        else:
            counts = collections.Counter()
            for count, reason in reasons:
                counts[reason] += count
            skipped += [(case.get("name"), count, reason) for reason, count in counts.items()]
    return skipped, senseless


def listed(skipped, senseless):
    """(lines that name what was skipped, whether all of it may be)."""
    whole, inside = sum(not count for _, count, _ in skipped), sum(count for _, count, _ in skipped)
    if not skipped and not senseless:
        return ["Skipped: nothing"], True
    lines = [f"Skipped: {whole + sum(senseless.values())} tests, and parts of others, {inside}. ctest counts them as passed:"]
    lines += [f"  {count} that make no sense for their configuration: {why}" for why, count in senseless.items()]
    allowed = True
    for name, count, why in skipped:
        command = next((command for pattern, command in ALLOWED.items() if re.fullmatch(pattern, name)), "")
        allowed = allowed and bool(command)
        part = f", {count} of its parts" if count else ""
        lines.append(f"  {name}{part}: {why}" + (f" ({command} runs it)" if command else ""))
    return lines, allowed


def main(report, *words):
    report = pathlib.Path(report)
    report.unlink(missing_ok=True)
    status, closing = run(words)
    lines, allowed = [], True
    if report.is_file():
        not_run, senseless = skips(report)
        lines, allowed = listed(not_run, senseless)
        skipped = sum(not count for _, count, _ in not_run) + sum(senseless.values())
        tests_tables.collect(report, skipped)
    if not allowed and os.environ.get("CI"):
        lines.append("Skips for want of a package are failures here: tools/install test test-synth lint")
        status = status or 1
    text = "\n".join(lines) + "\n\n" + closing
    report.with_suffix(".closing").write_text(text, encoding="utf-8")
    sys.stdout.write("\n" + text)
    return status


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
