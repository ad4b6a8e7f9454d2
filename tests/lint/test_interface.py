"""docs/interface.md has a row for each bit of event_o and each code of the DMA, and what lies in a result's
status is where the RTL has it.

SPDX-License-Identifier: Apache-2.0
"""

import re

from tools.project_root import ROOT
from tools.rtl import module_header, rtl_sources
from tools.tables import register_texts, registers, stream_words

PAGE = (ROOT / "docs" / "interface.md").read_text()
LAST_OF_STREAM, FIRST_OF_DMA, FIRST_TIMEOUT, FIRST_NEWER = "saturated", "dma_zero", "timeout_ar", "page_points"


def rows(heading, column):
    """The first cells of the table behind a heading whose first column is called that."""
    section = PAGE.split(f"\n## {heading}", 1)[1].split("\n## ", 1)[0]
    table = re.search(rf"^\| {column} \|.*\n\|[-|: ]+\n((?:\|.*\n)+)", section, re.MULTILINE).group(1)
    return [line.split("|")[1].strip() for line in table.splitlines()]


def names():
    return [field.name for field in register_texts.events(registers.read(ROOT))]


def test_every_event_has_a_row():
    of_all = names()
    stream = of_all[:of_all.index(FIRST_OF_DMA)] + of_all[of_all.index(FIRST_NEWER):]
    ports = {port.name: port.width for port in module_header.read(rtl_sources.Sources(), "hwffd_stream").ports}
    assert stream[of_all.index(LAST_OF_STREAM)] == LAST_OF_STREAM
    assert rows("5. Bad input", "bit") == [str(bit) for bit in range(len(stream))]
    assert ports["event_o"] == len(stream)


def test_every_status_bit_has_a_row():
    status = [field for field in stream_words.read() if field.word == "status"]
    carried = next(field for field in stream_words.read() if (field.word, field.name) == ("user", "status"))
    assert rows("4. Results and status", "bit of word 3") == [str(carried.low + field.low) for field in status]


def test_every_code_of_the_dma_has_a_row():
    """dma_zero to dma_ring are its codes in their order, but for results that are dropped, which have none."""
    of_all = names()
    of_dma = of_all[of_all.index(FIRST_OF_DMA):of_all.index(FIRST_TIMEOUT)]
    codes = [name for name in of_dma if name != "result_overflow"]
    assert rows("8. DMA", "code") == [str(code + 1) for code in range(len(codes))]
