"""Blocks of texts: what stands in them, what is refused, and results that may not be mixed.

SPDX-License-Identifier: Apache-2.0
"""

import re

import pytest

from tools.project_root import ROOT
from tools.reports import report_modules, results, text_blocks, text_expressions

RUNS = {"model": "cat.3ds", "runs": [
    {"org": "basic", "format": "fp32", "deform": "twist:90", "max_error": 1.5994e-07, "checked": 7340,
     "ok": True, "operators": {"mul": 8}, "used": [63, 128]},
    {"org": "basic", "format": "fx18", "deform": "random:1", "max_error": 1.01e-04, "checked": 7340,
     "ok": False, "operators": {"mul": 9}, "used": [1, 2]},
    {"org": "a b, c", "format": "fx18", "deform": "none", "max_error": None, "checked": 12,
     "ok": True, "operators": {"mul": 7}, "used": [1, 2]}]}
RELEASE = {"version": "1.0.0", "mixed": False, "commit": "abc", "studies": {"sim": {}}}
CLOSING = "Measured with 1.0.0."


class Sim:
    """A module of that report."""

    TABLES = {}
    FIGURES = {"runs": lambda reports: len(reports.rows("sim"))}


@pytest.fixture
def blocks(checkout):
    """The texts of a checkout with one release."""
    checkout.put({"docs/results/1.0.0/sim.json": {**RUNS, "commit": "abc"},
                  "docs/results/1.0.0/release.json": RELEASE})
    return text_blocks.Blocks(checkout.root, {**report_modules.MODULES, "sim": Sim})


@pytest.fixture
def data(blocks):
    return results.released(blocks.root, "1.0.0", blocks.modules)


@pytest.mark.parametrize("what, wanted", (
    ("sim.model", "cat.3ds"), ("sim.runs", "3"),
    ("sim.max_error[format=fp32]", "1.6e-07"),
    ("sim.max_error[format=fp32]:.2e", "1.60e-07"),
    ("sim.checked[org=basic]", "7,340"),
    ("sim.max_error[deform=none]:.2e", "-"),
    ("sim.ok[deform=none]", "yes"),
    ('sim.checked[org="a b, c"]', "12"),
    ("sim.checked[format=fp32,fx18 org!=basic]", "12"),
    ("sim.operators.mul[deform=twist:90]", "8"),
    ("sim.used.0[format=fp32] / sim.used.1[format=fp32]:.0%", "49%"),
    ("sum(sim.checked)", "14,692"), ("count(sim.checked[format=fx18])", "2"),
    ("max(sim.max_error[format=fx18]):.1e", "1.0e-04"),
    ("sim.checked[deform=none] / sim.checked[format=fp32]:.4f", "0.0016")))
def test_what_is_written(data, what, wanted):
    assert text_expressions.written(data, what) == wanted


def sentence(blocks, *lines):
    """What becomes of a template, or what is wrong with it."""
    opening = "<!-- results 1.0.0: template\n" + "\n".join(lines) + "\n-->\n"
    after, faults = blocks.fill(opening + "<!-- end results -->\n")
    assert blocks.fill(after) == (after, faults)
    return faults[0][1] if faults else after.removeprefix(opening).removesuffix("<!-- end results -->\n")


@pytest.mark.parametrize("what, complaint", (
    ("sim.nothing", "sim.json has no nothing"),
    ("sim.nothing[format=fp32]", "rows of sim have no nothing"),
    ("sim.checked[format=fx18]", "2 rows that differ"),
    ("sim.checked[format]", "'format' is not KEY=VALUE"),
    ("sum(sim.checked", "a bracket is missing"),
    ("nothing.model", "'nothing.model' is of no report"), ("sim", "is not REPORT.FIELD"),
    ("sim.model:.2f", "does not write"), ("sim.model * 2", "what is ' * 2'"),
    ("tests.tests", "docs/results/1.0.0/tests.json is not there"),
    ("sim.checked[format=fx99]", "sim.json has no row format=fx99")))
