"""Whether tools/packages.txt brings to an empty machine all that a build on this one has used.

The files that the build in build/ has read or linked, and the programs that scripts look for, belong to Debian
packages; each of these must be among what apt's resolver would install on a machine that has nothing. What lies in
/usr/local or in a home cannot be judged.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import shutil
import subprocess
import sys

from tools.project_root import ROOT

# What a bare machine has for the first command (README).
BARE = ("git", "make", "ca-certificates")
SET = "test-all"
# Scripts that run at a release, and say themselves what they need.
APART = ("fresh_machine.py", "picture.py")
# Programs that are started by their names, and by whom no script asks.
PROGRAMS = ("git", "sh", "sed", "sort", "awk", "python3", "perl", "ar", "ld", "c++filt", "berkeley-abc")
_WHICH = re.compile(r"""which\(["']([\w.+-]+)["']\)""")
_LIBRARY = re.compile(r"(/usr/lib/\S+?\.(?:so|a))\b")


def sets(text):
    """{set: (sets that it includes, [(package, command, kind)])} of tools/packages.txt."""
    package_sets, rows = {}, None
    for line in text.splitlines():
        line = line.split("#")[0].strip()
        if line.startswith("["):
            name, _, more = line[1:].partition("]")
            rows = []
            package_sets[name] = (more.split(), rows)
        elif line:
            package, command, *kind = line.split()
            rows.append((package, command, *kind))
    return package_sets


def rows_of(package_sets, name):
    """The rows of a set and of those that it includes."""
    more, rows = package_sets[name]
    return [row for other in more for row in rows_of(package_sets, other)] + rows


def _said(*words):
    return subprocess.run([str(word) for word in words], check=False, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL).stdout


def resolved(packages):
    """What apt would install on an empty machine for these."""
    essential, package = set(), ""
    for line in _said("apt-cache", "dumpavail").splitlines():
        if line.startswith("Package: "):
            package = line[9:]
        elif line in ("Essential: yes", "Priority: required"):
            essential.add(package)
    plan = _said("apt-get", "-s", "-q", "-o", "Dir::State::status=/dev/null", "install", "--no-install-recommends",
                 *sorted(essential), *BARE, *packages)
    return {line.split()[1] for line in plan.splitlines() if line.startswith("Inst ")}


def used(root, build, rows):
    """Files and programs of packages that this build has used."""
    files = {line.strip() for line in _said("ninja", "-C", build, "-t", "deps").splitlines()
             if line.strip().startswith("/usr/")}
    files |= set(_LIBRARY.findall(_said("ninja", "-C", build, "-t", "commands")))
    words = {command for _, command, *_ in rows if command != "-"} | set(PROGRAMS)
    for folder in ("tools", "tests", "apps"):
        for path in (root / folder).rglob("*"):
            if path.suffix in ("", ".py") and path.is_file() and path.name not in APART:
                words |= set(_WHICH.findall(path.read_text(encoding="utf-8", errors="replace")))
    tools = (shutil.which(word) for word in words)
    files |= {str(pathlib.Path(tool).resolve()) for tool in tools if tool}
    return sorted(file for file in files if file.startswith("/usr/") and not file.startswith("/usr/local/"))


def owners(files):
    """{file: package}"""
    owners_by_file = {}
    for first in range(0, len(files), 400):
        for line in _said("dpkg", "-S", *files[first:first + 400]).splitlines():
            packages, _, file = line.partition(": ")
            owners_by_file[file] = packages.split(",")[0].split(":")[0]
    return owners_by_file


def check(root, build):
    """(how many files were looked at, a line for each package that is missing from the table)."""
    text = (root / "tools" / "packages.txt").read_text(encoding="utf-8")
    rows = rows_of(sets(text), SET)
    there = resolved([row[0] for row in rows])
    if not there:
        return 0, ["apt-get -s says nothing: run apt-get update"]
    files = used(root, build, rows)
    packages, missing = owners(files), {}
    for file in files:
        package = packages.get(file) or packages.get(file.removeprefix("/usr"))
        if package and package not in there:
            missing.setdefault(package, file)
    return len(files), [f"tools/packages.txt: no set of '{SET}' brings {package}, which a build uses: {file}"
                        for package, file in sorted(missing.items())]


if __name__ == "__main__":
    COUNT, LINES = check(ROOT, ROOT / "build")
    print("\n".join([*LINES, f"{COUNT} files"]))
    sys.exit(1 if LINES else 0)
