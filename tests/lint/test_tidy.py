"""tools/checks/clang_tidy.py: clang-tidy hears planted faults, in what a commit or the working tree changes, in
headers through a source that includes them, and says what it could not look at.

SPDX-License-Identifier: Apache-2.0
"""

import re

import pytest

from tools.checks import clang_tidy

FAULT = "inline int* {name}() {{ return 0; }}\n"  # nullptr
CLEAN = {
    "golden/include/hwffd/x.hpp": "#pragma once\nint x();\n",
    "golden/src/x.cpp": '#include "hwffd/x.hpp"\nint x() { return 1; }\n',
    "golden/src/other.cpp": "int other() { return 2; }\n",
    "docs/x.md": "x\n",
}
HEADER = "golden/include/hwffd/x.hpp"


@pytest.fixture
def tree(checkout):
    checkout.copy(".clang-tidy")
    checkout.put({**CLEAN, ".gitignore": "build/\n", clang_tidy.COMMANDS: [
        {"directory": str(checkout.root), "file": str(checkout.root / name),
         "command": f"c++ -std=c++17 -Werror -I{checkout.root}/golden/include -c {name}"}
        for name in CLEAN if name.endswith(".cpp")]})
    checkout.git("init", "--quiet")
    checkout.commit()
    return checkout


@pytest.fixture
def changed(tree):
    def names():
        files = clang_tidy.changed(tree.root, ("golden", "tests"))
        return None if files is None else [str(path.relative_to(tree.root)) for path in files]
    return names


@pytest.fixture
def findings(tree):
    """Of these files, or of all."""
    def lines_of(*names):
        lines = []
        for check in clang_tidy.checks(tree.root, [tree.root / name for name in names] or None):
            check.run()
            lines += check.findings + [check.left_out] * bool(check.left_out)
        return lines
    return lines_of


@pytest.fixture
def program(tree):
    """Its status, lines and complaints; of its lines those that do not tell how far it is, which come
    every few seconds."""
    def run():
        status, out, errors = tree.module("tools.checks.clang_tidy", "--root", tree.root)
        return status, [line for line in out.splitlines() if not line.startswith("[")], errors
    return run


def test_first_commit_has_none_before_it(changed):
    assert changed() is None


def test_committed_edited_and_new_files(tree, changed):
    tree.put({"golden/src/x.cpp": "int x();\n", "docs/x.md": "y\n"})
    tree.commit()
    assert changed() == ["golden/src/x.cpp"]
    tree.put({HEADER: "", "golden/src/new.cpp": "", "apps/a.cpp": "", "golden/src/other.cpp": None})
    assert changed() == [HEADER, "golden/src/new.cpp", "golden/src/x.cpp"]
    tree.commit()
    tree.commit()
    assert changed() == []


def test_clean_tree(program):
    assert program() == (0, ["tidy: 2 files, 0 findings"], "")


# what -> (files, those looked at, how their one finding begins, a word in it)
FOUND = {
    "in a source": ({"golden/src/x.cpp": FAULT.format(name="x")}, ("golden/src/x.cpp",),
                    "golden/src/x.cpp:1:", "modernize-use-nullptr"),
    **{f"in a header, of {names}": (
        {HEADER: CLEAN[HEADER] + FAULT.format(name="y")}, names, f"{HEADER}:3:", "nullptr")
       for names in ((HEADER,), ("golden/src/x.cpp",), ())},
    "in a header that nothing includes": (
        {"tests/y.hpp": "#pragma once\n" + FAULT.format(name="y")}, ("tests/y.hpp",), "tests/y.hpp:2:",
        "nullptr"),
    "what does not compile": ({"golden/src/x.cpp": "int x() { return; }\n"}, ("golden/src/x.cpp",),
                              "golden/src/x.cpp:1:", "should return a value [clang-diagnostic"),
    "a model that is not built": ({"golden/src/x.cpp": '#include "Vdma_small.h"\n'},
                                  ("golden/src/x.cpp",), "", "Vdma_small.h is not built"),
}


@pytest.mark.parametrize("files, names, begins, word", FOUND.values(), ids=FOUND)
def test_findings(tree, findings, files, names, begins, word):
    tree.put(files)
    (line,) = findings(*names)
    assert line.removeprefix(f"{tree.root}/").startswith(begins) and word in line
    assert findings("golden/src/other.cpp") == []


def test_what_the_program_says_of_a_finding(tree, findings, program):
    tree.put({"golden/src/x.cpp": FAULT.format(name="x")})
    assert program()[:2] == (1, [*findings(), "tidy: 2 files, 1 findings"])
    tree.put({"golden/src/x.cpp": '#include "Vdma_small.h"\n'})
    status, lines, _ = program()
    assert status == 1 and "left out: Vdma_small.h" in lines[0]


def test_in_one_of_several_sources_compiled_as_one(tree, program):
    together = str(tree.root / "build/golden/Unity/unity_0_cxx.cxx")
    sources = [name for name in CLEAN if name.endswith(".cpp")]
    tree.put({
        together: "".join(f'#include "{tree.root / name}"\n' for name in sources),
        clang_tidy.COMMANDS: [{"directory": str(tree.root), "file": together,
                               "command": f"c++ -std=c++17 -I{tree.root}/golden/include -c {together}"}]})
    assert program() == (0, ["tidy: 2 files, 0 findings"], "")
    tree.put({"golden/src/x.cpp": FAULT.format(name="x")})
    status, (line, _), _ = program()
    assert status == 1 and "golden/src/x.cpp:1:" in line


def test_without_compile_commands(tree, program):
    tree.put({clang_tidy.COMMANDS: None})
    status, lines, message = program()
    assert (status, lines) == (1, [])
    assert re.search(r"\Atidy: no build/compile_commands.json, .*make lint.*\n\Z", message)
