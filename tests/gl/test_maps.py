"""glMap3 and glEvalCoord3: values against eq. (1), and state; glMapGrid3, glEvalPoint3,
glEvalMesh3.

SPDX-License-Identifier: Apache-2.0
"""

import threading

import numpy as np
from opengl import Context, asked, error_of, gl, seen
from scene import BSPLINE, CATMULL_ROM, CORNERS, HERMITE, UNIT, GlTest, RandomMap, bernstein
from scene import define_cube, draw, eq1

DEVICES = {"reference": 2e-6, "model": 2e-6, "model:tree4:fp32": 2e-6, "rtl:basic:fp32": 2e-6,
           "model:basic:fx18": 5e-4, "rtl:basic:fx18": 5e-4}
LINEAR = np.array([[1, -1], [0, 1]], np.float32)
QUADRATIC = np.array([[0.5, -1, 0.5], [0.5, 1, -1], [0, 0, 0.5]], np.float32)
MAPS = range(gl.MAP3_COLOR_4, gl.MAP3_VERTEX_4 + 1)
INITIAL = ([1, 1, 1, 1], [1], [0, 0, 1], [0], [0, 0], [0, 0, 0], [0, 0, 0, 1], [0, 0, 0],
           [0, 0, 0, 1])
MOST, LEAST = 2**31 - 1, -2**31


def seen_at(places):
    return seen(lambda: draw(gl.POINTS, gl.EvalCoord3d, places))


