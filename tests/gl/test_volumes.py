"""The GLU renderer: volumes of models, callbacks, properties. Most of it without a context.

SPDX-License-Identifier: Apache-2.0
"""

import ctypes
import itertools
import unittest

import hwffd
import numpy as np
from opengl import asked, gl, glu, seen
from scene import BSPLINE, GlTest

NUMBERS = ctypes.POINTER(ctypes.c_float)
CALLBACKS = {"ERROR": (ctypes.c_uint,), "PROGRESS": (ctypes.c_float,), "BEGIN": (ctypes.c_uint,),
             "VERTEX": (NUMBERS,), "NORMAL": (NUMBERS,), "COLOR": (NUMBERS,),
             "TEXTURE_COORD": (NUMBERS,), "END": ()}
USER = 77  # the pointer that callbacks get back
SLOPES = np.arange(1, 4)


class Renderer:
    """A renderer whose callbacks write a log: the callback's name, and its first numbers."""

    def __init__(self, device="model"):
        self.log = []
        self.functions = []  # OpenGL holds them too
        self.ffd = glu.NewFfdRenderer()
        glu.FfdCallbackData(self.ffd, USER)
        for name in CALLBACKS:
            self.listen(name)
        glu.FfdProperty(self.ffd, glu.FFD_MODE, glu.FFD_EVALUATOR)
        glu.FfdDevice(self.ffd, device.encode())

    def listen(self, name, with_data=True):
        data = (ctypes.c_void_p,) if with_data else ()

        def note(*values):
            if values[len(values) - len(data):] != (USER,) * len(data):
                values = ("without the user's data",)
            elif CALLBACKS[name] == (NUMBERS,):
                values = (values[0][:3],)
            else:
                values = values[:len(CALLBACKS[name])]
            self.log.append((name if with_data else "plain " + name, *values))

        self.functions.append(ctypes.CFUNCTYPE(None, *CALLBACKS[name], *data)(note))
        glu.FfdCallback(self.ffd, getattr(glu, "FFD_" + name + "_DATA" * with_data),
                        self.functions[-1])

    def heard(self, name):
        """What the callback was called with, each time."""
        return [value for called, *values in self.log if called == name for value in values]

    def order(self):
        """The callbacks of drawing."""
        return [called for called, *_ in self.log if called not in ("ERROR", "PROGRESS")]


