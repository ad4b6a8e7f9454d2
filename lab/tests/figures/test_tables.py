"""Tables and what follows from reports, of reports made up here.

SPDX-License-Identifier: Apache-2.0
"""

import copy
import re

import pytest
import samples
from figures import check, markers, sources, table
from figures.catalogue import CHARTS, REPORTS, missing, module, printed
from figures.reports import FRESH, RequestError
from figures.studies import energy, organizations, streams, synth, throughput, words
from rtl import ROOT


def test_columns_of_numbers_stand_on_the_right():
    made = table.Table(["a", "b", "c", "d"],
                       [["`x`", "1,234", "-", "14 + 12"], ["y z", "2.3e-07", "", "0 of 60,012"]])
    assert made.markdown().splitlines()[1] == "| --- | --: | --- | --: |"
    assert made.text().splitlines() == [
        "a          b  c            d", "x      1,234  -      14 + 12",
        "y z  2.3e-07     0 of 60,012"]
    assert table.Table(["a"], []).markdown() == "| a |\n| --- |"


def test_which_word_suffices(reports):
    data = reports(words=samples.WORDS)
    assert {name: data.figure("words", name) for name in words.FIGURES} == {
        "half_pixel_measured": 18, "half_pixel_proved": 20, "as_binary32_sequence": 27,
        "as_binary32_tree": 28, "vertices": 1000}
    text = words.printed(data)
    assert "in sequence: 27 bits by max, 27 by rms; as its tree: 28 and 28" in text
    assert "(2.44e-04): 18 bits measured, 20 bits proved" in text
    assert words.shortest([], "product", "bound", 1) is None


def test_what_the_rtl_took(reports):
    assert "resident        file   equal" in streams.printed(reports(streams=samples.STREAMS))
    wrong = copy.deepcopy(samples.STREAMS)
    wrong["rows"][-1]["beats_counted"] = 81
    text = streams.printed(reports(streams=wrong))
    assert (text.count("NOT EQUAL"), text.count("not built")) == (1, 4)


def test_words_of_one_mesh(reports):
    made = streams.words(reports(streams=samples.STREAMS), "horse.3ds")
    assert made.heads[2:] == ["4x4x4", "16x16x16"]
    assert made.rows[-1] == ["resident", "file", "4.05", "8.09"]


ENERGY = {"volts": 1.8, "period_ns": 10, "rows": [
    {"name": name, "device": "cells", "cells": 50000, "clocks_per_vertex": 64.0, "compared": 7,
     "energy_nj_per_vertex": spent, "clock_nj": spent / 2, "glitches_nj": spent / 5,
     "leakage_nj": spent / 100, "toggles_per_clock": 0.3351} for name, spent in (
         ("affine64-fx17-overlapped", 200.0), ("basic-fx18-overlapped", 300.0),
         ("cg1-fx18-overlapped", 250.0))]}


def test_energies_and_their_shares(reports):
    data = reports(energy=ENERGY)
    assert energy.evaluators(data).rows[0] == [
        "`affine64-fx17-overlapped`", "50,000", "64", "200.0", "50%", "20%", "0.34", "7"]
    assert (data.figure("energy", "least_name"), data.figure("energy", "most_nj")) == (
        "affine64-fx17-overlapped", 300)
    assert data.figure("energy", "clock_least") == data.figure("energy", "clock_most") == 0.5
    assert not missing(data, "energy")
    assert missing(reports(energy={**ENERGY, "rows": ENERGY["rows"][:2]}), "energy") == "rows"


@pytest.fixture
def data(reports):
    return reports(organizations=samples.ORGANIZATIONS, synth=samples.SYNTH, pnr=samples.PNR)


def test_a_line_for_each_organization(data):
    made = organizations.clocks(data)
    assert [line[0] for line in made.rows] == ["`basic`", "`tree 8`", "`parallel`", "`nested`"]
    assert made.rows[0][1:] == ["96", "96", "-", "4 + 3", "64 + 48", "64", "8 + 6", "2.31e-07",
                                "8.65e-05", "-"]
    assert made.rows[3][1:3] == ["-", "-"]


def test_units_of_organizations_that_are_named(data):
    assert organizations.units(data, "tree8", "nested").rows == [
        ["`tree 8`", "96", "4 + 3", "8", "8 + 6"], ["`nested`", "-", "-", "1", "8 + 6"]]
    alone = organizations.units(data, "nested")
    assert (alone.heads, alone.rows) == (["organization", "cycles per vertex", "multipliers + adders"],
                                         [["`nested`", "1", "8 + 6"]])
    with pytest.raises(RequestError, match="no organization 'tree9' in fx18 or fx17"):
        organizations.units(data, "tree9")


