"""The version of the project: the file VERSION, which register, C header, hwffd.core and CMake follow.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
from typing import NamedTuple

from tools.csv_table import TableError, read_text

FILE = "VERSION"
HEADER = "api/include/hwffd/version.h"
LITEX = "soc/litex_hwffd/litex_hwffd/version.py"


class Version(NamedTuple):
    major: int
    minor: int
    patch: int

    @property
    def number(self):
        return (self.major * 100 + self.minor) * 100 + self.patch

    def __str__(self):
        return ".".join(map(str, self))


def read(root):
    """That of a checkout. Raises TableError."""
    path = pathlib.Path(root) / FILE
    match = re.fullmatch(r"(0|[1-9]\d*)\.(0|[1-9]\d*)\.(0|[1-9]\d*)\n", read_text(path))
    if not match:
        raise TableError(f"{path}:1: not a version: three numbers joined by points, as 1.2.3")
    return Version(*map(int, match.groups()))


def header_text(version):
    lines = [f"/* Made from {FILE} by tools/tables/registers.py; changes here are lost.",
             " * The version of library and core that this header belongs to; hwffd_version() and",
             " * the register VERSION have those that run.",
             " * SPDX-License-Identifier: Apache-2.0 */", "#ifndef HWFFD_VERSION_H",
             "#define HWFFD_VERSION_H", ""]
    lines += [f"#define HWFFD_VERSION_{part.upper()} {number}"
              for part, number in version._asdict().items()]
    lines += [f'#define HWFFD_VERSION "{version}"', "",
              "/* One number that grows with the version: 10203 is 1.2.3. */",
              f"#define HWFFD_VERSION_NUMBER {version.number}",
              "/* Whether the headers are of that version or a later one, in #if too. */",
              "#define HWFFD_VERSION_AT_LEAST(major, minor, patch) \\",
              "  (HWFFD_VERSION_NUMBER >= (major)*10000 + (minor)*100 + (patch))"]
    return "\n".join([*lines, "", "#endif"]) + "\n"


def litex_text(version):
    return (f'"""Made from {FILE} by tools/tables/generated_files.py; changes here are lost.\n\n'
            f'SPDX-License-Identifier: Apache-2.0\n"""\n\nVERSION = "{version}"\n')
