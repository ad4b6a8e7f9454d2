"""Figures between markers: what is put in, and what is wrong with a text.

SPDX-License-Identifier: Apache-2.0
"""

import pytest
from figures import check, markers
from rtl import ROOT

RUNS = {"model": "cat.3ds", "runs": [
    {"org": "basic", "format": "fp32", "deform": "twist:90", "max_error": 1.5994e-07, "checked": 7340,
     "ok": True, "operators": {"mul": 8}, "used": [63, 128]},
    {"org": "basic", "format": "fx18", "deform": "random:1", "max_error": 1.01e-04, "checked": 7340,
     "ok": False, "operators": {"mul": 9}, "used": [1, 2]},
    {"org": "a b, c", "format": "fx18", "deform": "none", "max_error": None, "checked": 12,
     "ok": True, "operators": {"mul": 7}, "used": [1, 2]}]}

DEFAULT = {"model": "cat.3ds", "runs": [row for row in RUNS["runs"][:2] for _ in range(6)]}


@pytest.fixture
def data(reports):
    return reports(sim=RUNS)


def written(data, what, before="?"):
    text, faults = markers.fill(f"x <!--= {what} -->{before}<!--/--> y", data)
    if faults:
        return faults[0].message
    return text.removeprefix(f"x <!--= {what} -->").removesuffix("<!--/--> y")


@pytest.mark.parametrize("what, wanted", (
    ("sim.model", "cat.3ds"),
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
    assert written(data, what) == wanted
    assert written(data, what, wanted) == wanted


@pytest.mark.parametrize("what, complaint", (
    ("sim.nothing", "sim.json has no nothing"),
    ("sim.nothing[format=fp32]", "rows of sim have no nothing"),
    ("sim.checked[format=fx18]", "2 rows that differ"),
    ("sim.checked[format]", "'format' is not KEY=VALUE"),
    ("sum(sim.checked", "a bracket is missing"),
    ("nothing.model", "nothing has no model"), ("sim", "is not REPORT.FIELD"),
    ("sim.model:.2f", "does not write"), ("sim.model * 2", "what is ' * 2'"),
    ("words.max_error", "no report yet: make words"),
    ("sim.checked[format=fx99]", "no report yet: make sim")))
def test_what_is_refused(data, what, complaint):
    assert complaint in written(data, what)


@pytest.mark.parametrize("text, complaint", (
    ("a <!--= sim.model --> never closed", "other half"), ("a <!--/--> b", "other half"),
    ("<!-- figures: sim.runs -->\nno end\n", "other half"),
    ("<!--= sim.model -->cat.3ds<!--/--> first", "begin a line")))
def test_markers_that_are_none(data, text, complaint):
    after, (fault,) = markers.fill(f"\n{text}\n", data)
    assert (after, fault.line) == (f"\n{text}\n", 2)
    assert complaint in fault.message


def test_an_example_between_fences_stays(data):
    text = "```markdown\n<!--= sim.model -->?<!--/-->\n<!-- figures: sim.runs -->\n```\n"
    assert markers.fill(text, data) == (text, [])


def test_rows_of_a_report(data):
    opening = "sim.rows org=basic\nformat | format\nerror | max_error:.1e\n"
    assert markers.fill(f"<!-- figures: {opening}-->\n| old |\n<!-- end figures -->\n", data) == (
        f"<!-- figures: {opening}-->\n| format | error |\n| --- | --: |\n"
        "| fp32 | 1.6e-07 |\n| fx18 | 1.0e-04 |\n<!-- end figures -->\n", [])


def fault_of(data, opening, *lines):
    """What is wrong with a table, '' if nothing."""
    end = "".join(f"\n{line}" for line in lines) + ("\n-->" if lines else " -->")
    _, faults = markers.fill(f"<!-- figures: {opening}{end}\n<!-- end figures -->\n", data)
    return "; ".join(fault.message for fault in faults)


@pytest.mark.parametrize("opening, complaint", (
    (("sim.nothing",), "sim has no table 'nothing'"), (("nothing.runs",), "is not REPORT.TABLE"),
    (("sim.rows org=x", "a | org"), "no rows of sim"), (("sim.rows",), "each column is a line"),
    (("words.lengths",), "no report yet: make words")))
def test_tables_that_are_refused(data, opening, complaint):
    assert complaint in fault_of(data, *opening)


def test_for_a_terminal(reports):
    streams = {"rows": [{"mesh": "cat.3ds", "arrangement": "resident", "order": "file",
                         "lattice": "4x4x4", "words_per_vertex": 4.0468}]}
    text, faults = markers.fill("<!-- figures: streams.words text -->\n<!-- end figures -->\n",
                                reports(streams=streams))
    assert faults == []
    assert ("\n    arrangement  order of vertices  4x4x4\n"
            "    resident     file                4.05\n") in text


def test_every_port_and_parameter_needs_a_meaning():
    data = check.Reports(ROOT)
    ports = ("a*: clock, reset", "s_axis_*: in", "m_axis_*: out", "event_*: event",
             "vertex_o: vertex", "wait_o: waits", "idle_o: idle", "upset_o: upset")
    assert fault_of(data, "rtl.ports hwffd_stream", *ports) == ""
    assert "hwffd_stream.aresetn has no meaning" in fault_of(
        data, "rtl.ports hwffd_stream", "aclk: clock")
    assert "hwffd_stream has no nothing_i" in fault_of(
        data, "rtl.ports hwffd_stream", *ports, "nothing_i: x")
    assert "has no LATENCY" in fault_of(data, "rtl.parameters hwffd_stream", "*: any", "LATENCY: x")


@pytest.fixture
def gate(checkout, reports):
    """The warnings of tools/lint --text that are about figures, and its exit status, of a README
    and a report of such sources."""
    checkout.link("rtl", "geometry", "apps")
    checkout.copy("VERSION")

    def lint(figure="1.60e-07", what="sim.max_error[format=fp32]:.2e", *words, key=""):
        measured = {"command": "make sim",
                    "sources": key or check.sources.key(ROOT, check.REPORTS["sim"].sources)}
        reports(sim={"measured": measured, **DEFAULT})
        checkout.put({"README.md": f"# t\n\nat most <!--= {what} -->{figure}<!--/-->\n"})
        status, out, errors = checkout.script("lint", "--text", "--root", ".", *words)
        assert errors == ""
        return [line for line in out.splitlines() if "figures" in line
                or "README.md" in line or "stale" in line], status
    return lint


def test_a_wrong_number_is_a_warning(gate):
    assert gate()[0] == []
    (line,), status = gate("1.61e-07")
    assert line.startswith("README.md:3: not what the report says: ") and "1.60e-07" in line
    assert status == 1


def test_a_marker_that_names_nothing_is_a_warning(gate):
    assert gate("1", "sim.speed")[0] == ["README.md:3: sim.json has no speed"]


def test_what_is_not_measured_is_named_with_its_command(gate):
    wanted = "words.max_error[format=fx18]"
    line = "README.md: no report yet: make words, in 1 places"
    assert gate("1", wanted)[0] == [f"lint: {line}"]
    assert line in gate("1", wanted, "--strict")[0]


def test_a_stale_report_is_named_with_its_command(gate):
    line = "docs/reports/sim.json is stale: make sim && tools/figures adopt sim"
    assert gate(key="0" * 16)[0] == [f"lint: {line}"]
    found = gate("1.60e-07", "sim.max_error[format=fp32]:.2e", "--strict", key="0" * 16)
    assert found == ([line], 1)
