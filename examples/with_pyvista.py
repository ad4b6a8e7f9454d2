"""Bends a volume mesh of PyVista, and keeps the growth of volume as data of its points."""
import hwffd
import pyvista

image = pyvista.ImageData(dimensions=(21, 21, 41), spacing=(0.05, 0.05, 0.05))
grid = image.cast_to_structured_grid()
lattice = hwffd.Lattice.around("box", grid.points, (4, 4, 6), family="clamped")
lattice.deform("bend:60:zx")

embedding = lattice.embed(grid.points)
bent = grid.copy()
bent.points = embedding.deform(lattice)
bent.point_data["growth"] = embedding.determinants(lattice)
assert embedding.outside == 0 and lattice.folds() == "proved"

# The growth of volume, integrated over the mesh at rest, is the volume of the bent one.
expected = bent.point_data_to_cell_data()["growth"].sum() * 0.05**3
assert abs(bent.volume - expected) < 0.01 * expected
print(f"{grid.n_cells} cells, volume {grid.volume:.4f} before, {bent.volume:.4f} after")
