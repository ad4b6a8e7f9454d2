"""The reference of the C and C++ libraries, which Doxygen makes of the comments in their headers.

SPDX-License-Identifier: Apache-2.0
"""

import os
import subprocess


class DoxygenError(Exception):
    """Doxygen did not run, or warns of a comment."""


def run(root, output):
    """Writes `output`/index.html and what it links to. Raises DoxygenError."""
    output.mkdir(parents=True, exist_ok=True)
    settings = {**os.environ, "HWFFD_DOCS_OUTPUT": str(output)}
    try:
        result = subprocess.run(["doxygen", "apps/docs/Doxyfile"], cwd=root, env=settings, capture_output=True,
                                text=True, check=False)
    except FileNotFoundError as error:
        raise DoxygenError("doxygen not found: run tools/install docs") from error
    if result.returncode != 0:
        raise DoxygenError(f"doxygen: {result.stderr.strip()}")
