"""The laboratory's Makefile hands its programs what was asked for, against stand-ins for the programs that it starts.

SPDX-License-Identifier: Apache-2.0
"""

import re
import shutil

import pytest

from tools.project_root import ROOT

SHOW = """for word; do printf '<%s>' "$word"; done"""


@pytest.fixture
def lab(make, checkout, programs):
    """The same as `make`, of the laboratory."""
    checkout.copy("lab/Makefile")
    programs(build__venv__bin__python='exec python3 "$@"', lab__figures="""
[ "$1" != run ] && { echo figures; exit; }
while [ "$1" != -- ]; do shift; done; shift; exec "$@" """)
    return lambda *words, **variables: make("--no-print-directory", "-C", "lab", *words, **variables)


STUDIES = re.search(r"^STUDIES = ((?:.*\\\n)*.*)$", (ROOT / "lab" / "Makefile").read_text(encoding="utf-8"),
                    re.MULTILINE)[1].replace("\\", "").split()
SETS = dict(re.findall(r"^\[(.+)\] *([^#\n]*)", "".join((ROOT / folder / "packages.txt").read_text(encoding="utf-8")
                                                      for folder in ("tools", "lab")), re.MULTILINE))


def has_packages(name):
    """Whether build/venv is made for a set, as tools/python_env does."""
    return any((ROOT / folder / f"requirements-{name}.txt").is_file() for folder in ("tools", "lab")) or any(
        map(has_packages, SETS[name].split()))


@pytest.mark.parametrize("name", sorted(set(STUDIES) - {"formal"}))
def test_the_python_that_a_study_starts_is_installed(lab, name):
    """On a machine that has nothing build/venv comes with the packages of a set."""
    word, *sets = lab(name)[1][0].split()
    assert word == "install" and any(map(has_packages, sets))


def test_programs_that_are_named_are_where_they_are_built():
    """Those of pages, and of the commands that repeat a failure."""
    named = {(path, *match) for pattern in ("docs/*.md", "*/*.cpp") for path in (ROOT / "lab").glob(pattern)
             for match in re.findall(r"\b(build/[\w/]*)hwffd-(\w+)", path.read_text(encoding="utf-8"))}
    assert named and {(folder, program) for _, folder, program in named} == {
        (f"build/lab/{program}/", program) for *_, program in named}


@pytest.mark.parametrize("name", ("words", "embed", "tangents"))
def test_a_study_builds_one_program_and_runs_it(lab, programs, name):
    programs(**{f"build__lab__{name}__hwffd_{name}": f'echo "{name}<$*>"'})
    lines = lab(name)[1]
    assert lines[-2].endswith(f" --target hwffd-{name}")
    assert lines[-1] == f"{name}<>"


def test_a_study_of_the_table_needs_no_rule(lab, programs, checkout):
    checkout.put({"lab/release/studies.csv": "name,report,command,page,question,takes\nfee,fee,make -C lab fee,,,\n"
                                             "foe,foe,make -C lab foe,foe.md,How?,days\nwords,words,make words,,,\n", "lab/foe/CMakeLists.txt": ""})
    programs(lab__fee="echo fee", build__lab__foe__hwffd_foe="echo foe")
    assert lab("fee")[1][-1] == "fee" and not any(line.startswith("cmake") for line in lab("fee")[1])
    lines = lab("foe")[1]
    assert lines[-2].endswith(" --target hwffd-foe") and lines[-1] == "foe"
    assert {"  fee", "  foe"} <= set(lab()[1])


def test_compare_builds_its_program_and_runs_it_beside_others(lab, programs):
    programs(lab__compare="echo compare")
    lines = lab("compare")[1]
    assert lines[-2].endswith(" --target hwffd-compare hwffd_python")
    assert lines[-1] == "compare"


def test_align_builds_the_module_and_hands_on_its_budget(lab, programs):
    programs(lab__align=SHOW)
    lines = lab("align", "MINUTES=2")[1]
    assert lines[-2].endswith(" --target hwffd_python")
    assert lines[-1] == "<--minutes><2>"
    assert lab("align")[1][-1] != lines[-1]


