"""A volume of one point along w is a surface: the same vertices as from OpenGL's own evaluators.
glFFD: an interleaved stream gives the positions of eq. (1).

SPDX-License-Identifier: Apache-2.0
"""

import os

import numpy as np
from opengl import asked, error_of, gl, seen, seen_normals
from scene import BSPLINE, GlTest, RandomMap, draw, eq1

VERTICES = 40


class Planar(GlTest):
    def setUp(self):
        super().setUp()
        self.define("VERTEX_3", 3)
        self.define("COLOR_4", 4)

    def define(self, target, components):
        """The same random surface for both, over a domain that runs backwards along v."""
        given = RandomMap(self.random, (3, 4, 1), components, low=0.05)
        if target == "VERTEX_4":
            given.points[..., 3] += 1  # the quotient stays in view
        target3, target2 = getattr(gl, f"MAP3_{target}"), getattr(gl, f"MAP2_{target}")
        given.define(target3, ((0, 2), (1, -1), (0, 1)))
        gl.Map2d(target2, 0, 2, given.strides[0], 3, 1, -1, given.strides[1], 4, given.values)
        gl.EnableMap3(target3)
        gl.Enable(target2)

    def expect_same(self, volume, surface, count):
        ours, theirs = seen(volume), seen(surface)
        self.assertEqual(len(theirs), count)
        self.assert_near(ours.positions, theirs.positions, 1e-5)
        self.assert_near(ours.colors, theirs.colors, 1e-5)

    def test_eval_coord(self):
        at = np.vstack([[(0, -1), (2, 1), (0, 1)], self.random.uniform((0, -1), (2, 1), (27, 2))])
        self.expect_same(lambda: draw(gl.POINTS, lambda u, v: gl.EvalCoord3d(u, v, 0.5), at),
                         lambda: draw(gl.POINTS, gl.EvalCoord2d, at), 30)

    def test_eval_mesh_in_points_and_lines(self):
        gl.MapGrid3d(5, 0.25, 1.75, 3, 0.5, -0.5, 2, 0, 1)
        gl.MapGrid2d(5, 0.25, 1.75, 3, 0.5, -0.5)
        self.expect_same(lambda: gl.EvalMesh3(gl.POINT, 0, 5, 1, 3, 1, 1),
                         lambda: gl.EvalMesh2(gl.POINT, 0, 5, 1, 3), 18)
        self.expect_same(lambda: gl.EvalMesh3(gl.LINE, 1, 5, 0, 3, 0, 0),
                         lambda: gl.EvalMesh2(gl.LINE, 1, 5, 0, 3), 62)

    def test_eval_point(self):
        gl.MapGrid3f(4, 0, 2, 3, 1, -1, 1, 0, 1)
        gl.MapGrid2f(4, 0, 2, 3, 1, -1)
        at = [(i, 3 - i % 4) for i in range(5)]
        self.expect_same(lambda: draw(gl.LINE_STRIP, lambda i, j: gl.EvalPoint3(i, j, 0), at),
                         lambda: draw(gl.LINE_STRIP, gl.EvalPoint2, at), 8)

    def test_disabled_vertices_draw_nothing(self):
        gl.DisableMap3(gl.MAP3_VERTEX_3)
        gl.Disable(gl.MAP2_VERTEX_3)
        self.expect_same(lambda: gl.EvalMesh3(gl.POINT, 0, 1, 0, 1, 0, 1),
                         lambda: gl.EvalMesh2(gl.POINT, 0, 1, 0, 1), 0)

    def expect_same_normals(self, devices):
        gl.MapGrid3d(4, 0, 2, 4, 1, -1, 1, 0, 1)
        gl.MapGrid2d(4, 0, 2, 4, 1, -1)
        gl.Enable(gl.AUTO_NORMAL)
        gl.EnableMap3(gl.AUTO_NORMAL)
        theirs = seen_normals(lambda: gl.EvalMesh2(gl.POINT, 0, 4, 0, 4))
        self.assert_near(np.linalg.norm(theirs, axis=1), np.ones(25), 1e-5)
        for device, tolerance in devices.items():
            gl.FfdDevice(device.encode())
            self.assert_near(seen_normals(lambda: gl.EvalMesh3(gl.POINT, 0, 4, 0, 4, 0, 0)),
                             theirs, tolerance, device)

    def test_automatic_normals(self):
        self.expect_same_normals({"reference": 5e-6, "model": 5e-6, "model:basic:fx18": 1.5e-2,
                                  "rtl:basic:fx32": 5e-6})

    def test_automatic_normals_of_homogeneous_vertices(self):
        gl.DisableMap3(gl.MAP3_VERTEX_3)
        gl.Disable(gl.MAP2_VERTEX_3)
        self.define("VERTEX_4", 4)
        self.expect_same_normals({"model": 5e-5})

    def test_meshes_leave_the_context_as_it_was(self):
        gl.Color4f(0.25, 0.5, 0.75, 1)
        buffer = np.zeros(1, np.uint32)
        gl.GenBuffers(1, buffer)
        gl.BindBuffer(gl.ARRAY_BUFFER, int(buffer[0]))
        gl.EnableClientState(gl.NORMAL_ARRAY)
        self.assertEqual(error_of(gl.EvalMesh3, gl.LINE, 0, 1, 0, 1, 0, 1), gl.NO_ERROR)
        for name, expected in ((gl.CURRENT_COLOR, [0.25, 0.5, 0.75, 1]),
                               (gl.ARRAY_BUFFER_BINDING, buffer.tolist()),
                               (gl.VERTEX_ARRAY_BINDING, [0]), (gl.NORMAL_ARRAY, [1]),
                               (gl.VERTEX_ARRAY, [0])):
            self.assertEqual(asked(gl.GetDoublev, name, count=len(expected)), expected)

    def test_full_stacks_stay_as_they_are(self):
        gl.MapGrid3d(1, 0, 1, 1, 0, 1, 1, 0, 1)
        for push, pop, group, depth, most in (
                (gl.PushAttrib, gl.PopAttrib, gl.LINE_BIT, gl.ATTRIB_STACK_DEPTH, gl.MAX_ATTRIB_STACK_DEPTH),
                (gl.PushClientAttrib, gl.PopClientAttrib, gl.CLIENT_PIXEL_STORE_BIT,
                 gl.CLIENT_ATTRIB_STACK_DEPTH, gl.MAX_CLIENT_ATTRIB_STACK_DEPTH)):
            count = int(asked(gl.GetDoublev, most, count=1)[0])
            for _ in range(count):
                push(group)
            gl.LineWidth(3)
            gl.PixelStorei(gl.PACK_ALIGNMENT, 2)
            raised = []
            vertices = seen(lambda raised=raised: raised.append(error_of(gl.EvalMesh3, gl.POINT, 0, 1, 0, 1, 0, 1)))
            kept = [asked(gl.GetDoublev, name, count=1)[0] for name in (depth, gl.LINE_WIDTH, gl.PACK_ALIGNMENT)]
            for _ in range(count):
                pop()
            gl.LineWidth(1)
            gl.PixelStorei(gl.PACK_ALIGNMENT, 4)
            self.assertEqual((raised, len(vertices), kept), ([gl.STACK_OVERFLOW], 0, [count, 3, 2]))


