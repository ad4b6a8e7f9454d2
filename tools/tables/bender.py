"""Bender.yml, the core for Bender: the files of rtl/hwffd.f and the folders with headers.

SPDX-License-Identifier: Apache-2.0
"""

from tools.rtl import rtl_sources

NAME = "Bender.yml"
GENERATED = "Made by python3 -m tools.tables.generated_files write; changes here are lost."


def text(root):
    """What Bender.yml must be."""
    listed = root / "rtl" / rtl_sources.CORE_LIST
    lines = [f"# {GENERATED}", "# SPDX-License-Identifier: Apache-2.0", "package:", "  name: hwffd", "",
             "sources:", "  - include_dirs:"]
    lines += [f"      - rtl/{folder}" for folder in rtl_sources.read_include_folders(listed)]
    lines += ["    files:"]
    lines += [f"      - rtl/{entry}" for entry in rtl_sources.read_file_list(listed) if entry != rtl_sources.WAIVERS]
    return "\n".join(lines) + "\n"
