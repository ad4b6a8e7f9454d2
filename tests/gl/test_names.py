"""What names libhwffd_gl and its header bring into a program.

SPDX-License-Identifier: Apache-2.0
"""

import re
import subprocess
import unittest

from opengl import LIBRARY, macros

OURS = re.compile(r"glu?[A-Z]|GLU?[A-Z_]|PFNGL")
HEADER = "#include <hwffd/glffd.h>\n"
ASKED = "#define HWFFD_GL_NAMES\n" + HEADER


class Names(unittest.TestCase):
    def setUp(self):
        symbols = subprocess.run(["nm", "-D", "--defined-only", LIBRARY], text=True,
                                 stdout=subprocess.PIPE, check=True).stdout
        self.exported = {line.split()[-1] for line in symbols.splitlines()}

    def test_none_is_exported(self):
        self.assertEqual([name for name in sorted(self.exported) if OURS.match(name)], [])
        self.assertIn("hwffd_glMap3f", self.exported)

    def test_none_is_defined_unasked(self):
        added = set(macros(HEADER)) - set(macros("#include <GL/gl.h>\n"))
        self.assertEqual([name for name in sorted(added) if OURS.match(name)], [])

    def test_all_are_there_if_asked_for(self):
        plain, asked = macros(HEADER), macros(ASKED)
        short = {name: asked[name] for name in set(asked) - set(plain) if OURS.match(name)}
        tokens = {name for name in plain if name.startswith(("HWFFD_GL_M", "HWFFD_GLU_"))}
        functions = {name for name in self.exported if name.startswith("hwffd_gl")}
        types = {"hwffd_GLUffd", "hwffd_GLUffdCallback"}
        self.assertGreater(len(tokens) * len(functions), 0)
        self.assertEqual(set(short.values()), tokens | functions | types)
        for name, stands_for in short.items():
            self.assertEqual(stands_for.lower(), "hwffd_" + name.lower())
