"""Runs a test's program by the interpreter of build/venv. Where scripts/python_env has not installed
what it needs, the test is skipped if it has SKIP_RETURN_CODE, and fails otherwise.

    in_venv.py SET PROGRAM ARGUMENT...

SET is that of scripts/requirements-SET.txt which the test wants; "base": requirements.txt.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import sys

VENV = pathlib.Path(__file__).resolve().parent.parent / "build" / "venv"
SKIPPED = 77


def main():
    wanted, *program = sys.argv[1:]
    more = "" if wanted == "base" else wanted
    if not (VENV / f"requirements-{more}.txt".replace("-.", ".")).is_file():
        print(f"skipped: packages are missing in build/venv: run scripts/python_env {more}")
        return SKIPPED
    python = str(VENV / "bin" / "python")
    sys.stdout.flush()
    return os.execv(python, [python, "-B", *program])


if __name__ == "__main__":
    sys.exit(main())
