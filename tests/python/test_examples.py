"""The examples of Python run, and so does the code of docs/python.md.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("name", ["deform", "fit", "with_pyvista", "with_trimesh"])
def test_example(name, tmp_path):
    done = subprocess.run([sys.executable, "-B", "-W", "error::UserWarning",
                           ROOT / "examples" / f"{name}.py"], cwd=tmp_path, text=True, check=False,
                          capture_output=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.strip()


def test_the_page_on_python():
    text = (ROOT / "docs" / "python.md").read_text()
    blocks = re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    assert len(blocks) >= 2
    names = {}
    for block in blocks:
        exec(compile(block, "docs/python.md", "exec"), names)  # pylint: disable=exec-used
    assert names["moved"].shape == (1000, 3)
