#!/usr/bin/env python3
"""The fuzzer itself.

    test_fuzz.py PROGRAM

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import sys
import tempfile
import unittest
import unittest.mock

import fuzz

PROGRAM = sys.argv[1]
# A reader that finds every input valid.
ANSWERS_AND_ENDS = """#!{python}
import sys
print(1, 2, "{{}}", sep="\\n", end="", flush=True)
while size := sys.stdin.buffer.readline():
    sys.stdin.buffer.read(int(size))
    print("valid 0", flush=True)
sys.exit({status})
"""
CORPUS = [b'{"dims": [4, 5, 6], "shape": "box"}']


class Fuzzer(unittest.TestCase):
    def test_hundred_thousand_inputs(self):
        self.assertGreaterEqual(sum(fuzz.INPUTS.values()), 100000 + 6000)

    def test_inputs_differ_and_repeat(self):
        inputs = [fuzz.mutated(1, number, CORPUS) for number in range(1000)]
        self.assertEqual(inputs, [fuzz.mutated(1, number, CORPUS) for number in range(1000)])
        self.assertGreater(len(set(inputs)), 800)
        self.assertIn(CORPUS[0], inputs)
        self.assertNotEqual(inputs, [fuzz.mutated(2, number, CORPUS) for number in range(1000)])

    def test_planted_faults_are_found(self):
        for fault, report in {
                b"none": "", b"empty": "the message is empty", b"lines": "not one printable line",
                b"accent": "not one printable line", b"long": "has 501 characters",
                b"exception": "another exception: at", b"expect": "another exception: broken",
                b"number": "something thrown that is no exception",
                b"abort": "the program ended: -6", b"time": "the program ended: -27"}.items():
            with fuzz.Reader(PROGRAM, "planted") as reader:
                first, *more = reader.answers([fault, b"none"])
            self.assertIn(report, fuzz.fault_of(*first), fault)
            self.assertEqual(bool(report), bool(fuzz.fault_of(*first)), fault)
            self.assertEqual(len(more), 0 if b"ended" in first[1] else 1, fault)

    def test_a_failure_says_how_to_repeat_it(self):
        with unittest.mock.patch("fuzz.mutated", lambda *_: b"empty"):
            valid, refused, failures = fuzz.tried(PROGRAM, "planted", 7, range(5, 100))
        self.assertEqual((valid, refused, len(failures)), (0, 0, fuzz.MOST_FAILURES))
        self.assertTrue(failures[0].startswith(
            "HWFFD_FUZZ_SEED=7 HWFFD_FUZZ_INPUT=5 target planted: the message is empty"))

    def test_how_the_reader_ends_counts(self):
        """A leak is told behind the last answer."""
        with tempfile.TemporaryDirectory() as folder:
            reader = pathlib.Path(folder) / "reader"
            for status, failures in ((0, 0), (23, 1)):
                reader.write_text(ANSWERS_AND_ENDS.format(python=sys.executable, status=status))
                reader.chmod(0o755)
                outcome = fuzz.tried(str(reader), "lattice", 1, range(10))
                self.assertEqual((*outcome[:2], len(outcome[2])), (10, 0, failures), outcome)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
