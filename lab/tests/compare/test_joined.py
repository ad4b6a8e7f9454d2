"""Rows of `make compare`: what is joined from reports, and what ends it.

SPDX-License-Identifier: Apache-2.0
"""

import copy
import importlib.util
import json
import pathlib
import sys

import pytest

from lab.compare import joined, routed
from lab.figures.modules import MODULES, missing
from tools.reports import text_blocks
from tools.reports.report_modules import printed
from tools.reports.results import FRESH, RequestError, Results

STUDY = pathlib.Path(__file__).resolve().parents[3] / "lab" / "compare"

MEASURED = {"vertices": 100, "vector_units": "AVX2", "cores": [], "software": [
    {"what": what, "sorted": is_sorted, "vertices_per_s": rate * (2 if is_sorted else 1),
     "error": 1e-7, "latency_ns": 50.0, "bytes_per_vertex": 28.0}
    for is_sorted in (False, True) for what, rate in (
        ("LatticeEvaluator<float>", 70e6), ("LatticeEvaluator<double>", 40e6),
        ("device model basic-fx18-overlapped", 5e5))] + [
    {"what": what, "sorted": True, "vertices_per_s": rate, "error": 1e-5, "latency_ns": None,
     "bytes_per_vertex": 16.0}
    for what, rate in (("device model walk-fx17-overlapped, a grid", 2e7),
                       ("GridWalker of model walk-fx17-overlapped", 4e7))]}
PEERS = [{"what": "peer 1.0, call", "sorted": is_sorted, "vertices_per_s": 8e6, "error": 1e-15,
          "latency_ns": None, "bytes_per_vertex": 48.0} for is_sorted in (False, True)]


def core(name, clocks, latency=50):
    """What hwffd-compare counts of a row, of vertices in any order and sorted."""
    return [{"name": name, "sorted": is_sorted, "vertices": 10, "clocks_per_vertex": count,
             "latency_clocks": latency, "bytes_per_vertex": 32.0, "error": 3e-5, "mismatches": 0}
            for is_sorted, count in zip((False, True), clocks)]


CORES = [*core("factored3-fx18-overlapped", (3.0, 3.0)),
         *core("walk-fx17-overlapped", (16.0, 2.5)),
         *core("basic-fx18-overlapped", (64.0, 64.0))]


def clock(name, top, mhz, **more):
    return {"name": name, "top": top, "target": "ecp5", "device": "85F", "fmax_mhz": mhz,
            "seeds": [1, 2, 3], **more}


REPORTS = {
    "pnr": {"rows": [clock("factored3-fx18-overlapped", "hwffd_stream", 102.0),
                     clock("walk-fx17-overlapped", "hwffd_stream", 100.0),
                     clock("basic-fx18-overlapped", "hwffd_axi", 128.0),
                     clock("basic-fx18-overlapped", "ffd_org_select", 150.0)]},
    "synth": {"rows": [{"name": "factored3-fx18-overlapped", "top": "hwffd_stream",
                        "target": "ecp5", "dsp": 100}]},
    "dma": {"runs": [{"org": "basic", "format": "fx18", "schedule": "overlapped", "stream": "dma",
                      "clocks_per_vertex": 80.0}]}}


@pytest.fixture
def reports(checkout):
    def of(**changed):
        checkout.put({f"{FRESH}/{name}.json": content
                      for name, content in {**REPORTS, **changed}.items()})
        return Results(checkout.root, modules=MODULES)
    return of


def test_a_variant_with_other_features_has_the_clocks_of_its_row(reports):
    row, small = "affine4x3-fx17-overlapped-powers", "cg1-fx16-overlapped+small"
    data = reports(pnr={"rows": [clock(f"{row}+resident", "hwffd_stream", 90.0),
                                 clock(small, "hwffd_stream", 40.0)]},
                   synth={"rows": [{"name": f"{row}+resident", "top": "hwffd_stream",
                                    "target": "ecp5", "dsp": 150}]})
    assert routed.names(data) == [row]
    rows = routed.rows(data, core(row, (4 / 3, 4 / 3)))
    assert [(row["what"], row["multipliers"]) for row in rows] == [
        (f"hwffd_stream {row}+resident", 150)] * 2
    assert rows[0]["vertices_per_s"] == pytest.approx(67.5e6)


