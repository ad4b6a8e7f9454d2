"""What tests of the command hwffd begin with: files, and how it is called.

SPDX-License-Identifier: Apache-2.0
"""

import base64
import itertools
import json
import struct

from tests.support.program import ProgramTest

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


def triangle_in_gltf():
    """One triangle, as the bytes of a .gltf and of a .glb, with what no mesh has."""
    data = struct.pack("<9f", 0.5, 0, 0, 1, 0, 0, 0, 1 / 3, 0)
    scene = {"asset": {"version": "2.0", "extras": [1.50, "\\"]}, "scene": 0,
             "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "rotation": [0.6, 0, 0, 0.8]}],
             "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
             "materials": [{"extensions": {"KHR_materials_ior": {"ior": 1.4}}}],
             "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                            "min": [0, 0.0, 0], "max": [1, 0.3333333432674408, 0]}],
             "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36}]}
    chunk = json.dumps(scene).encode()
    chunk += b" " * (-len(chunk) % 4)
    container = (struct.pack("<4sII", b"glTF", 2, 28 + len(chunk) + len(data))
                 + struct.pack("<I4s", len(chunk), b"JSON") + chunk
                 + struct.pack("<I4s", len(data), b"BIN\0") + data)
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    scene["buffers"][0]["uri"] = uri
    return json.dumps(scene, indent=3).encode(), container


def lattice(point, dims=(4, 4, 4)):
    points = [point(*at) for at in itertools.product(*map(range, dims))]
    return json.dumps({"hwffd_lattice": 1, "dims": dims, "points": points})


FLAT = lattice(lambda i, j, k: [i, j, 0])
LATTICES = {"folded.json": lattice(lambda i, j, k: [-2 if i == 3 else i, j, k]),
            "sheet.json": lattice(lambda i, j, k: [i, j, i * j]), "flat.json": FLAT, "few.json": lattice(lambda *at: at, (2, 3, 2)), "junk.json": FLAT + "\0junk",
            "twice.json": FLAT.replace("{", '{"dims": [5, 5, 5], ', 1),
            "huge.json": lattice(lambda *at: [x * 1e154 for x in at])}


class CommandTest(ProgramTest):
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
        result = self.call(*words, given=given)
        stderr = f"hwffd: warning: {warning}\n" if warning else ""
        self.assertEqual((result.returncode, result.stderr), (0, stderr), words)
        return result.stdout
