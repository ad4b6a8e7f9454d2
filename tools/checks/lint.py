"""Every module and configuration through three tools or one, and the rules that no tool knows.

The last line is "lint: N checks, W warnings"; the exit status is 0 only for none. A check is one
tool on one module or configuration, or one rule on one file.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import importlib.util
import os
import pathlib
import re
import shutil
import sys

from tools import csv_table, job_pool, venv_packages
from tools.checks import clang_tidy, package_closure, text_rules
from tools.project_root import ROOT
from tools.reports import report_modules, text_blocks
from tools.rtl import module_header, rtl_sources
from tools.tables import configurations, features, generated_files

TOP = "hwffd_stream"
SYSTEM = "hwffd_axi"  # the same rows, which it hands on: those of tier sim will do
TOPS = (TOP, SYSTEM, "hwffd_wishbone")
ALL_AXES = range(4, 17)  # what AXIS may be
AXES = (4, 7, 16)
YOSYS_BATCH = 6
CLANG_FORMAT_BATCH = 20


def complaints(status, output):
    """A tool's warnings and errors, a line each; all it printed if it failed without one."""
    lines = re.findall(r"^(?:%Warning|%Error|.*\b(?:warning|Warning|error|ERROR|sorry):).*$",
                       output, re.MULTILINE)
    lines = [line for line in lines if "Exiting due to" not in line]
    if not lines and (status != 0 or output.strip()):
        lines = [output.strip() or f"exit status {status}"]
    return lines


class Job:
    """One process, and how many checks it stands for."""

    def __init__(self, name, command, checks=1, split=None, folder=None):
        self.name, self.command, self.checks, self.split = name, command, checks, split
        self.folder = folder
        self.problems = []

    def end(self, future):
        self.problems = future.result()

    def run(self):
        """[(name, complaint)]; a failing batch is split to tell which of its members it was."""
        status, output = rtl_sources.run(self.command, self.folder)
        lines = complaints(status, output)
        if lines and self.split:
            return [problem for job in self.split() for problem in job.run()] or [
                (self.name, line) for line in lines]
        return [(self.name, line) for line in lines]


def rtl_jobs(sources, every=False):
    """Every module with its default parameters by all three tools, in both languages, which differ in words and syntax
    alone. Of the tops rows of the table by all three: the first of each organization and of each format, the system
    with those of tier sim, and these hardened. Every row is read with the same warnings where a build verilates it,
    and here if `every`.
    """
    modules = [(module, module, []) for module in sources.modules()]
    jobs = tool_jobs(sources, modules)
    jobs += tool_jobs(sources, [(f"SystemVerilog {name}", *rest) for name, *rest in modules], rtl_sources.SYSTEMVERILOG)
    rows = configurations.read(sources.root / "rtl" / "configurations.csv")
    if TOP not in sources.files:
        print(f"lint: rtl/hwffd.f has no {TOP}; {len(rows)} configurations not looked at")
        return jobs
    first = {id(row): row for of in ("org", "format")
             for row in {getattr(row, of): row for row in reversed(configurations.of_tier(rows, "test"))}.values()}
    jobs += tool_jobs(sources, [subject(TOP, row) for row in (rows if every else first.values())])
    small = [subject(top, row) for top in (TOP, SYSTEM) if top in sources.files for row in configurations.of_tier(rows, "sim")]
    jobs += tool_jobs(sources, [case for case in small if case[1] == SYSTEM])
    jobs += tool_jobs(sources, [(f"{name} hardened", top, [*given, "HARDENED=1"]) for name, top, given in small])
    for top in TOPS:
        if top in sources.files:
            jobs += integrator_jobs(sources, top, ALL_AXES if every else AXES)
    return jobs


def subject(top, row):
    return f"{top} ({row.name})", top, [f"{name}={value}" for name, value in features.of_top(top, row.parameters).items()]


def integrator_jobs(sources, top, axes):
    """A top as users take it: by the file list from another folder; and with every parameter given
    on the command line, where it has 32 bits, with these values of AXIS."""
    jobs = [Job(f"verilator -F hwffd.f {top}", rtl_sources.verilator_list(sources, top), folder=os.sep)]
    defaults = module_header.parameters(sources, top)
    for axis in axes:
        given = [f"{name}={value}" for name, value in {**defaults, "AXIS": axis}.items()]
        jobs.append(Job(f"verilator {top} (all parameters given, AXIS={axis})",
                        rtl_sources.verilator(sources, top, sources.needed(top), given)))
    return jobs


