"""Whole calls of libraries: each gives what equation (1) says, or it is said that it does not.

SPDX-License-Identifier: Apache-2.0
"""

import dataclasses
import importlib
import json
import pathlib
import subprocess
import sys

import numpy
import pytest

from lab.compare.arrays import libraries
from lab.compare.arrays.scene import DIMS, Scene, evaluated, weights

ROOT = pathlib.Path(__file__).resolve().parents[3]
FOLDER = ROOT / "lab" / "compare" / "arrays"

POINTS = 5000


def program():
    return importlib.import_module("lab.compare.arrays.__main__")


def test_weights_sum_to_one_and_points_at_rest_stay():
    assert numpy.allclose(weights(numpy.linspace(0, 1, 11)).sum(-1), 1, atol=1e-15)
    scene = Scene.random(POINTS)
    at_rest = evaluated(scene.rest, Scene.places(scene.points))
    assert scene.rest.shape == (*DIMS, 3) and abs(at_rest - scene.points).max() < 1e-14


@pytest.mark.parametrize("number", range(len(libraries.LIBRARIES)))
def test_every_library_gives_the_points(number):
    row = program().measured(number, POINTS, 1)
    assert row["max_error"] <= libraries.LIBRARIES[number].bound
    assert row["points"] == POINTS and row["points_per_s"] > 0 and row["peak_mb"] > 10 and row["version"]


def test_a_wrong_result_is_no_figure(monkeypatch):
    library, module = libraries.LIBRARIES[0], program()

    def wrong(scene, threads):
        deform = library.prepare(scene, threads)
        return lambda: deform() + 1e-9
    planted = dataclasses.replace(library, prepare=wrong)
    monkeypatch.setattr(libraries, "LIBRARIES", (planted,))
    with pytest.raises(module.BenchError, match="hwffd, device reference: error 1.0e-09"):
        module.measured(0, POINTS, 1)


def test_a_row_is_a_process_and_says_why_there_is_none(tmp_path):
    command = [sys.executable, "-B", "-m", "lab.compare.arrays", "--output", tmp_path, "--points"]
    result = subprocess.run([*command, "0"], capture_output=True, text=True, check=False)
    assert result.returncode == 1
    assert result.stderr.startswith("compare: --points from 1 up") and not list(tmp_path.iterdir())
    subprocess.run([*command, str(POINTS), "--threads", "1"], capture_output=True, check=True)
    rows = json.loads((tmp_path / "reports" / "bench.json").read_text())["rows"]
    assert [row["what"] for row in rows] == [library.call for library in libraries.LIBRARIES]
