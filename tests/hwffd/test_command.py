#!/usr/bin/env python3
"""The command hwffd: what it writes, what it refuses, and how.

    test_command.py HWFFD

SPDX-License-Identifier: Apache-2.0
"""

import json
import math
import os
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from program import FAILURE, PROGRAM, USAGE, ProgramTest, vertices  # noqa: E402

# A tetrahedron and two loose triangles, with texture coordinates, groups and a material.
MESH = """mtllib solid.mtl
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
v 3 0 0
v 0 3 0
vt 0 0
vt 1 0
vt 0 1
g lower
usemtl red
f 1/1 3/2 2/3
f 1/1 2/2 4/3
f 1/1 4/2 3/3
f 2/1 3/2 4/3
g upper
f 2/1 5/2 4/3
f 3/1 4/2 6/3
"""


def lattice(point):
    points = [point(i, j, k) for i in range(4) for j in range(4) for k in range(4)]
    return json.dumps({"hwffd_lattice": 1, "dims": [4, 4, 4], "points": points})


FLAT = lattice(lambda i, j, k: [i, j, 0])
LATTICES = {"folded.json": lattice(lambda i, j, k: [-2 if i == 3 else i, j, k]),
            "flat.json": FLAT, "junk.json": FLAT + "\0junk",
            "twice.json": FLAT.replace("{", '{"dims": [5, 5, 5], ', 1),
            "huge.json": lattice(lambda *at: [x * 1e154 for x in at])}
LONGEST_MESSAGE = 200

