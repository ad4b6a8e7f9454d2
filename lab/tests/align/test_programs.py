"""How programs are called and counted, of logs as they print them; and the estimate of a core.

SPDX-License-Identifier: Apache-2.0
"""

import importlib
import sys

import numpy
import pytest

from lab.align import commands, core, from_source, libraries, programs, run

PLASTIMATCH = """
roi_dim = 48 48 48
[ 0,  0] MSE       20.674 NV 110592 GM     9.372 GN       2.8 [     0.022 s ]
         CMIN   0.00 CAVG   0.00 CMAX   0.00
[ 0,  1] MSE       17.724 NV 110172 GM     6.115 GN      2.31 [     0.018 s ]
roi_dim = 96 96 96
[ 0,  0] MSE    9.3056211 NV 884736 GM    -3.728 GN     0.867 [     0.150 s ]
"""
NIFTYREG = """
[NiftyReg F3D] 	* image dimension: 96 x 96 x 96 x 1
[NiftyReg F3D] Current level: 1 / 2
[NiftyReg F3D] 	* image dimension: 48 x 48 x 48 x 1
[NiftyReg F3D] [9] Current objective function: -0.000440341 = (wSIM)-0.000440341 [+ 2 mm]
[NiftyReg F3D] [100] Current objective function: -0.000228383 = (wSIM)-0.000228383 [+ 0.14594 mm]
[NiftyReg F3D] Current level: 2 / 2
[NiftyReg F3D] 	* image dimension: 96 x 96 x 96 x 1
[NiftyReg F3D] [50] Current objective function: -5.15422e-05 = (wSIM)-5.15422e-05 [+ 0.5 mm]
"""
ELASTIX = ("noise\n1:ItNr\t1a:SrchDirNr\tTime[ms]\n0\t0\t1\t12.1\t352.7\n1\t1\t0\t9.2\t175.5\n"
           "1:ItNr\t2:Metric\tTime[ms]\n0\t0\t0\t6.5\t2089.0\nthe end\n")


def job(tmp_path, **more):
    values = numpy.zeros((32, 24, 16), numpy.float32)
    return programs.Job(values, values, **{"spacing": 8, "levels": 2, "iterations": 20, "threads": 1, "budget": 9.0,
                                          "folder": tmp_path, **more})


def test_evaluations_of_logs():
    levels, seconds = commands.plastimatch_log(PLASTIMATCH)
    assert [(level.evaluations, level.voxels) for level in levels] == [(2, 48**3), (1, 96**3)]
    assert seconds == pytest.approx(0.19)
    assert [(level.evaluations, level.voxels) for level in commands.niftyreg_log(NIFTYREG)] == [(100, 48**3), (50, 96**3)]
    iterations = libraries.elastix_log(ELASTIX)
    assert [[line[2] for line in level] for level in iterations] == [["1", "0"], ["0"]]
    assert [libraries.line_search_evaluations(level) for level in iterations] == [6, 3]


def test_evaluations_between_iterations_are_counted_by_their_time():
    assert libraries.counted([0, 1.0, 2.1, 5.0, 6.0]) == 1 + 1 + 3 + 1
    assert libraries.counted([7.0]) == libraries.counted([]) == 0


def test_voxel_evaluations_are_those_of_each_level():
    outcome = programs.Outcome(None, [programs.Level(3, 1000), programs.Level(2, 8000)], 1.0)
    assert (outcome.evaluations, outcome.voxel_evaluations) == (5, 19000)


def test_plastimatch_gets_a_stage_for_each_level(tmp_path):
    text = commands.plastimatch_options(job(tmp_path))
    assert text.count("[STAGE]") == 2 and text.count("max_its=20") == 2
    assert text.index("grid_spac=16 16 16") < text.index("grid_spac=8 8 8")
    assert text.index("res=2 2 2") < text.index("res=1 1 1")


def test_a_command_says_its_memory_and_why_it_ended(tmp_path):
    text, used = commands.launched(job(tmp_path), "show",
                                   [sys.executable, "-c", "b = bytearray(b'x' * 60_000_000); print('x' * 10)"])
    assert text == "x" * 10 + "\n" and 60 < used["peak_mb"] < 150 and used["elapsed_s"] > 0
    with pytest.raises(programs.AlignError, match="show ended with 3: no such lattice"):
        commands.launched(job(tmp_path), "show", [sys.executable, "-c", "print('no such lattice'); exit(3)"])