@pytest.mark.parametrize("name, value", (
    ("rows_measured", 7), ("results_checked", 70), ("watertight_rows", 6),
    ("watertight_differences", 0), ("nested_seam_fx18", 14.0)))
def test_figures_of_organizations(data, name, value):
    assert data.figure("organizations", name) == value


def test_what_is_wrong_is_seen(data, reports):
    assert "NO" not in organizations.printed(data)
    wrong = copy.deepcopy(samples.ORGANIZATIONS)
    wrong["rows"][1]["equal"] = wrong["rows"][4]["equal_overlapped"] = False
    assert organizations.printed(reports(organizations=wrong)).count("NO ") == 2


def test_a_finished_report_has_the_targets_of_each_row(checkout, data):
    rows = organizations.finished(data)["rows"]
    assert rows[0]["targets"] == {}
    assert set(rows[1]["targets"]) == {"ecp5", "generic"}
    assert rows[1]["targets"]["ecp5"]["vertices_per_s"] == 100e6 / 64
    checkout.put({"docs/reports/synth.json": None})
    assert "targets" not in organizations.finished(data)["rows"][1]
    assert organizations.printed(data).endswith(
        "no areas: make synth writes build/reports/synth.json")


def test_a_report_that_is_not_whole(checkout, data):
    checkout.link("rtl")
    assert re.search("^[0-9]+ rows, the first basic-fp32-paper", organizations.missing(data))


def test_the_table_of_results_joins_three_reports(reports):
    cores = [samples.mapped(name, lut, top="hwffd_stream", dsp=11)
             for name, lut in (("basic-fx18-overlapped", 1500), ("tree8-fx18-overlapped", 1900))]
    clock = {**samples.PNR["rows"][0], "top": "hwffd_stream", "fmax_mhz": 110.0}
    data = reports(organizations=samples.ORGANIZATIONS,
                   synth={**samples.SYNTH, "rows": [*samples.SYNTH["rows"], *cores]},
                   pnr={**samples.PNR, "rows": [*samples.PNR["rows"], clock]})
    made = markers.table(data, "results.organizations")
    assert made.rows[0] == ["`basic`", "64", "11", "1,504", "504", "-", "-", "-", "8.7e-05"]
    bounds = {"rows": [{"form": form, "format": word, "bound": bound, "hypothesis": ""}
                       for form, word, bound in (("product", "fx18", 7e-4), ("product", "fx18", 6e-4),
                                                 ("product", "fx32", 5e-4), ("nested", "fx18", 4e-4))]}
    data = reports(organizations=samples.ORGANIZATIONS, synth=samples.SYNTH, pnr=samples.PNR, bounds=bounds)
    assert [row[-2] for row in markers.table(data, "results.organizations basic nested").rows] == [
        "6.0e-04", "4.0e-04"]
    assert made.rows[1][5:7] == ["110.0", "13.75"]
    assert [line[0] for line in markers.table(data, "results.organizations tree8 nested").rows] == [
        "`tree 8`", "`nested`"]


def test_a_clock_with_a_remark_gives_no_vertices_a_second(reports):
    rows = [samples.mapped("basic-fx18-overlapped", 500, target="gw5a", remark="unknown")]
    data = reports(organizations=samples.ORGANIZATIONS, synth={**samples.SYNTH, "rows": rows})
    one, = throughput.throughputs(data)
    assert (one.per_second, one.rate) == (None, 1 / 64)


def test_rates(data):
    timed, untimed = (next(one for one in throughput.throughputs(data) if one.name == name)
                      for name in ("basic-fx18-overlapped", "nested-fx18-overlapped"))
    assert (timed.size, timed.unit, timed.multipliers) == (500, "LUTs", 8)
    assert timed.per_second == 100e6 / 64
    assert timed.per_size == 100e6 / 64 / 500
    assert timed.per_multiplier == 100e6 / 64 / 8
    assert (untimed.per_second, untimed.rate) == (None, 1)


def test_sizes_that_a_target_counts(data):
    assert [(one.size, one.unit, one.per_multiplier) for one in throughput.throughputs(data)
            if one.target == "generic"] == [(44000, "cells", None)]


