"""What the bundled page has inside, and what apps/web/bundle.py says where something is missing.

SPDX-License-Identifier: Apache-2.0
"""

import base64
import gzip
import json
import re
import subprocess
import sys

import pytest
from browser import ROOT, program, stub_page


def bundle(*words):
    result = subprocess.run([sys.executable, "-B", "-m", "apps.web.bundle", *words],
                            capture_output=True, text=True, check=False)
    return result.returncode, result.stderr


def element(text, name):
    return re.search(rf'<script id="{name}"[^>]*>(.*?)</script>', text, re.DOTALL).group(1)


@pytest.fixture(scope="module")
def text(tmp_path_factory):
    return stub_page(tmp_path_factory.mktemp("page")).read_text()


@pytest.fixture
def engine(tmp_path):
    """A folder like the one that the engine's build makes; the end of a script stands in its worker."""
    folder = tmp_path / "engine"
    folder.mkdir()
    for name in ("engine.js", "drawings.js"):
        (folder / name).write_text(f"// {name}\n")
    (folder / "worker.js").write_text('const end = "</script><!--";\n')
    (folder / "engine.wasm").write_bytes(b"\0asm" * 100)
    return folder


def test_is_one_file(text):
    """Nothing is fetched: no address stands where a browser would follow it."""
    head = re.sub(r"<script.*?</script>", "", text, flags=re.DOTALL)
    assert not re.findall(r'(?:src|href)="(?!#|data:)[^"]*"|url\(|@import', head)
    assert not re.findall(r"<script[^>]*\ssrc=", text)


def test_has_licences(text):
    licences = json.loads(element(text, "data-licences"))
    assert any("three.js" in licence and "Permission is hereby granted" in licence for licence in licences)


def test_has_figures_of_the_reports(text):
    """The table is README's, row for row."""
    table = json.loads(element(text, "data-organizations"))
    readme = (ROOT / "README.md").read_text()
    (row,) = [row for row in table["rows"] if row[0] == "factored/3"]
    assert f"| `{row[0]}` | {' | '.join(row[1:])} |" in readme
    names = {entry["name"] for entry in json.loads(element(text, "data-pareto"))}
    assert "factored3-fx18-overlapped" in names


def test_engine(engine, tmp_path):
    """Its parts come back, and nothing in them ends the element that they stand in."""
    program("em++")
    page = tmp_path / "page.html"
    assert bundle("--engine", engine, "--output", page) == (0, "")
    text = page.read_text()
    worker = element(text, "worker-script")
    assert worker.startswith("// engine.js\n\n// drawings.js\n") and "<\\/script><\\!--" in worker
    packed = base64.b64decode(element(text, "packed-engine"))
    assert gzip.decompress(packed) == b"\0asm" * 100
    assert any(licence.startswith("verilator") for licence in json.loads(element(text, "data-licences")))


@pytest.mark.parametrize("missing", ["engine.js", "worker.js", "engine.wasm"])
def test_missing(engine, tmp_path, missing):
    program("em++")
    (engine / missing).unlink()
    status, errors = bundle("--engine", engine, "--output", tmp_path / "page.html")
    assert status == 1 and missing in errors and len(errors.splitlines()) == 1
    assert not (tmp_path / "page.html").exists()