# Command line -> exit status and words of the one line on standard error. Nothing is written.
REFUSED = {
    "": (USAGE, "subcommand"),
    "melt solid.obj": (USAGE, "hwffd-melt", "PATH", "--help"),
    "../melt solid.obj": (USAGE, "--help"),
    "deform": (USAGE, "input"),
    "deform solid.obj": (USAGE, "--output", "-o out.ply"),
    "deform none.obj -o out.ply": (FAILURE, "none.obj"),
    "deform folder -o out.ply": (FAILURE, "folder"),
    "deform empty.obj -o out.ply": (FAILURE, "empty.obj"),
    "deform words.obj -o out.ply": (FAILURE, "words.obj"),
    "deform nan.obj -o out.ply": (FAILURE, "nan.obj"),
    "deform bad.xyz -o out.xyz": (FAILURE, "bad.xyz", "line 2"),
    "deform solid.obj -o out.txt": (USAGE, "out.txt", "ply"),
    "deform solid.obj -o out": (USAGE, "out", "extension"),
    "deform none.obj -o out.txt": (USAGE, "out.txt"),  # before any work
    "deform none.obj -o none/out.ply": (FAILURE, "none/out.ply"),
    "deform solid.obj -o read-only.obj": (FAILURE, "read-only.obj: is read-only"),
    "deform points.xyz -o out.obj": (USAGE, "out.obj", "ply"),
    "deform points.xyz -o out.glb": (USAGE, "out.glb", "ply"),
    "deform points.xyz --json -": (USAGE, "--json -", "--output"),
    "deform points.xyz -o same --json same": (USAGE, "--json same", "--output"),
    "deform solid.obj -o same.ply --json folder/../same.ply": (USAGE, "--json", "--output"),
    "deform solid.obj -o f.ply --keyframes 3 --json f-0002.ply": (USAGE, "--json", "--output"),
    "embed solid.obj -o same --json same": (USAGE, "--json same", "--output"),
    "embed none.obj -o none/places": (FAILURE, "none/places"),
    "check none.json --json none/report": (FAILURE, "none/report"),
    "info none.obj --json none/report": (FAILURE, "none/report"),
    "deform solid.obj -o none/out.ply": (FAILURE, "none"),
    "deform solid.obj -o -": (USAGE, "standard output"),
    "deform solid.obj -o out.ply --twist 90": (USAGE, "--twist", "--help"),
    "deform solid.obj -o out.ply --deform twirl": (USAGE, "twirl", "twist", "helix"),
    "deform solid.obj -o out.ply --deform twist:x": (USAGE, "twist:x"),
    "deform solid.obj -o out.ply --deform twist:1e308": (USAGE, "twist:1e308", "1e6"),
    "deform solid.obj -o out.ply --deform twist:90:w": (USAGE, "90:w", "x, y or z"),
    "deform solid.obj -o out.ply --deform scale:0": (USAGE, "scale:0", "other than 0"),
    "deform solid.obj -o out.ply --deform move:9,0,0:1,1,1": (FAILURE, "9,0,0", "4 x 4 x 4"),
    "deform solid.obj -o out.ply --deform to:none.json": (FAILURE, "none.json"),
    "deform solid.obj -o out.ply --lattice pyramid": (FAILURE, "pyramid"),
    "deform solid.obj -o out.ply --lattice broken.json":
        (FAILURE, "broken.json", "line 1, column 35"),
    "deform solid.obj -o out.ply --lattice twice.json": (FAILURE, "twice.json", "'dims'", "twice"),
    "deform solid.obj -o out.ply --lattice junk.json": (FAILURE, "junk.json", "line 1, column"),
    "deform solid.obj -o out.ply --lattice /dev/zero": (FAILURE, "/dev/zero", "bytes"),
    "deform solid.obj -o out.ply --lattice huge.json": (FAILURE, "huge.json", "1e+100"),
    "check huge.json": (FAILURE, "huge.json", "1e+100"),
    "deform solid.obj -o out.ply --lattice folded.json": (FAILURE, "folded.json", "folded at"),
    "deform solid.obj -o out.ply --lattice flat.json": (FAILURE, "flat.json", "volume"),
    "deform solid.obj -o out.ply --dims 4x4": (USAGE, "--dims 4x4"),
    "deform solid.obj -o out.ply --dims 4x4x65": (USAGE, "4 to 64"),
    "deform solid.obj -o out.ply --lattice sphere --dims 4x4x4": (FAILURE, "4"),
    "deform solid.obj -o out.ply --region 0,0,0": (USAGE, "--region"),
    "deform solid.obj -o out.ply --region 0,0,0,0,0,0": (USAGE, "--region", "no volume"),
    "deform solid.obj -o out.ply --region 0,0,2,1,1,2": (USAGE, "--region", "no volume"),
    "deform solid.obj -o out.ply --outside away": (USAGE, "away", "fade"),
    "deform solid.obj -o out.ply --device fpga": (USAGE, "fpga", "rtl"),
    "deform solid.obj -o out.ply --org cg9": (USAGE, "cg9", "basic", "cg3", "nested3"),
    "deform solid.obj -o out.ply --format fp64": (USAGE, "fp64", "fx18"),
    "deform solid.obj -o out.ply --org basic-fp32-overlapped-fma": (USAGE, "fma", "hwffd info"),
    "deform solid.obj -o out.ply --org basic-fx18-overlapped --format fp32": (USAGE, "fx18"),
    "deform solid.obj -o out.ply --org factored/3 --device rtl --format fx99": (USAGE, "factored"),
    "deform solid.obj -o out.ply --keyframes 0": (USAGE, "--keyframes"),
    "deform points.xyz --keyframes 3": (USAGE, "--keyframes", "--output"),
    "embed solid.obj --deform twist": (USAGE, "--deform"),
    "embed solid.obj --lattice box --lattice sphere": (USAGE, "--lattice"),
    "lattice --lattice box --lattice box": (USAGE, "--lattice"),
    "lattice -o none/lattice.json": (FAILURE, "none"),
    "check": (USAGE, "lattices"),
    "check none.json": (FAILURE, "none.json"),
    "check solid.obj": (FAILURE, "solid.obj"),
    "info none.obj": (FAILURE, "none.obj"),
}