class Map(GlTest):
    def expect_values(self, counts, functions, domain=UNIT, devices=None, count=20, times=1):
        """A random map's, at its corners and elsewhere, on each device."""
        given = RandomMap(self.random, counts, 3)
        given.define(gl.MAP3_VERTEX_3, domain)
        gl.EnableMap3(gl.MAP3_VERTEX_3)
        at = np.vstack([[0, 0, 0], [1, 1, 1], [0, 1, 0.5], self.random.random((count - 3, 3))])
        first, last = np.transpose(domain)
        expected = [eq1(given.points, functions, position) for position in at]
        for device, tolerance in (devices or DEVICES).items():
            gl.FfdDevice(device.encode())
            self.assert_near(seen_at(first + at * (last - first)).positions, expected,
                             times * tolerance, f"{device} {counts}")

    def test_bezier_volumes_of_every_order_in_every_domain(self):
        for counts in ((1, 2, 3), (4, 3, 2), (2, 1, 4), (4, 4, 4)):
            self.expect_values(counts, [bernstein(n - 1) for n in counts],
                               ((2, -1), (0.5, 4), (10, 10.25)), count=10)  # u runs backwards

    def test_blending_functions_of_their_own_along_each_axis(self):
        # Weights of Hermite functions do not sum to 1; small tangents keep the sum in view.
        functions = (BSPLINE, HERMITE * [[1], [0.25], [1], [0.25]], CATMULL_ROM)
        for axis, matrix in enumerate(functions):
            gl.BlendCoefficientd(gl.MAP3_U + axis, 3, matrix)
        self.expect_values((6, 4, 5), functions, times=2)

    def test_blending_functions_of_low_degree_have_more_cells(self):
        functions = (LINEAR, QUADRATIC, np.ones((1, 1), np.float32))
        for axis, matrix in enumerate(functions):
            gl.BlendCoefficientf(gl.MAP3_U + axis, len(matrix) - 1, matrix)
        self.expect_values((14, 9, 13), functions, devices={"model": 2e-6})

    def test_coordinates_beyond_the_domain_are_clamped(self):
        RandomMap(self.random, (3, 3, 3), 3).define(gl.MAP3_VERTEX_3)
        gl.EnableMap3(gl.MAP3_VERTEX_3)
        for device in (b"model", b"reference"):
            gl.FfdDevice(device)
            low, beyond, none, far, high = seen_at(
                [(0, 0.5, 1), (-3, 0.5, 9), (np.nan, 0.5, 1), (np.inf, 0.5, 1), (1, 0.5, 1)]
            ).positions.tolist()
            self.assertEqual((beyond, none, far), (low, low, high), device)

    def test_every_target_issues_its_attribute_before_the_vertex(self):
        at = (0.25, 0.5, 0.75)

        def define(target, components):
            given = RandomMap(self.random, (2, 3, 4), components, low=0.05)
            if target == gl.MAP3_VERTEX_4:
                given.points[..., 3] += 1  # the quotient stays in view
            given.define(target)
            gl.EnableMap3(target)
            return eq1(given.points, [bernstein(degree) for degree in (1, 2, 3)], at)

        gl.Enable(gl.TEXTURE_2D)
        vertex = define(gl.MAP3_VERTEX_4, 4)
        define(gl.MAP3_VERTEX_3, 3)  # VERTEX_4 has precedence
        color, index, normal = (define(gl.MAP3_COLOR_4, 4), define(gl.MAP3_INDEX, 1),
                                define(gl.MAP3_NORMAL, 3))
        for size in range(1, 5):
            texture = np.array([0., 0, 0, 1])
            texture[:size] = define(gl.MAP3_TEXTURE_COORD_1 + size - 1, size)
            got = seen_at([at])
            self.assert_near(got.positions, [vertex[:3] / vertex[3]], 1e-5)
            self.assert_near(got.colors, [color], 1e-5)
            self.assert_near(got.textures, [texture], 1e-5, f"{size}")
        for name, expected in ((gl.CURRENT_NORMAL, normal), (gl.CURRENT_INDEX, index)):
            self.assert_near(asked(gl.GetDoublev, name, count=len(expected)), expected, 1e-5)

    def test_queries_give_back_what_was_given(self):
        domain = ((-2, 3.6), (4, 1), (0, 8))
        given = RandomMap(self.random, (2, 4, 3), 4)
        given.define(gl.MAP3_COLOR_4, domain)
        gl.Map3f(gl.MAP3_VERTEX_4, -2, 3.6, 48, 2, 4, 1, 12, 4, 0, 8, 4, 3,
                 np.ascontiguousarray(given.points, np.float32))
        # What is given or asked for in floats comes back rounded to these.
        for target, command, element, exact in (
                (gl.MAP3_COLOR_4, gl.GetMap3dv, np.float64, True),
                (gl.MAP3_COLOR_4, gl.GetMap3fv, np.float32, False),
                (gl.MAP3_VERTEX_4, gl.GetMap3dv, np.float64, False)):
            tolerance = 0 if exact else 2e-7
            for query, expected in ((gl.ORDER, [2, 4, 3]), (gl.DOMAIN, np.ravel(domain)),
                                    (gl.COEFF, given.points.ravel())):
                got = asked(command, target, query, count=len(expected), element=element)
                self.assert_near(got, expected, tolerance)
        for query, expected in ((gl.DOMAIN, [-2, 4, 4, 1, 0, 8]),
                                (gl.COEFF, np.round(given.points).ravel())):
            got = asked(gl.GetMap3iv, gl.MAP3_COLOR_4, query, count=len(expected),
                        element=np.int32)
            self.assertEqual(got, list(expected))

    def test_failed_commands_leave_their_state_alone(self):
        RandomMap(self.random, (2, 2, 2), 3).define(gl.MAP3_VERTEX_3, ((0, 1), (0, 1), (0, 2)))
        for call in ((gl.Map3d, gl.MAP3_VERTEX_3, 3, 4, 3, 1, 3, 4, 3, 1, 3, 3, 3, 1, [5, 5, 5]),
                     (gl.MapGrid3d, 5, 0, 9, 5, 0, 9, 0, 0, 9),
                     (gl.BlendCoefficientd, gl.MAP3_U, 7, [5, 5, 5])):
            self.assertNotEqual(error_of(*call), gl.NO_ERROR)
        self.assertEqual(asked(gl.GetMap3dv, gl.MAP3_VERTEX_3, gl.ORDER, count=3), [2, 2, 2])
        self.assertEqual(asked(gl.GetMap3dv, gl.MAP3_VERTEX_3, gl.DOMAIN, count=6)[5], 2)
        self.assertEqual(asked(gl.GetEval3dv, gl.MAP3_GRID_SEGMENTS, count=3), [1, 1, 1])
        self.assertEqual(asked(gl.GetBlendCoefficientdv, gl.MAP3_U, gl.ORDER, count=1), [0])

    def test_errors_are_raised_at_once_while_a_display_list_is_made(self):
        number = gl.GenLists(1)
        self.addCleanup(gl.DeleteLists, number, 1)
        for error, *call in ((gl.INVALID_VALUE, gl.MapGrid3d, 0, 0, 1, 1, 0, 1, 1, 0, 1),
                             (gl.INVALID_ENUM, gl.EnableMap3, gl.S),
                             (gl.INVALID_OPERATION, gl.EvalCoord3d, np.nan, np.inf, 0)):
            define_cube()
            if error == gl.INVALID_OPERATION:
                gl.BlendCoefficientd(gl.MAP3_U, 3, BSPLINE)  # of more points than the cube has
            gl.NewList(number, gl.COMPILE)
            raised = error_of(*call)
            gl.EndList()
            self.assertEqual((raised, error_of(gl.CallList, number)), (error, gl.NO_ERROR))

    def test_blending_functions_are_given_back_floats_of_the_bspline_as_the_bspline(self):
        gl.BlendCoefficientf(gl.MAP3_U, 1, LINEAR)
        gl.BlendCoefficientf(gl.MAP3_V, 3, BSPLINE.astype(np.float32))
        for axis, matrix in ((gl.MAP3_U, LINEAR), (gl.MAP3_V, BSPLINE)):
            self.assertEqual(asked(gl.GetBlendCoefficientdv, axis, gl.ORDER, count=1),
                             [len(matrix)])
            self.assertEqual(asked(gl.GetBlendCoefficientdv, axis, gl.COEFF, count=matrix.size),
                             matrix.ravel().tolist())

    def test_initial_state_is_that_of_opengl(self):
        states = []

        def ask():
            context = Context()
            for number, target in enumerate(MAPS):
                count = len(INITIAL[number])
                states.append((asked(gl.GetMap3dv, target, gl.COEFF, count=count),
                               asked(gl.GetMapdv, gl.MAP2_COLOR_4 + number, gl.COEFF, count=count),
                               gl.IsEnabledMap3(target)))
            states.append((gl.IsEnabledMap3(gl.AUTO_NORMAL),
                           asked(gl.GetEval3dv, gl.MAX_EVAL3_ORDER, count=1)))
            context.close()

        # A new thread has a state of its own, and no context until it makes one current.
        thread = threading.Thread(target=ask)
        thread.start()
        thread.join()
        self.assertEqual(states, [*((points, points, 0) for points in INITIAL), (0, [16])])


