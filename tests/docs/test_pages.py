"""Every command and every piece of code in a page is run here, or a mark says which test runs it or why none does;
and every `make` of a text is one that there is.

    pytest test_pages.py --argument=BUILD --argument=COMMAND

SPDX-License-Identifier: Apache-2.0
"""

import contextlib
import io
import math
import os
import pathlib
import re
import shutil
import subprocess
import tempfile

import blocks
import pytest
import SimpleITK

from apps.docs import staging
from tools.project_root import ROOT

BLOCKS = blocks.of_project(ROOT)
MODELS = pathlib.Path("/usr/share/glmark2/models")
# Of pages as short as they can be, which have no marks, what tests run the blocks of a language.
RUN_BY = {**{("README.md", kind): "hwffd.install" for kind in ("sh", "python", "cpp")},
          ("README.md", "verilog"): "lint.readme"}
RUN_HERE = [block for block in BLOCKS if not block.mark and (block.page, block.language) not in RUN_BY]
PYTHON_PAGES = list(dict.fromkeys(block.page for block in RUN_HERE if block.language == "python"))
SHELL = [block for block in RUN_HERE if block.language == "sh"]
# Of a block that is run, commands that are not, and the tests that run them.
ELSEWHERE = {"hwffd view": "view.window"}
CUBE = """v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1
f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 3 4 8\nf 3 8 7\n"""


@pytest.fixture(scope="module")
def build(arguments):
    return pathlib.Path(arguments[0])


@pytest.fixture
def folder(tmp_path, arguments):
    """Where commands run: with the files that pages speak of."""
    there = tmp_path
    (there / "chair.obj").write_text(CUBE)
    for name in ("tests", "rtl"):
        (there / name).symlink_to(ROOT / name)
    head = SimpleITK.GetImageFromArray([[[float(i + j * k) for i in range(8)] for j in range(9)] for k in range(10)])
    for name in ("head.nrrd", "head.nii.gz"):
        SimpleITK.WriteImage(head, str(there / name))
    waves = [[[math.sin(i / 3) + math.cos(j / 4) * math.sin(k / 5) for i in range(33)] for j in range(32)] for k in range(32)]
    for name, first in ("fixed", 0), ("moving", 1):
        image = SimpleITK.GetImageFromArray([[row[first:first + 32] for row in plane] for plane in waves])
        SimpleITK.WriteImage(image, str(there / f"{name}.nii.gz"))
    command = arguments[1]
    for words in (("--dims", "6x6x6", "-o", "rest.json"),
                  ("--dims", "6x6x6", "--deform", "twist:30", "-o", "moved.json")):
        subprocess.run([command, "lattice", "--lattice", "box", "--around", "chair.obj", *words], cwd=there, check=True)
    return there


@pytest.fixture(scope="module")
def tests(build):
    """The names of all tests of the build."""
    # By a folder of its own: ctest empties the log of the build whose tests it lists.
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "CTestTestfile.cmake").write_text(f'subdirs("{build}")\n')
        listed = subprocess.run(["ctest", "--test-dir", folder, "-N"], stdout=subprocess.PIPE, text=True, check=True)
    return re.findall(r"^ *Test +#\d+: (.+)$", listed.stdout, re.MULTILINE)


def test_blocks_are_found():
    text = "a\n\n<!-- not run: long -->\n```sh\nmake words\n```\n\n    hwffd info \\\n      x   # why\n\n    q = 1\n\n```python\n1\n```\n\n```text\n2\n```\n"
    parsed = blocks.of_text("p.md", text)
    assert [(block.language, block.line, block.mark, block.reason) for block in parsed] == [
        ("sh", 3, "not run", "long"), ("sh", 8, "", ""), ("python", 13, "", "")]
    assert parsed[1].commands() == ["hwffd info x"]
    assert parsed[2].expected == "2\n"


@pytest.mark.parametrize("expected, output, same", (
    ("a ... c\n", "a  b c\n", True), ("a\n", "a\nb\n", False), ("1.5\n", "1x5\n", False)))
def test_what_is_shown_is_compared(expected, output, same):
    assert blocks.matches(expected, output) is same


def test_every_block_is_run_or_marked():
    assert len(BLOCKS) > 20
    wrong = [block.place for block in RUN_HERE if block.language not in ("sh", "python")]
    assert not wrong, "no test runs these; mark them '<!-- run by: TEST -->' or '<!-- not run: REASON -->'"


def test_tests_that_are_named_exist(tests):
    wanted = {(block.place, name) for block in BLOCKS if block.mark == "run by" for name in block.reason.split(", ")}
    wanted |= {("test_pages.py", name) for name in [*ELSEWHERE.values(), *RUN_BY.values()]}
    missing = [(place, name) for place, name in sorted(wanted) if not any(test.startswith(name) for test in tests)]
    assert not missing


@pytest.mark.parametrize("page", PYTHON_PAGES)
def test_python(page, folder, monkeypatch):
    monkeypatch.chdir(folder)
    names = {}
    for block in BLOCKS:
        if block.page != page or block.language != "python" or block.mark:
            continue
        output = io.StringIO()
        with contextlib.redirect_stdout(output):
            exec(compile(block.text, block.place, "exec"), names)  # pylint: disable=exec-used
        if block.expected:
            assert blocks.matches(block.expected, output.getvalue()), (block.place, output.getvalue())


@pytest.mark.parametrize("block", SHELL, ids=lambda block: block.place)
def test_shell(block, folder, build, arguments):
    if ".3ds" in block.text and not MODELS.is_dir():
        pytest.skip("no models of glmark2")
    path = f"{pathlib.Path(arguments[1]).parent}:{build / 'api' / 'python'}:{os.environ['PATH']}"
    output = ""
    for command in block.commands():
        if any(command.startswith(prefix) for prefix in ELSEWHERE):
            continue
        result = subprocess.run(["bash", "-c", command], cwd=folder, env={**os.environ, "PATH": path}, text=True,
                                stdin=subprocess.DEVNULL, capture_output=True, check=False)
        assert result.returncode == 0, f"{block.place}: {command}: {result.stderr}"
        output += result.stdout
    if block.expected:
        assert blocks.matches(block.expected, output), output


def _fenced_indented(text):
    """Commands in fenced blocks like the others."""
    return re.sub(r"^```sh\n.*?^```$", lambda block: re.sub("^", "    ", block.group(), flags=re.MULTILINE), text,
                  flags=re.MULTILINE | re.DOTALL)


def test_every_make_of_a_text_is_one_that_there_is():
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    targets, handed_on = (set(" ".join(re.findall(rf"^(?:{begin}) (.*)$", makefile, re.MULTILINE)).split())
                          for begin in (r"\.PHONY:", r"FORWARDED *=|MOVED *="))  # those take variables of their own
    variables = set(re.findall(r"\bgiven,([A-Z]+)\b|:([A-Z]+)\b|^([A-Z]+)\s*\?=", makefile, re.MULTILINE))
    variables = {name for names in variables for name in names if name}
    wrong, checked = [], 0
    for path in staging.pages(ROOT):
        for words in re.findall(r"(?:`|^ {4})make ([a-z][^`\n#&|]*)", _fenced_indented(path.read_text(encoding="utf-8")), re.MULTILINE):
            target, *given = words.split()
            names = [word.partition("=")[0] for word in given if re.match(r"[A-Z]+=", word)]
            checked += 1
            if target not in handed_on and (target not in targets or not set(names) <= variables):
                wrong.append((str(path.relative_to(ROOT)), words))
    assert checked > 100
    assert not wrong


def test_the_command_is_the_one_that_was_built(arguments):
    assert shutil.which(arguments[1])
