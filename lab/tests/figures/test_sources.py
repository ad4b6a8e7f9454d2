"""The hash of sources: what changes it, and what does not.

SPDX-License-Identifier: Apache-2.0
"""

import re

import digest
import pytest
from figures import sources
from figures.catalogue import REPORTS
from rtl import ROOT

MODULE = """`include "m.vh"
module ffd_a (input wire clk);  // a comment
  wire [`WIDTH-1:0] a = 0; /* another
  over lines */
  wire [7:0] s = "a // b";
endmodule
"""


@pytest.fixture
def key(checkout):
    """Of these patterns, as another run would find it: a run reads each file once."""
    def found(*patterns):
        for function in (digest.tokens, digest.cpp, digest.lines):
            function.cache_clear()
        return sources.key(checkout.root, patterns)
    return found


@pytest.fixture
def changed(checkout, key):
    """Whether that of some Verilog is another with these words replaced, or with these files."""
    checkout.put({"rtl/one/m.vh": "`define WIDTH 8\n`define PORT input wire clk\n",
                  "rtl/one/ffd_a.v": MODULE, "rtl/one/ffd_b.v": "module ffd_b; endmodule\n"})
    before = key("rtl/**/*.v")

    def found(old="", new="", **files):
        assert old in MODULE
        checkout.put({"rtl/one/ffd_a.v": MODULE.replace(old, new) if old else MODULE, **files})
        return key("rtl/**/*.v") != before
    return found


@pytest.mark.parametrize("old, new, files", (
    ("a comment", "other words", {}), ("  wire [7:0] s", "\n\twire [7:0]  s", {}),
    ("/* another\n  over lines */", "", {}), ("`WIDTH", "8", {}), ("input wire clk", "`PORT", {}),
    ("  wire [`WIDTH-1:0] a = 0; /* another\n  over lines */", '`include "body.vh"',
     {"rtl/one/body.vh": "  wire [`WIDTH-1:0] a = 0;\n"}),
    ("", "", {"rtl/one/ffd_b.v": None, "rtl/two/ffd_b.v": "module ffd_b; endmodule\n"})))
def test_verilog_that_means_the_same(changed, old, new, files):
    assert not changed(old, new, **files)


@pytest.mark.parametrize("old, new, files", (
    ("a = 0", "a = 1", {}), ("a // b", "a // c", {}),
    ("", "", {"rtl/one/m.vh": "`define WIDTH 9\n"})))
def test_verilog_that_means_something_else(changed, old, new, files):
    assert changed(old, new, **files)
    assert not changed(**{"rtl/one/m.vh": "`define WIDTH 8\n"})


def test_no_such_sources(key):
    with pytest.raises(sources.SourceError, match="no sources are rtl/nothing"):
        key("rtl/nothing/*.v")


TABLE = (ROOT / "rtl/configurations.csv").read_text(encoding="utf-8")


@pytest.mark.parametrize("name, text, same, others", (
    ("a.cpp", '#include "a.hpp"\nint a = f("// no comment");  // but this\n',
     ('int a = f("// no comment");\n', 'int a =\n  f("// no comment"); /* x */'),
     'int a = f("// a comment");\n'),
    ("a.ys", "synth -top a\nabc\n", ("# a comment\nsynth -top a\n\nabc",),
     "synth -top a -flatten\nabc\n"),
    ("rtl/configurations.csv", TABLE, (TABLE.replace(",sim", ",test"),),
     TABLE.replace("overlapped,pipelined,4,4,0", "overlapped,pipelined,5,4,0"))),
    ids=("C++", "lines", "table"))
def test_other_texts(checkout, key, name, text, same, others):
    def of(content):
        checkout.put({name: content})
        return key(name)
    before = of(text)
    assert {of(one) for one in same} == {before}
    assert of(others) != before


@pytest.mark.parametrize("name", REPORTS)
def test_every_report_has_sources(name):
    assert re.fullmatch("[0-9a-f]{16}", sources.key(ROOT, REPORTS[name].sources))
