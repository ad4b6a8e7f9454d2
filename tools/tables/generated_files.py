"""Files that are made from tables and committed, so that the RTL can be used without any script: which
they are, and whether they are what the tables say.

SPDX-License-Identifier: Apache-2.0
"""

import sys

from tools import csv_table
from tools.project_root import ROOT
from tools.rtl import rtl_sources
from tools.tables import (
    bender, citation, core_file, formats, ip_xact, organization_rtl, registers, stream_words, system_rdl, version)

# What each of them is made from, and how. A checkout without that has no such files. The list of files
# comes after them, since it names them, and behind it what is made of it.
_SOURCES = (
    (organization_rtl.TABLE, organization_rtl.outputs),
    (formats.TABLE, lambda root: {formats.HEADER: formats.header_text(formats.read(root))}),
    (stream_words.TABLE, lambda root: {
        stream_words.RTL: stream_words.rtl_text(stream_words.read(root)),
        stream_words.HEADER: stream_words.header_text(stream_words.read(root)),
        stream_words.OPCODES: stream_words.opcodes_text(stream_words.read(root))}),
    (registers.TABLE, registers.outputs),
    (organization_rtl.TABLE, lambda root: {
        f"rtl/{name}": text for name, text in rtl_sources.file_list_texts(root / "rtl").items()}),
    (version.FILE, lambda root: {
        core_file.NAME: core_file.text(root), bender.NAME: bender.text(root), ip_xact.NAME: ip_xact.text(root),
        system_rdl.NAME: system_rdl.text(root), version.LITEX: version.litex_text(version.read(root)),
        citation.NAME: citation.text(root)}),
)


def _maker(source, make):
    return lambda root: make(root) if (root / source).exists() else {}


MAKERS = [_maker(*source) for source in _SOURCES]


def outputs(root=ROOT):
    """path below root -> the text that it must have. Raises TableError."""
    return {name: text for make in MAKERS for name, text in make(root).items()}


def stale(root=ROOT):
    """A line for each file that is not what the tables make of it."""
    return csv_table.stale(root, MAKERS, "generated_files")


def main(arguments=None):
    return csv_table.command("generated_files", MAKERS, arguments)


if __name__ == "__main__":
    sys.exit(main())
