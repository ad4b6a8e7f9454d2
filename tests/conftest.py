"""What tests in Python share: a folder for each, with copies of what it needs of the checkout.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

from tests.support import forked
from tools.project_root import environment

ROOT = pathlib.Path(__file__).resolve().parents[1]

# What tests start finds the packages of the checkout.
os.environ.update(environment())


class Checkout:
    """A folder that a test fills, and in which it runs what is tested."""

    def __init__(self, root):
        self.root = root

    def copy(self, *names):
        """Files or folders of the checkout."""
        for name in names:
            source, target = ROOT / name, self.root / name
            target.parent.mkdir(parents=True, exist_ok=True)
            (shutil.copytree if source.is_dir() else shutil.copy)(source, target)

    def link(self, *names):
        for name in names:
            (self.root / name).symlink_to(ROOT / name)

    def put(self, files, mode=0o644):
        """Writes files, {name: text, or what becomes JSON, or None for no file}."""
        for name, content in files.items():
            path = self.root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.unlink(missing_ok=True)
            if content is not None:
                path.write_text(content if isinstance(content, str) else json.dumps(content))
                path.chmod(mode)

    def text(self, name):
        return (self.root / name).read_text()

    def run(self, *command, **more):
        """(exit status, what it printed, its complaints)"""
        result = subprocess.run(command, cwd=self.root, stdin=subprocess.DEVNULL, text=True,
                                check=False, capture_output=True, **more)
        return result.returncode, result.stdout, result.stderr

    def module(self, name, *words, **more):
        """The same of a module of the checkout that is a command."""
        environment = {**(more.pop("env", None) or os.environ), "PYTHONPATH": str(ROOT)}
        result = forked.run_module(self.root, name, *words, env=environment)
        return result.returncode, result.stdout, result.stderr

    def git(self, *words):
        subprocess.run(["git", "-C", self.root, "-c", "user.name=x", "-c", "user.email=x@x.example",
                        *words], check=True)

    def commit(self):
        self.git("add", "--all")
        self.git("commit", "--quiet", "--allow-empty", "--message", "x")


def pytest_addoption(parser):
    parser.addoption("--argument", action="append", default=[])


def pytest_configure(config):
    config.addinivalue_line("markers", "whole: takes long; run with HWFFD_WHOLE=1, as test-all does")


def pytest_collection_modifyitems(config, items):
    """Tests that take long are left to test-all, unless they alone are asked for."""
    late = [item for item in items if item.get_closest_marker("whole")]
    if os.environ.get("HWFFD_WHOLE") or len(late) == len(items):
        return
    config.hook.pytest_deselected(items=late)
    items[:] = [item for item in items if item not in late]


@pytest.fixture(scope="session")
def arguments(request):
    """What the test was called with."""
    return request.config.getoption("--argument")


@pytest.fixture
def checkout(tmp_path):
    return Checkout(tmp_path.resolve())


@pytest.fixture
def call(capsys):
    """A script's main(), called: (exit status, lines that it printed, lines of complaints)"""
    def called(main, *words):
        status = main([str(word) for word in words])
        captured = capsys.readouterr()
        return status, captured.out.splitlines(), captured.err.splitlines()
    return called


MODULE = """import subprocess, sys
sys.exit(subprocess.run(["sh", "-c", {body!r}, "sh", *sys.argv[1:]]).returncode)
"""


def stand_in(name, body):
    """{path: text} of a program of the shell, or of a module that runs this in the shell, with the packages around it."""
    path = name.replace("__", "/")
    if name == "tools__install" or not name.startswith(("tools__", "lab__")):
        return {path.replace("_", "-"): f"#!/bin/sh\n{body}\n"}
    folders = [path[:end.start()] for end in re.finditer("/|$", path)]
    return {**{f"{folder}/__init__.py": "" for folder in folders}, f"{path}/__main__.py": MODULE.format(body=body)}


@pytest.fixture
def programs(checkout):
    """Writes programs of the shell, and modules of tools and lab that run it; programs in bin/ come first in PATH."""
    def put(**bodies):
        for name, body in bodies.items():
            checkout.put(stand_in(name, body), 0o755)
    return put


@pytest.fixture
def run(checkout):
    """Nothing of a make that may be running this test, nor of its caller's choices."""
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("MAKE", "MFLAGS", "HWFFD_"))}
    # The interpreter itself: a wrapper that chooses one takes longer than what it starts.
    interpreter = pathlib.Path(sys.executable).resolve().parent
    environment["PATH"] = f"{checkout.root}/bin:{interpreter}:{environment['PATH']}"
    return lambda *command, **variables: checkout.run(*command, env={**environment, **variables})


@pytest.fixture
def make(checkout, programs, run):
    """(exit status, lines that are printed, complaints)"""
    checkout.copy("Makefile", "tools/options.mk")
    programs(tools__checks__run_tests='shift; exec "$@"')
    programs(tools__install='echo "install $*"', tools__checks__lint="exit 0")
    programs(**{f"bin__{tool}": f'echo "{tool} $*"' for tool in ("cmake", "ctest")},
             **{"tools__tables__configurations": "exit 0"})

    def called(*words, **variables):
        status, out, errors = run("make", *words, **variables)
        return status, out.splitlines(), errors
    return called
