"""Two volumes aligned: the moving one is the fixed one, bent, with other noise."""
import hwffd
import numpy as np
from hwffd import volumes

rng = np.random.default_rng(3)
k, j, i = np.indices((52, 60, 68), np.float64)
shells = sum(np.cos(np.hypot(np.hypot(i - a, j - b), k - c) / 2) for a, b, c in rng.uniform(10, 50, (3, 3)))
moving = volumes.Volume(shells.astype(np.float32))

# fixed(x) = moving(T(x)) for a T that is to be found.
place = volumes.Volume(np.zeros((40, 48, 56), np.float32), origin=(6, 6, 6))
truth = volumes.lattice_over(place, (7, 7, 5))
truth.control_points = truth.rest_points + rng.uniform(-5, 5, truth.rest_points.shape)
fixed = volumes.warp(moving, truth, like=place)
fixed.values += rng.normal(0, 0.05, fixed.values.shape).astype(np.float32)

result = hwffd.register(fixed, moving, spacing=14, levels=2, penalty=0.1)


def errors(lattice):
    """Distances in voxels from where the truth takes the voxels, but for a few at the border."""
    field, true_field = (volumes.displacement_field(fixed, one).values for one in (lattice, truth))
    return np.linalg.norm(field - true_field, axis=-1)[5:-5, 5:-5, 5:-5]


before = errors(volumes.lattice_over(fixed))
after = errors(result.lattice)
assert result.folds == "proved" and after.mean() < 0.3 * before.mean()
print(f"displacements are off by {before.mean():.2f} voxels before and {after.mean():.3f} after "
      f"{result.evaluations} evaluations; det J {result.jacobian[0]:.2f} to {result.jacobian[1]:.2f}")
