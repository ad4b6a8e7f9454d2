"""Runs a test's program by the interpreter of build/venv. Where tools/install has not installed
what it needs, the test is skipped if it has SKIP_RETURN_CODE, and fails otherwise.

    in_venv.py SET PROGRAM ARGUMENT...

SET is that of tools/packages.txt which the test wants.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import sys

VENV = pathlib.Path(__file__).resolve().parent.parent / "build" / "venv"
SKIPPED = 77


def main():
    wanted, *program = sys.argv[1:]
    if not (VENV / f"requirements-{wanted}.txt").is_file():
        print(f"skipped: packages are missing in build/venv: run tools/install {wanted}")
        return SKIPPED
    python = str(VENV / "bin" / "python")
    sys.stdout.flush()
    return os.execv(python, [python, "-B", *program])


if __name__ == "__main__":
    sys.exit(main())
