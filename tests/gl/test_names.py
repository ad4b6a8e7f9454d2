#!/usr/bin/env python3
"""What names libhwffd_gl and its header bring into a program.

    test_names.py CC NM INCLUDE LIBRARY

SPDX-License-Identifier: Apache-2.0
"""

import re
import subprocess
import sys
import unittest

CC, NM, INCLUDE, LIBRARY = sys.argv[1:]
OURS = re.compile(r"glu?[A-Z]|GLU?[A-Z_]|PFNGL")


def output(*words, text=""):
    return subprocess.run(words, input=text, text=True, stdout=subprocess.PIPE,
                          check=True).stdout


def macros(*includes, names=()):
    """Macros that are defined behind some headers, and what they stand for."""
    text = "".join(f"#define {name}\n" for name in names)
    text += "".join(f"#include <{header}>\n" for header in includes)
    found = output(CC, f"-I{INCLUDE}", "-E", "-dM", "-x", "c", "-", text=text)
    return dict(re.findall(r"#define (\w+) ?(.*)", found))


class Names(unittest.TestCase):
    def test_none_is_exported(self):
        symbols = {line.split()[-1] for line in output(NM, "-D", "--defined-only",
                                                       LIBRARY).splitlines()}
        self.assertEqual([name for name in sorted(symbols) if OURS.match(name)], [])
        self.assertIn("hwffd_glMap3f", symbols)

    def test_none_is_defined_unasked(self):
        added = set(macros("hwffd/glffd.h")) - set(macros("GL/gl.h"))
        self.assertEqual([name for name in sorted(added) if OURS.match(name)], [])

    def test_all_are_there_if_asked_for(self):
        plain = macros("hwffd/glffd.h")
        asked = macros("hwffd/glffd.h", names=["HWFFD_GL_NAMES"])
        short = {name: asked[name] for name in set(asked) - set(plain) if OURS.match(name)}
        tokens = {name for name in plain if name.startswith(("HWFFD_GL_M", "HWFFD_GLU_"))}
        functions = {name for name in output(NM, "-D", "--defined-only", LIBRARY).split()
                     if name.startswith("hwffd_gl")}
        types = {"hwffd_GLUffd", "hwffd_GLUffdCallback"}
        self.assertGreater(len(tokens) * len(functions), 0)
        self.assertEqual(set(short.values()), tokens | functions | types)
        for name, stands_for in short.items():
            self.assertEqual(stands_for.lower(), "hwffd_" + name.lower())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
