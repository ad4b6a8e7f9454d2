"""Pictures: the same bytes each time, every name in them, names that do not meet.

SPDX-License-Identifier: Apache-2.0
"""

import importlib
import xml.etree.ElementTree

import pytest
from matplotlib import pyplot

from lab.figures.charts import timeline, walk
from lab.figures.charts.labels import Labels
from lab.figures.modules import CHARTS
from tests.support import report_samples as samples
from tools.project_root import ROOT

CORES = [{**row, "top": "hwffd_stream"} for row in samples.SYNTH["rows"]]
REPORTS = {"organizations": samples.ORGANIZATIONS, "synth": {**samples.SYNTH, "rows": CORES}, "words": samples.WORDS,
           "streams": samples.STREAMS, "timelines": samples.TIMELINES,
           "structure": samples.STRUCTURE, "compare": samples.COMPARE}
# A picture -> words that stand in it. Letters are paths; the words stand in comments beside them.
WORDS = {
    "organizations.svg": ("basic", "tree 8", "overlapped", "paper's schedule, as built"),
    "pareto.svg": ("hwffd_stream on ecp5, routed", "hwffd_stream on ecp5, mapped", "basic fx18",
                   "parallel fx18", "LUTs"),
    "tree8.svg": ("tree8-fx18-paper", "3 accumulators", "first vertex done"),
    "words.svg": ("half a pixel of 4,096", "product form, largest", "binary32 tree, largest"),
    "streams.svg": ("cat.3ds, 10 vertices", "changed points, by cell", "resident"),
    "structure-hwffd_top-basic-fx18.svg": ("hwffd_top", "ffd_mid_a", "\u00d7 2", "52.1%", "192"),
    "compare.svg": ("device reference", "interpolation 2.2 eval_cubic",
                    "hwffd_stream basic-fx18-overlapped, a chip", "sorted by cell"),
    "equation.svg": ("control points", "what lies in the lattice, deformed"),
    "weights.svg": ("B_0", "their sum"),
    "cell.svg": ("vertex",),
    "rounding.svg": ("exact", "rounded to 4 bits behind the point"),
    "packet.svg": ("opcode 3", "vertex 1, tlast"),
    "board.svg": ("host.py", "FPGA"),
    "walk-rows.svg": ("bank 3 holds", "plane 6", "3 stays", "cell 3", "the next row"),
}


def drawn(name, reports, folder):
    return importlib.import_module(f"lab.figures.charts.{name}").draw(reports, folder)


def test_every_picture_has_its_words_and_the_same_bytes_again(reports, tmp_path):
    data = reports(**REPORTS)
    first, second = ([path for name in CHARTS for path in drawn(name, data, tmp_path / folder)]
                     for folder in ("first", "second"))
    assert [path.name for path in first] == list(WORDS)
    for path, other in zip(first, second):
        assert path.read_bytes() == other.read_bytes()
        text = path.read_text(encoding="utf-8")
        assert xml.etree.ElementTree.fromstring(text).tag[-3:] == "svg"
        for word in WORDS[path.name]:
            assert f">{word}<" in text


def test_what_another_beats_has_no_name(reports, tmp_path):
    beaten = samples.mapped("tree8-fx18-overlapped", 99999, top="hwffd_stream")
    rows = [row for row in CORES if row["name"] != beaten["name"]]
    path, = drawn("pareto", reports(organizations=samples.ORGANIZATIONS,
                                    synth={**samples.SYNTH, "rows": [*rows, beaten]}), tmp_path)
    text = path.read_text(encoding="utf-8")
    assert ">tree 8 fx18<" not in text
    assert ">parallel fx18<" in text


def test_without_a_whole_core_there_is_an_empty_picture(reports, tmp_path):
    path, = drawn("pareto", reports(organizations=samples.ORGANIZATIONS, synth=samples.SYNTH),
                  tmp_path)
    assert ">hwffd_stream on ecp5, mapped<" in path.read_text(encoding="utf-8")


