#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "hwffd/points.hpp"

struct aiScene;

namespace hwffd {

/// A polygon mesh whose vertices can be moved. It keeps the whole scene of the file (faces, texture
/// coordinates, colours, materials, groups) and shows each distinct position once: vertices that
/// a file repeats along smoothing groups or texture seams are welded by exact equality, over all
/// parts of the scene.
///
/// Coordinates are those of the scene with its node transforms applied. A 3ds file is taken as
/// written, y up, without the turn that Assimp puts on its root. Node transforms end as identity
/// and an instanced part becomes one part an instance; animations, bones, morph targets, cameras
/// and lights are dropped, since they do not follow the deformation.
class Mesh {
 public:
  /// Vertex indices of one triangle, counterclockwise seen from outside.
  using Triangle = std::array<std::uint32_t, 3>;

  /// Reads a mesh file in any format that Assimp knows.
  /// @throws Error: file missing, not a mesh, no vertices, a coordinate that is not finite, or a
  ///   face that refers to a vertex that is not there.
  static Mesh load(const std::filesystem::path& path);

  /// A closed model of 3,072 vertices (a tube along a trefoil knot, about 6 units wide) that needs
  /// no file.
  static Mesh procedural();

  Mesh(Mesh&& other) noexcept;
  Mesh& operator=(Mesh&& other) noexcept;
  ~Mesh();

  /// The file's name without its folder, or "procedural".
  const std::string& name() const { return name_; }

  /// Number of welded vertices: rows of positions().
  std::size_t vertex_count() const { return static_cast<std::size_t>(positions_.rows()); }

  /// Number of vertices before welding: distinct combinations of position, normal, texture
  /// coordinates and colour in each part.
  std::size_t vertex_count_read() const { return weld_.size(); }

  /// Welded positions, vertex_count() x 3. Every value is a binary32 number.
  const Points& positions() const { return positions_; }

  /// Moves the vertices, with all their duplicates, and computes anew the normals that the mesh
  /// has: area-weighted means over the faces that shared a normal, so hard edges stay hard.
  /// Values are rounded to binary32. Tangents were dropped on reading.
  /// @param positions vertex_count() x 3
  /// @throws Error if the number of rows differs or a value is not a finite binary32 number; the
  ///   mesh is then unchanged.
  void set_positions(const Points& positions);

  /// Triangles in welded indices. Polygons are fans from their first corner; points and lines
  /// are left out; a triangle that welding made degenerate stays.
  const std::vector<Triangle>& triangles() const { return triangles_; }

  /// Unit normals of the welded vertices, vertex_count() x 3, smooth over all edges, weighted by
  /// area; (0, 1, 0) where the faces give no direction.
  Points smooth_normals() const;

  /// Writes the mesh; the extension chooses the format (obj, ply, stl, glb, gltf, dae). Files that
  /// belong to it (mtl, bin) go beside it. Written whole or not at all, see write_files().
  /// @throws Error for an unknown extension (lists the known ones) or a failed write.
  void save(const std::filesystem::path& path) const;

  /// The scene as it stands now, for a renderer that wants materials or texture coordinates.
  const aiScene& scene() const { return *scene_; }

 private:
  struct SceneDeleter {
    void operator()(aiScene* scene) const;
  };
  using ScenePtr = std::unique_ptr<aiScene, SceneDeleter>;

  Mesh(ScenePtr scene, std::string name);
  void weld();
  void find_triangles();
  void find_normal_classes();
  void update_normals();

  ScenePtr scene_;
  std::string name_;
  Points positions_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> weld_;          ///< scene vertex (parts in order) -> welded vertex
  std::vector<std::uint32_t> normal_class_;  ///< scene vertex -> vertices with the same normal
  std::uint32_t normal_classes_ = 0;
};

/// Resolves the name of a model. A name with a folder, or of a file that is here, is taken as it
/// is; a bare name such as "cat.3ds" is also looked for in the folders given.
/// @param folders where else to look; the default is where the package glmark2-data keeps models
/// @throws Error if there is no such file; it names the folders and the package.
std::filesystem::path find_model(const std::string& name,
                                 const std::vector<std::filesystem::path>& folders = {
                                     "/usr/share/glmark2/models",
                                     "/usr/local/share/glmark2/models"});

}  // namespace hwffd