def volume(ffd, coordinates, control, kind=gl.MAP3_VERTEX_3, knots=None, orders=(4, 4, 4)):
    """One attribute; control points are an array (s, t, u, component)."""
    counts = [points + order for points, order in zip(control.shape, orders)]
    knots = knots or (None, None, None)
    strides = [stride // control.itemsize for stride in control.strides[:3]]
    glu.FfdVolume(ffd, len(coordinates), 4, coordinates.astype(np.float32),
                  *itertools.chain(*zip(counts, knots)), *strides, control, *orders, kind)


class Model:
    """Places in a deformed lattice, rounded to GLfloat as its control points are."""

    def __init__(self, dims, deformation, scale=1):
        points = np.random.default_rng(3).uniform(-0.9, 0.9, (3072, 3))
        lattice = hwffd.Lattice.around("box", points, dims)
        self.cells, local, _, inside = lattice.embed(points)
        assert inside.all()
        lattice.deform(deformation)
        self.local = local.astype(np.float32)
        self.control = (scale * lattice.points).astype(np.float32).reshape(*dims, 3)
        self.lattice = hwffd.Lattice(dims, self.control.reshape(-1, 3).astype(float))
        numbers = np.ravel_multi_index(self.cells.T, dims)
        self.coordinates = np.column_stack([self.local, numbers]).astype(np.float32)

    def give(self, ffd, normals=None, elements=None):
        """A volume of the model."""
        glu.BeginVolume(ffd)
        volume(ffd, self.coordinates, self.control)
        if normals is not None:
            glu.FfdNormals(ffd, len(normals), 3, normals)
        if elements is not None:
            glu.FfdElements(ffd, len(elements), elements)
        glu.EndVolume(ffd)

    def jacobians(self):
        """dq/ds, dq/dt, dq/du as columns, of every place."""
        at = self.cells[:, :, None] + np.arange(4)
        supports = self.control[at[:, 0, :, None, None], at[:, 1, None, :, None],
                                at[:, 2, None, None, :]].astype(float)
        powers = self.local.astype(float)[..., None] ** np.arange(4)
        weights, slopes = powers @ BSPLINE.T, powers[..., :3] * SLOPES @ BSPLINE[:, 1:].T
        return np.stack([np.einsum("vl,vm,vn,vlmnc->vc",
                                   *((slopes if axis == along else weights)[:, axis]
                                     for axis in range(3)), supports)
                         for along in range(3)], axis=2)


class RendererTest(unittest.TestCase):
    def renderer(self, device="model"):
        renderer = Renderer(device)
        self.addCleanup(glu.DeleteFfdRenderer, renderer.ffd)
        return renderer


class Volume(RendererTest):
    def test_vertices_of_a_model_are_those_of_the_device(self):
        model = Model((5, 4, 6), "twist:90")
        for device in ("model:basic:fp32", "model:parallel:fx18", "rtl:basic:fx18", "reference"):
            renderer = self.renderer(device)
            model.give(renderer.ffd)
            self.assertEqual(renderer.heard("ERROR"), [], device)
            model.lattice.set_device(*device.split(":"))
            expected = model.lattice.evaluate(model.cells, model.local).astype(np.float32)
            np.testing.assert_array_equal(renderer.heard("VERTEX"), expected, device)

    def test_progress_rises_to_one_on_every_device(self):
        model = Model((4, 4, 4), "bend:90")
        for device in ("model", "rtl:basic:fx18", "reference"):
            renderer = self.renderer(device)
            model.give(renderer.ffd, np.ones((3072, 3), np.float32))
            progress = renderer.heard("PROGRESS")
            self.assertTrue(np.all(np.diff(progress) >= 0), device)
            self.assertEqual(progress.index(1), len(progress) - 1, device)
            if device != "reference":
                self.assertGreater(len(progress), 150, "two passes, about a hundred steps each")
                self.assertLess(progress[0], 0.01, device)

    def test_attributes_come_before_the_vertex_and_elements_give_the_order(self):
        renderer, model = self.renderer(), Model((4, 4, 4), "none")
        glu.FfdProperty(renderer.ffd, glu.FFD_PRIMITIVE, gl.LINE_STRIP)
        glu.BeginVolume(renderer.ffd)
        volume(renderer.ffd, model.coordinates, model.control)
        for kind in (gl.MAP3_TEXTURE_COORD_2, gl.MAP3_COLOR_4, gl.MAP3_NORMAL):
            volume(renderer.ffd, model.coordinates, np.full((4, 4, 4, 4), 0.5, np.float32), kind)
        glu.FfdElements(renderer.ffd, 3, [5, 3, 5])
        glu.EndVolume(renderer.ffd)
        self.assertEqual(renderer.order(),
                         ["BEGIN", *3 * ["COLOR", "NORMAL", "TEXTURE_COORD", "VERTEX"], "END"])
        self.assertEqual(renderer.heard("BEGIN"), [gl.LINE_STRIP])
        first, second, third = renderer.heard("VERTEX")
        self.assertEqual(first, third)
        self.assertNotEqual(first, second)

    def test_normals_are_those_of_the_inverse_jacobian(self):
        model = Model((5, 5, 4), "random:3")
        normals = np.random.default_rng(5).uniform(-1, 1, (3072, 3)).astype(np.float32)
        expected = np.einsum("vi,vij->vj", normals, np.linalg.inv(model.jacobians()))
        for device, tolerance in (("reference", 1e-5), ("model", 1e-4), ("model:basic:fx32", 1e-4),
                                  ("model:basic:fx18", 3e-2)):
            renderer = self.renderer(device)
            model.give(renderer.ffd, normals)
            off = np.linalg.norm(renderer.heard("NORMAL") - expected, axis=1)
            self.assertLess((off / np.linalg.norm(expected, axis=1)).max(), tolerance, device)

    def test_knots_of_any_kind(self):
        knots = ([0, 0, 0, 0, 1, 1.5, 4, 4, 4, 4], [-3, -2, 0, 0.5, 0.5, 2], [0, 1, 3, 3.25, 7])
        orders = (4, 3, 2)  # of 6, 3 and 3 points

        def bspline(axis, number, degree, at):
            """The B-spline of a number and degree, by its recurrence."""
            k = knots[axis][number:]
            if degree == 0:
                return float(k[0] <= at < k[1])
            return sum((at - a) / (b - a) * bspline(axis, number + n, degree - 1, at)
                       for n, a, b in ((0, k[0], k[degree]), (1, k[degree + 1], k[1])) if a != b)

        random = np.random.default_rng(9)
        control = random.uniform(-1, 1, (6, 3, 3, 3)).astype(np.float32)
        coordinates, expected = [], []
        for vertex in range(60):
            cell = (vertex % 3, 0, vertex // 3 % 2)
            local = random.random(3).astype(np.float32)
            coordinates.append((*local, (cell[0] * 3 + cell[1]) * 3 + cell[2]))
            weights = []
            for axis, order in enumerate(orders):
                first, last = knots[axis][cell[axis] + order - 1:cell[axis] + order + 1]
                at = first + float(local[axis]) * (last - first)
                weights.append([bspline(axis, number, order - 1, at)
                                for number in range(control.shape[axis])])
            expected.append(np.einsum("i,j,k,ijkc->c", *weights, control))
        renderer = self.renderer()
        glu.BeginVolume(renderer.ffd)
        volume(renderer.ffd, np.array(coordinates), control, knots=knots, orders=orders)
        glu.EndVolume(renderer.ffd)
        self.assertEqual(renderer.heard("ERROR"), [])
        np.testing.assert_allclose(renderer.heard("VERTEX"), expected, rtol=0, atol=5e-6)

    def test_a_call_that_fails_spoils_its_volume_alone(self):
        renderer, model = self.renderer(), Model((4, 4, 4), "none")
        glu.BeginVolume(renderer.ffd)
        volume(renderer.ffd, model.coordinates, model.control)
        glu.FfdElements(renderer.ffd, -1, None)
        glu.EndVolume(renderer.ffd)
        self.assertEqual(renderer.heard("ERROR"), [glu.FFD_INVALID_VALUE])
        self.assertEqual(renderer.order(), [])
        model.give(renderer.ffd)
        self.assertEqual(len(renderer.heard("ERROR")), 1)
        self.assertEqual(len(renderer.heard("VERTEX")), 3072)

    def test_callbacks_without_data_are_called_where_none_with_data_is(self):
        renderer = self.renderer()
        glu.FfdCallback(renderer.ffd, glu.FFD_END_DATA, None)
        renderer.listen("BEGIN", with_data=False)
        renderer.listen("END", with_data=False)
        Model((4, 4, 4), "none").give(renderer.ffd)
        runs = [(name, len(list(run))) for name, run in itertools.groupby(renderer.order())]
        self.assertEqual(runs, [("BEGIN", 1), ("VERTEX", 3072), ("plain END", 1)])


class Properties(RendererTest):
    def test_defaults_and_values(self):
        ffd = glu.NewFfdRenderer()
        self.addCleanup(glu.DeleteFfdRenderer, ffd)
        for name, initial, other in ((glu.FFD_MODE, glu.FFD_RENDERER, glu.FFD_EVALUATOR),
                                     (glu.FFD_PRIMITIVE, gl.TRIANGLES, gl.POINTS),
                                     (glu.FFD_DISPLAY_MODE, gl.FILL, gl.LINE),
                                     (glu.FFD_LINE_WIDTH, 1, 2.5), (glu.FFD_POINT_SIZE, 1, 4),
                                     (glu.FFD_DEVICE, glu.FFD_MODEL, glu.FFD_REFERENCE)):
            for value in (initial, other):
                got = asked(glu.GetFfdProperty, ffd, name, count=1, element=np.float32)
                self.assertEqual(got, [value], name)
                glu.FfdProperty(ffd, name, other)
        glu.FfdDevice(ffd, b"rtl:basic:fx18")
        got = asked(glu.GetFfdProperty, ffd, glu.FFD_DEVICE, count=1, element=np.float32)
        self.assertEqual(got, [glu.FFD_RTL])
        glu.DeleteFfdRenderer(None)


class Drawing(GlTest, RendererTest):
    def test_goes_to_the_context_in_the_display_mode(self):
        renderer, model = self.renderer(), Model((4, 4, 4), "twist:45", scale=1 / 8)
        ffd, elements = renderer.ffd, [0, 100, 2000, 7, 8, 9]
        model.give(ffd, elements=elements)
        expected = renderer.heard("VERTEX")
        self.assertEqual(len(expected), 6)
        glu.FfdProperty(ffd, glu.FFD_MODE, glu.FFD_RENDERER)
        for mode, count in ((gl.FILL, 6), (gl.LINE, 12), (gl.POINT, 6)):
            glu.FfdProperty(ffd, glu.FFD_DISPLAY_MODE, mode)
            drawn = seen(lambda: model.give(ffd, elements=elements))
            self.assertEqual(len(drawn), count, mode)
            if mode != gl.LINE:
                self.assert_near(drawn.positions, expected, 5e-6)
            self.assertEqual(asked(gl.GetDoublev, gl.POLYGON_MODE, count=2)[0], gl.FILL)
        self.assertEqual(len(renderer.order()), 8, "callbacks while drawing")
        self.assertEqual(renderer.heard("ERROR"), [])