def test_what_is_refused(blocks, what, complaint):
    assert complaint in sentence(blocks, f"a {{{what}}} b")


def test_sentences_and_tables_of_a_template(blocks):
    assert sentence(blocks, "It moves {sum(sim.checked)}", "vertices.") == f"It moves 14,692\nvertices.\n{CLOSING}\n"
    assert sentence(blocks, "| a |", "| --: |", "| {sim.runs} |") == f"| a |\n| --: |\n| 3 |\n\n{CLOSING}\n"


@pytest.mark.parametrize("text, complaint", (
    ("<!-- results 1.0.0: sim.rows -->\nno end\n", "other half"), ("<!-- end results -->\n", "other half"),
    ("a <!--= sim.model -->cat.3ds<!--/--> b", "other half"), ("<!-- figures: sim.rows -->", "other half"),
    ("<!-- results: sim.rows -->\n<!-- end results -->", "names its version"),
    ("<!-- results 1.0.1: sim.rows -->\n<!-- end results -->", "1.0.1 has no results: one of 1.0.0, or make -C lab results"),
    ("<!-- results 1.0.0: sim.rows org=x\na | org\n-->\n<!-- end results -->", "the table has no rows"),
    ("<!-- results 1.0.0: sim.rows -->\n<!-- end results -->", "each column is a line"),
    ("<!-- results 1.0.0: sim.none -->\n<!-- end results -->", "sim has no table 'none'"),
    ("<!-- results 1.0.0: none.rows -->\n<!-- end results -->", "'none' is of no report"),
    ("<!-- results 1.0.0: none -->\n<!-- end results -->", "is not REPORT.TABLE")))
def test_blocks_that_are_refused(blocks, text, complaint):
    after, faults = blocks.fill(f"\n{text}\n")
    assert (after, faults[0][0]) == (f"\n{text}\n", 2)
    assert complaint in faults[0][1]


def test_an_example_between_fences_stays(blocks):
    text = "```markdown\n<!-- results 9.9.9: sim.runs -->\n```\n"
    assert blocks.fill(text) == (text, [])


def test_rows_of_a_report(blocks):
    opening = "sim.rows org=basic\nformat | format\nerror | max_error:.1e\n"
    assert blocks.fill(f"<!-- results 1.0.0: {opening}-->\n| old |\n<!-- end results -->\n") == (
        f"<!-- results 1.0.0: {opening}-->\n| format | error |\n| --- | --: |\n"
        f"| fp32 | 1.6e-07 |\n| fx18 | 1.0e-04 |\n\n{CLOSING}\n<!-- end results -->\n", [])


def test_what_only_others_know_is_left_to_them(blocks):
    partly = text_blocks.Blocks(blocks.root, report_modules.MODULES, partly=True)
    for what in ("theorems.bugs", "template\n{theorems.good}\n"):
        text = f"<!-- results 1.0.0: {what}-->\n| old |\n<!-- end results -->\n".replace("bugs-->", "bugs -->")
        assert partly.fill(text) == (text, [])
        assert "is of no report" in blocks.fill(text)[1][0][1]


def test_every_port_and_parameter_needs_a_meaning():
    blocks = text_blocks.Blocks(ROOT, report_modules.MODULES)

    def filled(opening, *lines):
        text = "\n".join([f"<!-- sources: {opening} -->", *lines, "<!-- end sources -->", ""])
        after, faults = blocks.fill(text)
        return after, "; ".join(message for _, message in faults)

    sheet = (ROOT / "docs" / "datasheet.md").read_text()
    rows = re.search(r"<!-- sources: rtl.ports hwffd_stream -->\n(.*?)<!-- end", sheet, re.DOTALL)[1].splitlines()[2:]
    short = [re.sub(r" \|.*\| ", " | ", row) for row in rows]
    after, fault = filled("rtl.ports hwffd_stream", *short)
    assert (after.splitlines()[3:-1], fault) == (rows, "")
    assert "hwffd_stream.aresetn has no meaning" in filled("rtl.ports hwffd_stream", short[0], *short[2:])[1]
    assert "hwffd_stream.aresetn has no meaning" in filled("rtl.ports hwffd_stream", *short[:1], "| `aresetn` | |", *short[2:])[1]
    assert "hwffd_stream.aclk has 2 meaning" in filled("rtl.ports hwffd_stream", short[0], *short)[1]
    assert "hwffd_stream has no nothing_i" in filled("rtl.ports hwffd_stream", *short, "| `nothing_i` | x |")[1]
    assert "of both directions" in filled("rtl.ports hwffd_stream", short[0].replace("`aclk`", "`aclk`, `idle_o`"),
                                          *(row for row in short[1:] if "idle_o" not in row))[1]
    assert "hwffd_stream.ORG has no meaning" in filled("rtl.parameters hwffd_stream", "| `LATENCY` | x |")[1]


