"""Lines and branches of the C++ libraries, by gcov through gcovr; exceptions are no branches.

SPDX-License-Identifier: Apache-2.0
"""

import itertools
import json
import subprocess
import sys

from lab.rtl_coverage.counts import CoverageError

FOLDERS = ("api", "cores", "geometry", "golden")


def _files(root, build):
    """What gcovr knows of each file."""
    command = [sys.executable, "-m", "gcovr", "--root", str(root), "--object-directory", str(build),
               "--exclude-throw-branches", "--exclude-unreachable-branches", "--json", "-",
               "--merge-mode-functions=merge-use-line-0", "--gcov-ignore-errors=no_working_dir_found",
               # Of threads that count at once, and of loops that run often.
               *(f"--gcov-ignore-parse-errors={kind}_hits.warn_once_per_file"
                 for kind in ("negative", "suspicious")),
               *(f"--filter={root / folder}/" for folder in FOLDERS), str(build)]
    answer = subprocess.run(command, capture_output=True, text=True, check=False)
    if answer.returncode:
        raise CoverageError(f"gcovr: {answer.stderr.strip().splitlines()[-1:]}")
    return json.loads(answer.stdout)["files"]


def merged(lines):
    """{line: (whether it ran, whether each of its branches did)}. A line of a template is there once for
    each of its instances, and as in the RTL it is enough that any of them ran."""
    by_line = {}
    for line in lines:
        if line.get("gcovr/excluded"):
            continue
        ran, branches = by_line.get(line["line_number"], (False, []))
        more = [branch["count"] > 0 for branch in line.get("branches", ())
                if not branch.get("gcovr/excluded")]
        by_line[line["line_number"]] = (ran or line["count"] > 0, [
            one or other for one, other in itertools.zip_longest(branches, more, fillvalue=False)])
    return by_line


def rows(root, build):
    """A row for each folder."""
    files, measured = _files(root, build), []
    for folder in FOLDERS:
        lines = [line for entry in files if entry["file"].startswith(f"{folder}/")
                 for line in merged(entry["lines"]).values()]
        branches = [ran for _, all_of_it in lines for ran in all_of_it]
        if not lines:
            raise CoverageError(f"{folder}/: no line was counted")
        measured.append({"folder": folder, "lines": len(lines), "branches": len(branches),
                         "line": round(100 * sum(ran for ran, _ in lines) / len(lines), 2),
                         "branch": round(100 * sum(branches) / max(1, len(branches)), 2)})
    return measured
