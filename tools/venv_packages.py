"""The packages that tools/python_env installs, for programs that are started without them.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import sys

from tools.project_root import ROOT

FOLDER = ROOT / "build" / "venv"


def enter(requirements):
    """Starts the program again by the interpreter of build/venv, where that has these packages."""
    if (FOLDER / requirements).is_file() and pathlib.Path(sys.prefix) != FOLDER:
        python = str(FOLDER / "bin" / "python")
        os.execv(python, [python, *sys.orig_argv[1:]])
