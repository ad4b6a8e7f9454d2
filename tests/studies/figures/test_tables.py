"""Tables and what follows from reports, of reports made up here.

SPDX-License-Identifier: Apache-2.0
"""

import copy
import unittest

import samples
from checkout import ROOT, Checkout
from figures import check, markers, sources, table
from figures.catalogue import CHARTS, REPORTS, missing, module, printed
from figures.reports import FRESH
from figures.studies import organizations, streams, synth, throughput, words


class Alignment(unittest.TestCase):
    def test_columns_of_numbers_stand_on_the_right(self):
        made = table.Table(["a", "b", "c", "d"],
                           [["`x`", "1,234", "-", "14 + 12"], ["y z", "2.3e-07", "", "0 of 60,012"]])
        self.assertEqual(made.markdown().splitlines()[1], "| --- | --: | --- | --: |")
        self.assertEqual(made.text().splitlines(), [
            "a          b  c            d", "x      1,234  -      14 + 12",
            "y z  2.3e-07     0 of 60,012"])
        self.assertEqual(table.Table(["a"], []).markdown(), "| a |\n| --- |")


class Words(Checkout):
    def test_which_word_suffices(self):
        data = self.reports(words=samples.WORDS)
        figures = {name: data.figure("words", name) for name in words.FIGURES}
        self.assertEqual(figures, {"half_pixel_measured": 18, "half_pixel_proved": 20,
                                   "as_binary32_sequence": 27, "as_binary32_tree": 28,
                                   "vertices": 1000})
        text = words.printed(data)
        self.assertIn("in sequence: 27 bits by max, 27 by rms; as its tree: 28 and 28", text)
        self.assertIn("(2.44e-04): 18 bits measured, 20 bits proved", text)
        self.assertEqual(words.shortest([], "product", "bound", 1), None)


class Streams(Checkout):
    def test_what_the_rtl_took(self):
        self.assertIn("resident        file   equal", streams.printed(
            self.reports(streams=samples.STREAMS)))
        wrong = copy.deepcopy(samples.STREAMS)
        wrong["rows"][-1]["beats_counted"] = 81
        text = streams.printed(self.reports(streams=wrong))
        self.assertEqual(text.count("NOT EQUAL"), 1)
        self.assertEqual(text.count("not built"), 4)

    def test_one_mesh(self):
        made = streams.words(self.reports(streams=samples.STREAMS), "horse.3ds")
        self.assertEqual(made.heads[2:], ["4x4x4", "16x16x16"])
        self.assertEqual(made.rows[-1], ["resident", "file", "4.05", "8.09"])


class Organizations(Checkout):
    def setUp(self):
        super().setUp()
        self.data = self.reports(organizations=samples.ORGANIZATIONS, synth=samples.SYNTH,
                                 pnr=samples.PNR)

    def test_a_line_each(self):
        made = organizations.clocks(self.data)
        self.assertEqual([line[0] for line in made.rows],
                         ["`basic`", "`tree 8`", "`parallel`", "`nested`"])
        self.assertEqual(made.rows[0][1:8], ["96", "96", "-", "4 + 3", "64 + 48", "64", "8 + 6"])
        self.assertEqual(made.rows[0][8:], ["2.31e-07", "8.65e-05", "-"])
        self.assertEqual(made.rows[3][1:3], ["-", "-"])

    def test_figures(self):
        figures = {name: self.data.figure("organizations", name)
                   for name in ("rows_measured", "results_checked", "watertight_rows",
                                "watertight_differences", "nested_seam_fx18")}
        self.assertEqual(figures, {"rows_measured": 7, "results_checked": 70, "watertight_rows": 6,
                                   "watertight_differences": 0, "nested_seam_fx18": 14.0})

    def test_what_is_wrong_is_seen(self):
        self.assertNotIn("NO", organizations.printed(self.data))
        wrong = copy.deepcopy(samples.ORGANIZATIONS)
        wrong["rows"][1]["equal"] = wrong["rows"][4]["equal_overlapped"] = False
        text = organizations.printed(self.reports(organizations=wrong))
        self.assertEqual(text.count("NO "), 2)

    def test_a_finished_report_has_the_targets_of_each_row(self):
        rows = organizations.finished(self.data)["rows"]
        self.assertEqual(rows[0]["targets"], {})
        self.assertEqual(set(rows[1]["targets"]), {"ecp5", "generic"})
        self.assertEqual(rows[1]["targets"]["ecp5"]["vertices_per_s"], 100e6 / 64)
        (self.root / "docs/reports/synth.json").unlink()
        self.assertNotIn("targets", organizations.finished(self.data)["rows"][1])

    def test_without_areas_it_says_what_makes_them(self):
        (self.root / "docs/reports/synth.json").unlink()
        self.assertTrue(organizations.printed(self.data).endswith(
            "no areas: make synth writes build/reports/synth.json"))

    def test_a_report_that_is_not_whole(self):
        (self.root / "rtl").symlink_to(ROOT / "rtl")
        self.assertRegex(organizations.missing(self.data), "^[0-9]+ rows, the first basic-fp32-paper")

    def test_the_table_of_results_joins_three_reports(self):
        made = markers.table(self.data, "results.organizations")
        self.assertEqual(made.rows[0], ["`basic`", "64", "8", "504", "-", "-", "8.7e-05"])
        self.assertEqual(made.rows[1][4:6], ["120.0", "15.00"])
        self.assertEqual([line[0] for line in markers.table(
            self.data, "results.organizations tree8 nested").rows], ["`tree 8`", "`nested`"])


