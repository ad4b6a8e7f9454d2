"""The examples of Python run; the code of the pages does so in tests/docs.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Processes of Dask complain of each other where a busy machine ends one of them late.
SETTINGS = {**os.environ, "DASK_LOGGING__DISTRIBUTED": "critical"}


@pytest.mark.parametrize("name", ["align_scans", "deform", "fit", "register", "with_dask", "with_pyvista", "with_trimesh"])
def test_example(name, tmp_path):
    result = subprocess.run([sys.executable, "-B", "-W", "error::UserWarning",
                             ROOT / "examples" / f"{name}.py"], cwd=tmp_path, text=True, check=False,
                            capture_output=True, env=SETTINGS)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.strip()
