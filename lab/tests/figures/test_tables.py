"""Tables and what follows from reports, of reports made up here.

SPDX-License-Identifier: Apache-2.0
"""

import copy
import re

import pytest

from lab.figures.modules import CHARTS, MODULES, TEXTS, missing
from lab.figures.studies import energy, organizations, streams, words
from tests.support import report_samples as samples
from tools.project_root import ROOT
from tools.reports import results, synth_tables, text_blocks
from tools.reports.results import RequestError


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
    table = streams.words(reports(streams=samples.STREAMS), "horse.3ds")
    assert table.heads[2:] == ["4x4x4", "16x16x16"]
    assert table.rows[-1] == ["resident", "file", "4.05", "8.09"]


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


BEYOND = samples.ORGANIZATIONS["rows"][-1]["org"]  # the paper


@pytest.fixture
def data(reports):
    return reports(organizations=samples.ORGANIZATIONS, synth=samples.SYNTH, pnr=samples.PNR)


def test_a_line_for_each_organization(data):
    table = organizations.clocks(data)
    assert [line[0] for line in table.rows] == ["`basic`", "`tree 8`", "`parallel`", f"`{BEYOND}`"]
    assert table.rows[0][1:] == ["96", "96", "-", "4 + 3", "64 + 48", "64", "8 + 6", "2.31e-07", "-",
                                 "8.65e-05", "-"]
    assert table.rows[3][1:3] == ["-", "-"]


def test_organizations_of_17_bits_have_a_line_too(reports):
    rows = [samples.organization("walk2-fx17-overlapped", 16, org="walk/2"),
            samples.organization("affine4x3-fx17-overlapped", 4 / 3, org="affine/4x3")]
    table = organizations.clocks(reports(organizations={"rows": rows}))
    assert [[line[0], line[6], line[9]] for line in table.rows] == [
        ["`walk/2`", "16", "8.65e-05"], ["`affine/4x3`", "1.33", "8.65e-05"]]


def test_units_of_organizations_that_are_named(data):
    assert organizations.units(data, "tree8", BEYOND).rows == [
        ["`tree 8`", "96", "4 + 3", "8", "8 + 6"], [f"`{BEYOND}`", "-", "-", "1", "8 + 6"]]
    alone = organizations.units(data, BEYOND)
    assert (alone.heads, alone.rows) == (["organization", "cycles per vertex", "multipliers + adders"],
                                         [[f"`{BEYOND}`", "1", "8 + 6"]])
    with pytest.raises(RequestError, match="no organization 'tree9' in fx18 or fx17"):
        organizations.units(data, "tree9")


@pytest.mark.parametrize("name, value", (
    ("rows_measured", 2), ("results_checked", 20), ("watertight_rows", 1), ("watertight_results", 10)))
def test_figures_of_organizations(reports, name, value):
    rows = [samples.organization("basic-fx18-overlapped", 64),
            samples.organization("tree8-fx18-overlapped", 8, seam_differences=3)]
    assert reports(organizations={"rows": rows}).figure("organizations", name) == value


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
    other = '{"tests": 61, "suites": []}'
    for text in (other, None):
        checkout.put({"build/reports/synth.json": text})
        bare = type(data)(data.root, modules=data.modules)
        assert "targets" not in organizations.finished(bare)["rows"][1]
        assert organizations.printed(bare).endswith("no areas: make synth writes build/reports/synth.json")


def test_whole_cores_of_every_module_and_format(reports):
    rows = [samples.mapped("affine3-fx17-overlapped", 800, top="hwffd_stream"),
            samples.mapped("cg1-fx18-overlapped", 700, top="hwffd_stream"),
            samples.mapped("add-fp32-latency4", 300, top="ffd_fp_add"),
            samples.mapped("affine-fx17-overlapped+rows", 600, top="hwffd_scatter", variant="rows", meaning="by rows"),
            samples.mapped("walk-fx17-overlapped+adjoint", 900, top="hwffd_adjoint", variant="adjoint", meaning="both")]
    data = reports(synth={**samples.SYNTH, "wanted": 5, "rows": rows})
    assert [line[0] for line in synth_tables.cores(data).rows] == ["`cg1-fx18-overlapped`"]
    assert len(synth_tables.cores(data, "ecp5", "hwffd_stream", "fx17,fx18").rows) == 2
    table = synth_tables.transposes(data)
    assert [line[:3] + line[-1:] for line in table.rows] == [
        ["`affine-fx17-overlapped+rows`", "`hwffd_scatter`", "600", "by rows"],
        ["`walk-fx17-overlapped+adjoint`", "`hwffd_adjoint`", "900", "both"]]
    units = synth_tables.document(data).split("Binary32 units by themselves")[1].split("\n## ")[0]
    assert "add-fp32-latency4" in units and "hwffd" not in units and "overlapped" not in units


@pytest.mark.parametrize("killed, below", ((9697, "none"), (9696, "slave 97.0 %")))
def test_subjects_below_their_aim(checkout, reports, killed, below):
    checkout.put({"lab/mutants/subjects.csv": "name,aim\nslave,96.965\n"})
    row = {"subject": "slave", "module": "ffd", "total": 10000, "killed": killed, "equivalent": 0, "undecided": 0,
           "survived": 10000 - killed, "survivors": []}
    assert reports(mutants={"rows": [row]}).figure("mutants", "below") == below


def test_a_report_that_is_not_whole(checkout, data):
    checkout.link("rtl")
    assert re.search("^[0-9]+ rows, the first basic-fp32-paper", organizations.missing(data))


RELEASED = results.released(ROOT, modules=MODULES)
PRESENT = [name for name in MODULES if RELEASED.has(name)]


def test_every_picture_is_of_reports_that_there_are():
    assert {name for needed in CHARTS.values() for name in needed} <= set(MODULES)
    assert len(PRESENT) >= 25


@pytest.mark.parametrize("name", PRESENT)
def test_released_reports(name):
    """Each is whole, and every figure can be made of it."""
    assert isinstance(MODULES[name].TABLES, dict)
    if not results.read(RELEASED.folder / results.RELEASE)["mixed"]:
        assert not missing(RELEASED, name)
    for figure in getattr(MODULES[name], "FIGURES", {}):
        assert RELEASED.figure(name, figure) is not None


def test_every_text_says_what_the_results_say():
    count, wrong = text_blocks.Blocks(ROOT, MODULES, TEXTS).check()
    assert count > 50
    assert wrong == []
