#!/usr/bin/env python3
"""What the shared library exports: the functions of hwffd.h, a list that is kept, and C++ of the
namespace hwffd; nothing of the libraries inside it. Its SONAME, and what it needs.

    test_symbols.py LIBRARY MAJOR

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import subprocess
import sys
import unittest

LIBRARY, MAJOR = sys.argv[1:3]
ROOT = pathlib.Path(__file__).resolve().parents[2]


def output(*words):
    return subprocess.run(words, check=True, text=True, stdout=subprocess.PIPE).stdout


def exported(*options):
    """Names of defined symbols. Versions are cut off."""
    lines = output("nm", "--dynamic", "--defined-only", "--format=posix", *options, LIBRARY)
    return [re.sub(r" [A-Za-z] [0-9a-f]+.*$", "", line) for line in lines.splitlines()]


class Symbols(unittest.TestCase):
    def test_those_for_c_are_the_list_and_the_header(self):
        for_c = sorted(name for name in exported() if not name.startswith("_Z"))
        listed = (pathlib.Path(__file__).parent / "c_symbols.txt").read_text().split()
        self.assertEqual(for_c, listed, "a change of the ABI: also of tests/hwffd/c_symbols.txt")
        header = (ROOT / "api/include/hwffd/hwffd.h").read_text()
        declared = re.findall(r"^(?!typedef)\w[\w *]*?\b(hwffd_\w+)\(", header, re.MULTILINE)
        self.assertEqual(sorted(declared), listed)

    def test_those_for_cpp_are_of_the_namespace(self):
        cpp = [name for name in exported("--demangle") if not re.match(r"hwffd_\w+$", name)]
        self.assertGreater(len(cpp), 100)
        others = [name for name in cpp
                  if not re.match(r"((typeinfo|typeinfo name|vtable|VTT) for )?hwffd::", name)]
        self.assertEqual(others, [])

    def test_soname_and_needs(self):
        dynamic = output("readelf", "--dynamic", "--wide", LIBRARY)
        self.assertEqual(re.findall(r"SONAME.*\[(.*)\]", dynamic), [f"libhwffd.so.{MAJOR}"])
        needed = re.findall(r"NEEDED.*\[(.*)\]", dynamic)
        self.assertIn("libassimp", " ".join(needed))
        self.assertNotRegex(" ".join(needed), "GL|glfw|EGL|X11|hwffd_rtl")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
