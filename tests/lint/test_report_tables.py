"""Tables of the product's reports and what follows from them, of reports made up here.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from tests.support import report_samples as samples
from tools.reports import report_modules, synth_tables, tests_tables, text_blocks, throughput
from tools.reports.results import Results
from tools.reports.text_table import Table


@pytest.fixture
def reports(checkout):
    """The reports of a checkout, with these written into it first."""
    def of(**contents):
        checkout.put({f"build/reports/{name}.json": content for name, content in contents.items()})
        return Results(checkout.root, modules=report_modules.MODULES)
    return of


@pytest.fixture
def data(reports):
    return reports(organizations=samples.ORGANIZATIONS, synth=samples.SYNTH, pnr=samples.PNR)


def test_columns_of_numbers_stand_on_the_right():
    table = Table(["a", "b", "c", "d"],
                       [["`x`", "1,234", "-", "14 + 12"], ["y z", "2.3e-07", "", "0 of 60,012"]])
    assert table.markdown().splitlines()[1] == "| --- | --: | --- | --: |"
    assert table.text().splitlines() == [
        "a          b  c            d", "x      1,234  -      14 + 12",
        "y z  2.3e-07     0 of 60,012"]
    assert Table(["a"], []).markdown() == "| a |\n| --- |"


def test_the_table_of_results_joins_three_reports(reports):
    cores = [samples.mapped(name, lut, top="hwffd_stream", dsp=11)
             for name, lut in (("basic-fx18-overlapped", 1500), ("tree8-fx18-overlapped", 1900))]
    clock = {**samples.PNR["rows"][0], "top": "hwffd_stream", "fmax_mhz": 110.0}
    data = reports(organizations=samples.ORGANIZATIONS,
                   synth={**samples.SYNTH, "rows": [*samples.SYNTH["rows"], *cores]},
                   pnr={**samples.PNR, "rows": [*samples.PNR["rows"], clock]})
    table = text_blocks.table(data, "results.organizations")
    assert table.rows[0] == ["`basic`", "64", "11", "1,504", "504", "-", "-", "-", "8.7e-05"]
    bounds = {"rows": [{"form": form, "format": word, "bound": bound, "hypothesis": ""}
                       for form, word, bound in (("product", "fx18", 7e-4), ("product", "fx18", 6e-4),
                                                 ("product", "fx32", 5e-4), ("affine", "fx18", 4e-4))]}
    data = reports(organizations=samples.ORGANIZATIONS, synth=samples.SYNTH, pnr=samples.PNR, bounds=bounds)
    assert [row[-2] for row in text_blocks.table(data, "results.organizations basic affine").rows] == [
        "6.0e-04", "4.0e-04"]
    assert table.rows[1][5:7] == ["110.0", "13.75"]
    assert [line[0] for line in text_blocks.table(data, "results.organizations tree8 affine").rows] == [
        "`tree 8`", "`affine`"]


def test_cores_that_have_been_routed_have_both_rates(reports):
    def core(name, top, any_order, rows, **fields):
        return samples.mapped(name, 1500, 90.0, top=top, bram=29, routed=True, meaning=fields.pop("meaning", None),
                              vertices_per_s=any_order, row_vertices_per_s=rows, **fields)

    cores = [core("cg1-fx18-overlapped", "hwffd_stream", 1_406_250, 1_406_250),
             core("walk-fx17-overlapped-powers+grids", "hwffd_stream", 5_625_000, 90_000_000, meaning="grids"),
             core("affine-fx17-overlapped+scatter", "hwffd_scatter", 30_000_000, 30_000_000, meaning="the transpose"),
             core("cg1-fx18-overlapped", "ffd_org_select", 1_406_250, 1_406_250)]
    bounds = {"rows": [{"form": form, "format": word, "bound": bound, "hypothesis": ""} for form, word, bound in (
        ("product", "fx18", 7e-4), ("affine", "fx17", 3e-4), ("powers", "fx17", 2e-4))]}
    data = reports(synth={**samples.SYNTH, "rows": [*samples.SYNTH["rows"], *cores]}, bounds=bounds)
    assert text_blocks.table(data, "results.cores").rows == [
        ["`cg1-fx18-overlapped`", "`hwffd_stream`", "positions, derivatives, det J", "64", "64", "8", "1,504", "29", "90.0",
         "1.4", "1.4", "7.0e-04"],
        ["`walk-fx17-overlapped-powers+grids`", "`hwffd_stream`", "grids", "16", "1", "8", "1,504", "29", "90.0",
         "5.6", "90.0", "2.0e-04"],
        ["`affine-fx17-overlapped+scatter`", "`hwffd_scatter`", "the transpose", "3", "3", "8", "1,504", "29", "90.0",
         "30.0", "30.0", "-"]]
    named = "results.cores cg1-fx18-overlapped/hwffd_axi affine-fx17-overlapped+scatter/hwffd_scatter"
    (row,) = text_blocks.table(data, named).rows
    assert row[2] == "the transpose"


def test_a_clock_with_a_remark_gives_no_vertices_a_second(reports):
    rows = [samples.mapped("basic-fx18-overlapped", 500, target="gw5a", remark="unknown")]
    data = reports(organizations=samples.ORGANIZATIONS, synth={**samples.SYNTH, "rows": rows})
    entry, = throughput.throughputs(data)
    assert (entry.per_second, entry.rate) == (None, 1 / 64)


def test_rates(data):
    timed, untimed = (next(entry for entry in throughput.throughputs(data) if entry.name == name)
                      for name in ("basic-fx18-overlapped", "affine-fx18-overlapped"))
    assert (timed.size, timed.unit, timed.multipliers) == (500, "LUTs", 8)
    assert timed.per_second == 100e6 / 64
    assert timed.per_size == 100e6 / 64 / 500
    assert timed.per_multiplier == 100e6 / 64 / 8
    assert (untimed.per_second, untimed.rate) == (None, 1)


def test_sizes_that_a_target_counts(data):
    assert [(entry.size, entry.unit, entry.per_multiplier) for entry in throughput.throughputs(data)
            if entry.target == "generic"] == [(44000, "cells", None)]


def test_of_organizations_only_and_each_once(reports):
    rows = [*samples.SYNTH["rows"], samples.mapped("tree8-fx18-overlapped", 1, top="hwffd_axi"),
            samples.mapped("basic-fx18-paper", 1)]
    names = [(entry.name, entry.target) for entry in throughput.throughputs(
        reports(organizations=samples.ORGANIZATIONS, synth={"rows": rows}))]
    assert len(names) == len(set(names)) == 6


def test_the_front_is_what_no_other_beats(data):
    entries = [entry for entry in throughput.throughputs(data) if entry.target == "ecp5"]
    assert [entry.name for entry in throughput.unbeaten(entries)] == [
        "basic-fx18-overlapped", "tree8-fx18-overlapped", "parallel-fx18-overlapped",
        "affine-fx18-overlapped"]


@pytest.mark.parametrize("name, label", (("tree8-fx18-overlapped", "tree 8 fx18"),
                                         ("basic-fp32-overlapped-deep", "basic deep fp32")))
def test_labels(name, label):
    assert throughput.label(samples.organization(name, 1)) == label


def test_the_document_of_synth(reports):
    report = {**samples.SYNTH, "wanted": 8,
              "failed": [{"name": "x", "top": "t", "target": "ecp5", "error": "latches"}]}
    text = synth_tables.document(reports(synth=report))
    for line in ("2 of 8 rows have not been mapped", "Failed: x, t, ecp5: latches",
                 "## Lattice ECP5", "Binary32, `ffd_org_select`, units kept apart:",
                 "| row | LUT | LUT as memory | FF | MULT18X18D | DP16KD | depth | MHz |",
                 "| `LUT4` | 500 | 900 |",
                 "Lattice ECP5, LUT, memory included:", "| `basic` | 504 | 954 |"):
        assert line in text


def test_the_price_of_a_feature_stands_beside_its_row(reports):
    core, few = (samples.mapped(name, lut, top="hwffd_stream", variant=variant, meaning=variant)
                 for name, lut, variant in (("cg1-fx18-overlapped", 2400, None),
                                            ("cg1-fx18-overlapped+few", 1700, "few")))
    data = reports(synth={**samples.SYNTH, "rows": [few, core]})
    assert [line[:3] for line in synth_tables.prices(data).rows] == [
        ["`cg1-fx18-overlapped`, `hwffd_stream`", "as in the table", "2,400"],
        ["", "few", "1,700 (-700)"]]
    assert synth_tables.prices(data, "ecp5", "cg1-fx18-overlapped/hwffd_stream").rows == synth_tables.prices(data).rows
    assert not synth_tables.prices(data, "ecp5", "cg1-fx18-overlapped/hwffd_axi").rows
    assert [line[0] for line in synth_tables.cores(data).rows] == ["`cg1-fx18-overlapped`"]
    assert "## What features cost" in synth_tables.document(data)


def test_what_ctest_wrote(checkout, reports):
    checkout.put({"build/reports/tests.xml": """<testsuite name="x"><testcase name="lint.a" time="1.5"
        status="run"/><testcase name="lint.b" time="0.25" status="fail"/>
        <testcase name="api.c.d" time="7" status="run"/></testsuite>"""})
    tests_tables.collect(checkout.root / "build/reports/tests.xml", 2)
    data = reports()
    assert [data.figure("tests", what) for what in ("tests", "failed", "skipped", "not_passed")] == [3, 1, 2, 3]
    assert text_blocks.table(data, "tests.suites").rows == [["`api`", "1", "7"], ["`lint`", "2", "2"]]
    assert text_blocks.table(data, "tests.longest").rows[0] == ["`api.c.d`", "7"]


def test_reports_that_are_shown(checkout, reports):
    reports(glapi={"calls": 3, "failed_checks": 0, "commands": [
        {"command": "glX", "cases": 12, "compared": 4, "failed": 0}]})
    status, out, errors = checkout.module("tools.reports.show", "--root", checkout.root, "glapi")
    assert (status, errors) == (0, "")
    assert out.startswith("3 calls checked by their values") and "glX" in out
    status, out, errors = checkout.module("tools.reports.show", "--root", checkout.root, "web")
    assert (status, out, errors) == (1, "", "show: build/reports/web.json is not there\n")
