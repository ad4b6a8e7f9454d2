"""Moves control points until points come to lie on targets: SciPy's least squares, with the weights
of the control points as its Jacobian."""
import hwffd
import numpy as np
from scipy.optimize import least_squares
from scipy.sparse import csr_matrix, identity, kron, vstack

rng = np.random.default_rng(7)
points = rng.uniform(-1, 1, (300, 3))
lattice = hwffd.Lattice.around("box", points, (5, 5, 5))
lattice.set_device("reference")

# What is to be found: a bend, seen at the points with a little noise.
seen = hwffd.Lattice.of(lattice.rest_points)
seen.set_device("reference")
seen.deform("bend:40")
targets = hwffd.deform(seen, points) + rng.normal(0, 1e-3, points.shape)

embedding = lattice.embed(points)
stiffness = 1e-3  # pulls control points that few points see towards their rest
jacobian = csr_matrix(vstack([kron(embedding.weights(), identity(3)),
                              stiffness * identity(lattice.rest.size)]))


def residuals(control):
    lattice.control_points = control.reshape(lattice.control_points.shape)
    misses = embedding.deform(lattice) - targets
    return np.concatenate([misses.ravel(), stiffness * (control - lattice.rest.ravel())])


before = residuals(lattice.rest.ravel())
fit = least_squares(residuals, lattice.rest.ravel(), jac=lambda _: jacobian,
                    tr_options={"atol": 1e-12, "btol": 1e-12})
misses = np.linalg.norm(embedding.deform(lattice) - targets, axis=1)
assert fit.success and misses.max() < 0.02
print(f"mean distance {np.linalg.norm(before[:points.size].reshape(-1, 3), axis=1).mean():.3f} "
      f"before, {misses.mean():.4f} after {fit.nfev} evaluations")
