"""The Makefile hands hwffd-sim what was asked for, and scripts/install asks for what is missing;
both against stand-ins for the programs that they start.

SPDX-License-Identifier: Apache-2.0
"""

import os
import shutil
import subprocess
import unittest

from workspace import ROOT, Workspace


class Checkout(Workspace):
    """A folder with the file under test, and a bin/ that comes first in PATH."""

    def setUp(self):
        super().setUp()

    def script(self, name, body):
        self.program(name, f"#!/bin/sh\n{body}\n")

    def run_here(self, *command, **variables):
        # Nothing of a make that may be running this test, nor of its caller's choices.
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith(("MAKE", "MFLAGS", "HWFFD_"))}
        environment["PATH"] = f"{self.root}/bin:{environment['PATH']}"
        environment.update(variables)
        return subprocess.run(command, cwd=self.root, env=environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              check=False)


class Make(Checkout):
    def setUp(self):
        super().setUp()
        self.copy("Makefile")
        self.script("scripts/install", "exit 0")
        self.script("scripts/lint", "exit 0")
        self.script("scripts/python_env", ":")
        self.script("scripts/figures", '''[ "$1" != measure ] && { echo figures; exit; }
while [ "$1" != -- ]; do shift; done; shift; exec "$@"''')
        for tool in ("cmake", "ctest"):
            self.script(f"bin/{tool}", f'echo "{tool} $*"')
        for build in ("build", "build-trace"):
            self.script(f"{build}/apps/hwffd-sim", f"echo {build}; "
                        """for word; do printf '<%s>' "$word"; done; exit "${STATUS:-0}" """)

    def sim(self, *words, **variables):
        done = self.run_here("make", "sim", *words, **variables)
        return done, done.stdout.splitlines()[-1] if "<" in done.stdout else ""

    def test_every_variable(self):
        names = ("MODEL", "DEFORM", "LATTICE", "ORG", "FORMAT", "SCHEDULE", "STREAM", "SEED")
        for name in names:
            self.assertEqual(self.sim(f"{name}=x")[1], f"<--{name.lower()}><x>")
        given = self.sim(*(f"{name}={name}" for name in names))[1]
        self.assertEqual(given, "".join(f"<--{name.lower()}><{name}>" for name in names))

    def test_only_the_command_line_counts(self):
        self.assertEqual(self.sim(MODEL="x", ORG="y", TRACE="1")[1], "")
        self.assertEqual(self.sim("ORG=", "SEED=1", ORG="y")[1], "<--seed><1>")

    def test_trace(self):
        for value, words in (("1", "<--trace>"), ("0", ""), ("", "")):
            done, given = self.sim(f"TRACE={value}")
            build, on = ("build-trace", "ON") if words else ("build", "OFF")
            self.assertEqual(given, words)
            self.assertIn(build, done.stdout.splitlines())
            self.assertIn(f"cmake -S . -B {build} ", done.stdout)
            self.assertIn(f"-DHWFFD_TRACE={on}\n", done.stdout)

    def test_values_survive(self):
        for value in ("a b.obj", "it's", '"q"', "$HOME", "$(shell echo no)", "`id`", "a;b|c&d>e",
                      "*", "back\\slash\\", "#1", "a=b", "50%", "~", "-x", "(", "é"):
            with self.subTest(value):
                self.assertEqual(self.sim(f"MODEL={value}")[1], f"<--model><{value}>")

    def test_exit_status_is_shown(self):
        for status in ("1", "2"):
            done, _ = self.sim(STATUS=status)
            self.assertEqual(done.returncode, 2)
            self.assertRegex(
                done.stderr, rf"\Amake: \*\*\* \[Makefile:\d+: sim\] Error {status}\n\Z")

    def test_tests_end_with_ctest(self):
        for target, label in (("test", "^test$"), ("test-all", "^(test|all)$")):
            lines = self.run_here("make", target).stdout.splitlines()
            self.assertTrue(lines[-1].startswith("ctest "), lines)
            self.assertTrue(lines[-1].endswith(f" -L {label}"), lines)

    def test_words_embed_and_tangents_build_one_program_and_run_it(self):
        for name in ("words", "embed", "tangents"):
            self.script(f"build/studies/hwffd-{name}", f'echo "{name}<$*>"')
            lines = self.run_here("make", name).stdout.splitlines()
            self.assertTrue(lines[-2].endswith(f" --target hwffd-{name}"), lines)
            self.assertEqual(lines[-1], f"{name}<>")

    def test_bfp_selects_rows_of_its_format(self):
        self.script("scripts/configurations.py", ":")
        self.script("build/studies/hwffd-bfp", 'echo "bfp<$*>"')
        lines = self.run_here("make", "bfp", "ORG=basic", "FORMAT=fx18").stdout.splitlines()
        for word in ("-DHWFFD_ORG=basic", "-DHWFFD_N=", "-DHWFFD_FORMAT=bfp32"):
            self.assertIn(word, lines[-3].split())
        self.assertTrue(lines[-2].endswith(" --target hwffd-bfp"), lines)
        self.assertEqual(lines[-1], "bfp<>")

    def test_synth(self):
        self.script("scripts/synth", """for word; do printf '<%s>' "$word"; done""")

        def synth(*words, **variables):
            return self.run_here("make", "synth", "JOBS=3", *words, **variables).stdout

        self.assertEqual(synth(ORG="x", TARGET="y", SET="ci"), "<-j><3>")
        given = [f"{name}=a {name}" for name in ("TARGET", "ORG", "N", "FORMAT", "SET")]
        self.assertEqual(synth(*given, "MODEL=x"), "<-j><3>" + "".join(
            f"<--{word.split('=')[0].lower()}><{word.split('=')[1]}>" for word in given))
        self.assertEqual(synth("ORG=$HOME;'"), "<-j><3><--org><$HOME;'>")

    def test_figures_and_structure(self):
        self.script("scripts/structure", """printf 'structure'; printf '<%s>' "$@"; echo""")
        self.assertEqual(self.run_here("make", "structure", "JOBS=3").stdout, "structure<-j><3>\n")
        self.assertEqual(self.run_here("make", "figures").stdout, "figures\n")

    def test_help_is_the_default(self):
        self.assertIn("make test-all", self.run_here("make").stdout)