def tool_jobs(sources, subjects, language=rtl_sources.VERILOG):
    """Each (name, top, parameters) by all three tools."""
    jobs, batch = [], []
    for name, top, parameters in subjects:
        files = sources.needed(top)
        jobs.append(Job(f"verilator {name}",
                        rtl_sources.verilator(sources, top, files, parameters, language)))
        jobs.append(Job(f"icarus {name}", rtl_sources.icarus(sources, top, files, parameters, language)))
        batch.append((name, top, files, parameters))
    for first in range(0, len(batch), YOSYS_BATCH):
        jobs.append(yosys_job(sources, batch[first : first + YOSYS_BATCH], language))
    return jobs


def yosys_job(sources, members, language):
    split = None
    if len(members) > 1:
        def split():
            return [yosys_job(sources, [member], language) for member in members]
    command = rtl_sources.yosys(sources, [member[1:] for member in members], language)
    return Job("yosys " + ", ".join(member[0] for member in members), command, len(members), split)


def packages(root):
    """(files that the build has used, packages that tools/packages.txt lacks), where there is a build."""
    if not (root / "build" / ".ninja_deps").is_file() or not shutil.which("apt-get"):
        print("lint: nothing is built, or this is not Debian: tools/packages.txt is not compared with what a build uses")
        return 0, []
    return package_closure.check(root, root / "build")


def python_jobs(root):
    """By ruff, whose rules stand in pyproject.toml."""
    return [Job("ruff", [sys.executable, "-m", "ruff", "check", "--quiet", "--no-cache", "--output-format", "concise", str(root)])]


def clang_format_jobs(root):
    files = [str(path) for path in text_rules.Tree(root).cpp]
    return [
        Job("clang-format", ["clang-format", "--style=file", "--dry-run", "-Werror", *part],
            len(part))
        for part in (files[i : i + CLANG_FORMAT_BATCH]
                     for i in range(0, len(files), CLANG_FORMAT_BATCH))
    ]


class TidyJob(Job):
    """clang-tidy on one file."""

    def __init__(self, check):
        super().__init__("clang-tidy", None)
        self.check = check

    def run(self):
        self.check.run()
        if self.check.left_out:
            print(f"lint: {self.check.file} without clang-tidy: {self.check.left_out}")
        return [(self.name, line) for line in self.check.findings]


def clang_tidy_jobs(root):
    """What the last commit or the working tree changed; the others are those of make test-all."""
    files = clang_tidy.changed(root, text_rules.Tree(root).folders)
    if files is None:
        print("lint: no commit before the last; clang-tidy looks at nothing")
    return [TidyJob(check) for check in clang_tidy.checks(root, files)] if files else []


def main():
    parser = argparse.ArgumentParser(description="Lints RTL and C++; fails on any warning.")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="checkout to look at")
    parser.add_argument("--text", action="store_true", help="the text rules only")
    parser.add_argument("--every", action="store_true", help="every row of the table by all three tools: an hour")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args()
    root = options.root.absolute()

    venv_packages.enter("requirements-lint.txt")
    parsed = importlib.util.find_spec("pyslang") is not None
    if not parsed and not options.text:
        print("lint: pyslang not found: run tools/install lint", file=sys.stderr)
        return 1
    checks, warnings = text_rules.check(root, parsed)
    texts, wrong = text_blocks.Blocks(root, report_modules.MODULES, partly=True).check()
    checks += texts
    warnings += wrong + text_blocks.releases(root)
    if not options.text:
        if importlib.util.find_spec("ruff") is None:
            print("lint: ruff not found: run tools/install lint", file=sys.stderr)
            return 1
        needed = ("verilator", "iverilog", "yosys", "clang-format", "clang-tidy")
        absent = [tool for tool in needed if not shutil.which(tool)]
        if absent:
            print(f"lint: {', '.join(absent)} not found: run tools/install lint", file=sys.stderr)
            return 1
        try:
            generated = generated_files.stale(root)
            jobs = (rtl_jobs(rtl_sources.Sources(root), options.every) + clang_format_jobs(root)
                    + clang_tidy_jobs(root) + python_jobs(root))
        except (csv_table.TableError, clang_tidy.TidyError, OSError) as error:
            print(f"lint: {error}", file=sys.stderr)
            return 1
        checks += 1
        warnings += generated
        count, missing = packages(root)
        checks += count
        warnings += missing
        # The last are the longest (batches, configurations) and go first.
        job_pool.run(lambda job: job.run(), jobs[::-1], options.jobs, Job.end,
                     lambda job: job.name)
        seen = set()  # a fault below several tops is reported by each of them: show it once
        for job in jobs:
            checks += job.checks
            for name, line in job.problems:
                fault = re.sub(r" \[\d+\]", "", line)  # yosys names each bit of a bus
                if fault not in seen:
                    warnings.append(f"{name}: {line}")
                seen.add(fault)

    for warning in warnings:
        print(warning)
    plural = "" if len(warnings) == 1 else "s"
    print(f"lint: {checks} checks, {len(warnings)} warning{plural}")
    return 1 if warnings else 0


if __name__ == "__main__":
    sys.exit(main())
