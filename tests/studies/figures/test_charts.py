"""Pictures: the same bytes each time, every name in them, names that do not meet.

SPDX-License-Identifier: Apache-2.0
"""

import importlib
import unittest
import xml.etree.ElementTree

import samples
from checkout import ROOT, Checkout
from figures.catalogue import CHARTS
from figures.charts import timeline
from figures.charts.labels import Labels
from figures.reports import FRESH
from matplotlib import pyplot

REPORTS = {"organizations": samples.ORGANIZATIONS, "synth": samples.SYNTH, "words": samples.WORDS,
           "streams": samples.STREAMS, "timelines": samples.TIMELINES,
           "structure": samples.STRUCTURE}
# A picture -> words that stand in it. Letters are paths; the words stand in comments beside them.
WORDS = {
    "organizations.svg": ("basic", "tree 8", "nested", "overlapped", "paper's schedule, as built"),
    "pareto.svg": ("ecp5", "generic", "basic fx18", "parallel fx18", "LUTs", "cells"),
    "timeline-tree8.svg": ("tree8-fx18-paper", "3 accumulators", "first vertex done"),
    "words.svg": ("half a pixel of 4,096", "product form, largest", "binary32 tree, largest"),
    "streams.svg": ("cat.3ds, 10 vertices", "changed points, by cell", "resident"),
    "structure-hwffd_top-basic-fx18.svg": ("hwffd_top", "ffd_mid_a", "\u00d7 2", "52.1%", "192"),
}


class Drawn(Checkout):
    def draw(self, folder):
        reports = self.reports(FRESH, **REPORTS)
        return [path for name in CHARTS
                for path in importlib.import_module(f"figures.charts.{name}").draw(
                    reports, self.root / folder)]

    def test_every_picture_has_its_words_and_the_same_bytes_again(self):
        first, second = self.draw("first"), self.draw("second")
        self.assertEqual([path.name for path in first], list(WORDS))
        for one, other in zip(first, second):
            with self.subTest(one.name):
                self.assertEqual(one.read_bytes(), other.read_bytes())
                text = one.read_text(encoding="utf-8")
                self.assertEqual(xml.etree.ElementTree.fromstring(text).tag[-3:], "svg")
                for word in WORDS[one.name]:
                    self.assertIn(f"<!-- {word} -->", text)

    def test_what_another_beats_has_no_name(self):
        beaten = samples.mapped("tree8-fx18-overlapped", 99999)
        rows = [row for row in samples.SYNTH["rows"] if row["name"] != beaten["name"]]
        reports = self.reports(organizations=samples.ORGANIZATIONS,
                               synth={**samples.SYNTH, "rows": [*rows, beaten]})
        path, = importlib.import_module("figures.charts.pareto").draw(reports, self.root)
        text = path.read_text(encoding="utf-8")
        self.assertNotIn("<!-- tree 8 fx18 -->", text)
        self.assertIn("<!-- parallel fx18 -->", text)

    def test_pictures_that_documents_show_are_there(self):
        for pattern, least in (("structure-*.svg", 4), ("words.svg", 1), ("streams.svg", 1)):
            found = list((ROOT / "docs").glob(pattern))
            self.assertGreaterEqual(len(found), least)
            for path in found:
                self.assertGreater(len(path.read_bytes()), 10000, path)


class Timeline(unittest.TestCase):
    def test_the_last_operation_to_enter_counts(self):
        lane = {"spans": [[0, 4, 0], [2, 6, 1], [6, 7, 1], [9, 12, 0]]}
        self.assertEqual(timeline.runs(lane, 10), [(0, 2, 0), (2, 5, 1), (9, 1, 0)])


class Names(unittest.TestCase):
    def setUp(self):
        figure, self.axes = pyplot.subplots()
        self.addCleanup(pyplot.close, figure)
        self.axes.set(xlim=(0, 100), ylim=(0, 100))
        figure.canvas.draw()
        self.labels = Labels(self.axes)

    def box(self, text):
        return text.get_window_extent(self.labels.renderer)

    def test_a_lone_one_is_above_or_below(self):
        self.labels.keep_free(50, 50)
        _, middle = self.axes.transData.transform((50, 50))
        self.assertGreater(self.box(self.labels.beside(50, 50, "above", "red")).y0, middle)
        self.assertLess(self.box(self.labels.beside(50, 50, "below", "red", False)).y1, middle)

    def test_crowded_ones_do_not_meet(self):
        marks = [(50 + i, 50 + i) for i in range(5)]
        for mark in marks:
            self.labels.keep_free(*mark)
        boxes = [self.box(self.labels.beside(*mark, "a name", "red")) for mark in marks]
        for i, one in enumerate(boxes):
            for other in boxes[:i]:
                self.assertFalse(one.overlaps(other), f"{one} and {other}")

    def test_a_line_is_not_covered(self):
        self.labels.keep_free(50, 50)
        self.labels.keep_line_free((50, 50), (90, 90))
        left, _ = self.axes.transData.transform((50, 50))
        self.assertLess(self.box(self.labels.beside(50, 50, "a name", "red")).x0, left)
        self.labels.keep_free(20, 50)
        self.labels.keep_line_free((20, 50), (20, 90))
        box = self.box(self.labels.beside(20, 50, "a name", "red"))
        self.assertTrue(box.x1 < self.axes.transData.transform((20, 50))[0] or
                        box.x0 > self.axes.transData.transform((20, 50))[0])


if __name__ == "__main__":
    unittest.main(verbosity=2)