class Command(ProgramTest):
    name = "hwffd"  # also of the one with sanitizers
    given = {"solid.obj": MESH, "solid.mtl": "newmtl red\nKd 1 0 0\n", "empty.obj": "",
             "words.obj": "only words in a row\n" * 9,
             "nan.obj": MESH.replace("v 1 0 0", "v nan 0 0"),
             "points.xyz": "0 0 0\n0.25 0.5 0.75\n1 1 1\n", "bad.xyz": "0 0 0\n1 2\n",
             "broken.json": '{"hwffd_lattice": 1, "dims": [4, 4', "read-only.obj": MESH,
             "folder": None, **LATTICES}

    def setUp(self):
        super().setUp()
        (self.folder / "read-only.obj").chmod(0o444)

    def report(self, name="r.json"):
        return json.loads(self.text(name))

    def assert_near(self, got, wanted, places):
        self.assertEqual(len(got), len(wanted))
        for a, b in zip(got, wanted):
            for x, y in zip(a, b):
                self.assertAlmostEqual(x, y, places=places)

    def good(self, *words, given="", warning=""):
        done = self.call(*words, given=given)
        stderr = f"hwffd: warning: {warning}\n" if warning else ""
        self.assertEqual((done.returncode, done.stderr), (0, stderr), words)
        return done.stdout

    def test_bad_input(self):
        for line, (status, *words) in REFUSED.items():
            with self.subTest(line):
                done = self.call(*line.split())
                self.assert_refused(done, status, words)
                self.assertLess(len(done.stderr), LONGEST_MESSAGE)

    def other_program(self, folder, name, text, mode=0o755):
        """A program on PATH, in a folder of the test's."""
        (self.folder / folder).mkdir(exist_ok=True)
        program = self.folder / folder / name
        program.write_text(text)
        program.chmod(mode)
        return {"PATH": f"{self.folder / folder}{os.pathsep}{os.environ['PATH']}"}

    def test_other_commands_are_programs_on_path(self):
        path = self.other_program("bin", "hwffd-greet",
                                  '#!/bin/sh\necho "$#:$1:$2"; cat; exit 7\n')
        done = self.call("greet", "two words", "--help", given="given", **path)
        self.assertEqual((done.returncode, done.stdout, done.stderr),
                         (7, "2:two words:--help\ngiven", ""))
        self.other_program("bin", "hwffd-info", "#!/bin/sh\nexit 7\n")
        self.assertEqual(self.call("info", **path).returncode, 0)  # its own come first
        # Nothing runs by a path.
        for name in "melt", "greet/", "bin/greet", "../greet":
            done = self.call(name, **path)
            self.assertEqual((done.returncode, done.stdout), (USAGE, ""))
            self.assertRegex(done.stderr, r"\Ahwffd: [^\n]+\n\Z")

    def test_programs_that_cannot_be_run(self):
        path = self.other_program("bin", "hwffd-words", "#!/bin/sh\n", mode=0o644)
        done = self.call("words", **path)
        self.assertEqual((done.returncode, done.stdout), (FAILURE, ""))
        self.assertRegex(done.stderr, r"\Ahwffd: words: hwffd-words cannot be run: [^\n]+\n\Z")

    def test_help_has_examples(self):
        self.assertIn("deform", self.good("--help"))
        for command in ("deform", "embed", "lattice", "check", "info"):
            text = self.good(command, "--help")
            self.assertIn("Examples:", text)
            self.assertIn(f"hwffd {command}", text)
        self.assertRegex(self.good("--version"), r"\A\d+\.\d+\.\d+\n\Z")

    def test_devices_write_the_same_file(self):
        options = ("--lattice", "sphere", "--deform", "twist:90")
        for device in ("model", "rtl", "reference"):
            out = self.good("deform", "solid.obj", *options, "--device", device,
                            "-o", f"{device}.obj")
            self.assertIn(f"wrote {device}.obj", out)
        read = {d: self.text(f"{d}.obj").replace(d, "") for d in ("model", "rtl", "reference")}
        self.assertEqual(read["model"], read["rtl"])
        self.assert_near(vertices(read["model"]), vertices(read["reference"]), places=5)
        self.assertNotEqual(sorted(vertices(read["model"])), sorted(vertices(MESH)))

    def test_formats_and_what_they_keep(self):
        order = "order of vertices"
        lost = {"obj": "", "ply": f"{order}, materials, part names", "glb": order, "gltf": order,
                "off": "texture coordinates, materials, part names",
                "stl": f"{order}, texture coordinates, materials, part names"}
        for extension, losses in lost.items():
            self.good("deform", "solid.obj", "--deform", "none", "-o", f"out.{extension}",
                      warning=losses and f"out.{extension}: dropped: {losses}")
            info = json.loads(self.good("info", f"out.{extension}", "--json", "-"))
            self.assertEqual((info["vertices"], info["triangles"]), (6, 6), extension)
        text = self.text("out.obj")
        for word in ("red", "vt 1 0", "lower", "upper"):
            self.assertIn(word, text + self.text("out.mtl"))

    def test_points_vertices_and_names(self):
        (self.folder / "dust.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 0 0\nv 0 2 1\n")
        self.good("deform", "dust.obj", "--deform", "none", "-o", "dust.ply")
        info = json.loads(self.good("info", "dust.ply", "--json", "-"))
        self.assertEqual([info[key] for key in ("vertices", "vertices_before_welding",
                                                "triangles")], [3, 4, 0])
        self.good("deform", "dust.ply", "--deform", "none", "-o", "again.obj")
        self.assert_near(*(vertices(self.text(f"{n}.obj")) for n in ("again", "dust")), places=6)
        quality = ("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                   "property float y\nproperty float z\nproperty float quality\nend_header\n"
                   "1 2 3 4\n")
        (self.folder / "new\nline.ply").write_text(quality)
        out = self.good("deform", "new\nline.ply", "--deform", "none", "-o", "a\nb.ply",
                        warning="new\\x0aline.ply: dropped: property quality of vertex")
        self.assertIn("wrote a\\x0ab.ply\n", out)

    def test_a_reader_that_crashes(self):
        (self.folder / "a.raw").write_text("0 0 0 1 0 0 1 1 0\nroof\n0 0 1 1 0 1 1 1 1\n")
        for command in (("info", "a.raw"), ("deform", "a.raw", "-o", "out.ply")):
            done = self.call(*command)
            self.assertEqual((done.returncode, done.stdout), (FAILURE, ""))
            self.assertRegex(done.stderr, r"\Ahwffd: a.raw: not a mesh [^\n]* crashed[^\n]*\n\Z")
        self.assertFalse((self.folder / "out.ply").exists())

    def test_report(self):
        self.good("deform", "solid.obj", "--deform", "twist:30", "-o", "out.obj", "--json", "r.json")
        report = self.report()
        self.assertEqual(report["vertices"], 6)
        self.assertEqual(report["device"], "model basic-fp32-overlapped")
        self.assertEqual(report["written"], ["out.obj"])
        (stage,) = report["stages"]
        self.assertEqual((stage["lattice"], stage["dims"]), ("box", [4, 4, 4]))
        self.assertEqual(stage["embedding"]["inside"], 6)
        self.assertEqual(stage["deformed"]["verdict"], "proved")
        sides = [max(axis) - min(axis) + 2**-22 * max(map(abs, axis))
                 for axis in zip(*vertices(MESH))]
        self.assertAlmostEqual(stage["rest"]["volume"], math.prod(sides), places=9)

    def test_stream_of_points(self):
        out = self.good("deform", "-", "--region", "0,0,0,1,1,1", "--deform", "scale:2",
                        given="# a comment\n0 0 0\n 0.5, 0.5, 0.5\n1 0 1\n")
        moved = [tuple(map(float, line.split())) for line in out.splitlines()]
        self.assert_near(moved, [(-0.5, -0.5, -0.5), (0.5, 0.5, 0.5), (1.5, -0.5, 1.5)], places=6)
        self.good("deform", "points.xyz", "--deform", "none", "-o", "out.xyz")
        self.assertEqual(len(self.text("out.xyz").splitlines()), 3)

    def test_points_in_other_spellings(self):
        (self.folder / "plain.xyz").write_text("1 2 3\n4 5 6\n7 9 8\n")
        (self.folder / "marked.XYZ").write_text("\ufeff1,2,3\r\n4, 5, 6\r\n7;9;8\r\n")
        options = ("--deform", "bend:40", "--device", "reference")
        wanted = self.good("deform", "plain.xyz", *options)
        self.assertEqual(self.good("deform", "marked.XYZ", *options), wanted)
        self.good("deform", "marked.XYZ", *options, "-o", "out.PLY")
        head, points = self.text("out.PLY").split("end_header\n")
        self.assertEqual(points, wanted)
        self.assertEqual(head, "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"
                               "property double y\nproperty double z\n")

    def test_rows(self):
        for words, row in {
                ("factored/3", "--format", "fx18"): "factored3-fx18-overlapped",
                ("tree 8",): "tree8-fp32-overlapped",
                ("nested3", "--format", "fx32"): "nested3-fx32-overlapped",
                ("basic-fp32-overlapped-fmac",): "basic-fp32-overlapped-fmac",
                ("basic-fp32-overlapped-deep", "--format", "fp32"): "basic-fp32-overlapped-deep",
                ("basic-fx32-overlapped-iterative",): "basic-fx32-overlapped-iterative",
                ("basic-fx18-overlapped-bspline",): "basic-fx18-overlapped-bspline"}.items():
            self.good("deform", "points.xyz", "-o", "out.xyz", "--json", "r.json", "--org", *words)
            report = self.report()
            self.assertEqual(report["device"], f"model {row}")

    def test_standard_output_that_takes_nothing(self):
        self.good("lattice", "-o", "rest.json")
        lines = ("lattice", "lattice -o l.json", "info", "info solid.obj", "info --json -",
                 "check rest.json", "check rest.json --json -", "embed solid.obj",
                 "embed solid.obj -o -", "deform points.xyz", "deform solid.obj -o out.obj",
                 "deform points.xyz -o out.xyz --json -", "--help", "deform --help", "--version")
        for line in lines:
            for closed in (False, True):
                with self.subTest(line=line, closed=closed), open("/dev/full", "wb") as full:
                    done = subprocess.run([PROGRAM, *line.split()], cwd=self.folder, stdout=full,
                                          stderr=subprocess.PIPE, text=True, check=False,
                                          preexec_fn=(lambda: os.close(1)) if closed else None)
                    self.assertEqual(done.returncode, FAILURE)
                    self.assertRegex(done.stderr, r"\Ahwffd: standard output: [^\n]+\n\Z")

    def test_output_closed_does_not_reach_files(self):
        """A file opened in the place of the closed standard output does not get its text."""
        wanted = self.good("lattice")
        subprocess.run([PROGRAM, "lattice", "-o", "out.json"], cwd=self.folder, check=False,
                       stderr=subprocess.DEVNULL, preexec_fn=lambda: os.close(1))
        self.assertEqual(self.text("out.json"), wanted)

    def test_axes_and_what_a_helix_turns(self):
        (self.folder / "p.xyz").write_text("0 1 0\n2 1 2\n")
        out = self.good("deform", "p.xyz", "--region", "0,0,0,2,1,2", "--dims", "4x16x4",
                        "--device", "reference", "--deform", "helix:90")
        arm = [float(x) for x in out.splitlines()[1].split()]
        self.assert_near([arm[::2]], [(2, 0)], places=2)
        out = self.good("deform", "p.xyz", "--region", "0,0,0,2,1,2", "--device", "reference",
                        "--deform", "taper:0.5:x")
        self.assertNotEqual(out.split()[2], out.split()[5])

    def test_keyframes(self):
        self.good("deform", "solid.obj", "--deform", "shear:1", "--keyframes", "4", "-o", "f.obj")
        frames = [vertices(self.text(f"f-{n:04}.obj")) for n in range(5)]
        self.assertFalse((self.folder / "f.obj").exists())
        halfway = [[(a + b) / 2 for a, b in zip(*ends)] for ends in zip(frames[0], frames[4])]
        self.assert_near(frames[2], halfway, places=5)
        self.assertNotEqual(frames[0], frames[4])

    def test_a_mirror_turns_faces(self):
        for scale, corners in (("1", "132"), ("-1,1,1", "123"), ("-1,-1,1", "132")):
            self.good("deform", "solid.obj", "--deform", f"scale:{scale}", "-o", "out.obj")
            faces = [line for line in self.text("out.obj").splitlines() if line.startswith("f ")]
            self.assertEqual("".join(re.findall(r" (\d)", faces[0])), corners, scale)

    def rounded(self, name):
        return [tuple(round(x, 5) for x in v) for v in vertices(self.text(name))]

    def test_outside(self):
        options = ("deform", "solid.obj", "--region", "0,0,0,1,1,1", "--deform", "scale:2")
        done = self.call(*options, "-o", "keep.obj")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"\Ahwffd: warning: \d edges join[^\n]+tears[^\n]+\n\Z")
        self.assertIn("4 inside, 2 outside", done.stdout)
        self.assertIn((3, 0, 0), vertices(self.text("keep.obj")))
        self.good(*options, "--outside", "clamp", "-o", "clamp.obj")
        self.assertIn((3.5, -0.5, -0.5), self.rounded("clamp.obj"))
        self.good(*options, "--outside", "fade:4", "-o", "fade.obj")
        self.assertIn((3.25, -0.25, -0.25), self.rounded("fade.obj"))

    def test_lattices(self):
        self.assertIn("wrote rest.json", self.good("lattice", "--lattice", "cylinder", "--around",
                                                   "solid.obj", "-o", "rest.json"))
        self.good("lattice", "--lattice", "rest.json", "--deform", "taper:0.5", "-o", "moved.json")
        out = self.good("check", "rest.json", "moved.json", "--json", "check.json")
        self.assertEqual(out.count("proved but on collapsed faces"), 2)
        volumes = [entry["volume"] for entry in self.report("check.json")["lattices"]]
        self.assertLess(volumes[1], volumes[0])
        self.assertRegex(out, r"\(-\d+\.\d+ %\)")
        info = json.loads(self.good("info", "rest.json", "--json", "-"))
        self.assertEqual((info["dims"], info["closed_axes"]), ([4, 4, 9], ["u"]))
        self.good("deform", "solid.obj", "--lattice", "rest.json", "--deform", "to:moved.json",
                  "-o", "a.obj")
        self.good("deform", "solid.obj", "--lattice", "cylinder", "--deform", "taper:0.5",
                  "-o", "b.obj")
        self.assertEqual(*(vertices(self.text(f"{n}.obj")) for n in "ab"))
        folded = self.call("check", "folded.json")
        self.assertEqual((folded.returncode, folded.stderr), (1, ""))
        self.assertIn("folded at", folded.stdout)

    def test_embed(self):
        out = self.good("embed", "solid.obj", "--lattice", "sphere", "-o", "places.txt",
                        "--json", "embed.json")
        self.assertIn("6 inside, 0 outside, 0 not converged", out)
        report = self.report("embed.json")
        self.assertLess(report["worst_residual"] / report["size"], 1e-12)
        lines = self.text("places.txt").splitlines()
        self.assertEqual(len(lines), 1 + 6)
        for line in lines[1:]:
            self.assertTrue(re.fullmatch(r"(\d+ ){3}(\S+ ){4}inside", line), line)

    def test_hierarchy(self):
        self.good("deform", "solid.obj", "--deform", "scale:2", "--lattice", "box", "--deform",
                  "none", "--region=-3,-3,-3,6,6,6", "-o", "two.obj", "--json", "r.json")
        self.good("deform", "solid.obj", "--deform", "scale:2", "-o", "one.obj")
        self.assert_near(*(vertices(self.text(f"{n}.obj")) for n in ("one", "two")), places=4)
        self.assertEqual(len(self.report()["stages"]), 2)

    def test_info_of_the_build(self):
        devices = json.loads(self.good("info", "--json", "-"))["devices"]
        self.assertEqual(sorted(devices), ["model", "reference", "rtl"])
        self.assertLessEqual(set(devices["rtl"]), set(devices["model"]))
        self.assertIn("basic-fp32-overlapped", devices["rtl"])
        self.assertIn("basic-fp32-overlapped", self.good("info"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