class Mesh3(GlTest):
    def setUp(self):
        super().setUp()
        define_cube()
        gl.MapGrid3d(4, 0, 1, 2, 1, 0, 5, 0, 0.5)

    def expect_points(self, mode, ends, numbers):
        """What a mesh draws: grid points by their numbers."""
        self.assert_near(seen(lambda: gl.EvalMesh3(mode, *ends)).positions,
                         np.array(numbers).reshape(-1, 3) * [1 / 4, -1 / 2, 1 / 10] + [0, 1, 0],
                         1e-6)

    def test_points_run_along_u_then_v_then_w(self):
        self.expect_points(gl.POINT, (1, 4, 0, 1, 2, 5), [
            (i, j, k) for k in range(2, 6) for j in range(2) for i in range(1, 5)])

    def test_lines_run_along_each_axis(self):
        us, vs, ws = range(1, 5), range(3), range(1, 4)
        lines = [[(i, j, k) for i in us] for k in ws for j in vs]
        lines += [[(i, j, k) for j in vs] for k in ws for i in us]
        lines += [[(i, j, k) for k in ws] for j in vs for i in us]
        self.expect_points(gl.LINE, (1, 4, 0, 2, 1, 3), [
            point for line in lines for segment in zip(line, line[1:]) for point in segment])

    def test_a_restart_of_primitives_takes_no_vertex(self):
        gl.PrimitiveRestartIndex(1)
        gl.Enable(gl.PRIMITIVE_RESTART)
        try:
            self.test_points_run_along_u_then_v_then_w()
            self.test_lines_run_along_each_axis()
            self.assertTrue(gl.IsEnabled(gl.PRIMITIVE_RESTART))
        finally:
            gl.Disable(gl.PRIMITIVE_RESTART)

    def test_coordinates_of_every_type(self):
        a, b = (0.25, 0.5, 0.75), (0.125, 0.625, 0.375)
        calls = [(gl.EvalCoord3f, *a), (gl.EvalCoord3fv, a), (gl.EvalCoord3d, *b),
                 (gl.EvalCoord3dv, b)]
        got = seen(lambda: draw(gl.POINTS, lambda command, *at: command(*at), calls))
        self.assert_near(got.positions, [a, a, b, b], 1e-6)

    def test_eval_point_hits_the_last_point_exactly(self):
        # A domain about the end of the grid and so narrow that its neighbours in double lie apart.
        last = 0.7
        near = (last - 1e-15, last + 1e-15)
        gl.Map3d(gl.MAP3_VERTEX_3, *near, 12, 2, *near, 6, 2, *near, 3, 2, CORNERS)
        for segments in range(1, 100):
            gl.MapGrid3d(segments, 0.1, last, segments, 0.2, last, segments, 0.3, last)
            got = seen(lambda count=segments: draw(gl.POINTS, gl.EvalPoint3, [(count,) * 3]))
            self.assert_near(got.positions, seen_at([(last,) * 3]).positions, 0, f"{segments}")

    def test_grid_can_be_asked_for(self):
        self.assertEqual(asked(gl.GetEval3dv, gl.MAP3_GRID_DOMAIN, count=6), [0, 1, 1, 0, 0, 0.5])
        self.assertEqual(asked(gl.GetEval3dv, gl.MAP3_GRID_SEGMENTS, count=3), [4, 2, 5])

    def test_numbers_up_to_the_largest(self):
        for mode in (gl.POINT, gl.LINE):
            for ends, error in (((MOST,) * 6, gl.NO_ERROR),
                                ((MOST - 2, MOST, 0, 1, LEAST, LEAST + 1), gl.NO_ERROR),
                                ((0, MOST) * 3, gl.INVALID_OPERATION),
                                ((LEAST, MOST) * 3, gl.INVALID_OPERATION),
                                ((LEAST, MOST, 0, 0, 0, 0), gl.INVALID_OPERATION)):
                self.assertEqual(error_of(gl.EvalMesh3, mode, *ends), error, (mode, ends))

    def test_maps_are_switched_on_and_off(self):
        self.assertTrue(gl.IsEnabledMap3(gl.MAP3_VERTEX_3))
        gl.DisableMap3(gl.MAP3_VERTEX_3)
        self.assertFalse(gl.IsEnabledMap3(gl.MAP3_VERTEX_3))
        self.expect_points(gl.POINT, (0, 1, 0, 1, 0, 1), [])
        gl.EnableMap3(gl.AUTO_NORMAL)
        self.assertTrue(gl.IsEnabledMap3(gl.AUTO_NORMAL))
