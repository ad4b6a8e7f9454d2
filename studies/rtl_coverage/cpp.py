"""Lines and branches of the C++ libraries, by gcov through gcovr; exceptions are no branches.

SPDX-License-Identifier: Apache-2.0
"""

import json
import subprocess
import sys

from counts import CoverageError

FOLDERS = ("api", "cores", "geometry", "golden")


def rows(root, build):
    """A row for each folder."""
    command = [sys.executable, "-m", "gcovr", "--root", str(root), "--object-directory", str(build),
               "--exclude-throw-branches", "--exclude-unreachable-branches", "--json-summary", "-",
               "--merge-mode-functions=merge-use-line-0", "--merge-lines", "--gcov-ignore-errors=no_working_dir_found",
               # Of threads that count at once, and of loops that run often.
               *(f"--gcov-ignore-parse-errors={kind}_hits.warn_once_per_file"
                 for kind in ("negative", "suspicious")),
               *(f"--filter={root / folder}/" for folder in FOLDERS), str(build)]
    answer = subprocess.run(command, capture_output=True, text=True, check=False)
    if answer.returncode:
        raise CoverageError(f"gcovr: {answer.stderr.strip().splitlines()[-1:]}")
    found = []
    for folder in FOLDERS:
        files = [one for one in json.loads(answer.stdout)["files"]
                 if one["filename"].startswith(f"{folder}/")]
        total = {field: sum(one[field] for one in files) for field in (
            "line_total", "line_covered", "branch_total", "branch_covered")}
        if not total["line_total"]:
            raise CoverageError(f"{folder}/: no line was counted")
        found.append({"folder": folder, "lines": total["line_total"], "branches": total["branch_total"],
                      "line": round(100 * total["line_covered"] / total["line_total"], 2),
                      "branch": round(100 * total["branch_covered"] / max(1, total["branch_total"]), 2)})
    return found
