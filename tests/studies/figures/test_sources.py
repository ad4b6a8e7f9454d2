"""The hash of sources: what changes it, and what does not.

SPDX-License-Identifier: Apache-2.0
"""

import unittest

from checkout import ROOT, Checkout  # first: it says where the others are
import digest
from figures import sources
from figures.catalogue import REPORTS

MODULE = """`include "m.vh"
module ffd_a (input wire clk);  // a comment
  wire [`WIDTH-1:0] a = 0; /* another
  over lines */
  wire [7:0] s = "a // b";
endmodule
"""


class Keys(Checkout):
    def key_of(self, *patterns):
        """As another run would find it: a run reads each file once."""
        for function in (digest.tokens, digest.cpp, digest.lines):
            function.cache_clear()
        return sources.key(self.root, patterns)


class Verilog(Keys):
    def setUp(self):
        super().setUp()
        self.put("rtl/one/m.vh", "`define WIDTH 8\n`define PORT input wire clk\n")
        self.put("rtl/one/ffd_a.v", MODULE)
        self.put("rtl/one/ffd_b.v", "module ffd_b; endmodule\n")
        self.before = self.key()

    def key(self):
        return self.key_of("rtl/**/*.v")

    def changed(self, *replaced, name="rtl/one/ffd_a.v", text=MODULE):
        for before, after in replaced:
            self.assertIn(before, text)
            text = text.replace(before, after)
        self.put(name, text)
        return self.key() != self.before

    def test_what_means_the_same(self):
        for before, after in (("a comment", "other words"), ("  wire [7:0] s", "\n\twire [7:0]  s"),
                              ("/* another\n  over lines */", ""), ("`WIDTH", "8"),
                              ("input wire clk", "`PORT")):
            with self.subTest(after):
                self.assertFalse(self.changed((before, after)))

    def test_text_moved_into_an_include(self):
        self.put("rtl/one/body.vh", "  wire [`WIDTH-1:0] a = 0;\n")
        self.assertFalse(self.changed(
            ("  wire [`WIDTH-1:0] a = 0; /* another\n  over lines */", '`include "body.vh"')))

    def test_a_module_moved_to_another_folder(self):
        (self.root / "rtl/two").mkdir()
        (self.root / "rtl/one/ffd_b.v").rename(self.root / "rtl/two/ffd_b.v")
        self.assertEqual(self.key(), self.before)

    def test_what_means_something_else(self):
        self.assertTrue(self.changed(("a = 0", "a = 1")))
        self.assertTrue(self.changed(("a // b", "a // c")))
        self.put("rtl/one/ffd_a.v", MODULE)
        self.assertEqual(self.key(), self.before)
        self.assertTrue(self.changed(("8", "9"), name="rtl/one/m.vh", text="`define WIDTH 8\n"))

    def test_no_such_sources(self):
        with self.assertRaisesRegex(sources.SourceError, "no sources are rtl/nothing"):
            self.key_of("rtl/nothing/*.v")


class Others(Keys):
    def key(self, name, text):
        self.put(name, text)
        return self.key_of(name)

    def test_cpp(self):
        before = self.key("a.cpp", '#include "a.hpp"\nint a = f("// no comment");  // but this\n')
        for text in ('int a = f("// no comment");\n', 'int a =\n  f("// no comment"); /* x */'):
            self.assertEqual(self.key("a.cpp", text), before)
        self.assertNotEqual(self.key("a.cpp", 'int a = f("// a comment");\n'), before)

    def test_other_texts_by_their_lines(self):
        before = self.key("a.ys", "synth -top a\nabc\n")
        self.assertEqual(self.key("a.ys", "# a comment\nsynth -top a\n\nabc"), before)
        self.assertNotEqual(self.key("a.ys", "synth -top a -flatten\nabc\n"), before)

    def test_of_the_table_what_the_rtl_gets(self):
        table = (ROOT / "rtl/configurations.csv").read_text(encoding="utf-8")
        before = self.key("rtl/configurations.csv", table)
        self.assertEqual(self.key("rtl/configurations.csv", table.replace(",sim", ",test")),
                         before)
        self.assertNotEqual(self.key("rtl/configurations.csv",
                                        table.replace("overlapped,pipelined,4,4,0",
                                                      "overlapped,pipelined,5,4,0")), before)


class Catalogue(unittest.TestCase):
    def test_every_report_has_sources(self):
        for name, report in REPORTS.items():
            with self.subTest(name):
                self.assertRegex(sources.key(ROOT, report.sources), "^[0-9a-f]{16}$")


if __name__ == "__main__":
    unittest.main(verbosity=2)