def test_a_core_has_the_routed_clock_and_the_clocks_counted(reports):
    rows = routed.rows(reports(), CORES)
    assert [(row["what"], row["sorted"], row["vertices_per_s"]) for row in rows] == [
        ("hwffd_stream factored3-fx18-overlapped", False, 34e6),
        ("hwffd_stream factored3-fx18-overlapped", True, 34e6),
        ("hwffd_stream walk-fx17-overlapped", False, 6.25e6),
        ("hwffd_stream walk-fx17-overlapped", True, 40e6),
        ("hwffd_axi basic-fx18-overlapped", False, 1.6e6),
        ("hwffd_axi basic-fx18-overlapped", True, 1.6e6)]
    assert rows[0]["per_multiplier"] == 34e4
    assert rows[0]["latency_ns"] == pytest.approx(50 / 102e6 * 1e9)
    assert rows[2]["per_multiplier"] is None
    assert rows[4]["latency_ns"] is None
    assert routed.names(reports()) == ["factored3-fx18-overlapped", "walk-fx17-overlapped"]


def test_a_core_that_was_not_counted_has_no_row(reports):
    assert routed.rows(reports(), []) == []


def test_memory_to_memory_only_where_the_order_plays_no_part(reports):
    pnr = {"rows": [clock("walk-fx17-overlapped", "hwffd_axi", 100.0)]}
    dma = {"runs": [{**REPORTS["dma"]["runs"][0], "org": "walk", "format": "fx17"}]}
    assert routed.rows(reports(pnr=pnr, dma=dma), CORES) == []
    same = core("walk-fx17-overlapped", (3.0, 3.0))
    assert len(routed.rows(reports(pnr=pnr, dma=dma), same)) == 2


def test_a_remark_goes_with_its_clock(reports):
    pnr = {"rows": [clock("factored3-fx18-overlapped", "hwffd_stream", 102.0, remark="no delays")]}
    row = routed.rows(reports(pnr=pnr), CORES)[0]
    assert row["source"].endswith("; no delays") and row["remark"] == "no delays"


@pytest.fixture
def whole(reports):
    return joined.report(MEASURED, PEERS, routed.rows(reports(), CORES))


def test_every_row_has_every_field(whole):
    assert all(set(joined.FIELDS) <= set(row) for row in whole["rows"])
    assert {row["kind"] for row in whole["rows"]} == set(joined.KINDS)
    assert all(row["per_multiplier"] is None for row in whole["rows"] if row["kind"] != "core")
    assert "AVX2" in whole["rows"][0]["source"]
    assert json.loads(json.dumps(whole)) == whole


@pytest.mark.parametrize("spoil, message", (
    ({"peers": []}, "no peer was measured"), ({"cores": []}, "no core was measured"),
    ({"measured": {**MEASURED, "software": []}}, "no own was measured; no model was measured"),
    ({"peers": [{**PEERS[0], "vertices_per_s": 0}]}, "peer 1.0, call: 0 vertices a second"),
    ({"peers": [{**PEERS[0], "vertices_per_s": float("nan")}]}, "nan vertices a second"),
    ({"peers": [{**PEERS[0], "error": float("nan")}]}, "an error of nan"),
    ({"peers": [{**PEERS[0], "error": 0.0}]}, "an error of 0.0")))
def test_what_measured_nothing_is_no_report(reports, spoil, message):
    inputs = {"measured": MEASURED, "peers": PEERS, "cores": routed.rows(reports(), CORES), **spoil}
    with pytest.raises(joined.CompareError, match=message):
        joined.report(inputs["measured"], inputs["peers"], inputs["cores"])


def test_the_processor_says_its_name(tmp_path):
    (tmp_path / "cpuinfo").write_text("flags : x\nmodel name\t: A Core 1 \n")
    assert joined.processor(tmp_path / "cpuinfo") == "A Core 1"
    assert joined.processor(tmp_path / "none") == "a processor without a name"


