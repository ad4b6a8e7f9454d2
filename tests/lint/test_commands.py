"""The Makefile hands hwffd-sim what was asked for, and scripts/install asks for what is missing;
both against stand-ins for the programs that they start.

SPDX-License-Identifier: Apache-2.0
"""

import os
import re

import pytest

SHOW = """for word; do printf '<%s>' "$word"; done"""


@pytest.fixture
def programs(checkout):
    """Writes programs of the shell; those in bin/ come first in PATH."""
    def put(**bodies):
        for name, body in bodies.items():
            checkout.put({name.replace("__", "/").replace("_", "-"): f"#!/bin/sh\n{body}\n"}, 0o755)
    return put


@pytest.fixture
def run(checkout):
    """Nothing of a make that may be running this test, nor of its caller's choices."""
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("MAKE", "MFLAGS", "HWFFD_"))}
    environment["PATH"] = f"{checkout.root}/bin:{environment['PATH']}"
    return lambda *command, **variables: checkout.run(*command, env={**environment, **variables})


@pytest.fixture
def make(checkout, programs, run):
    """(exit status, lines that are printed, complaints)"""
    checkout.copy("Makefile")
    programs(scripts__install="exit 0", scripts__lint="exit 0", scripts__figures="""
[ "$1" != measure ] && { echo figures; exit; }
while [ "$1" != -- ]; do shift; done; shift; exec "$@" """)
    checkout.put({"scripts/python_env": "#!/bin/sh\n"}, 0o755)
    programs(**{f"bin__{tool}": f'echo "{tool} $*"' for tool in ("cmake", "ctest")})
    for build in ("build", "build-trace"):
        programs(**{f"{build}__apps__hwffd_sim": f"echo {build}; {SHOW}; " + 'exit "${STATUS:-0}"'})

    def called(*words, **variables):
        status, out, errors = run("make", *words, **variables)
        return status, out.splitlines(), errors
    return called


@pytest.fixture
def sim(make):
    """What hwffd-sim is given."""
    def given(*words, **variables):
        lines = make("sim", *words, **variables)[1]
        return lines[-1] if "<" in lines[-1] else ""
    return given


def test_every_variable(sim):
    names = ("MODEL", "DEFORM", "LATTICE", "ORG", "FORMAT", "SCHEDULE", "STREAM", "SEED")
    for name in names:
        assert sim(f"{name}=x") == f"<--{name.lower()}><x>"
    assert sim(*(f"{name}={name}" for name in names)) == "".join(
        f"<--{name.lower()}><{name}>" for name in names)


def test_only_the_command_line_counts(sim):
    assert sim(MODEL="x", ORG="y", TRACE="1") == ""
    assert sim("ORG=", "SEED=1", ORG="y") == "<--seed><1>"


@pytest.mark.parametrize("value, words, build, on", (
    ("1", "<--trace>", "build-trace", "ON"), ("0", "", "build", "OFF"), ("", "", "build", "OFF")))
def test_trace(make, value, words, build, on):
    _, lines, _ = make("sim", f"TRACE={value}")
    assert lines[-1] == (words or build)
    assert build in lines
    (configured,) = (line for line in lines if line.startswith(f"cmake -S . -B {build} "))
    assert configured.endswith(f"-DHWFFD_TRACE={on}")


@pytest.mark.parametrize("value", (
    "a b.obj", "it's", '"q"', "$HOME", "$(shell echo no)", "`id`", "a;b|c&d>e", "*",
    "back\\slash\\", "#1", "a=b", "50%", "~", "-x", "(", "é"))
def test_values_survive(sim, value):
    assert sim(f"MODEL={value}") == f"<--model><{value}>"


@pytest.mark.parametrize("status", ("1", "2"))
def test_exit_status_is_shown(make, status):
    found, _, errors = make("sim", STATUS=status)
    assert found == 2
    assert re.search(rf"\Amake: \*\*\* \[Makefile:\d+: sim\] Error {status}\n\Z", errors)


@pytest.mark.parametrize("target, label", (("test", "^test$"), ("test-all", "^(test|all)$")))
def test_tests_end_with_ctest(make, target, label):
    last = make(target)[1][-1]
    assert last.startswith("ctest ") and last.endswith(f" -L {label}")


@pytest.mark.parametrize("name", ("words", "embed", "tangents"))
def test_a_study_builds_one_program_and_runs_it(make, programs, name):
    programs(**{f"build__studies__hwffd_{name}": f'echo "{name}<$*>"'})
    lines = make(name)[1]
    assert lines[-2].endswith(f" --target hwffd-{name}")
    assert lines[-1] == f"{name}<>"


def test_compare_builds_its_program_and_runs_it_beside_others(make, programs):
    programs(build__venv__bin__python='echo "python<$*>"')
    lines = make("compare")[1]
    assert lines[-2].endswith(" --target hwffd-compare hwffd_python")
    assert lines[-1] == "python<-B studies/compare>"


def test_bfp_selects_rows_of_its_format(make, programs):
    programs(**{"scripts__configurations.py": ":", "build__studies__hwffd_bfp": 'echo "bfp<$*>"'})
    lines = make("bfp", "ORG=basic", "FORMAT=fx18")[1]
    assert {"-DHWFFD_ORG=basic", "-DHWFFD_N=", "-DHWFFD_FORMAT=bfp32"} <= set(lines[-3].split())
    assert lines[-2].endswith(" --target hwffd-bfp")
    assert lines[-1] == "bfp<>"


