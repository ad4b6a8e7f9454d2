"""Two scans of one surface aligned: neither has points of the other, so that each round fits a lattice to
the nearest ones."""
import hwffd
import numpy as np
from scipy.spatial import cKDTree

rng = np.random.default_rng(5)


def scan(count):
    """Points of an egg with ripples, with the noise of a scanner."""
    directions = rng.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    radius = 1 + 0.1 * np.sin(5 * directions[:, :1]) * np.cos(4 * directions[:, 1:2])
    return radius * directions * [1, 1.3, 0.8]


bend = hwffd.Lattice.around("box", [[-1.4] * 3, [1.4] * 3], (5, 5, 5))
bend.deform("bend:15")
first = scan(6000)
second = hwffd.deform(bend, scan(9000)) + rng.normal(0, 2e-3, (9000, 3))
second[:200] = rng.uniform(-2, 2, (200, 3))  # what else the scanner saw

tree = cKDTree(second)
lattice = hwffd.Lattice.around("box", first, (5, 5, 5), padding=0.1)
start, _ = tree.query(first)
for scale in 0.2, 0.1, 0.05, 0.02, 0.02, 0.02:
    _, nearest = tree.query(hwffd.deform(lattice, first))
    hwffd.fit(lattice, first, second[nearest], loss="geman-mcclure", scale=scale, penalty=1e-4, iterations=60)
end, _ = tree.query(hwffd.deform(lattice, first))
assert np.median(end) < 0.5 * np.median(start) and lattice.folds() == "proved"
print(f"distance to the other scan, median: {np.median(start):.4f} before, {np.median(end):.4f} after")