def test_table_and_figures(reports, whole):
    data = reports(compare=whole)
    lines = text_blocks.table(data, "compare.programs").rows
    assert [line[0] for line in lines] == [
        "`LatticeEvaluator<float>`", "`LatticeEvaluator<double>`",
        "`device model basic-fx18-overlapped`", "peer 1.0 `call`",
        "`hwffd_stream` factored3-fx18-overlapped", "`hwffd_stream` walk-fx17-overlapped",
        "`hwffd_axi` basic-fx18-overlapped"]
    assert lines[0][2:4] == ["70.00", "140.00"]
    assert lines[4][2:7] == ["34.00", "34.00", "0.340", "490", "32"]
    assert data.figure("compare", "float_sorted") == 140
    assert data.figure("compare", "float_sorted_reached") is True
    assert data.figure("compare", "core_name") == "factored3-fx18-overlapped"
    assert data.figure("compare", "times_peer_random") == 5
    assert "AVX2" in printed(MODULES["compare"], data)
    assert missing(data, "compare") == ""


def test_grids_have_a_table_of_their_own(reports, whole):
    data = reports(compare=whole)
    lines = text_blocks.table(data, "compare.grids").rows
    assert [line[0] for line in lines] == ["`GridWalker of model walk-fx17-overlapped`",
                                           "`device model walk-fx17-overlapped, a grid`"]
    assert [line[2] for line in lines] == ["40.00", "20.00"]
    assert lines[0][3:] == ["16", "1.0e-05"]
    assert data.figure("compare", "model_random") == 0.5
    assert "a regular grid" in printed(MODULES["compare"], data)
    without = {**whole, "rows": [row for row in whole["rows"] if row["kind"] != "grid"]}
    assert "a regular grid" not in printed(MODULES["compare"], reports(compare=without))
    with pytest.raises(RequestError, match="no rows of kind grid"):
        text_blocks.table(reports(compare=without), "compare.grids")


def test_standard_cells_have_an_energy_and_no_clock(reports, whole):
    cells = {"rows": [{"name": "cg1-fx18-overlapped", "device": "cells", "energy_nj_per_vertex": 250.04}]}
    lines = text_blocks.table(reports(compare=whole, energy=cells), "compare.programs").rows
    assert len(lines) == 8
    assert lines[-1] == ["`ffd_org_select` cg1-fx18-overlapped", "cells", *["-"] * 5, "250.0", "-"]


def test_a_clock_with_a_remark_is_no_fastest_core(reports, whole):
    marked = copy.deepcopy(whole)
    for row in marked["rows"]:
        if "factored3" in row["what"]:
            row["remark"] = "no delays"
    data = reports(compare=marked)
    assert data.figure("compare", "core_name") == "walk-fx17-overlapped"
    assert "(1) no delays" in printed(MODULES["compare"], data)


def test_without_a_kind_it_is_not_whole(reports, whole):
    part = {**whole, "rows": [row for row in whole["rows"] if row["kind"] != "peer"]}
    data = reports(compare=part)
    assert missing(data, "compare") == "rows of kind peer"
    with pytest.raises(RequestError, match="no rows of kind peer"):
        data.figure("compare", "peer_random")


def test_a_program_that_fails_ends_it(checkout, programs_that):
    status, _, errors = programs_that("exit 3")
    assert status == 1 and "ended with 3" in errors
    assert not (checkout.root / "reports" / "compare.json").exists()


@pytest.fixture
def programs_that(checkout):
    """`make compare` with another program in place of hwffd-compare."""
    def run(body):
        checkout.put({"program": f"#!/bin/sh\n{body}\n"}, 0o755)
        return checkout.run(sys.executable, "-B", "-m", "lab.compare", "--program", checkout.root / "program",
                            "--output", checkout.root)
    return run


def test_the_peers_are_those_of_the_requirements():
    if importlib.util.find_spec("numpy") is None:
        pytest.skip("no numpy")
    from lab.compare import peers  # pylint: disable=import-outside-toplevel
    wanted = (STUDY.parent / "requirements-compare.txt").read_text()
    assert all(f"\n{peer.package}==" in wanted for peer in peers.PEERS)