def test_bfp_selects_rows_of_its_format(lab, programs):
    programs(**{"tools__tables__configurations": ":", "build__lab__bfp__hwffd_bfp": 'echo "bfp<$*>"'})
    lines = lab("bfp", "ORG=basic", "FORMAT=fx18")[1]
    assert {"-DHWFFD_ORG=basic", "-DHWFFD_N=", "-DHWFFD_FORMAT=bfp32"} <= set(lines[-3].split())
    assert "-DHWFFD_FORMAT=fx18" not in lines[-3]
    assert lines[-2].endswith(" --target hwffd-bfp")
    assert lines[-1] == "bfp<>"


def test_workflow(lab, programs, checkout):
    programs(build__venv__bin__snakemake=SHOW)
    (checkout.root / "lab" / "workflow" / "profiles" / "slurm").mkdir(parents=True)
    start = ("<--snakefile><lab/workflow/Snakefile><--directory><build><--workflow-profile>"
             "<synth/profiles/default><--profile>")
    config = f"<--config><root={checkout.root}>"
    assert lab("workflow", PROFILE="slurm")[1][-1] == f"{start}<lab/workflow/profiles/local>{config}"
    assert lab("workflow", "PROFILE=slurm", "WORK=soak pnr", "SEEDS=3", "JOBS=9")[1][-1] == (
        f"{start}<lab/workflow/profiles/slurm><--cores><9><--jobs><9>{config}<work=soak pnr><soak_seeds=3>")
    assert lab("workflow", "PROFILE=ours $HOME;'", "WORK=")[1][-1] == f"{start}<ours $HOME;'>{config}"


def test_what_an_earlier_command_configured_does_not_stay(lab, programs):
    programs(**{"tools__tables__configurations": ":", "build__lab__organizations__hwffd_organizations": "exit 0",
                "build__lab__words__hwffd_words": "exit 0"})

    def configured(*words):
        (line,) = (line for line in lab(*words)[1] if line.startswith("cmake -S"))
        return {word for word in line.split() if word.startswith("-DHWFFD")}

    selected = configured("organizations", "ORG=basic", "N=1", "FORMAT=fx18")
    plain = configured("words", "ORG=basic")
    assert selected - plain == {"-DHWFFD_ORG=basic", "-DHWFFD_N=1", "-DHWFFD_FORMAT=fx18"}
    assert {word.split("=")[0] for word in selected} == {word.split("=")[0] for word in plain}


@pytest.mark.parametrize("words, complaint", (
    (("soak", "HOURS=1h"), "HOURS=1h: a number"), (("upsets", "FLIPS=1.2.3"), "FLIPS=1.2.3: a number"),
    (("words", "TIER=none"), "TIER=none: one of")))
def test_a_wrong_word_is_refused_before_anything_is_built(lab, words, complaint):
    status, lines, errors = lab(*words)
    assert status == 2 and complaint in errors
    assert not any(line.startswith("cmake") for line in lines)


def test_an_organization_that_went_is_refused_before_anything_is_built(lab, checkout):
    shutil.rmtree(checkout.root / "tools" / "tables", ignore_errors=True)
    checkout.copy("rtl", "VERSION", "tools/tables", "tools/rtl")
    for module in (ROOT / "tools").glob("*.py"):
        checkout.copy(f"tools/{module.name}")
    status, lines, errors = lab("organizations", "ORG=cg2")
    assert status == 2 and "configurations: cg2 went with 0.3.0: take cg1\n" in errors
    assert not any(line.startswith("cmake") for line in lines)


@pytest.mark.parametrize("command", ("words", "streams"))
def test_the_root_hands_on(lab, make, programs, command):
    programs(**{f"build__lab__{command}__hwffd_{command}": f"{SHOW}; echo {command}"})
    assert lab(command) == make(command) and make(command)[1][-1] == command


def test_figures_and_help(lab):
    assert lab("figures")[1] == ["install figures", "figures"]
    assert any("organizations" in line for line in lab()[1])
