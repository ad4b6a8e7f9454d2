"""The Makefile hands hwffd-sim what was asked for, and tools/install asks for what is missing;
both against stand-ins for the programs that they start.

SPDX-License-Identifier: Apache-2.0
"""

import re
import shlex
import shutil

import pytest

from tools.project_root import ROOT
from tools.reports import report_modules

SHOW = """for word; do printf '<%s>' "$word"; done"""


@pytest.fixture
def sim(make, programs):
    """What hwffd-sim is given."""
    for build in ("build", "build-trace"):
        programs(**{f"{build}__tb__hwffd_sim": f"echo {build}; {SHOW}; " + 'exit "${STATUS:-0}"'})

    def given(*words, **variables):
        lines = make("sim", *words, **variables)[1]
        return lines[-1] if "<" in lines[-1] else ""
    return given


def test_every_variable(sim):
    given = {**dict.fromkeys(("MODEL", "DEFORM", "LATTICE", "ORG", "FORMAT", "SCHEDULE"), "x"), "STREAM": "dma", "SEED": "7"}
    for name, value in given.items():
        assert sim(f"{name}={value}") == f"<--{name.lower()}><{value}>"
    assert sim(*(f"{name}={value}" for name, value in given.items())) == "".join(
        f"<--{name.lower()}><{value}>" for name, value in given.items())


def test_only_the_command_line_counts(sim):
    assert sim(MODEL="x", ORG="y", TRACE="1") == ""
    assert sim("ORG=", "SEED=1", ORG="y") == "<--seed><1>"


@pytest.mark.parametrize("value, words, build, on", (
    ("1", "<--trace>", "build-trace", "ON"), ("0", "", "build", "OFF"), ("", "", "build", "OFF")))
@pytest.mark.usefixtures("sim")
def test_trace(make, value, words, build, on):
    _, lines, _ = make("sim", f"TRACE={value}")
    assert lines[-1] == (words or build)
    assert build in lines
    (configured,) = (line for line in lines if line.startswith(f"cmake -S . -B {build} "))
    assert f"-DHWFFD_TRACE={on}" in configured.split()


@pytest.mark.parametrize("value", (
    "a b.obj", "it's", '"q"', "$HOME", "$(shell echo no)", "`id`", "a;b|c&d>e", "*",
    "back\\slash\\", "#1", "a=b", "50%", "~", "-x", "(", "é"))
def test_values_survive(sim, value):
    assert sim(f"MODEL={value}") == f"<--model><{value}>"


@pytest.mark.parametrize("status", ("1", "2"))
@pytest.mark.usefixtures("sim")
def test_exit_status_is_shown(make, status):
    exit_status, _, errors = make("sim", STATUS=status)
    assert exit_status == 2
    assert re.search(rf"\Amake: \*\*\* \[Makefile:\d+: sim\] Error {status}\n\Z", errors)


@pytest.mark.parametrize("target, label", (("test", "^test$"), ("test-all", "^(test|all|synth|fuzz|lint)$"), ("test-synth", "^synth$"),
                                           ("fuzz", "^fuzz$"), ("lint", "^lint$")))
def test_tests_end_with_ctest(make, target, label):
    last = make(target)[1][-1]
    assert last.startswith("ctest ") and last.endswith(f" -L {label}")
    report = re.search(r"reports/(\S+)[.]xml", last)[1]
    assert report == ("tests" if target in ("test", "test-all") else target)
    assert report == "tests" or report not in report_modules.MODULES


def test_synth(make, programs):
    programs(tools__synth=SHOW)

    def synth(*words, **variables):
        return make("synth", "JOBS=3", *words, **variables)[1]

    assert synth(ORG="x", TARGET="y", SET="ci") == ["install engine cells", "<-j><3>"]
    given = [f"{name}=a {name}" for name in ("TARGET", "ORG", "N", "FORMAT", "SET")]
    assert synth(*given, "MODEL=x")[1:] == ["<-j><3>" + "".join(
        f"<--{word.split('=')[0].lower()}><{word.split('=')[1]}>" for word in given)]
    assert synth("ORG=$HOME;'")[1:] == ["<-j><3><--org><$HOME;'>"]


def test_structure_and_help(make, programs):
    programs(tools__synth__structure=f"printf structure; {SHOW}; echo")
    assert make("structure", "JOBS=3")[1][1:] == ["structure<-j><3>"]
    assert any("make test-all" in line for line in make()[1])


@pytest.mark.parametrize("words, complaint", (
    (("sim", "STREAM=q"), "STREAM=q: one of"), (("sim", "SEED=x"), "SEED=x: a number"),
    (("random", "N=1.2.3"), "N=1.2.3: a number"), (("lint", "TIER=none"), "TIER=none: one of"),
    (("sim", "JOBS=0"), "JOBS=0: a number"), (("test", "JOBS=two"), "JOBS=two: a number"),
    (("hwffd", "PREFIX=/dev/null/x"), "PREFIX=/dev/null/x: cannot be written")))