class Install(Checkout):
    def setUp(self):
        super().setUp()
        (self.root / "scripts").mkdir()
        shutil.copy(ROOT / "scripts" / "install", self.root / "scripts")
        (self.root / "scripts" / "packages.txt").write_text(
            "# comment\n\nshell sh\nlib-here -\nlib-gone -\ndata-gone - optional\n")
        self.verilator("5.006 2023-01-22 rev (Debian 5.006-3)")
        self.script("bin/id", "echo 0")
        self.script("bin/dpkg-query", "printf 'installed:lib-here not-installed:lib-gone '; exit 1")
        self.apt("exit 0")

    def verilator(self, version):
        self.script("bin/verilator", f"echo 'Verilator {version}'")

    def apt(self, body):
        self.script("bin/apt-get", f'echo "$DEBIAN_FRONTEND $*" >>apt.log\n{body}')

    def install(self, **variables):
        """(exit status, lines of messages, apt-get's command lines)."""
        log = self.root / "apt.log"
        log.unlink(missing_ok=True)
        done = self.run_here("scripts/install", **variables)
        asked = log.read_text().splitlines() if log.exists() else []
        return done.returncode, done.stderr.splitlines(), asked

    def test_all_there(self):
        self.script("bin/dpkg-query",
                    "printf 'installed:lib-here installed:lib-gone installed:data-gone '")
        self.assertEqual(self.install(), (0, [], []))

    def test_installs_what_is_missing(self):
        status, _, asked = self.install()
        self.assertEqual((status, len(asked)), (0, 3))
        self.assertRegex(asked[0], "^noninteractive .* update$")
        self.assertRegex(asked[1], "^noninteractive .* install --no-install-recommends lib-gone$")
        self.assertRegex(asked[2], "^noninteractive .* install --no-install-recommends data-gone$")

    def test_sudo(self):
        self.script("bin/id", "echo 1000")
        self.script("bin/sudo", 'echo "sudo $*" >>apt.log\nexec "$@"')
        asked = self.install()[2]
        self.assertEqual([line.startswith("sudo ") for line in asked], [True, False] * 3)

    def test_no_install(self):
        status, messages, asked = self.install(HWFFD_NO_INSTALL="1")
        self.assertEqual((status, len(messages), asked), (0, 1, []))
        self.assertTrue(messages[0].endswith(
            "apt-get install --no-install-recommends lib-gone data-gone"), messages)

    def test_optional_package_is_asked_for_once(self):
        self.apt('case $* in *data-gone) exit 100 ;; esac')
        self.assertEqual(self.install()[0], 0)
        self.script("bin/dpkg-query", "printf 'installed:lib-here installed:lib-gone '; exit 1")
        self.assertEqual(self.install(), (0, [], []))

    def test_required_package_that_cannot_be_had(self):
        self.apt('case $* in *lib-gone) exit 100 ;; esac')
        status, messages, _ = self.install()
        self.assertEqual(status, 1)
        self.assertIn("could not install lib-gone", messages[-1])

    def test_old_verilator(self):
        self.script("bin/dpkg-query",
                    "printf 'installed:lib-here installed:lib-gone installed:data-gone '")
        for version, status in (("4.228 2022-10-01", 1), ("5.005 devel", 1), ("5.006", 0),
                                ("5.020 2024-01-01", 0), ("5.100 x", 0), ("6.000 x", 0)):
            with self.subTest(version):
                self.verilator(version)
                found, messages, _ = self.install()
                self.assertEqual((found, len(messages)), (status, status))
        self.verilator("4.228")
        self.assertEqual(self.install(HWFFD_NO_INSTALL="1")[0], 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
