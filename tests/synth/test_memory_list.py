"""The list of memories of a configuration (tools/rtl/memories.py).

SPDX-License-Identifier: Apache-2.0
"""

import functools
import re

import pytest

from tools.project_root import ROOT
from tools.rtl import memories

WORD = 3 * 19  # of a point in fx18: three numbers with a bit that says whether they are saturated


@functools.cache
def of(top, **given):
    return memories.of_top(ROOT, top, given)


def test_points_of_a_lattice():
    """Two buffers of 16 x 16 x 16 points, one memory a lane; pages make it deeper."""
    for org, lanes in ((1, 1), (7, 32), (10, 64)):
        shaped = of("hwffd_stream", ORG=org, INTERLEAVED=0, EVALUATOR=0, FORMAT=18 if org < 10 else 17)
        points = {shape: places["ffd_cache_lane"] for shape, places in shaped.items() if places["ffd_cache_lane"]}
        bits = sum(shape.bits * count for shape, count in points.items())
        assert sum(points.values()) == lanes
        assert bits == 2 * 16 ** 3 * (WORD if org < 10 else WORD - 3)
    four = of("hwffd_stream", ORG=1, PAGED=1, PAGES=4)
    assert max(shape.depth for shape in four) == 4 * 16 ** 3


def test_what_is_left_out_has_no_memory():
    places = [sum(shaped.values(), start=memories.Counter())["ffd_cache_beats"]
              for shaped in (of("hwffd_stream", ORG=1, INTERLEAVED=0, EVALUATOR=0, FORMAT=18), of("hwffd_axi", ORG=1))]
    assert places[0] == 0 and places[1] > 0


def test_table():
    shaped = of("hwffd_axi", ORG=1)
    head, *rows, total = memories.lines(shaped)
    numbers = [[int(word.replace(",", "")) for word in row.split()[:4]] for row in rows]
    assert len(numbers) > 10 and all(width * depth == bits for _, width, depth, bits in numbers)
    count, bits = (int(word.replace(",", "")) for word in re.match(r"([\d,]+) memories, ([\d,]+) bits", total).groups())
    assert (count, bits) == (sum(row[0] for row in numbers), sum(row[0] * row[3] for row in numbers))
    assert head.split()[:4] == ["instances", "width", "depth", "bits"]
    assert [row[3] for row in numbers] == sorted((row[3] for row in numbers), reverse=True)


@pytest.mark.parametrize("arguments, status, words", (
    ((), 2, "TOP [NAME=NUMBER...] wanted"), (("hwffd_exi",), 2, "unknown top 'hwffd_exi'"),
    (("hwffd_axi", "ORG"), 2, "'ORG': NAME=NUMBER wanted"),
    (("ffd_org_select", "ORG=99"), 1, "ffd_org_select: ERROR_ffd_org_select_org_is_unknown")))
def test_refusals(capsys, arguments, status, words):
    assert memories.main(arguments) == status
    (line,) = capsys.readouterr().err.splitlines()
    assert words in line
