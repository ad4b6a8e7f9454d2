"""Runs a test's program by the interpreter of build/venv; skips it where scripts/python_env has not
installed what it needs.

    in_venv.py PROGRAM ARGUMENT...

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import sys

VENV = pathlib.Path(__file__).resolve().parent.parent / "build" / "venv"
SKIPPED = 77  # SKIP_RETURN_CODE of these tests


def main():
    if not (VENV / "requirements-all.txt").is_file():
        print("skipped: no Python packages of make test-all in build/venv: "
              "run scripts/python_env all")
        return SKIPPED
    python = str(VENV / "bin" / "python")
    sys.stdout.flush()
    return os.execv(python, [python, "-B", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