@pytest.mark.parametrize("pattern, least", (
    ("structure-*.svg", 4), ("words.svg", 1), ("streams.svg", 1), ("organizations/*.svg", 15)))
def test_pictures_that_documents_show_are_there(pattern, least):
    pictures = list((ROOT / "docs").glob(pattern))
    assert len(pictures) >= least
    assert all(len(path.read_bytes()) > 10000 for path in pictures)


def test_the_last_operation_to_enter_counts():
    lane = {"spans": [[0, 4, 0], [2, 6, 1], [6, 7, 1], [9, 12, 0]]}
    assert timeline.runs(lane, 10) == [(0, 2, 0), (2, 5, 1), (9, 1, 0)]


def test_vertices_have_colours_in_their_order():
    assert timeline.in_order([{"spans": [[4, 5, 5], [0, 4, 213]]}, {"spans": [[6, 7, 39], [5, 6, 213]]}]) == {
        213: 0, 5: 1, 39: 2}


def test_a_plane_is_held_from_the_cell_where_it_is_new_until_it_is_replaced():
    taken = list(range(100, 100 + 2 * walk.VERTICES))
    planes = {plane: (bank, begin - 100, end - 100, fresh - 100) for bank, plane, _, begin, end, fresh in walk.held(0, taken)}
    assert planes == {0: (0, 0, 7, 7), 1: (1, 0, 14, 7), 2: (2, 0, 21, 7), 3: (3, 0, 28, 7), 4: (0, 7, 28, 14),
                      5: (1, 14, 28, 21), 6: (2, 21, 28, 28)}


def test_what_is_drawn_of_a_row_is_a_plane_every_four_clocks_and_a_vertex_every_clock():
    reads, taken = walk.events()
    assert [clock for clock, _, _ in reads] == list(range(0, 4 * 2 * walk.PLANES, 4))
    assert [plane for _, _, plane in reads] == 2 * list(range(walk.PLANES))
    assert taken == list(range(taken[0], taken[0] + 2 * walk.VERTICES))


def test_a_tree_is_shown_with_eight_units_where_there_is_one():
    rows = [{"org": "tree", "n": n} for n in (2, 8, 32)] + [{"org": "factored", "n": 64}]
    assert timeline.shown(rows) == [rows[1], rows[3]]
    assert timeline.shown(rows[:1]) == rows[:1]


def test_an_organization_that_went_is_not_drawn():
    assert timeline.shown([{"org": "cg2", "n": 1}]) == []


@pytest.fixture
def labels():
    figure, axes = pyplot.subplots()
    axes.set(xlim=(0, 100), ylim=(0, 100))
    figure.canvas.draw()
    yield Labels(axes)
    pyplot.close(figure)


def box(labels, *name):
    return labels.place_near(*name).get_window_extent(labels.renderer)


def test_a_lone_name_is_above_or_below(labels):
    labels.keep_free(50, 50)
    _, middle = labels.axes.transData.transform((50, 50))
    assert box(labels, 50, 50, "above", "red").y0 > middle
    assert box(labels, 50, 50, "below", "red", False).y1 < middle


def test_crowded_names_do_not_meet(labels):
    marks = [(50 + i, 50 + i) for i in range(5)]
    for mark in marks:
        labels.keep_free(*mark)
    boxes = [box(labels, *mark, "a name", "red") for mark in marks]
    assert not any(extent.overlaps(other) for i, extent in enumerate(boxes) for other in boxes[:i])


def test_a_line_is_not_covered(labels):
    labels.keep_free(50, 50)
    labels.keep_line_free((50, 50), (90, 90))
    assert box(labels, 50, 50, "a name", "red").x0 < labels.axes.transData.transform((50, 50))[0]
    labels.keep_free(20, 50)
    labels.keep_line_free((20, 50), (20, 90))
    extent, line = box(labels, 20, 50, "a name", "red"), labels.axes.transData.transform((20, 50))[0]
    assert extent.x1 < line or extent.x0 > line
