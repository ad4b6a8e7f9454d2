"""The error tables, and what `make glapi` says of them.

SPDX-License-Identifier: Apache-2.0
"""

import json
import unittest

import gl_errors
import glu_errors
from opengl import Context, error_of, gl, glu
from report import REPORT, Report
from test_volumes import RendererTest


class ErrorTables(RendererTest):
    def setUp(self):
        self.addCleanup(Context().close)

    def try_all(self, cases, planar, passes):
        """How many were tried, and how many of them were mistakes."""
        tried, failed = [], []
        for case in cases:
            tried.append(case.expected)
            passed = passes(case)
            REPORT.add(case.name, planar(case), passed)
            if not passed:
                failed.append(case.name)
        self.assertEqual(failed, [])
        return len(tried), len(tried) - tried.count(gl.NO_ERROR)

    def test_gl_errors_are_those_of_the_tables_and_of_mesa(self):
        tried, wrong = self.try_all(
            gl_errors.cases(), lambda case: case.planar is not None,
            lambda case: all(error_of(*call) == case.expected
                             for call in (case.call, case.planar) if call))
        self.assertGreater(tried, 1050)
        self.assertGreater(wrong, 900)

    def test_glu_errors_come_once_through_the_callback_alone(self):
        def passes(case):
            renderer = self.renderer()

            def act():
                for command, *arguments in case.calls:
                    command(renderer.ffd, *arguments)
            expected = [] if case.expected == gl.NO_ERROR else [case.expected]
            return (error_of(act) == gl.NO_ERROR and renderer.heard("ERROR") == expected
                    and all(map(glu.FfdErrorString, expected)))

        tried, wrong = self.try_all(glu_errors.cases(), lambda case: False, passes)
        self.assertGreater(tried, 90)
        self.assertGreater(wrong, 60)

    def test_each_glu_error_has_a_line_of_its_own(self):
        numbers = range(glu.FFD_INVALID_ENUM, glu.FFD_DEVICE_FAILED + 1)
        lines = {glu.FfdErrorString(number) for number in numbers}
        self.assertEqual(len(lines - {None}), 15)
        self.assertIsNone(glu.FfdErrorString(gl.NO_ERROR))
        self.assertIsNone(glu.FfdErrorString(glu.FFD_DEVICE_FAILED + 1))


class GlapiReport(unittest.TestCase):
    def test_names_what_failed(self):
        report = Report()
        self.assertEqual(report.faults(set(), {"hwffd_glFFD"}),
                         ["no error cases tried", "not called: hwffd_glFFD"])
        report.add("glMap3: stride 2", True, True)
        self.assertEqual(report.faults({"hwffd_glFFD"}, {"hwffd_glFFD"}), [])
        report.add("glMap3: uorder 0", True, False)
        report.add("gluFfdNormals: none", False, False)
        self.assertEqual(report.faults({"hwffd_glFFD"}, {"hwffd_glFFD"}),
                         ["FAILED: glMap3: uorder 0", "FAILED: gluFfdNormals: none"])

    def test_counts_by_command(self):
        report = Report()
        report.add("gluFfdNormals: none", False, True)
        report.add("glMap3: stride 2", True, True)
        report.add("glMap3: uorder 0", True, False)
        self.assertEqual(json.loads(report.text(calls=2, failed_checks=3)), {
            "calls": 2, "error_cases": 3, "compared_with_mesa": 2, "failed": 4, "failed_checks": 3,
            "commands": [{"command": "glMap3", "cases": 2, "compared": 2, "failed": 1},
                         {"command": "gluFfdNormals", "cases": 1, "compared": 0, "failed": 0}]})
