"""Twists points of a sphere in a lattice of its shape."""
import hwffd
import numpy as np

corners = np.array([[-1, -1, -1], [1, 1, 1]], dtype=float)
points = np.array([[0.5, 0.9, 0], [0, 0.9, 0.5], [0.5, -0.9, 0]])

sphere = hwffd.Lattice.around("sphere", corners)
cells, local, residual, inside = sphere.embed(points)
assert inside.all() and residual.max() < 1e-12

sphere.deform("twist:90")
moved = hwffd.deform(sphere, points)
assert np.array_equal(moved, sphere.evaluate(cells, local))
for cell, point in zip(cells, moved):
    print("cell {} {} {}: {:.6f} {:.6f} {:.6f}".format(*cell, *point))
