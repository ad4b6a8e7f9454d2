"""make -C lab formal on a small copy of the tree: what it proves, refutes, refuses, keeps and reports.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import io
import json
import re
import shutil
import subprocess

import pytest

from lab.formal import proofs
from tools.project_root import ROOT
from tools.rtl import rtl_sources
from tools.tables import registers

SOURCE, HARNESSED = "rtl/stream/ffd_stream_count.v", "lab/formal/formal_count.v"
COUNTER = """\
`default_nettype none
module ffd_stream_count (
  input  wire       clk,
  input  wire       rst,
  input  wire       step_i,
  output reg  [3:0] count_o
);
  always @(posedge clk) begin
    if (rst) count_o <= 4'd0;
    else if (step_i && count_o != 4'd13) count_o <= count_o + 4'd1;
  end
endmodule
`default_nettype wire
"""
HARNESS = """\
`default_nettype none
module formal_count #(
  parameter MOST = 13
) (
  input wire clk,
  input wire rst,
  input wire step
);
  wire [3:0] count;
  ffd_stream_count u_dut (.clk(clk), .rst(rst), .step_i(step), .count_o(count));
  reg first_q = 1'b1;
  always @(posedge clk) first_q <= 1'b0;
  always @* if (first_q) assume (rst);
  always @* if (!first_q) begin
    bound: assert (count <= MOST);
    narrow: assert (count[3:1] != 3'd7);
    loose: assert (count < 15);
  end
endmodule
`default_nettype wire
"""
GOOD = ("ffd_stream_count", "bound", "formal_count", "MOST=13", "pdr", "", "ffd_stream_count",
        "!= 4'd13", "!= 4'd12 || step_i", "The count is at most MOST.")


def row(**changes):
    return tuple({**dict(zip(proofs.COLUMNS, GOOD)), **changes}.values())


@pytest.fixture
def table(checkout):
    """Writes the table of properties."""
    checkout.put({"rtl/hwffd.f": "stream/ffd_stream_count.v\n", SOURCE: COUNTER,
                  HARNESSED: HARNESS})

    def put(*rows):
        text = io.StringIO()
        csv.writer(text, lineterminator="\n").writerows([proofs.COLUMNS, *rows])
        checkout.put({"lab/formal/properties.csv": text.getvalue()})
    put(GOOD)
    return put


@pytest.fixture
def formal(checkout, table):
    def run(*words):
        status, out, errors = checkout.module("lab.formal", "--root", checkout.root, "-j1", "--limit", "10", *words)
        return status, out.splitlines(), errors.splitlines()
    return run


@pytest.fixture
def report(checkout):
    return lambda: json.loads(checkout.text("build/reports/formal.json"))["properties"]


@pytest.fixture
def refused(formal):
    def check(word):
        status, _, (error,) = formal()
        assert status == 1 and word in error
    return check


def test_proved_by_either_method_and_kept(checkout, table, formal, report):
    table(GOOD, row(name="narrow", method="induction", mutant="!= 4'd12"),
          row(name="loose", lemmas="bound"))
    status, _, (error,) = formal()
    assert status == 1 and "narrow: the planted bug is not found" in error
    table(GOOD, row(name="narrow", method="induction", original="count_o <= 4'd0;",
                    mutant="count_o <= 4'd14;"), row(name="loose", lemmas="bound"))
    status, lines, errors = formal()
    assert (status, errors) == (0, []), lines
    assert [(row["name"], row["result"], row["negative_control"]) for row in report()] == [
        (name, "proved", "refuted") for name in ("bound", "narrow", "loose")]
    assert "3 of 3 properties" in checkout.text("build/reports/formal.md")
    assert "formal: 3 properties, 3 of them unchanged" in formal()[1]
    for name, text, unchanged in ((SOURCE, COUNTER + "// a comment\n", 1),
                                  (SOURCE, COUNTER + "`default_nettype wire\n", 0),
                                  (HARNESSED, HARNESS + "`default_nettype wire\n", 0)):
        checkout.put({name: text})
        line = f"formal: 1 properties, {unchanged} of them unchanged"
        assert line in formal("--only", "*.bound")[1]
    assert {path.suffix for path in (checkout.root / "build/formal").iterdir()} == {
        ".said", ".seconds", ".log"}


def test_a_proof_that_was_broken_off_is_made_again(checkout, table, formal):
    table(GOOD)
    assert formal()[0] == 0
    (said,) = (checkout.root / "build/formal").glob("*.proof.said")
    said.write_text("")
    said.with_suffix(".seconds").unlink()
    status, lines, errors = formal()
    assert (status, errors) == (0, []) and "formal: 1 properties, 0 of them unchanged" in lines, lines


def test_a_module_of_the_harness_takes_the_place_of_its_namesake(checkout, table, formal, report):
    """As tokens take that of arithmetic: with another counter behind the one under proof it is refuted."""
    inner = "module ffd_stream_most (output wire [3:0] most_o);\n  assign most_o = 4'd{};\nendmodule\n"
    outer = COUNTER.replace("  always", "  wire [3:0] most;\n  ffd_stream_most u_most (.most_o(most));\n  always")
    checkout.put({"rtl/hwffd.f": "stream/ffd_stream_count.v\nstream/ffd_stream_most.v\n",
                  SOURCE: outer.replace("!= 4'd13", "!= most"), "rtl/stream/ffd_stream_most.v": inner.format(13)})
    table(row(original="!= most", mutant="!= 4'd14"))
    for stands_in, status in ((13, 0), (12, 0), (14, 1)):
        checkout.put({HARNESSED: inner.format(stands_in) + HARNESS})
        assert formal()[0] == status
    assert report()[0]["result"] == "refuted"


def test_a_report_that_came_with_the_checkout_proves_nothing(checkout, table, formal, report):
    table(GOOD)
    formal()
    checkout.put({"docs/results/1.0.0/formal.json": checkout.text("build/reports/formal.json")})
    for unchanged in (1, 0):
        assert f"formal: 1 properties, {unchanged} of them unchanged" in formal()[1]
        assert report()[0]["result"] == "proved"
        shutil.rmtree(checkout.root / "build/formal")


def test_wrong_property_is_refuted(table, refused, report):
    table(row(parameters="MOST=12"))
    refused("ffd_stream_count, bound: refuted")
    assert (report()[0]["result"], report()[0]["broken_at_clock"]) == ("refuted", 14)


def test_induction_does_not_prove_what_breaks_after_its_base(table, refused):
    table(row(parameters="MOST=12", method="induction"))
    refused("ffd_stream_count, bound: undecided")


def test_lemma_that_does_not_hold(table, formal):
    table(row(name="narrow", parameters="MOST=12", lemmas="bound"), row(parameters="MOST=12"))
    status, _, errors = formal()
    assert (status, len(errors)) == (1, 2)
    assert "narrow: lemma bound is not proved" in errors[0]


def test_harmless_bug_is_not_found(table, refused):
    table(row(mutant="!= 4'd12"))
    refused("the planted bug is not found (undecided)")


@pytest.mark.parametrize("change, word", (
    ({"original": "!= 4'd7"}, "0 times in ffd_stream_count.v, not once"),
    ({"original": "count_o"}, "5 times in ffd_stream_count.v, not once"),
    ({"mutant": "!="}, "syntax error"),
    ({"original": "count_o <= 4'd0", "mutant": "count_o <= none"}, "none")))
def test_planted_bugs_that_are_refused(table, refused, report, change, word):
    table(row(**change))
    refused(word)
    assert report()[0]["result"] == "error"


def test_harnesses_that_are_refused(checkout, table, refused):
    table(row(name="other"))
    refused("the harness has not exactly one assertion of this name")
    table(row(harness="formal_other"))
    refused("no harness lab/formal/formal_other.v")
    table(GOOD)
    checkout.put({HARNESSED: HARNESS.replace(
        "wire [3:0] count;", "wire [3:0] count;\n  (* hierconn *) wire \\u_dut.none_q ;"
    ).replace("count <= MOST", "\\u_dut.none_q ")})
    refused("no driver")


@pytest.mark.parametrize("rows, word", (
    ((GOOD[:-1],), "row 2: 9 columns, not 10"), ((GOOD, GOOD), "bound is there twice"),
    ((row(method="luck"),), "none of pdr, scorr, induction"),
    ((row(mutant="!= 4'd13"),), "the planted bug changes nothing"),
    ((row(parameters="MOST=a"),), "are not NAME=NUMBER"),
    ((row(lemmas="bound"),), "lemma 'bound' is no property"),
    ((row(statement=""),), "no statement"),
    ((row(module="ffd_stream_other"),), "ffd_stream_other is not in rtl/hwffd.f")))
def test_tables_that_are_refused(table, refused, rows, word):
    table(*rows)
    refused(word)


def test_another_head_and_bad_requests(checkout, table, formal, refused):
    checkout.put({"lab/formal/properties.csv": "module,name\n"})
    refused("the first line must be module,name,harness")
    table(GOOD)
    assert formal("--only", "x*")[0] == formal("--limit", "x")[0] == 2


SOURCES = rtl_sources.Sources(ROOT)
SHARED = "".join(path.read_text() for path in (ROOT / "lab/formal").glob("properties_*.v"))


@pytest.mark.parametrize("prop", proofs.read(ROOT / "lab/formal/properties.csv"),
                         ids=lambda prop: prop.full_name)
def test_rows_of_this_tree(prop):
    assert prop.module in SOURCES.files
    assert SOURCES.files[prop.file].read_text().count(prop.original) == 1
    text = (ROOT / "lab/formal" / f"{prop.harness}.v").read_text() + SHARED
    assert re.search(rf"\b{re.escape(prop.name.split('.')[-1])}: +assert", text)


def test_what_software_only_reads_is_at_rest_in_each_harness():
    connections = proofs.registers_at_rest(registers.read(ROOT)).splitlines()
    assert {".limits_in_flight_i(16'd0),", ".features_pages_i(1'd0),", ".wait_read_i(32'd0),"} <= set(connections)
    assert len(set(connections)) == len(connections) and "status" not in "".join(connections)
    for path in (ROOT / "lab/formal").glob("*.v"):
        text = path.read_text()
        assert ("registers_at_rest.vh" in text) == bool(re.search(r"^ +ffd_bus_registers ", text, re.MULTILINE)), path


def test_what_changed_last_is_proved_first(checkout, table, formal):
    """Two modules change in two commits: within no time only the later one is tried, and what is left is counted."""
    other = {"rtl/stream/ffd_stream_other.v": COUNTER.replace("ffd_stream_count", "ffd_stream_other"),
             "lab/formal/formal_other.v": HARNESS.replace("ffd_stream_count", "ffd_stream_other")
                                                 .replace("formal_count", "formal_other")}
    checkout.put({"rtl/hwffd.f": "stream/ffd_stream_count.v\nstream/ffd_stream_other.v\n", **other})
    table(GOOD, ("ffd_stream_other", "bound", "formal_other", *GOOD[3:6], "ffd_stream_other", *GOOD[7:]))

    def commit():
        for words in (("add", "-A"), ("-c", "user.name=t", "-c", "user.email=t@t", "commit", "-qm", "t")):
            subprocess.run(["git", "-C", checkout.root, *words], check=True)
    subprocess.run(["git", "-C", checkout.root, "init", "-q"], check=True)
    commit()
    assert formal("--since", "HEAD")[:2] == (0, ["formal: nothing under proof has changed since HEAD"])
    for name, text in ((SOURCE, COUNTER), *list(other.items())[:1]):
        checkout.put({name: text + "`default_nettype wire\n"})
        commit()
    status, lines, errors = formal("--since", "HEAD~2", "--minutes", "0")
    assert (status, errors) == (0, [])
    assert "formal: 1 of 1 properties proved, each with its planted bug found" in lines
    assert "formal: 1 that changed earlier were not tried: 0 minutes were up" in lines
    assert "formal: 2 of 2 properties proved, each with its planted bug found" in formal("--since", "HEAD~2")[1]
