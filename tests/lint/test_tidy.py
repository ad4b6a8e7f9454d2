"""scripts/tidy.py: clang-tidy hears planted faults, in what a commit or the working tree changes, in
headers through a source that includes them, and says what it could not look at.

SPDX-License-Identifier: Apache-2.0
"""

import json
import shutil
import subprocess
import sys
import unittest

from workspace import ROOT, Workspace

import tidy

FAULT = "inline int* {name}() {{ return 0; }}\n"  # nullptr
CLEAN = {
    "golden/include/hwffd/x.hpp": "#pragma once\nint x();\n",
    "golden/src/x.cpp": '#include "hwffd/x.hpp"\nint x() { return 1; }\n',
    "golden/src/other.cpp": "int other() { return 2; }\n",
    "docs/x.md": "x\n",
}


class Tree(Workspace):
    def setUp(self):
        super().setUp()
        shutil.copy(ROOT / ".clang-tidy", self.root)
        (self.root / ".gitignore").write_text("build/\n")
        self.write(CLEAN)
        self.write({tidy.COMMANDS: json.dumps([
            {"directory": str(self.root), "file": str(self.root / name),
             "command": f"c++ -std=c++17 -Werror -I{self.root}/golden/include -c {name}"}
            for name in CLEAN if name.endswith(".cpp")])})
        self.git("init", "--quiet")
        self.commit()

    def write(self, files):
        for name, text in files.items():
            self.put(name, text)

    def git(self, *words):
        subprocess.run(["git", "-C", self.root, "-c", "user.name=x", "-c", "user.email=x@x.example",
                        *words], check=True)

    def commit(self):
        self.git("add", "--all")
        self.git("commit", "--quiet", "--allow-empty", "--message", "x")

    def changed(self):
        files = tidy.changed(self.root, ("golden", "tests"))
        return None if files is None else [str(path.relative_to(self.root)) for path in files]

    def findings(self, *names):
        """Of these files, or of all."""
        found = []
        for check in tidy.checks(self.root, [self.root / name for name in names] or None):
            check.run()
            found += check.findings + [check.left_out] * bool(check.left_out)
        return found

    def program(self):
        done = subprocess.run([sys.executable, ROOT / "scripts/tidy.py", "--root", self.root],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
        return done.returncode, done.stdout.splitlines(), done.stderr


class Changed(Tree):
    def test_first_commit_has_none_before_it(self):
        self.assertIsNone(self.changed())

    def test_committed_edited_and_new_files(self):
        self.write({"golden/src/x.cpp": "int x();\n", "docs/x.md": "y\n"})
        self.commit()
        self.assertEqual(self.changed(), ["golden/src/x.cpp"])
        self.write({"golden/include/hwffd/x.hpp": "", "golden/src/new.cpp": "", "apps/a.cpp": ""})
        (self.root / "golden/src/other.cpp").unlink()
        self.assertEqual(self.changed(), ["golden/include/hwffd/x.hpp", "golden/src/new.cpp",
                                          "golden/src/x.cpp"])
        self.commit()
        self.commit()
        self.assertEqual(self.changed(), [])


class Findings(Tree):
    def test_clean_tree(self):
        self.assertEqual(self.program(), (0, ["tidy: 2 files, 0 findings"], ""))

    def test_in_a_source(self):
        self.write({"golden/src/x.cpp": FAULT.format(name="x")})
        (line,) = self.findings("golden/src/x.cpp")
        self.assertIn("golden/src/x.cpp:1:", line)
        self.assertIn("modernize-use-nullptr", line)
        self.assertEqual(self.findings("golden/src/other.cpp"), [])
        status, lines, _ = self.program()
        self.assertEqual((status, lines), (1, [line, "tidy: 2 files, 1 findings"]))

    def test_in_one_of_several_sources_compiled_as_one(self):
        together = self.root / "build/golden/Unity/unity_0_cxx.cxx"
        sources = [name for name in CLEAN if name.endswith(".cpp")]
        self.write({
            str(together): "".join(f'#include "{self.root / name}"\n' for name in sources),
            tidy.COMMANDS: json.dumps([{
                "directory": str(self.root), "file": str(together),
                "command": f"c++ -std=c++17 -I{self.root}/golden/include -c {together}"}])})
        self.assertEqual(self.program(), (0, ["tidy: 2 files, 0 findings"], ""))
        self.write({"golden/src/x.cpp": FAULT.format(name="x")})
        (line,) = self.findings("golden/src/x.cpp")
        self.assertIn("golden/src/x.cpp:1:", line)

    def test_in_a_header_through_the_source_that_includes_it(self):
        header = "golden/include/hwffd/x.hpp"
        self.write({header: CLEAN[header] + FAULT.format(name="y")})
        for names in ((header,), ("golden/src/x.cpp",), ()):
            (line,) = self.findings(*names)
            self.assertIn(f"{header}:3:", line)

    def test_in_a_header_that_nothing_includes(self):
        self.write({"tests/y.hpp": "#pragma once\n" + FAULT.format(name="y")})
        (line,) = self.findings("tests/y.hpp")
        self.assertIn("tests/y.hpp:2:", line)

    def test_what_does_not_compile(self):
        self.write({"golden/src/x.cpp": "int x() { return; }\n"})
        (line,) = self.findings("golden/src/x.cpp")
        self.assertIn("should return a value [clang-diagnostic", line)

    def test_a_model_that_is_not_built_is_left_out_and_that_is_said(self):
        self.write({"golden/src/x.cpp": '#include "Vdma_small.h"\n'})
        self.assertEqual(self.findings("golden/src/x.cpp"), ["Vdma_small.h is not built"])
        status, lines, _ = self.program()
        self.assertEqual(status, 1)
        self.assertIn("left out: Vdma_small.h", lines[0])

    def test_without_compile_commands(self):
        (self.root / tidy.COMMANDS).unlink()
        status, lines, message = self.program()
        self.assertEqual((status, lines), (1, []))
        self.assertRegex(message, r"\Atidy: no build/compile_commands.json, .*make lint.*\n\Z")


if __name__ == "__main__":
    unittest.main(verbosity=2)