class Stream(GlTest):
    def setUp(self):
        super().setUp()
        self.addCleanup(os.environ.pop, "HWFFD_DEVICE", None)
        at, points = self.random.random((VERTICES, 3)), (VERTICES, 4, 4, 4, 3)
        supports = self.random.uniform(-0.9, 0.9, points)
        self.stream = np.hstack([at, supports.reshape(VERTICES, 192)])
        self.expected = np.array([eq1(support, [BSPLINE] * 3, position)
                                  for support, position in zip(supports, at)])
        for axis in (gl.MAP3_U, gl.MAP3_V, gl.MAP3_W):
            gl.BlendCoefficientd(axis, 3, BSPLINE)

    def drawn(self, mode=gl.POINTS, number=gl.DOUBLE, element=np.float64):
        return seen(lambda: gl.FFD(mode, VERTICES, number, self.stream.astype(element))).positions

    def test_every_device(self):
        for device, tolerance in {"reference": 2e-6, "model": 2e-6, "model:parallel:fp32": 2e-6,
                                  "rtl": 2e-6, "rtl:basic:fx32": 2e-6,
                                  "model:parallel:fx18": 2e-4, "rtl:basic:fx18": 2e-4}.items():
            gl.FfdDevice(device.encode())
            self.assert_near(self.drawn(), self.expected, tolerance, device)

    def test_coordinates_beyond_the_cell_are_clamped_on_every_device(self):
        self.stream[:, :3] = 3 * self.stream[:, :3] - 1
        supports = self.stream[:, 3:].reshape(VERTICES, 4, 4, 4, 3)
        expected = [eq1(support, [BSPLINE] * 3, position)
                    for support, position in zip(supports, self.stream[:, :3].clip(0, 1))]
        for device, tolerance in {"reference": 2e-6, "model": 2e-6, "model:basic:fx32": 2e-6}.items():
            gl.FfdDevice(device.encode())
            self.assert_near(self.drawn(), expected, tolerance, device)

    def test_floats_and_primitives(self):
        strip = self.drawn(gl.LINE_STRIP, gl.FLOAT, np.float32)
        self.assert_near(strip, np.repeat(self.expected, 2, axis=0)[1:-1], 1e-6)

    def test_the_environment_names_the_device(self):
        os.environ["HWFFD_DEVICE"] = "model:basic:fx18"
        gl.FfdDevice(None)
        coarse = self.drawn()
        self.assert_near(coarse, self.expected, 5e-4)
        self.assertGreater(np.abs(coarse - self.expected).max(), 1e-5, "eighteen bits show")
        os.environ["HWFFD_DEVICE"] = "abacus"
        self.assertEqual(error_of(gl.FfdDevice, None), gl.INVALID_VALUE)

    def test_numbers_that_are_not_finite_are_refused(self):
        self.stream[0, 100] = np.inf
        self.assertEqual(error_of(gl.FFD, gl.POINTS, VERTICES, gl.DOUBLE, self.stream),
                         gl.INVALID_OPERATION)
