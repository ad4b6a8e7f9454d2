#!/usr/bin/env python3
"""The command hwffd: what it writes, and how.

    test_command.py HWFFD

SPDX-License-Identifier: Apache-2.0
"""

import json
import math
import os
import pathlib
import re
import subprocess
import unittest

from tests.hwffd.command import MESH, CommandTest, triangle_in_gltf
from tests.support.program import FAILURE, PROGRAM, USAGE, vertices


class Command(CommandTest):
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
        result = self.call("greet", "two words", "--help", given="given", **path)
        self.assertEqual((result.returncode, result.stdout, result.stderr),
                         (7, "2:two words:--help\ngiven", ""))
        self.other_program("bin", "hwffd-info", "#!/bin/sh\nexit 7\n")
        self.assertEqual(self.call("info", **path).returncode, 0)  # its own come first
        # Nothing runs by a path.
        for name in "melt", "greet/", "bin/greet", "../greet":
            result = self.call(name, **path)
            self.assertEqual((result.returncode, result.stdout), (USAGE, ""))
            self.assertRegex(result.stderr, r"\Ahwffd: [^\n]+\n\Z")

    def test_programs_that_cannot_be_run(self):
        path = self.other_program("bin", "hwffd-words", "#!/bin/sh\n", mode=0o644)
        result = self.call("words", **path)
        self.assertEqual((result.returncode, result.stdout), (FAILURE, ""))
        self.assertRegex(result.stderr, r"\Ahwffd: words: hwffd-words cannot be run: [^\n]+\n\Z")

    def test_help_has_examples(self):
        self.assertIn("deform", self.good("--help"))
        for command in ("deform", "embed", "fit", "lattice", "check", "info", "completion", "manual"):
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
        for word in ("red", "vt 1 0", "lower", "upper", "mtllib solid.mtl"):
            self.assertIn(word, text)
        self.assertFalse((self.folder / "out.mtl").exists())
        self.good("deform", "solid.obj", "--deform", "none", "--device", "reference", "-o", "o.obj")
        self.assertEqual(self.text("o.obj"), MESH)

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
        out = self.good("deform", "new\nline.ply", "--deform", "none", "-o", "a\nb.obj",
                        warning="new\\x0aline.ply: dropped: property quality of vertex")
        self.assertIn("wrote a\\x0ab.obj\n", out)
        self.good("deform", "new\nline.ply", "--deform", "none", "--device", "reference",
                  "-o", "b.ply")
        self.assertEqual(self.text("b.ply"), quality)

    def test_a_reader_that_crashes(self):
        (self.folder / "a.raw").write_text("0 0 0 1 0 0 1 1 0\nroof\n0 0 1 1 0 1 1 1 1\n")
        for command in (("info", "a.raw"), ("deform", "a.raw", "-o", "out.ply")):
            result = self.call(*command)
            self.assertEqual((result.returncode, result.stdout), (FAILURE, ""))
            self.assertRegex(result.stderr, r"\Ahwffd: a.raw: not a mesh [^\n]* crashed[^\n]*\n\Z")
        self.assertFalse((self.folder / "out.ply").exists())

    def test_fit(self):
        points = [(math.sin(n), math.cos(3 * n), math.sin(7 * n)) for n in range(200)]
        (self.folder / "rest.xyz").write_text("".join(f"{x} {y} {z}\n" for x, y, z in points))
        (self.folder / "there.xyz").write_text("".join(f"{x + 0.1 * y * y} {y} {z - 0.1}\n" for x, y, z in points))
        text = self.good("fit", "rest.xyz", "there.xyz", "--dims", "5x5x5", "-o", "fitted.json", "--json", "report.json")
        self.assertRegex(text, r"\Abox 5x5x5: 200 points, 0 outside; rms [0-9.e-]+ -> [0-9.e-]+, largest [0-9.e-]+, \d+ iterations\nproved\n")
        report = json.loads((self.folder / "report.json").read_text())
        self.assertLess(report["rms_end"], 0.01 * report["rms_start"])
        fitted = json.loads((self.folder / "fitted.json").read_text())
        self.assertEqual((fitted["dims"], len(fitted["points"]), len(fitted["rest"])), ([5, 5, 5], 125, 125))
        self.assertIn("wrote nothing", self.good("fit", "rest.xyz", "there.xyz"))
        before = (self.folder / "rest.xyz").read_bytes()
        for words, status in ((("-o", "rest.xyz"), USAGE), (("--json", "there.xyz"), USAGE), (("--loss", "joy"), USAGE),
                              (("--loss", "huber"), USAGE), (("--lattice", "sphere", "--penalty", "1"), FAILURE)):
            result = self.call("fit", "rest.xyz", "there.xyz", *words)
            self.assertEqual(result.returncode, status, result.stderr)
            self.assertRegex(result.stderr, r"\Ahwffd: [^\n]+\n\Z")
        self.assertEqual((self.folder / "rest.xyz").read_bytes(), before)

    def test_fit_takes_vertices_of_the_files_one_by_one(self):
        """Vertices that share a place in one mesh and not in the other."""
        def write(name, *vertices):
            lines = "".join(f"v {v}\n" for v in vertices)
            (self.folder / name).write_text(lines + "f 1 2 3\nf 4 5 6\n")

        write("rest.obj", "0 0 0", "1 0 0", "1 1 0", "0 0 0", "0 1 1", ".3 .2 .7")
        write("closed.obj", "0 0 0", "1 0 0", "1 0 0", "0 0 0", "0 1 1", ".3 .2 .7")
        write("other.obj", "0 0 0", "1 0 0", "1 0 0", "0 .1 0", "0 1 1", ".3 .2 .7")
        for target, count, square in (("rest", 5, 0), ("closed", 5, 1), ("other", 6, 1.01)):
            self.good("fit", "rest.obj", f"{target}.obj", "--json", "report.json")
            report = json.loads((self.folder / "report.json").read_text())
            self.assertEqual((report["points"], report["outside"]), (count, 0), target)
            self.assertAlmostEqual(report["rms_start"] ** 2, square / count, msg=target)

    def test_report(self):
        self.good("deform", "solid.obj", "--deform", "twist:30", "-o", "out.obj", "--json", "r.json")
        report = self.report()
        self.assertEqual(report["vertices"], 6)
        self.assertEqual(report["device"], "reference")
        self.assertEqual(report["written"], ["out.obj"])
        (stage,) = report["stages"]
        self.assertEqual((stage["lattice"], stage["dims"]), ("box", [4, 4, 4]))
        self.assertEqual(stage["embedding"]["inside"], 6)
        self.assertFalse({"rest", "deformed"} & stage.keys())

    def test_folds_are_looked_for_where_asked(self):
        out = self.good("deform", "solid.obj", "--deform", "twist:30", "-o", "out.obj", "--json",
                        "r.json", "--check-folds")
        self.assertIn("box 4x4x4: at rest proved, deformed proved\n", out)
        (stage,) = self.report()["stages"]
        self.assertEqual(stage["deformed"]["verdict"], "proved")
        sides = [max(axis) - min(axis) + 2**-22 * max(map(abs, axis))
                 for axis in zip(*vertices(MESH))]
        self.assertAlmostEqual(stage["rest"]["volume"], math.prod(sides), places=9)
        inside_out = ("deform", "solid.obj", "--dims", "4x8x4", "--deform", "bend:300", "-o",
                      "out.obj")
        self.good(*inside_out)
        result = self.call(*inside_out, "--check-folds")
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stderr, r"\Ahwffd: warning: lattice 'box', deformed, is folded at [^\n]+\n\Z")
        flat = self.call("deform", "solid.obj", "--deform", "scale:1,1e-300,1", "-o", "out.obj", "--check-folds")
        self.assertRegex(flat.stderr, r"\Ahwffd: warning: lattice 'box', deformed, is undecided at [^\n]+\n\Z")
        out = self.good("embed", "solid.obj", "--check-folds", "--json", "e.json")
        self.assertTrue(out.endswith("\nat rest proved\n"))
        self.assertEqual(self.report("e.json")["rest"]["verdict"], "proved")

    def test_a_lattice_that_folds_at_rest(self):
        """Each place found gives the vertex back, though it is one of several."""
        (self.folder / "p.xyz").write_text("1.05 1.5 1.5\n1.2 1.2 1.3\n9 9 9\n")
        self.good("embed", "p.xyz", "--lattice", "folded.json", "-o", "places.txt", "--json", "e.json")
        report = self.report("e.json")
        self.assertNotIn("rest", report)
        self.assertEqual((report["inside"], report["outside"]), (2, 1))
        self.assertLess(report["worst_residual"], 1e-11)
        out = self.good("deform", "p.xyz", "--lattice", "folded.json", "--deform", "move:0,0,0:0,0,0")
        self.assert_near([tuple(map(float, line.split())) for line in out.splitlines()],
                         [(1.05, 1.5, 1.5), (1.2, 1.2, 1.3), (9, 9, 9)], places=9)

    def test_large_lattices_take_no_proof(self):
        result = subprocess.run([PROGRAM, "deform", "points.xyz", "--dims", "64x64x64", "--deform",
                                 "twist:30"], cwd=self.folder, capture_output=True, text=True,
                                check=True, timeout=60)
        self.assertEqual(len(result.stdout.splitlines()), 3)

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

    def test_names_are_bytes(self):
        mesh, lattice = os.fsdecode(b"m\xe9.obj"), os.fsdecode(b"l\xe9.json")
        (self.folder / mesh).write_text(self.text("solid.obj"))
        for command in (["lattice", "-o", lattice], ["check", lattice, "--json", "-"], ["info", mesh],
                        ["embed", mesh, "-o", os.fsdecode(b"e\xe9")],
                        *(["deform", mesh, "--lattice", "box", "--deform", "twist", "-o",
                           os.fsdecode(b"o\xe9." + end)] for end in (b"obj", b"ply", b"glb", b"gltf"))):
            result = subprocess.run([PROGRAM, *command], cwd=self.folder, capture_output=True, check=False)
            self.assertEqual(result.returncode, 0, result.stderr)
            if command[0] == "deform":
                self.assertTrue((self.folder / command[-1]).is_file())
        for command in (["deform", mesh, "--lattice", os.fsdecode(b"n\xe9.json"), "-o", "out.obj"],
                        ["info", os.fsdecode(b"n\xe9.obj")], ["deform", mesh, "-o", os.fsdecode(b"o.\xe9")],
                        ["deform", mesh, "-o", "out.obj", "--deform", os.fsdecode(b"\xe9")]):
            result = subprocess.run([PROGRAM, *command], cwd=self.folder, capture_output=True, check=False)
            self.assertIn(result.returncode, (FAILURE, USAGE))
            self.assertRegex(result.stderr, rb"\Ahwffd: [^\n]+\n\Z")

    def test_the_table_of_formats(self):
        """Each row of the documents: a file in its own format, where nothing moves."""
        page = pathlib.Path(__file__).resolve().parents[2] / "docs" / "hwffd.md"
        rows = re.findall(r"^\| `(\w+)` \|.*\| (\d+) \|$", page.read_text(), re.MULTILINE)
        files = {"obj": MESH.replace("v 1 0 0", " v 1.000 0 0 # a"),
                 "ply": "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                        "property double y\nproperty float z\nproperty float q\nelement face 1\n"
                        "property list uchar int vertex_indices\nend_header\n"
                        "0.50 0 0 1\n1 0 0 1\n0 1.10 0 1\n3 0 1 2\n",
                 "off": "OFF # a\n3 1 0\n0.50 0 0\n1 0 0\n0 1.123456789012 0\n3 0 1 2 1 0 0\n",
                 "stl": "solid a\n facet normal 0.0 0 1\nouter loop\nvertex 0.50 0 0\n"
                        "vertex 1 0 0\nvertex 0 1 0\nendloop endfacet\nendsolid a\n",
                 "xyz": "# a\n0.50 0 0 red\n1 2 3\n"}
        files = {name: text.encode() for name, text in files.items()}
        files["gltf"], files["glb"] = triangle_in_gltf()
        self.assertEqual([name for name, _ in rows], list(files))
        for name, differ in rows:
            (self.folder / f"in.{name}").write_bytes(files[name])
            self.good("deform", f"in.{name}", "--deform", "none", "--device", "reference",
                      "-o", f"out.{name}")
            was, now = ((self.folder / f"{n}.{name}").read_bytes() for n in ("in", "out"))
            self.assertEqual(len(was), len(now), name)
            self.assertEqual(sum(a != b for a, b in zip(was, now)), int(differ), name)

    def test_points_come_back_edited(self):
        text = "x y z  a # names\n\n0.50 0 0 red 1\r\n# b\n1e0,2;3 blue\n4 5 6\n"
        (self.folder / "a.xyz").write_text(text, newline="")
        options = ("--device", "reference", "-o", "b.xyz")
        self.good("deform", "a.xyz", "--deform", "none", *options)
        self.assertEqual((self.folder / "b.xyz").read_bytes(), text.encode())
        self.good("deform", "a.xyz", "--deform", "shear:1", *options)
        lines = (self.folder / "b.xyz").read_bytes().split(b"\n")
        self.assertEqual([lines[n] for n in (0, 1, 3, 6)], [b"x y z  a # names", b"", b"# b", b""])
        self.assertTrue(lines[2].endswith(b" red 1\r"))
        self.assertRegex(lines[2], rb"\A0\.50 -3\.3+\d* 0 red")
        self.good("deform", "a.xyz", "--deform", "none", "-o", "b.ply",
                  warning="b.ply: dropped: columns behind x y z")

    def test_rows(self):
        for words, row in {
                ("factored/3", "--format", "fx18"): "factored3-fx18-overlapped",
                ("tree 8",): "tree8-fp32-overlapped",
                ("affine3", "--format", "fx32"): "affine3-fx32-overlapped",
                ("basic-fp32-overlapped-fmac",): "basic-fp32-overlapped-fmac",
                ("basic-fp32-overlapped-deep", "--format", "fp32"): "basic-fp32-overlapped-deep",
                ("basic-fx32-overlapped-iterative",): "basic-fx32-overlapped-iterative",
                ("affine-fx17-overlapped-powers",): "affine-fx17-overlapped-powers"}.items():
            self.good("deform", "points.xyz", "-o", "out.xyz", "--json", "r.json", "--device", "model",
                      "--org", *words)
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
                    result = subprocess.run([PROGRAM, *line.split()], cwd=self.folder, stdout=full,
                                            stderr=subprocess.PIPE, text=True, check=False,
                                            preexec_fn=(lambda: os.close(1)) if closed else None)
                    self.assertEqual(result.returncode, FAILURE)
                    self.assertRegex(result.stderr, r"\Ahwffd: standard output: [^\n]+\n\Z")

    def test_what_is_open_is_written_on(self):
        """A log behind standard output keeps what it holds."""
        for name in "/dev/stdout", "/dev/fd/1":
            (self.folder / "log").write_text("precious\n")
            with open(self.folder / "log", "a") as log:
                subprocess.run([PROGRAM, "deform", "points.xyz", "--deform", "none", "--device",
                                "reference", "-o", name], cwd=self.folder, stdout=log, check=True)
            lines = self.text("log").splitlines()
            self.assertEqual(lines[:4], ["precious", "0 0 0", "0.25 0.5 0.75", "1 1 1"])
            self.assertTrue((self.folder / "log").is_file())

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

    def test_families(self):
        moved = {}
        for family in ("bspline", "clamped", "bernstein", "catmull-rom", "linear"):
            options = ("--family", family, "--deform", "move:1,1,1:0.1,0.2,0.3")
            for device in ("model", "reference"):
                self.good("deform", "solid.obj", *options, "--device", device, "-o", "out.obj",
                          "--json", "out.json")
                moved[family, device] = vertices(self.text("out.obj"))
            self.assertEqual(json.loads(self.text("out.json"))["stages"][0]["family"], family)
            self.assert_near(moved[family, "model"], moved[family, "reference"], places=4)
            self.good("lattice", *options, "-o", "lattice.json")
            self.assertIn("proved", self.good("check", "lattice.json", "--family", family))
        self.assertEqual(len({tuple(moved[key]) for key in moved}), len(moved))

    def test_few_points(self):
        """A cube whose corner is pulled takes what it holds along by trilinear weights."""
        pull = ("--dims", "2x2x2", "--region", "0,0,0,1,1,1", "--deform", "move:1,1,1:0.5,0,0")
        corner = (0.3, 0.6, 0.9)
        (self.folder / "one.obj").write_text("v {} {} {}\nv 0 0 0\nv 1 1 1\nf 1 2 3\n".format(
            *corner))
        for family in ("bernstein", "catmull-rom", "linear"):
            self.good("deform", "one.obj", "--family", family, *pull, "--device", "reference",
                      "-o", "out.obj")
            wanted = (corner[0] + 0.5 * corner[0] * corner[1] * corner[2], *corner[1:])
            self.assert_near([vertices(self.text("out.obj"))[0]], [wanted], places=6)
            self.good("lattice", "--family", family, *pull, "-o", "few.json")
            self.assertEqual(json.loads(self.text("few.json"))["dims"], [2, 2, 2])
            self.assertIn("proved", self.good("check", "few.json"))
            self.good("deform", "one.obj", "--lattice", "few.json", "-o", "out.obj")

    def test_groups_and_masks(self):
        whole = ("deform", "solid.obj", "--deform", "scale:2", "--device", "reference",
                 "-o", "out.obj")
        at_rest = vertices(MESH)
        self.good(*whole)
        moved = vertices(self.text("out.obj"))
        self.good(*whole, "--group", "upper")
        self.assertEqual(vertices(self.text("out.obj")), at_rest[:1] + moved[1:])
        self.good(*whole, "--group", "upper", "--group", "lower")
        self.assertEqual(vertices(self.text("out.obj")), moved)
        weights = (1, 0.5, 0, 1, 0, 0.25)
        (self.folder / "mask.txt").write_text("\n".join(map(str, weights)) + "\n")
        self.good(*whole, "--mask", "mask.txt")
        between = [[a + w * (b - a) for a, b in zip(p, q)]
                   for w, p, q in zip(weights, at_rest, moved)]
        self.assert_near(vertices(self.text("out.obj")), between, places=6)
        self.assertEqual(vertices(self.text("out.obj"))[2], at_rest[2])
        for words, text in ((("--group", "uper"), "lower, upper"), (("--mask", "none.txt"), "none.txt"),
                            (("--mask", "few.txt"), "1 numbers for 6"),
                            (("--mask", "over.txt"), "of vertex 5")):
            (self.folder / "few.txt").write_text("1\n")
            (self.folder / "over.txt").write_text("1\n" * 5 + "1.5\n")
            result = self.call(*whole, *words)
            self.assertEqual(result.returncode, FAILURE)
            self.assertIn(text, result.stderr)
        (self.folder / "two.xyz").write_text("0 0 0\n1 1 1\n")
        (self.folder / "two.txt").write_text("0\n1\n")
        out = self.good("deform", "two.xyz", "--deform", "scale:2", "--device", "reference",
                        "--mask", "two.txt")
        self.assertEqual(out.splitlines()[0], "0 0 0")

    def test_what_it_says_of_itself(self):
        bash = self.good("completion", "bash")
        (self.folder / "bash").write_text(bash)
        ask = ("source ./bash; COMP_WORDS=(hwffd {}); COMP_CWORD={}; _hwffd; echo ${{COMPREPLY[@]}}")
        for words, last, wanted in (("em", 1, "embed"), ("deform --fam", 2, "--family"),
                                    ("deform --family cat", 3, "catmull-rom"), ("embed x", 2, "")):
            result = subprocess.run(["bash", "-c", ask.format(words, last)], cwd=self.folder,
                                    capture_output=True, text=True, check=True)
            self.assertEqual(result.stdout.strip(), wanted)
        for shell in ("zsh", "fish"):
            text = self.good("completion", shell)
            for word in ("deform", "family", "catmull-rom"):
                self.assertIn(word, text)
        manual = self.good("manual")
        for command in ("deform", "embed", "lattice", "check", "info", "view", "completion"):
            self.assertIn(f".SS hwffd {command}\n", manual)
        self.assertIn(".TP\n\\fB\\-o, \\-\\-output\\fR", manual)

    def test_a_mirror_turns_faces(self):
        for scale, corners in (("1", "132"), ("-1,1,1", "123"), ("-1,-1,1", "132")):
            self.good("deform", "solid.obj", "--deform", f"scale:{scale}", "-o", "out.obj")
            faces = [line for line in self.text("out.obj").splitlines() if line.startswith("f ")]
            self.assertEqual("".join(re.findall(r" (\d)", faces[0])), corners, scale)

    def rounded(self, name):
        return [tuple(round(x, 5) for x in v) for v in vertices(self.text(name))]

    def test_outside(self):
        options = ("deform", "solid.obj", "--region", "0,0,0,1,1,1", "--deform", "scale:2")
        result = self.call(*options, "-o", "keep.obj")
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stderr, r"\Ahwffd: warning: \d edges join[^\n]+tears[^\n]+\n\Z")
        self.assertIn("4 inside, 2 outside", result.stdout)
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

    def test_lattice_files_keep_their_family_and_what_is_at_rest(self):
        self.good("lattice", "--around", "solid.obj", "--family", "catmull-rom", "--dims", "6x6x6", "-o", "rest.json")
        self.good("lattice", "--lattice", "rest.json", "--deform", "bend:60", "-o", "moved.json")
        self.good("deform", "solid.obj", "--lattice", "rest.json", "--deform", "to:moved.json", "-o", "a.obj")
        self.good("deform", "solid.obj", "--family", "catmull-rom", "--dims", "6x6x6", "--deform", "bend:60", "-o", "b.obj")
        self.assertEqual(*(vertices(self.text(f"{n}.obj")) for n in "ab"))
        info = json.loads(self.good("info", "moved.json", "--json", "-"))
        self.assertEqual((info["family"], info["cells"]), ("catmull-rom", [3, 3, 3]))

        rest, moved = (json.loads(self.text(name)) for name in ("rest.json", "moved.json"))
        self.assertEqual({*rest, *moved}, {"hwffd_lattice", "order", "dims", "family", "points"})
        (self.folder / "both.json").write_text(json.dumps({**moved, "rest": rest["points"]}))
        self.good("lattice", "--lattice", "both.json", "--deform", "none", "-o", "again.json")
        again = json.loads(self.text("again.json"))
        self.assertEqual((again["rest"], again["points"], again["family"]), (rest["points"], moved["points"], "catmull-rom"))
        self.good("deform", "solid.obj", "--lattice", "again.json", "-o", "a.obj")
        self.assertEqual(*(vertices(self.text(f"{n}.obj")) for n in "ab"))

    def test_a_lattice_is_read_once_so_that_it_may_come_through_a_pipe(self):
        self.good("lattice", "--around", "solid.obj", "--family", "linear", "-o", "rest.json")
        words = ("--lattice", "rest.json", "--deform", "bend:60"), ("--lattice", "/dev/stdin", "--deform", "bend:60")
        for stage, name in zip(words, "ab"):
            self.good("lattice", *stage, "-o", f"{name}.json", given=self.text("rest.json"))
            self.good("deform", "solid.obj", *stage, "-o", f"{name}.obj", given=self.text("rest.json"))
        for suffix in ("json", "obj"):
            self.assertEqual(self.text(f"a.{suffix}"), self.text(f"b.{suffix}"))

    def test_a_view_saves_over_no_file_that_it_read(self):
        self.good("lattice", "-o", "lattice.json")
        for words, name in ((("--lattice", "lattice.json"), "lattice.json"),
                            (("--deform", "to:lattice.json"), "lattice.json"), (("-o", "solid.obj"), "solid.obj")):
            refused = self.call("view", "solid.obj", *words)
            self.assertEqual(refused.returncode, USAGE)
            self.assertIn(f"--output {name}: is read from; name another file", refused.stderr)

    def test_a_check_is_of_the_family_that_a_file_names(self):
        self.good("lattice", "--family", "bernstein", "--dims", "4x4x4", "--region", "0,0,0,1,1,1", "-o", "cell.json")
        self.good("check", "cell.json", "--json", "check.json")
        self.assertAlmostEqual(self.report("check.json")["lattices"][0]["volume"], 1.0)
        self.good("check", "cell.json", "--family", "bspline", "--json", "check.json")
        self.assertAlmostEqual(self.report("check.json")["lattices"][0]["volume"], 1 / 27)

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
        self.assertEqual(sorted(devices), ["model", "reference", "rtl", "serial:PATH", "socket:PATH", "uio:N"])
        self.assertLessEqual(set(devices["rtl"]), set(devices["model"]))
        self.assertIn("basic-fp32-overlapped", devices["rtl"])
        self.assertIn("basic-fp32-overlapped", self.good("info"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
