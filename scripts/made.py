#!/usr/bin/env python3
"""Files that are made from tables and committed, so that the RTL can be used without any script: which
they are, and whether they are what the tables say.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import sys

import core_file
import formats
import organization_rtl
import rtl
import stream_words
import version
from module_header import HeaderError
from tables import TableError, differing, write_if_changed

# What each of them is made from, and how. A checkout without that has no such files. The list of files
# comes after them, since it names them, and behind it what is made of it.
MAKERS = (
    (organization_rtl.TABLE, organization_rtl.outputs),
    (formats.TABLE, lambda root: {formats.HEADER: formats.header_text(formats.read(root))}),
    (stream_words.TABLE, lambda root: {
        stream_words.RTL: stream_words.rtl_text(stream_words.read(root)),
        stream_words.HEADER: stream_words.header_text(stream_words.read(root))}),
    (organization_rtl.TABLE, lambda root: {"rtl/hwffd.f": rtl.file_list_text(root / "rtl")}),
    (version.FILE, lambda root: {core_file.NAME: core_file.text(root)}),
)


def _made(root, table, make):
    return make(pathlib.Path(root)) if (pathlib.Path(root) / table).exists() else {}


def outputs(root=rtl.ROOT):
    """path below root -> the text that it must have. Raises TableError."""
    return {name: text for table, make in MAKERS for name, text in _made(root, table, make).items()}


def stale(root=rtl.ROOT):
    """A line for each file that is not what the tables make of it."""
    root = pathlib.Path(root)
    return [f"{name}: not what the tables say: run scripts/made.py write"
            for name in differing(root, outputs(root))]


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Writes the files made from tables, or checks them.")
    parser.add_argument("--root", type=pathlib.Path, default=rtl.ROOT, help="checkout to work on")
    parser.add_argument("command", choices=("write", "check"))
    options = parser.parse_args(arguments)
    try:
        if options.command == "write":
            for table, make in MAKERS:
                for name, text in _made(options.root, table, make).items():
                    write_if_changed(options.root / name, text)
            return 0
        found = stale(options.root)
    except (TableError, HeaderError, OSError) as error:
        found = [str(error)]
    for line in found:
        print(f"made.py: {line}", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
