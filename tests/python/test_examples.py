"""The examples of Python run, and so does the code of docs/python.md and docs/cluster.md.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import re
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Processes of Dask complain of each other where a busy machine ends one of them late.
SETTINGS = {**os.environ, "DASK_LOGGING__DISTRIBUTED": "critical"}


@pytest.mark.parametrize("name", ["deform", "fit", "with_dask", "with_pyvista", "with_trimesh"])
def test_example(name, tmp_path):
    done = subprocess.run([sys.executable, "-B", "-W", "error::UserWarning",
                           ROOT / "examples" / f"{name}.py"], cwd=tmp_path, text=True, check=False,
                          capture_output=True, env=SETTINGS)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.strip()


@pytest.mark.parametrize("page, least, shape", (("python", 2, (1000, 3)), ("cluster", 1, (60, 50, 40, 3))))
def test_a_page(page, least, shape):
    text = (ROOT / "docs" / f"{page}.md").read_text()
    blocks = re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    assert len(blocks) >= least
    names = {}
    for block in blocks:
        exec(compile(block, f"docs/{page}.md", "exec"), names)  # pylint: disable=exec-used
    assert names["moved"].shape == shape