def test_a_wrong_word_is_refused_before_anything_is_built(make, words, complaint):
    status, lines, errors = make(*words)
    assert status == 2 and complaint in errors
    assert not any(line.startswith("cmake") for line in lines)


@pytest.mark.parametrize("word, complaint", (
    ("FORMAT=fp16", "FORMAT=fp16: unknown here: one of fp32"), ("ORG=foo", "ORG=foo: unknown here: one of basic"),
    ("ORG=cg2", "configurations: cg2 went with 0.3.0: take cg1\n"),
    ("SCHEDULE=x", "SCHEDULE=x: unknown here: one of paper, overlapped")))
def test_a_row_that_is_not_there_is_refused_before_anything_is_built(make, checkout, word, complaint):
    shutil.rmtree(checkout.root / "tools" / "tables")
    checkout.copy("rtl", "VERSION", "tools/tables", "tools/rtl")
    for module in (ROOT / "tools").glob("*.py"):
        checkout.copy(f"tools/{module.name}")
    status, lines, errors = make("sim", word)
    assert status == 2 and complaint in errors
    assert not any(line.startswith("cmake") for line in lines)


def test_the_generator_of_a_build_stays(make, checkout):
    assert " -G Ninja " in make("lint")[1][1]
    checkout.put({"build/CMakeCache.txt": ""})
    assert " -G " not in make("lint")[1][1]


@pytest.mark.parametrize("command", ("mutants", "bounds", "results"))
def test_what_has_moved_is_said(make, checkout, command):
    checkout.put({"lab/Makefile": ""})
    status, lines, errors = make(command)
    assert (status, lines) == (2, []) and errors.startswith(f"make: {command} has moved: make -C lab {command}\n")


@pytest.mark.parametrize("command", ("mutants", "organizations"))
def test_without_the_laboratory_its_commands_are_refused(make, command):
    status, lines, errors = make(command)
    assert (status, lines) == (2, [])
    assert errors.startswith(f"make: {command}: a command of the laboratory, and lab/ is not here\n")


HERE, ALL = "printf 'installed:lib-here{}'; exit 1", " installed:lib-gone installed:data-gone "


@pytest.fixture
def install(checkout, programs, run):
    """(exit status, lines of messages, apt-get's command lines)"""
    checkout.copy("tools/install")
    checkout.put({"tools/python_env": '#!/bin/sh\necho "python $*" >&2\n'}, 0o755)
    checkout.put({"tools/packages.txt":
                  "# comment\n\n[build] libraries # of C++\nshell sh\n[other]\nlib-other -\n"
                  "[libraries]\nlib-here -\nlib-gone -\ndata-gone - optional\n"})
    programs(bin__verilator="echo 'Verilator 5.006 2023-01-22 rev (Debian 5.006-3)'",
             bin__id="echo 0", bin__apt_cache="exit 0", bin__dpkg_query=HERE.format(" not-installed:lib-gone "), **apt("exit 0"))

    def installed(*sets, **variables):
        checkout.put({"apt.log": ""})
        status, _, errors = run("tools/install", *(sets or ("build",)), **variables)
        return status, errors.splitlines(), checkout.text("apt.log").splitlines()
    return installed


def apt(body):
    """It says on the descriptor for it how far it is, and what comes as `--print-uris`."""
    return {"bin__apt_get": f"""case $* in *--print-uris*) printf "'x' a_1.deb 1500000\\n'x' b_1.deb 500000\\n"; exit ;; "-q -s "*) printf 'Inst a\\nConf a\\n'; exit ;; esac
echo "$DEBIAN_FRONTEND $*" >>apt.log
printf 'pmstatus:dpkg:%s:x\\n' 3.5 41.2 44.4 99.9 >&3
{body}"""}


def test_all_there(install, programs):
    programs(bin__dpkg_query=HERE.format(ALL))
    assert install() == (0, ["python libraries build"], [])


def test_installs_what_is_missing(install):
    status, messages, asked = install()
    assert (status, len(asked)) == (0, 2)
    for line, end in zip(asked, ("update", "install .*--no-install-recommends lib-gone data-gone")):
        assert re.search(f"^noninteractive .* {end}$", line)
    assert "tools/install: installing 1 Debian packages (2 MB to fetch): lib-gone data-gone" in messages
    assert [line for line in messages if "%" in line][-2:] == [
        "tools/install: 40 % installed", "tools/install: 80 % installed"]
    assert len(messages) < 12


def test_only_what_a_set_names(install):
    assert [line.split()[-1] for line in install("other")[2]] == ["update", "lib-other"]
    assert "no set 'none': one of build other libraries" in install("none")[1][0]


def test_sudo(install, programs):
    programs(bin__id="echo 1000", bin__sudo='echo "sudo $1" >>apt.log\nexec "$@"')
    assert [line.split()[0] for line in install()[2]] == ["sudo", "sudo", "noninteractive"] + ["sudo", "noninteractive"]


