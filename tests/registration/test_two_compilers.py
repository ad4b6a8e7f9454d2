"""A registration built by gcc and by clang has the same bits.

    pytest test_two_compilers.py --argument=PROGRAM --argument=SOURCE... --argument=LIBRARY... --argument=-OPTION...

PROGRAM was built with the project, of the first SOURCE and the library. Where each LIBRARY is given, make test takes from these
what is no part of registration, as gcc has built it.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import shutil
import subprocess

import pytest

APART = ("fold.cpp",)  # whose names are those of others of its folder


def lines_of(program):
    return subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()


@pytest.mark.parametrize("everything", (False, pytest.param(True, marks=pytest.mark.whole)))
def test_clang_gives_the_bits_of_gcc(arguments, tmp_path, everything):
    clang = shutil.which("clang++")
    if clang is None:
        pytest.skip("no clang++: run tools/install test")
    program, rest = arguments[0], arguments[1:]
    libraries = [] if everything else [word for word in rest if word.endswith(".a")]
    sources = [word for word in rest if word.endswith(".cpp")]
    if libraries:
        sources = [source for source in sources if source == sources[0] or "/registration/src/" in source]
    options = [word for word in rest if word.startswith("-")]
    # Those of a folder as one file: what they include would take most of the time.
    whole = {}
    for source in sources:
        path = pathlib.Path(source)
        part = "apart" if path.name in APART else str(path.parent).replace("/", "_")
        whole.setdefault(tmp_path / f"{part}.cpp", []).append(f'#include "{source}"\n')
    for path, lines in whole.items():
        path.write_text("".join(lines))
    built = tmp_path / "built"
    linked = ["-Wl,--start-group", *libraries, "-Wl,--end-group", "-lassimp", "-lhwy", "-lz"] if libraries else []
    subprocess.run([clang, "-std=c++17", "-O1", "-ffp-contract=off", *options, *whole, "-o", built, *linked, "-lfmt", "-lpthread"],
                   check=True)
    expected, found = lines_of(program), lines_of(built)
    metrics = [line.split() for line in expected if " " in line]
    assert len(metrics) == 3 and all(int(count) > 10 and float.fromhex(end) < float.fromhex(start)
                                     for _, count, start, end in metrics)
    assert len(expected) > 1000 and len(expected) == len(found)
    assert [n for n, pair in enumerate(zip(expected, found)) if pair[0] != pair[1]] == []