def test_a_text_that_differs_is_named_and_written(checkout, blocks):
    block = "<!-- results 1.0.0: template\nat most {sim.max_error[format=fp32]:.2e}\n-->\nat most {}\n" + CLOSING
    text = "# t\n\n" + block + "\n<!-- end results -->\n"
    checkout.put({"README.md": text.replace("{}", "1.61e-07")})
    count, (line,) = blocks.check()
    assert count == 1
    assert line == "README.md:6: not what the results say: 'at most 1.61e-07', 'at most 1.60e-07' wanted: python3 -m tools.reports.write_blocks"
    assert blocks.write() == ([checkout.root / "README.md"], [])
    assert checkout.text("README.md") == text.replace("{}", "1.60e-07")
    assert blocks.check() == (1, [])


def test_texts_of_the_next_release(checkout, blocks):
    checkout.put({"README.md": "<!-- results 1.0.0: template\n{sim.runs} runs.\n-->\n<!-- end results -->\n",
                  "docs/results/1.0.10/sim.json": RUNS, "docs/results/1.0.11/sim.json": RUNS,
                  "docs/results/1.0.10/release.json": {"version": "1.0.10", "mixed": True, "why": "a trial"}})
    blocks.write("1.0.10")
    assert checkout.text("README.md").endswith(
        "-->\n3 runs.\nMeasured with 1.0.10 (several commits).\n<!-- end results -->\n")
    assert results.versions(checkout.root) == ["1.0.0", "1.0.10"]
    assert results.released(checkout.root).folder.name == "1.0.10"


@pytest.mark.parametrize("release, message", (
    ({}, ""), ({"mixed": True, "why": "measured one by one"}, ""), ({"mixed": True}, "is mixed and does not say why"),
    ({"commit": "abd"}, "sim.json is of another commit than abd: measure all with make -C lab results"),
    ({"version": "1.0.1"}, "says version 1.0.1"), ({"studies": {"words": {}}}, "words.json: cannot be read")))
def test_results_of_several_commits_say_so(checkout, blocks, release, message):
    checkout.put({"docs/results/1.0.0/release.json": {**RELEASE, **release}})
    complaints = text_blocks.releases(checkout.root)
    assert len(complaints) == bool(message)
    if message:
        assert complaints[0].startswith("docs/results/1.0.0/release.json: ") and message in complaints[0]


def test_without_results():
    with pytest.raises(results.RequestError, match="docs/results has no results: make -C lab results"):
        results.released("/nowhere")


def test_the_gate(checkout, blocks):
    """python3 -m tools.checks.lint --text says what is wrong with texts and with releases."""
    checkout.link("rtl", "geometry")
    checkout.copy("VERSION")
    checkout.put({"README.md": "# t\n\n<!-- results 1.2.0: synth.cores -->\n<!-- end results -->\n",
                  "docs/results/1.0.0/release.json": {**RELEASE, "commit": "abd"}})
    status, out, errors = checkout.module("tools.checks.lint", "--text", "--root", ".")
    assert (status, errors) == (1, "")
    assert "README.md:3: 1.2.0 has no results: one of 1.0.0, or make -C lab results" in out
    assert "sim.json is of another commit than abd" in out
