#!/usr/bin/env python3
"""glTF files through the command hwffd.

    test_gltf.py HWFFD

SPDX-License-Identifier: Apache-2.0
"""

import base64
import itertools
import json
import math
import struct
import unittest

from tests.hwffd.command import CommandTest


class Gltf(CommandTest):
    @staticmethod
    def ball():
        """A glTF of a ball with normals and tangents, far from a node that turns and shrinks it,
        with a skin and a morph target."""
        rings, places, normals, tangents = 9, [], [], []
        for i, j in itertools.product(range(rings), repeat=2):
            up, around = math.pi * i / (rings - 1), 2 * math.pi * j / rings
            normal = (math.sin(up) * math.cos(around), math.cos(up), math.sin(up) * math.sin(around))
            normals += normal
            places += [1 / 3 + 0.1 * x for x in normal]
            tangents += [-math.sin(around), 0, math.cos(around), 1]
        corners = [c for i, j in itertools.product(range(rings - 1), repeat=2)
                   for a in [i * rings + j] for c in (a, a + 1, a + rings)]
        data = (struct.pack(f"<{10 * rings**2}f", *places, *normals, *tangents)
                + struct.pack(f"<{len(corners)}H", *corners))
        sizes = [12 * rings**2, 12 * rings**2, 16 * rings**2, 2 * len(corners)]
        views = [{"buffer": 0, "byteOffset": sum(sizes[:v]), "byteLength": size}
                 for v, size in enumerate(sizes)]
        accessors = [{"bufferView": v, "componentType": 5126 if v < 3 else 5123,
                      "count": rings**2 if v < 3 else len(corners), "type": kind}
                     for v, kind in enumerate(("VEC3", "VEC3", "VEC4", "SCALAR"))]
        uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
        return json.dumps({
            "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "scene": 0,
            "nodes": [{"children": [1], "rotation": [0.1, 0.7, 0.1, 0.7], "scale": [0.1, 0.2, 0.3]},
                      {"mesh": 0, "skin": 0, "translation": [1e3, 1 / 7, -0.1]}],
            "skins": [{"joints": [0]}],
            "meshes": [{"primitives": [
                {"attributes": {"POSITION": 0, "NORMAL": 1, "TANGENT": 2}, "indices": 3,
                 "targets": [{"NORMAL": 1}]}]}],
            "materials": [{"extensions": {"KHR_materials_ior": {"ior": 1.4}}}],
            "extensionsUsed": ["KHR_materials_ior"], "extras": {"odd": 1.50},
            "buffers": [{"byteLength": len(data), "uri": uri}], "bufferViews": views,
            "accessors": accessors})

    def test_a_gltf_that_does_not_move_stays(self):
        (self.folder / "ball.gltf").write_text(self.ball())
        message = ("kept as they were, and so move the deformed shape as if it were at rest:"
                   " 1 skin, 1 morph target")
        for shape in "box", "cylinder", "sphere":
            self.good("deform", "ball.gltf", "--lattice", shape, "--deform", "none",
                      "--device", "reference", "-o", "out.gltf", warning=f"out.gltf: {message}")
            self.assertEqual(self.text("out.gltf"), self.ball(), shape)
        self.good("deform", "ball.gltf", "--deform", "twist:30", "-o", "out.glb",
                  warning=f"out.glb: {message}")
        self.assertNotEqual(self.report_of("out.glb"), self.report_of("ball.gltf"))
        self.good("deform", "ball.gltf", "--deform", "none", "-o", "out.obj",
                  warning="ball.gltf: dropped: 1 bone, 1 morph target, tangents,"
                          " extension KHR_materials_ior, extras")

    def report_of(self, name):
        return json.loads(self.good("info", name, "--json", "-"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
