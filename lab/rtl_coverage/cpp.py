"""Lines and branches of the C++ libraries, by gcov through gcovr; exceptions are no branches.

A line of a template is there once for each of its instances, and as in the RTL it is enough that any of them ran.

SPDX-License-Identifier: Apache-2.0
"""

import collections
import json
import subprocess
import sys

from lab.rtl_coverage.counts import CoverageError

FOLDERS = ("api", "cores", "geometry", "golden")


def _files(root, build):
    """What gcovr counts in each file."""
    command = [sys.executable, "-m", "gcovr", "--root", str(root), "--object-directory", str(build),
               "--exclude-throw-branches", "--exclude-unreachable-branches", "--json-summary", "-",
               "--merge-lines", "--merge-mode-functions=merge-use-line-0", "--gcov-ignore-errors=no_working_dir_found",
               # Of threads that count at once, and of loops that run often.
               *(f"--gcov-ignore-parse-errors={kind}_hits.warn_once_per_file"
                 for kind in ("negative", "suspicious")),
               *(f"--filter={root / folder}/" for folder in FOLDERS), str(build)]
    answer = subprocess.run(command, capture_output=True, text=True, check=False)
    if answer.returncode:
        raise CoverageError(f"gcovr: {answer.stderr.strip().splitlines()[-1:]}")
    return json.loads(answer.stdout)["files"]


def forget_outdated(build):
    """Removes counts of code that has been compiled anew since: a program that finds them says so among its errors."""
    for notes in build.rglob("*.gcno"):
        counts = notes.with_suffix(".gcda")
        if counts.exists() and counts.stat().st_mtime < notes.stat().st_mtime:
            counts.unlink()


def rows(root, build):
    """A row for each folder."""
    files, measured = _files(root, build), []
    for folder in FOLDERS:
        counts = collections.Counter()
        for file in files:
            if file["filename"].startswith(f"{folder}/"):
                counts.update({name: count for name, count in file.items() if name.endswith(("_total", "_covered"))})
        lines, branches = counts["line_total"], counts["branch_total"]
        if not lines:
            raise CoverageError(f"{folder}/: no line was counted")
        measured.append({"folder": folder, "lines": lines, "branches": branches,
                         "line": round(100 * counts["line_covered"] / lines, 2),
                         "branch": round(100 * counts["branch_covered"] / max(1, branches), 2)})
    return measured
