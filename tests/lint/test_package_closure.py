"""tools/checks/package_closure.py finds the package that tools/packages.txt lacks: with stand-ins for apt, dpkg and ninja.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from tools.checks import package_closure
from tools.project_root import ROOT

TABLE = """# sets
[build] # C++
g++      g++
liba-dev -   optional
[test-all] build
xvfb     Xvfb
"""
PROGRAMS = {
    "apt-cache": "printf 'Package: bash\\nEssential: yes\\n\\nPackage: other\\nPriority: optional\\n'",
    # What it would install: all that it is asked for, and what liba-dev needs.
    "apt-get": """for word; do case $word in -*|install) ;; *) echo "Inst $word (1)" ;; esac; done
case "$*" in *liba-dev*) echo 'Inst liba (1)' ;; esac""",
    "ninja": """case $* in *deps) printf 'x.o: #deps\\n    /usr/include/a.h\\n    rtl/x.v\\n' ;; *) echo 'g++ /usr/lib/libb.so -o x' ;; esac""",
    "dpkg": """shift; for file; do case $file in /usr/include/a.h) echo "liba-dev:amd64: $file" ;;
/usr/lib/libb.so) echo "libb: $file" ;; esac; done""",
}


@pytest.fixture
def check(checkout, monkeypatch):
    for name, body in PROGRAMS.items():
        checkout.put({f"bin/{name}": f"#!/bin/sh\n{body}\n"}, 0o755)
    monkeypatch.setenv("PATH", f"{checkout.root}/bin:/nowhere")
    (checkout.root / "bin" / "sh").symlink_to("/bin/sh")

    def checked(table):
        checkout.put({"tools/packages.txt": table})
        return package_closure.check(checkout.root, checkout.root / "build")[1]
    return checked


def test_a_package_that_is_missing_is_named(check):
    lines = check(TABLE)
    assert len(lines) == 1 and "brings libb, which a build uses: /usr/lib/libb.so" in lines[0]
    assert check(TABLE + "libb -\n") == []
    assert len(check(TABLE.replace("liba-dev", "libc-dev") + "libb -\n")) == 1


def test_sets_of_the_project():
    package_sets = package_closure.sets((ROOT / "tools" / "packages.txt").read_text())
    build = [row[0] for row in package_closure.rows_of(package_sets, "build")]
    assert "verilator" in build and "yosys" not in build
    assert set(build) < {row[0] for row in package_closure.rows_of(package_sets, "test")}
    wanted = {word for line in (ROOT / "Makefile").read_text().splitlines() if line.startswith("\t$(INSTALL)")
              for word in line.replace("$(CELLS)", "cells").replace("$(ROUTE)", "route").split()[1:]}
    assert wanted <= set(package_sets)
    for path in (ROOT / "tools").glob("requirements-*.txt"):
        assert path.stem.removeprefix("requirements-") in package_sets
