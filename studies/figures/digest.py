"""A hash of sources that changes where they mean something else.

Of Verilog the preprocessed tokens count, so that a macro or a file that is included may hold what
stood in the module before; of C++ the tokens; of the table of configurations each row's name and
parameters; of any other file its lines. Neither comments nor blanks count, nor where a file lies.

SPDX-License-Identifier: Apache-2.0
"""

import hashlib
import pathlib
import re
import shutil
import subprocess

import configurations

_COMMENT = re.compile(r'("(?:\\.|[^"\\\n])*")|//[^\n]*|/\*.*?\*/', re.DOTALL)
_TOKEN = re.compile(r'"(?:\\.|[^"\\\n])*"|\w+|[^\w\s]')
_INCLUDE = re.compile(r"^\s*#\s*(?:include\b.*|pragma once)$", re.MULTILINE)
_TABLE = "configurations.csv"


class DigestError(Exception):
    """Why sources cannot be hashed, in one line."""


def _tokens(text):
    return _TOKEN.findall(_COMMENT.sub(lambda match: match.group(1) or " ", text))


def _cpp(path):
    return _tokens(_INCLUDE.sub("", path.read_text(encoding="utf-8")))


def _verilog(root, files):
    """The tokens of Verilog, macros and included files expanded; files in the order of their names,
    wherever they lie.
    """
    if not shutil.which("iverilog"):
        raise DigestError("iverilog not found: run scripts/install")
    folders = sorted({f"-I{path.parent}" for path in (root / "rtl").rglob("*.vh")})
    files = sorted(files, key=lambda path: path.name)
    done = subprocess.run(["iverilog", "-g2005", "-E", *folders, "-o", "-", *map(str, files)],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise DigestError(f"iverilog: {(done.stderr.splitlines() or ['failed'])[0]}")
    return _tokens(done.stdout)


def _other(path):
    if path.name == _TABLE:
        return [f"{row.name} {' '.join(row.assignments())}" for row in configurations.read(path)]
    return [line.strip() for line in path.read_text(encoding="utf-8").splitlines() if line.strip()]


def _hash(words):
    return hashlib.sha256("\n".join(words).encode()).hexdigest()


def files_of(root, patterns):
    """Those that the patterns name. Raises DigestError where one names none."""
    found = set()
    for pattern in patterns:
        matched = {path for path in pathlib.Path(root).glob(pattern) if path.is_file()}
        if not matched:
            raise DigestError(f"no sources are {pattern}")
        found |= matched
    return sorted(found)


def digest(root, patterns):
    """Sixteen digits for what the patterns name. Raises DigestError."""
    root = pathlib.Path(root)
    files = files_of(root, patterns)
    verilog = [path for path in files if path.suffix == ".v"]
    parts = [_hash(_verilog(root, verilog))] if verilog else []
    for path in files:
        if path.suffix in (".cpp", ".hpp"):
            parts.append(_hash(_cpp(path)))
        elif path.suffix != ".v":
            parts.append(_hash([path.name, *_other(path)]))
    return _hash(sorted(parts))[:16]