class Throughput(Checkout):
    def found(self):
        return throughput.throughputs(self.reports(organizations=samples.ORGANIZATIONS,
                                                   synth=samples.SYNTH))

    def test_rates(self):
        timed, untimed = (next(one for one in self.found() if one.name == name) for name in (
            "basic-fx18-overlapped", "nested-fx18-overlapped"))
        self.assertEqual((timed.size, timed.unit, timed.multipliers), (500, "LUTs", 8))
        self.assertEqual(timed.per_second, 100e6 / 64)
        self.assertEqual(timed.per_size, 100e6 / 64 / 500)
        self.assertEqual(timed.per_multiplier, 100e6 / 64 / 8)
        self.assertEqual((untimed.per_second, untimed.rate), (None, 1))

    def test_sizes_that_a_target_counts(self):
        generic = [one for one in self.found() if one.target == "generic"]
        self.assertEqual([(one.size, one.unit, one.per_multiplier) for one in generic],
                         [(44000, "cells", None)])

    def test_of_organizations_only_and_each_once(self):
        rows = [*samples.SYNTH["rows"], samples.mapped("tree8-fx18-overlapped", 1, top="hwffd_axi"),
                samples.mapped("basic-fx18-paper", 1)]
        data = self.reports(organizations=samples.ORGANIZATIONS, synth={"rows": rows})
        names = [(one.name, one.target) for one in throughput.throughputs(data)]
        self.assertEqual(len(names), 6)
        self.assertEqual(len(set(names)), 6)

    def test_the_front_is_what_no_other_beats(self):
        found = [one for one in self.found() if one.target == "ecp5"]
        self.assertEqual([one.name for one in throughput.front(found)],
                         ["basic-fx18-overlapped", "tree8-fx18-overlapped",
                          "parallel-fx18-overlapped", "nested-fx18-overlapped"])

    def test_labels(self):
        self.assertEqual([throughput.label(samples.organization(name, 1)) for name in (
            "tree8-fx18-overlapped", "basic-fp32-overlapped-deep")],
            ["tree 8 fx18", "basic deep fp32"])


class Synth(Checkout):
    def test_the_document(self):
        wired = samples.mapped("basic-fx18-overlapped-bspline", 250)
        report = {**samples.SYNTH, "rows": [*samples.SYNTH["rows"], wired], "wanted": 9,
                  "failed": [{"name": "x", "top": "t", "target": "ecp5", "error": "latches"}]}
        text = synth.document(self.reports(synth=report))
        for line in ("2 of 9 rows have not been mapped", "Failed: x, t, ecp5: latches",
                     "## Lattice ECP5", "Binary32, `ffd_org_select`, units kept apart:",
                     "| row | LUT | LUT as memory | FF | MULT18X18D | DP16KD | depth | MHz |",
                     "|  | general / wired in | 2.00 | 1.00 |", "| `LUT4` | 500 | 900 |",
                     "Lattice ECP5, LUT, memory included:", "| `basic` | 504 | 954 |"):
            self.assertIn(line, text)


class Tests(Checkout):
    def test_what_ctest_wrote(self):
        self.put("build/reports/tests.xml", """<testsuite name="x"><testcase name="lint.a" time="1.5"
            status="run"/><testcase name="lint.b" time="0.25" status="fail"/>
            <testcase name="api.c.d" time="7" status="run"/></testsuite>""")
        module("tests").collect(self.root)
        data = self.reports(FRESH)
        self.assertEqual((data.figure("tests", "tests"), data.figure("tests", "not_passed")), (3, 1))
        self.assertEqual(markers.table(data, "tests.suites").rows,
                         [["`api`", "1", "7"], ["`lint`", "2", "2"]])
        self.assertEqual(markers.table(data, "tests.longest").rows[0], ["`api.c.d`", "7"])


class Catalogue(unittest.TestCase):
    def test_every_report_has_its_module(self):
        for name in REPORTS:
            with self.subTest(name):
                self.assertIsInstance(module(name).TABLES, dict)
        self.assertLessEqual({one for needed in CHARTS.values() for one in needed}, set(REPORTS))

    def test_committed_reports(self):
        """Every table and figure can be made of each, and lint lists one that is not whole."""
        reports = check.Reports(ROOT)
        present = [name for name in REPORTS if reports.has(name)]
        self.assertGreaterEqual(len(present), 5)
        listed = check.check(ROOT)[2]
        for name in present:
            with self.subTest(name):
                self.assertTrue(not missing(reports, name) or any(
                    line.startswith(f"docs/reports/{name}.json ") for line in listed))
                if not REPORTS[name].volatile:  # what is printed is fresh
                    self.assertEqual(printed(reports, name), printed(reports, name).rstrip())
                for figure in getattr(module(name), "FIGURES", {}):
                    self.assertIsNotNone(reports.figure(name, figure))
                self.assertEqual(reports.get(name)["measured"]["command"], REPORTS[name].command)
                self.assertTrue(sources.files_of(ROOT, REPORTS[name].sources))


if __name__ == "__main__":
    unittest.main(verbosity=2)