def test_of_organizations_only_and_each_once(reports):
    rows = [*samples.SYNTH["rows"], samples.mapped("tree8-fx18-overlapped", 1, top="hwffd_axi"),
            samples.mapped("basic-fx18-paper", 1)]
    names = [(one.name, one.target) for one in throughput.throughputs(
        reports(organizations=samples.ORGANIZATIONS, synth={"rows": rows}))]
    assert len(names) == len(set(names)) == 6


def test_the_front_is_what_no_other_beats(data):
    found = [one for one in throughput.throughputs(data) if one.target == "ecp5"]
    assert [one.name for one in throughput.front(found)] == [
        "basic-fx18-overlapped", "tree8-fx18-overlapped", "parallel-fx18-overlapped",
        "nested-fx18-overlapped"]


@pytest.mark.parametrize("name, label", (("tree8-fx18-overlapped", "tree 8 fx18"),
                                         ("basic-fp32-overlapped-deep", "basic deep fp32")))
def test_labels(name, label):
    assert throughput.label(samples.organization(name, 1)) == label


def test_the_document_of_synth(reports):
    wired = samples.mapped("basic-fx18-overlapped-bspline", 250)
    report = {**samples.SYNTH, "rows": [*samples.SYNTH["rows"], wired], "wanted": 9,
              "failed": [{"name": "x", "top": "t", "target": "ecp5", "error": "latches"}]}
    text = synth.document(reports(synth=report))
    for line in ("2 of 9 rows have not been mapped", "Failed: x, t, ecp5: latches",
                 "## Lattice ECP5", "Binary32, `ffd_org_select`, units kept apart:",
                 "| row | LUT | LUT as memory | FF | MULT18X18D | DP16KD | depth | MHz |",
                 "|  | general / wired in | 2.00 | 1.00 |", "| `LUT4` | 500 | 900 |",
                 "Lattice ECP5, LUT, memory included:", "| `basic` | 504 | 954 |"):
        assert line in text


def test_the_price_of_a_feature_stands_beside_its_row(reports):
    core, few = (samples.mapped(name, lut, top="hwffd_stream", variant=variant, meaning=variant)
                 for name, lut, variant in (("cg1-fx18-overlapped", 2400, None),
                                            ("cg1-fx18-overlapped+few", 1700, "few")))
    data = reports(synth={**samples.SYNTH, "rows": [few, core]})
    assert [line[:3] for line in synth.prices(data).rows] == [
        ["`cg1-fx18-overlapped`, `hwffd_stream`", "as in the table", "2,400"],
        ["", "few", "1,700 (-700)"]]
    assert [line[0] for line in synth.cores(data).rows] == ["`cg1-fx18-overlapped`"]
    assert "## What features cost" in synth.document(data)


def test_what_ctest_wrote(checkout, reports):
    checkout.put({"build/reports/tests.xml": """<testsuite name="x"><testcase name="lint.a" time="1.5"
        status="run"/><testcase name="lint.b" time="0.25" status="fail"/>
        <testcase name="api.c.d" time="7" status="run"/></testsuite>"""})
    module("tests").collect(checkout.root)
    data = reports(FRESH)
    assert (data.figure("tests", "tests"), data.figure("tests", "failed"), data.figure("tests", "skipped")) == (3, 1, 0)
    assert markers.table(data, "tests.suites").rows == [["`api`", "1", "7"], ["`lint`", "2", "2"]]
    assert markers.table(data, "tests.longest").rows[0] == ["`api.c.d`", "7"]


@pytest.mark.parametrize("name", REPORTS)
def test_every_report_has_its_module(name):
    assert isinstance(module(name).TABLES, dict)
    assert {one for needed in CHARTS.values() for one in needed} <= set(REPORTS)


COMMITTED = check.Reports(ROOT)
PRESENT = [name for name in REPORTS if COMMITTED.has(name)]


@pytest.fixture(scope="module")
def listed():
    """What lint lists to be measured."""
    return check.check(ROOT)[2]


@pytest.mark.parametrize("name", PRESENT)
def test_committed_reports(listed, name):
    """Every table and figure can be made of each, and lint lists one that is not whole."""
    assert len(PRESENT) >= 5
    assert not missing(COMMITTED, name) or any(
        line.startswith(f"docs/reports/{name}.json ") for line in listed)
    if not REPORTS[name].volatile:  # what is printed is fresh
        assert printed(COMMITTED, name) == printed(COMMITTED, name).rstrip()
    for figure in getattr(module(name), "FIGURES", {}):
        assert COMMITTED.figure(name, figure) is not None
    assert COMMITTED.get(name)["measured"]["command"] == REPORTS[name].command
    assert sources.files_of(ROOT, REPORTS[name].sources)
