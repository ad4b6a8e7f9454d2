#!/usr/bin/env python3
"""Every command of the OpenGL extension against eq. (1), the model and Mesa, and every row of its
error tables; with --output a report of them all.

    glapi.py [--output FOLDER] [CLASS...]

Wants the library in build/, or in HWFFD_BUILD, and the Python module of the same in PYTHONPATH.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import sys
import unittest

import opengl
import test_errors
import test_maps
import test_names
import test_planar
import test_volumes
from report import REPORT

CLASSES = {name: value for module in (test_maps, test_planar, test_volumes, test_errors, test_names)
           for name, value in vars(module).items() if isinstance(value, type)
           and issubclass(value, unittest.TestCase) and value.__module__ == module.__name__}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--output", type=pathlib.Path, help="folder for reports")
    parser.add_argument("classes", nargs="*", metavar="CLASS", help=", ".join(CLASSES))
    options = parser.parse_args()

    load = unittest.defaultTestLoader.loadTestsFromTestCase
    suite = unittest.TestSuite(load(CLASSES[name]) for name in options.classes or CLASSES)
    result = unittest.TextTestRunner(sys.stdout).run(suite)
    faults = []
    if options.output:
        faults = REPORT.faults(opengl.called, opengl.EXTENSION)
        failed = [test for test, _ in result.failures + result.errors
                  if not isinstance(test, test_errors.ErrorTables)]
        path = options.output / "reports" / "glapi.json"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(REPORT.text(len(opengl.called), len(failed)))
        print(f"wrote {path}", *faults, sep="\n")
    return 0 if result.wasSuccessful() and not faults else 1


if __name__ == "__main__":
    sys.exit(main())