def test_a_program_whose_package_is_not_there_is_absent(tmp_path, monkeypatch):
    gone = programs.Program("gone", "no-such-package", "none", "no_such_module", "nothing", "none")
    with pytest.raises(programs.Absent, match="no-such-package is not in build/venv"):
        assert gone.version
    with pytest.raises(programs.Absent, match="no_such_module"):
        gone.run(job(tmp_path))
    # The same as a process of its own says it.
    monkeypatch.setattr(programs, "PROGRAMS", (gone,))
    numpy.savez(tmp_path / "pair.npz", fixed=numpy.zeros((2, 2, 2)), moving=numpy.zeros((2, 2, 2)))
    (tmp_path / "job.json").write_text('{"spacing": 8, "levels": 1, "iterations": 1, "threads": 1, "budget": 1}')
    assert run.answer(tmp_path, 0) == {"absent": "No module named 'lab.align.no_such_module'"}


@pytest.mark.parametrize("field", (numpy.zeros((32, 24, 16, 2)), numpy.full((32, 24, 16, 3), numpy.nan)))
def test_a_field_that_is_none_is_refused(tmp_path, monkeypatch, field):
    monkeypatch.setattr(programs.Program, "run", lambda self, job: programs.Outcome(field, [], 1.0))
    with pytest.raises(programs.AlignError, match="plastimatch: a field of"):
        run.work(job(tmp_path), programs.PROGRAMS[3])


def test_seconds_are_those_of_the_processor(tmp_path, monkeypatch):
    field = numpy.zeros((32, 24, 16, 3))
    used = {"elapsed_s": 8.0, "processor_s": 2.0, "peak_mb": 1.0}
    for elapsed, threads, seconds in ((True, 1, 1.0), (False, 1, 4.0), (True, 2, 4.0)):
        outcome = programs.Outcome(field, [programs.Level(1, 1)], 4.0, elapsed=elapsed, usage=used)
        monkeypatch.setattr(programs.Program, "run", lambda self, job, outcome=outcome: outcome)
        assert run.work(job(tmp_path, threads=threads), programs.PROGRAMS[0])[0]["seconds"] == seconds


def test_a_source_that_does_not_compile_says_why(tmp_path, monkeypatch):
    monkeypatch.setitem(from_source.SOURCES, "gone", ("1.0", {}))
    monkeypatch.setattr(from_source.subprocess, "call", lambda command, stdout, **_: stdout.write(
        "Collecting gone\nERROR: Failed building wheel for gone\n"))
    monkeypatch.delenv("HWFFD_NO_INSTALL", raising=False)
    assert from_source.installed("gone", tmp_path) == "gone 1.0 does not compile here: ERROR: Failed building wheel for gone"
    monkeypatch.setenv("HWFFD_NO_INSTALL", "1")
    assert "HWFFD_NO_INSTALL forbids" in from_source.installed("gone", tmp_path)
    assert from_source.installed("numpy", tmp_path) == ""


def test_every_program_has_a_function_and_says_how_it_is_counted():
    names = [program.name for program in programs.PROGRAMS]
    assert len(set(names)) == len(names) >= 6 and sum(program.hwffd for program in programs.PROGRAMS) == 3
    for program in programs.PROGRAMS:
        assert callable(getattr(importlib.import_module(f"lab.align.{program.module}"), program.function))
        assert program.counted


def test_clocks_of_an_evaluation_by_hand():
    # 10 rows of 96 voxels in 6 cells: a clock each; in rows of 20 the points take longer.
    assert core.clocks_of((96, 5, 2), (6, 1, 1)) == (960 + 0.75 * 144, 960 + 6 * 144)
    assert core.clocks_of((20, 5, 2), (6, 1, 1)) == (360 + 0.75 * 144, 270 + 6 * 144)


class Routed:
    """A report of one half, or of none."""

    def __init__(self, *tops):
        self.tops = tops

    def has(self, name):
        return name == "pnr" and bool(self.tops)

    def rows(self, _, top, **__):
        return [{"fmax_mhz": 120.0}] if top in self.tops else []


def test_an_estimate_says_what_has_been_routed():
    halves = core.clocks(Routed())
    assert [half["routed"] for half in halves] == [False, False] and all(half["mhz"] >= 50 for half in halves)
    estimate = core.estimate(Routed("hwffd_scatter"), (96, 96, 96), (6, 6, 6))
    assert [half["routed"] for half in estimate["halves"]] == [False, True] and estimate["halves"][1]["mhz"] == 120.0
    assert estimate["voxels_per_s"] == pytest.approx(96**3 / sum(
        half["clocks"] / half["mhz"] / 1e6 for half in estimate["halves"]))
