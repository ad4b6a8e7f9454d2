"""Where the checkout is.

SPDX-License-Identifier: Apache-2.0
"""

import hashlib
import os
import pathlib
import re
import tempfile


def without_blanks(path):
    """A folder, or a link to it where its path has blanks, at which Verilator, yosys and others end."""
    if not re.search(r"\s", str(path)):
        return path
    name = f"hwffd-{os.getuid()}-{hashlib.sha256(str(path).encode()).hexdigest()[:16]}"
    link = pathlib.Path(tempfile.gettempdir()) / name
    if not (link.is_symlink() and os.readlink(link) == str(path)):
        new = link.with_name(f"{name}.{os.getpid()}")
        new.symlink_to(path)
        new.replace(link)
    return link


ROOT = without_blanks(pathlib.Path(__file__).resolve().parent.parent)


def environment():
    """That of a process which is to find the packages of the checkout."""
    before = os.environ.get("PYTHONPATH")
    return {**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT), *([before] if before else [])])}