def test_sudo_that_refuses(install, programs):
    programs(bin__id="echo 1000", bin__sudo="echo a password is required >&2; exit 1")
    status, (message,), asked = install()
    assert (status, asked) == (1, [])
    assert message.endswith("sudo does not let this user install; as root: "
                            "apt-get install --no-install-recommends lib-gone data-gone")


def test_no_install(install, programs):
    status, messages, asked = install(HWFFD_NO_INSTALL="1")
    assert (status, asked) == (0, [])
    assert messages[0].endswith("apt-get install --no-install-recommends lib-gone data-gone")


def test_no_install_ends_where_a_program_is_missing(install, checkout):
    checkout.put({"tools/packages.txt": "[build]\ntool tool-that-is-not-there\n"})
    status, (message,), asked = install(HWFFD_NO_INSTALL="1")
    assert (status, asked) == (1, [])
    assert message.endswith("not found: tool-that-is-not-there; to install: apt-get install --no-install-recommends tool")


def test_optional_package_is_looked_for_once(install, programs):
    programs(bin__apt_cache='case $* in *data-gone) exit 100 ;; esac')
    status, messages, asked = install()
    assert status == 0 and asked[-1].endswith(" lib-gone")
    assert any("going on without data-gone (optional)" in line for line in messages)
    programs(bin__dpkg_query=HERE.format(" installed:lib-gone "))
    assert install() == (0, ["python libraries build"], [])


@pytest.mark.parametrize("complaint", ("E: Unable to locate package lib-gone", "E: You don't have enough free space"))
def test_what_apt_says_is_one_line(install, programs, complaint):
    programs(**apt(f"echo noise; case $* in *lib-gone*) echo \"{complaint}\"; echo 'E: more'; exit 100 ;; esac"))
    status, messages, _ = install()
    assert status == 1 and f"could not install them: {complaint[3:]};" in messages[-1]
    assert not any("noise" in line for line in messages)


def test_an_interrupted_installation_goes_on(install, programs):
    programs(bin__dpkg='echo "dpkg $*" >>apt.log', **apt(
        "case $* in *lib-gone*) grep -q configure apt.log || { echo 'E: dpkg was interrupted, you must'; exit 100; } ;; esac"))
    status, _, asked = install()
    assert status == 0 and "dpkg --configure -a" in asked


@pytest.mark.parametrize("version, status", (
    ("4.228 2022-10-01", 1), ("5.005 devel", 1), ("5.006", 0), ("5.020 2024-01-01", 0),
    ("5.100 x", 0), ("6.000 x", 0)))
def test_old_verilator(install, programs, version, status):
    programs(bin__dpkg_query=HERE.format(ALL), bin__verilator=f"echo 'Verilator {version}'")
    exit_status, messages, _ = install()
    assert (exit_status, "or newer needed" in messages[0]) == (status, bool(status))


def test_fresh_knows_every_target(checkout):
    assert checkout.module("tools.checks.fresh_machine", "no-target") == (2, "", "fresh: not known here: no-target\n")


@pytest.fixture
def environment(checkout, programs, run):
    """What tools/python_env asks for, of a machine whose Python is of the version that the file `version` says."""
    checkout.copy("tools/python_env")
    checkout.put({"version": "3.11", **{f"tools/requirements-{name}.txt": f"{name}-package\n" for name in ("one", "two")}})
    here = shlex.quote(str(checkout.root))
    python = f"""case $* in
      *"import pip"*) test -e {here}/build/venv/lib/$(cat {here}/version)/pip ;;
      *"-m venv"*) echo venv >>{here}/asked
        rm -rf {here}/build/venv
        mkdir -p {here}/build/venv/bin {here}/build/venv/lib/$(cat {here}/version)
        touch {here}/build/venv/lib/$(cat {here}/version)/pip
        cp "$0" {here}/build/venv/bin/python ;;
      *"-m pip"*) echo "$*" | sed 's/.*requirements-/pip /' >>{here}/asked ;;
    esac"""
    programs(bin__python3=python)

    def asked(*sets):
        log = checkout.root / "asked"
        log.unlink(missing_ok=True)
        status, _, _ = run("tools/python_env", *sets)
        assert status == 0
        return log.read_text().splitlines() if log.exists() else []
    return asked


def test_python_packages_are_installed_once(environment):
    assert environment("one", "none") == ["venv", "pip one.txt"]
    assert environment("one", "two") == ["pip two.txt"]
    assert environment("one", "two") == []


@pytest.mark.parametrize("second", ("two", "one"))
def test_python_packages_of_another_python_do_not_count(environment, checkout, second):
    """The system's Python became another one: the virtual environment has no packages for it."""
    environment("one")
    checkout.put({"version": "3.13"})
    assert environment("one", second) == ["venv", "pip one.txt", "pip two.txt"][:2 if second == "one" else 3]
