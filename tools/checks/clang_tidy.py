"""clang-tidy on C++ files, each with the options that build/ compiles it with.

As a program: on every file that build/ compiles. The last line is "tidy: N files, W findings"; the
exit status is 0 only for none, and none left out.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import json
import os
import pathlib
import re
import subprocess
import sys

from tools import job_pool
from tools.checks import text_rules
from tools.project_root import ROOT

COMMANDS = "build/compile_commands.json"
SOURCES, HEADERS = (".cpp",), (".hpp", ".h")
_PRECOMPILED = re.compile(r" -Winvalid-pch| -include \S+cmake_pch\.hxx| -Werror\b")
_FINDING = re.compile(r"^.*\b(?:warning|error): .*$", re.MULTILINE)
_INCLUDE = re.compile(r'^\s*#\s*include\s*[<"](?:\.\./)*([^<>"]+)[>"]', re.MULTILINE)
_TOGETHER = re.compile(r"/Unity/unity_\d+_cxx\.cxx$")
_MODEL = re.compile(r"error: '((?:V\w+|\w+_cxxrtl)\.h)' file not found")


class TidyError(Exception):
    """clang-tidy cannot be run here."""


def database(root):
    """The files that build/ compiles, with a folder of their commands: one a file, not that of its
    copy under sanitizers, and without precompiled headers, which only their own compiler reads."""
    path = root / COMMANDS
    if not path.is_file():
        raise TidyError(f"no {COMMANDS}, which clang-tidy needs: make lint writes it")
    entries = {}
    for entry in json.loads(path.read_text(encoding="utf-8")):
        command = _PRECOMPILED.sub("", entry["command"])
        for file in map(pathlib.Path, compiled_together(entry["file"])):
            if root not in file.parents or file in entries or file.suffix not in SOURCES:
                continue
            if "-fsanitize=" not in command:
                entries[file] = {**entry, "file": str(file),
                                 "command": command.replace(entry["file"], str(file))}
    folder = root / "build" / "tidy"
    folder.mkdir(exist_ok=True)
    (folder / COMMANDS.split("/")[1]).write_text(json.dumps(list(entries.values())))
    return list(entries), folder


def compiled_together(file):
    """The files that one of CMake's for several includes; any other alone."""
    if not _TOGETHER.search(file):
        return [file]
    return re.findall(r'^#include "(.*)"$', pathlib.Path(file).read_text(encoding="utf-8"),
                      re.MULTILINE)


def changed(root, folders):
    """The C++ files of these folders that differ from those of the commit before the last, not yet
    committed ones among them; None where there is no such commit."""
    def git(*words):
        result = subprocess.run(["git", "-C", root, *words, "--", *folders], text=True, check=False,
                                stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        return result.stdout.split("\0")[:-1] if result.returncode == 0 else None

    differing = git("diff", "-z", "--name-only", "--relative", "--diff-filter=d", "HEAD~1")
    if differing is None:
        return None
    new = git("ls-files", "-z", "--others", "--exclude-standard")
    return [root / name for name in sorted({*differing, *new})
            if name.endswith(SOURCES + HEADERS)]


def inclusions(root, compiled):
    """file -> what it includes, as written or, where that is beside it, with its folder; sources
    that build/ makes come last, and those that it has not made yet are not there."""
    def named(file, name):
        return str(file.parent / name) if (file.parent / name).is_file() else name

    files = sorted({*compiled, *text_rules.Tree(root).cpp},
                   key=lambda file: (root / "build" in file.parents, file))
    return {file: [named(file, name) for name in _INCLUDE.findall(file.read_text(errors="replace"))]
            for file in files if file.is_file()}


def includer(header, includes, compiled):
    """A source through which the compiler sees a header, the nearest; the header itself, with the
    options of a source like it, where there is none."""
    reached, ends = [header], {header}
    for seen in reached:
        for file, names in includes.items():
            if file not in ends and any(f"/{seen}".endswith(f"/{name}") for name in names):
                if file in compiled:
                    return file
                ends.add(file)
                reached.append(file)
    return header


class Check:
    """clang-tidy on one file."""

    def __init__(self, file, commands):
        self.file, self.commands = file, commands
        self.findings, self.left_out = [], None

    def run(self):
        result = subprocess.run(["clang-tidy", "--quiet", "-p", self.commands, self.file], text=True,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, check=False)
        model = _MODEL.search(result.stdout)
        if model:
            self.left_out = f"{model[1]} is not built"
            return
        self.findings = sorted(set(_FINDING.findall(result.stdout)))
        if result.returncode != 0 and not self.findings:
            self.findings = [result.stderr.strip() or f"exit status {result.returncode}"]

    def end(self, future):
        future.result()


def checks(root, files=None):
    """One for each of these files, or for every source outside build/. What is in a header shows
    in the sources that include it, so it is one of those that is looked at."""
    compiled, commands = database(root)
    if files is None:
        looked_at = {file for file in compiled if root / "build" not in file.parents}
    else:
        includes = inclusions(root, compiled)
        looked_at = {includer(file, includes, compiled) for file in files if file.suffix in HEADERS}
        looked_at |= {file for file in files if file in compiled}
    return [Check(file, commands) for file in sorted(looked_at)]


def main():
    parser = argparse.ArgumentParser(description="Runs clang-tidy on all that build/ compiles.")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="checkout to look at")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args()
    try:
        pending = checks(options.root.absolute())
    except TidyError as error:
        print(f"tidy: {error}", file=sys.stderr)
        return 1
    job_pool.run(Check.run, pending, options.jobs, Check.end, lambda check: check.file.name)
    findings = sorted({line for check in pending for line in check.findings})
    findings += [f"{check.file}: left out: {check.left_out}" for check in pending if check.left_out]
    for line in findings:
        print(line)
    print(f"tidy: {len(pending)} files, {len(findings)} findings")
    return 1 if findings or not pending else 0


if __name__ == "__main__":
    sys.exit(main())
