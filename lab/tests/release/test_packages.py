"""make -C lab packages: the archive of a small tree, with trials of its own.

SPDX-License-Identifier: Apache-2.0
"""

import hashlib
import tarfile

import pytest

from lab.release import packages


def tried(made):
    """the unpacked archive"""
    assert (made.sources / "a.v").read_text() == "module a;\n"
    assert not (made.sources / "untracked").exists()
    made.run("sh", "-c", "test -z \"$PYTHONPATH$HWFFD_X\"", folder=made.sources)


def fails(made):
    """what does not work"""
    made.run("sh", "-c", "echo what it says; exit 3")


@pytest.fixture
def packed(checkout, call, monkeypatch):
    """(exit status, lines printed, complaints) with these trials."""
    checkout.put({"VERSION": "1.2.3\n", ".gitignore": "build\nuntracked\n", "a.v": "module a;\n", "docs/releases/1.2.3.md": "new\n",
                  "untracked": ""})
    checkout.git("init", "--quiet")
    checkout.commit()
    monkeypatch.setenv("HWFFD_X", "1")

    def ran(*trials):
        monkeypatch.setattr(packages, "TRIALS", ((packages.Packages.archive, trials),))
        return call(packages.main, "--root", checkout.root)
    return ran


def test_the_archive_is_what_git_has_and_the_same_each_time(checkout, packed):
    path = checkout.root / "build" / "packages" / "hwffd-1.2.3.tar.gz"
    sums = set()
    for _ in range(2):
        assert packed(tried) == (0, ["packages: hwffd-1.2.3.tar.gz: the unpacked archive",
                                     "packages: build/packages/SHA256SUMS, 85 bytes",
                                     f"packages: build/packages/{path.name}, {path.stat().st_size:,} bytes"], [])
        sums.add(checkout.text("build/packages/SHA256SUMS"))
    assert sums == {f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n"}
    with tarfile.open(path) as file:
        assert sorted(file.getnames()) == [f"hwffd-1.2.3{name}" for name in (
            "", "/.gitignore", "/VERSION", "/a.v", "/docs", "/docs/releases", "/docs/releases/1.2.3.md")]


def test_a_release_has_notes(checkout, packed):
    (checkout.root / "docs" / "releases" / "1.2.3.md").unlink()
    assert packed(tried) == (1, [], ["packages: docs/releases/1.2.3.md is not there: a release has a page of notes"])
    assert not (checkout.root / "build" / "packages").exists()


def test_a_trial_that_fails_is_one_line(checkout, packed):
    status, _, errors = packed(fails)
    assert status == 1
    assert errors == [f"packages: sh -c ended with 3: see {checkout.root}/build/packages.log"]
    assert "what it says" in checkout.text("build/packages.log")
    assert sorted(path.name for path in (checkout.root / "build").iterdir()) == ["packages.log"]


def test_local_changes_are_refused(checkout, packed):
    checkout.put({"a.v": "module b;\n"})
    assert packed(tried) == (2, [], ["packages: the tree has a local change, a.v: commit it first"])
