"""Twists a mesh of trimesh, with its normals, and says what that does to its volume."""
import hwffd
import numpy as np
import trimesh

mesh = trimesh.creation.capsule(height=2, radius=0.5, count=[32, 32])
normals = np.array(mesh.vertex_normals)
lattice = hwffd.Lattice.around("box", mesh.vertices, (4, 6, 4))
lattice.deform("twist:90:z")
lattice.deform("taper:0.5:z")

embedding = lattice.embed(mesh.vertices)
assert embedding.outside == 0 and lattice.folds() == "proved"
moved = trimesh.Trimesh(embedding.deform(lattice), mesh.faces, process=False,
                        vertex_normals=embedding.normals(lattice, normals))
assert moved.is_watertight and len(moved.vertices) == len(mesh.vertices)
agreement = (moved.face_normals * moved.vertex_normals[moved.faces].mean(axis=1)).sum(axis=1)
assert agreement.min() > 0.8
print(f"{len(mesh.vertices)} vertices, volume {mesh.volume:.4f} before, {moved.volume:.4f} after, "
      f"growth at the vertices {embedding.determinants(lattice).min():.3f} to "
      f"{embedding.determinants(lattice).max():.3f}")