def test_synth(make, programs):
    programs(scripts__synth=SHOW)

    def synth(*words, **variables):
        return make("synth", "JOBS=3", *words, **variables)[1]

    assert synth(ORG="x", TARGET="y", SET="ci") == ["<-j><3>"]
    given = [f"{name}=a {name}" for name in ("TARGET", "ORG", "N", "FORMAT", "SET")]
    assert synth(*given, "MODEL=x") == ["<-j><3>" + "".join(
        f"<--{word.split('=')[0].lower()}><{word.split('=')[1]}>" for word in given)]
    assert synth("ORG=$HOME;'") == ["<-j><3><--org><$HOME;'>"]


def test_workflow(make, programs, checkout):
    programs(build__venv__bin__snakemake=SHOW)
    (checkout.root / "studies" / "workflow" / "profiles" / "slurm").mkdir(parents=True)
    start = ("<--snakefile><studies/workflow/Snakefile><--directory><build><--workflow-profile>"
             "<synth/profiles/default><--profile>")
    config = f"<--config><root={checkout.root}>"
    assert make("workflow", PROFILE="slurm")[1][-1] == f"{start}<studies/workflow/profiles/local>{config}"
    assert make("workflow", "PROFILE=slurm", "WORK=soak pnr", "SEEDS=3", "JOBS=9")[1][-1] == (
        f"{start}<studies/workflow/profiles/slurm><--cores><9><--jobs><9>{config}<work=soak pnr><soak_seeds=3>")
    assert make("workflow", "PROFILE=ours $HOME;'", "WORK=")[1][-1] == f"{start}<ours $HOME;'>{config}"


def test_figures_structure_and_help(make, programs):
    programs(scripts__structure=f"printf structure; {SHOW}; echo")
    assert make("structure", "JOBS=3")[1] == ["structure<-j><3>"]
    assert make("figures")[1] == ["figures"]
    assert any("make test-all" in line for line in make()[1])


HERE, ALL = "printf 'installed:lib-here{}'; exit 1", " installed:lib-gone installed:data-gone "


@pytest.fixture
def install(checkout, programs, run):
    """(exit status, lines of messages, apt-get's command lines)"""
    checkout.copy("scripts/install")
    checkout.put({"scripts/packages.txt":
                  "# comment\n\nshell sh\nlib-here -\nlib-gone -\ndata-gone - optional\n"})
    programs(bin__verilator="echo 'Verilator 5.006 2023-01-22 rev (Debian 5.006-3)'",
             bin__id="echo 0", bin__dpkg_query=HERE.format(" not-installed:lib-gone "), **apt("exit 0"))

    def installed(**variables):
        checkout.put({"apt.log": ""})
        status, _, errors = run("scripts/install", **variables)
        return status, errors.splitlines(), checkout.text("apt.log").splitlines()
    return installed


def apt(body):
    return {"bin__apt_get": f'echo "$DEBIAN_FRONTEND $*" >>apt.log\n{body}'}


def test_all_there(install, programs):
    programs(bin__dpkg_query=HERE.format(ALL))
    assert install() == (0, [], [])


def test_installs_what_is_missing(install):
    status, _, asked = install()
    assert (status, len(asked)) == (0, 3)
    for line, end in zip(asked, ("update", "install --no-install-recommends lib-gone",
                                 "install --no-install-recommends data-gone")):
        assert re.search(f"^noninteractive .* {end}$", line)


def test_sudo(install, programs):
    programs(bin__id="echo 1000", bin__sudo='echo "sudo $*" >>apt.log\nexec "$@"')
    assert [line.startswith("sudo ") for line in install()[2]] == [True, False] * 3


def test_no_install(install):
    status, (message,), asked = install(HWFFD_NO_INSTALL="1")
    assert (status, asked) == (0, [])
    assert message.endswith("apt-get install --no-install-recommends lib-gone data-gone")


def test_optional_package_is_asked_for_once(install, programs):
    programs(**apt("case $* in *data-gone) exit 100 ;; esac"))
    assert install()[0] == 0
    programs(bin__dpkg_query=HERE.format(" installed:lib-gone "))
    assert install() == (0, [], [])


def test_required_package_that_cannot_be_had(install, programs):
    programs(**apt("case $* in *lib-gone) exit 100 ;; esac"))
    status, messages, _ = install()
    assert status == 1 and "could not install lib-gone" in messages[-1]


@pytest.mark.parametrize("version, status", (
    ("4.228 2022-10-01", 1), ("5.005 devel", 1), ("5.006", 0), ("5.020 2024-01-01", 0),
    ("5.100 x", 0), ("6.000 x", 0)))
def test_old_verilator(install, programs, version, status):
    programs(bin__dpkg_query=HERE.format(ALL), bin__verilator=f"echo 'Verilator {version}'")
    found, messages, _ = install()
    assert (found, len(messages)) == (status, status)
    assert install(HWFFD_NO_INSTALL="1")[0] == 0
