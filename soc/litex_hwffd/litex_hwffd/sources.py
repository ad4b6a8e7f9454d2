"""Which files a core is made of.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib

LIST = "hwffd.f"
VARIABLE = "HWFFD_RTL"


class RtlError(Exception):
    """The sources are not there, in one line."""


def sources(folder=None):
    """(files, folders of headers) of a core.

    The folder is `rtl/` of the project, `share/hwffd/rtl` of an installation, or one that `hwffd core`
    wrote, without its testbench; without one it is that of the variable HWFFD_RTL. Raises RtlError.
    """
    folder = folder or os.environ.get(VARIABLE)
    if not folder:
        raise RtlError(f"no folder of sources: give rtl=, or set {VARIABLE}")
    folder = pathlib.Path(folder).resolve()
    names = folder / LIST
    if not names.is_file():
        files = sorted(path for path in folder.glob("*.v") if not path.stem.endswith("_tb"))
        if not files:
            raise RtlError(f"{folder}: neither {LIST} nor a file of Verilog is there")
        return [str(path) for path in files], [str(folder)]
    lines = [line.strip() for line in names.read_text(encoding="utf-8").splitlines()]
    headers = [line[len("+incdir+"):] for line in lines if line.startswith("+incdir+")]
    files = [line for line in lines if line.endswith(".v")]
    return [str(folder / name) for name in files], [str(folder / name) for name in headers]
