"""hwffd-sim: bad input ends with one line that names the thing and what is accepted, and writes
nothing; a good run writes its report, its mesh and a picture.

Called with the path of hwffd-sim.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import re
import unittest

from tests.support.program import FAILURE, USAGE, ProgramTest, size_of, vertices

# Options that are refused -> exit status, words of the message. Files are those of `make_files`.
REFUSED = {
    ("--model", "nowhere.obj"): (FAILURE, "nowhere.obj", "no such file", "give a path"),
    ("--model", "notes.txt"): (FAILURE, "notes.txt", "not a mesh", "accepted are obj, ply"),
    ("--model", "notes.obj"): (FAILURE, "notes.obj", "accepted are obj, ply"),
    ("--model", "empty.obj"): (FAILURE, "empty.obj", "accepted are obj, ply"),
    ("--model", "comment.obj"): (FAILURE, "comment.obj", "accepted are obj, ply"),
    ("--model", "folder"): (FAILURE, "folder", "no such file"),
    ("--model", "./folder"): (FAILURE, "./folder", "not a file", "accepted are obj, ply"),
    ("--format", "foo"): (USAGE, "FORMAT=foo", "known here: ", "fp32", "fx17, fx18, fx32"),
    ("--deform", "foo"): (USAGE, "'foo'", "none, twist, helix, shear"),
    ("--deform", "twist:abc"): (USAGE, "'twist:abc'", "not DEGREES", "DEGREES:AXIS"),
    ("--deform", "twist:inf"): (USAGE, "'twist:inf'", "not DEGREES"),
    ("--deform", "random:-1"): (USAGE, "'random:-1'", "0 to 2^64 - 1"),
    ("--lattice", "3x4x4"): (USAGE, "LATTICE=3x4x4", "4 to 16"),
    ("--lattice", "4x4x17"): (USAGE, "LATTICE=4x4x17", "4 to 16"),
    ("--lattice", "foo"): (USAGE, "LATTICE=foo", "as 4x4x4"),
    ("--lattice", "4x4"): (USAGE, "LATTICE=4x4:", "as 4x4x4"),
    ("--lattice", "4x4x4x4"): (USAGE, "LATTICE=4x4x4x4", "as 4x4x4"),
    ("--org", "foo"): (USAGE, "ORG=foo", "basic"),
    ("--org", "cg2"): (USAGE, "cg2 went with 0.3.0: take cg1"),
    ("--schedule", "foo"): (USAGE, "SCHEDULE=foo", "overlapped, paper"),
    ("--stream", "foo"): (USAGE, "STREAM=foo", "dma, interleaved, resident"),
    ("--stream", "dma", "--schedule", "paper"):
        (USAGE, "STREAM=dma", "basic-fp32-overlapped, basic-fx18-overlapped"),
    ("--seed", "abc"): (USAGE, "SEED=abc", "0 to 2^64 - 1"),
    ("--seed", "-1"): (USAGE, "SEED=-1", "0 to 2^64 - 1"),
    ("--seed", "18446744073709551616"): (USAGE, "SEED=1844", "0 to 2^64 - 1"),
    ("--colour", "red"): (USAGE, "--colour", "--help"),
    ("--colour",): (USAGE, "--colour", "--help"),
    ("--lattice",): (USAGE, "--lattice", "--help"),
}

GOOD = ("--model", "block.obj", "--format", "fx18", "--schedule", "overlapped")
ROW_FIELDS = ["org", "format", "schedule", "stream", "deform", "checked", "mismatches",
              "clocks_per_vertex", "max_error", "rms_error"]


def block(n):
    """The surface of a block of n x n squares a side, as obj, and its number of vertices."""
    places = {}
    faces = []

    def place(axis, side, a, b):
        point = [a, b]
        point.insert(axis, side)
        return places.setdefault(tuple(point), len(places) + 1)

    for axis in range(3):
        for side in (0, n):
            for a in range(n):
                for b in range(n):
                    faces.append([place(axis, side, a + i, b + j)
                                  for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))])
    lines = [f"v {x} {y / 2} {z * 3}" for x, y, z in places]
    lines += ["f " + " ".join(map(str, face)) for face in faces]
    return "\n".join(lines) + "\n", len(places)


def on_grid(point):
    """The nearest point with coordinates that are multiples of 1/2, as those of a block are."""
    return [round(2 * value) / 2 for value in point]


BLOCK, BLOCK_VERTICES = block(4)


class Sim(ProgramTest):
    given = {"notes.txt": "not a mesh\n", "notes.obj": "not a mesh, only words in a row\n" * 9,
             "empty.obj": "", "comment.obj": "# nothing\n" * 9, "block.obj": BLOCK, "folder": None}

    def sim(self, *options, output="out", **environment):
        return self.call("--output", output, *options, **environment)

    def test_bad_input(self):
        refused = 0
        for options, (status, *words) in REFUSED.items():
            with self.subTest(" ".join(options)):
                self.assert_refused(self.sim(*options), status, words)
                refused += 1
        print(f"sim: {refused} of {len(REFUSED)} bad command lines refused")

    def test_unwritable_output(self):
        outputs = ["notes.txt", "notes.txt/below", "/proc/below"]
        if os.geteuid() != 0:  # root may write anywhere
            (self.folder / "folder").chmod(0o555)
            outputs.append("folder")
        for output in outputs:
            result = self.sim(*GOOD, output=output)
            self.assert_refused(result, FAILURE, (output, "cannot write", "--output"))

    def test_trace_where_the_build_has_none(self):
        result = self.sim(*GOOD, "--trace")
        if result.returncode == 0:
            waveforms = sorted((self.folder / "out" / "sim").glob("*.fst"))
            self.assertEqual(len(waveforms), 2)
            for waveform in waveforms:
                self.assertIn(f"out/sim/{waveform.name}\n", result.stdout)
        else:
            self.assert_refused(result, USAGE, ("--trace", "make sim TRACE=1", "-DHWFFD_TRACE=ON"))

    def report(self, result, output="out"):
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return json.loads(self.text(f"{output}/reports/sim.json"))

    def test_report_and_mesh(self):
        report = self.report(self.sim(*GOOD))
        self.assertEqual(list(report), ["model", "vertices", "runs"])
        self.assertEqual((report["model"], report["vertices"]), ("block.obj", BLOCK_VERTICES))
        self.assertEqual([run["deform"] for run in report["runs"]], ["twist:90", "random:1"])
        for run in report["runs"]:
            self.assertEqual(list(run), ROW_FIELDS)
            self.assertEqual([run[field] for field in ROW_FIELDS[:4]],
                             ["basic", "fx18", "overlapped", "interleaved"])
            self.assertEqual((run["checked"], run["mismatches"]), (BLOCK_VERTICES, 0))
            self.assertEqual(run["clocks_per_vertex"], 64)
            self.assertTrue(0 < run["rms_error"] <= run["max_error"] < 1e-3, run)
        mesh = self.text("out/sim/block-twist-90.obj")
        self.assertEqual(sum(line.startswith("v ") for line in mesh.splitlines()), BLOCK_VERTICES)
        self.assertEqual(sum(line.startswith("f ") for line in mesh.splitlines()), 6 * 16)

    def test_picture(self):
        result = self.sim(*GOOD, "--deform", "shear")
        self.report(result)
        png = (self.folder / "out" / "sim" / "block-shear.png").read_bytes()
        self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(size_of(png), (2 * 700, 600))
        self.assertGreater(len(png), 50000, "nothing is drawn")
        self.assertTrue(result.stdout.endswith(
            "wrote out/sim/block-shear.obj, out/reports/sim.json, out/sim/block-shear.png\n"))

    def test_without_opengl_only_the_picture_is_missing(self):
        result = self.sim(*GOOD, __EGL_VENDOR_LIBRARY_FILENAMES="/nowhere.json")
        self.report(result)
        self.assertRegex(result.stdout, r"\nno picture: no OpenGL [^\n]*libgl1-mesa-dri\n\Z")
        written = self.files("out/sim")
        self.assertIn("block-twist-90.obj", written)
        self.assertNotIn("block-twist-90.png", written)

    def test_two_runs_give_the_same_files(self):
        for output in ("one", "two"):
            self.report(self.sim(*GOOD, "--seed", "7", output=output), output)
        first, second = (self.files(output) for output in ("one", "two"))
        self.assertEqual(first, second)
        self.assertGreaterEqual(sum(content is not None for content in first.values()), 3)

    def test_the_seed_of_the_bench_does_not_change_the_results(self):
        seen = [self.report(self.sim(*GOOD, "--deform", "bend:45", "--seed", seed))
                for seed in ("1", "2")]
        self.assertEqual(*seen)

    def test_streams_give_the_same_bits(self):
        runs = {}
        for stream in ("interleaved", "resident", "dma"):
            options = ("--lattice", "5x7x6", "--stream", stream)
            (twist, random) = self.report(self.sim(*GOOD, *options, output=stream), stream)["runs"]
            self.assertEqual(twist.pop("stream"), stream)
            # A result of the last burst does not wait for others.
            self.assertAlmostEqual(twist.pop("clocks_per_vertex"), 64, delta=0.5)
            if stream == "dma":
                self.assertTrue(0 < twist.pop("bus_utilisation") < 1)
            mesh = self.text(f"{stream}/sim/block-twist-90.obj")
            runs[stream] = (twist, random["max_error"], random["rms_error"], mesh)
        self.assertEqual(runs["interleaved"], runs["resident"])
        self.assertEqual(runs["interleaved"], runs["dma"])

    def test_the_bus_of_a_run_through_memory(self):
        result = self.sim(*GOOD, "--stream", "dma", "--deform", "none")
        (run,) = self.report(result)["runs"]
        self.assertEqual(list(run), ROW_FIELDS + ["bus_utilisation"])
        self.assertEqual((run["checked"], run["mismatches"]), (BLOCK_VERTICES, 0))
        # A packet of coefficients, one of 64 points, one of the vertices: header and descriptor each.
        read, written = BLOCK_VERTICES + 12 + 64 + 3 * 2, BLOCK_VERTICES
        line = next(line for line in result.stdout.splitlines() if line.startswith("  bus:"))
        match = re.search(r"([\d.]+) % used: (\d+) beats read \(([\d.]+) %\), (\d+) written "
                          r"\(([\d.]+) %\) in (\d+) clocks", line)
        both, beats_read, _, beats_written, _, clocks = map(float, match.groups())
        self.assertEqual((beats_read, beats_written), (read, written))
        self.assertAlmostEqual(run["bus_utilisation"], (read + written) / 2 / clocks)
        self.assertAlmostEqual(both, 100 * run["bus_utilisation"], delta=0.051)

    def test_several_cells(self):
        report = self.report(self.sim(*GOOD, "--lattice", "6x5x4", "--deform", "none"))
        (run,) = report["runs"]
        self.assertEqual((run["checked"], run["mismatches"]), (BLOCK_VERTICES, 0))
        # An undeformed lattice gives the mesh back.
        mesh = self.text("out/sim/block-none.obj")
        got, wanted = vertices(mesh), vertices(BLOCK)
        self.assertEqual(sorted(map(on_grid, got)), sorted(map(on_grid, wanted)))
        for point in got:
            for value, exact in zip(point, on_grid(point)):
                self.assertAlmostEqual(value, exact, delta=0.01)


if __name__ == "__main__":
    unittest.main(verbosity=2)
