#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "mesh/format/content.hpp"
#include "mesh/gltf/accessors.hpp"
#include "mesh/gltf/file.hpp"

namespace hwffd::gltf {

/// How the vertices of a primitive are joined (glTF 2.0, section 3.7.2.1).
enum class Mode {
  kPoints = 0,
  kLines = 1,
  kLineLoop = 2,
  kLineStrip = 3,
  kTriangles = 4,
  kTriangleStrip = 5,
  kTriangleFan = 6,
};

/// A primitive where a node shows it: part of a Content, and where its numbers come from.
struct Part {
  std::size_t node;
  std::size_t mesh;
  std::size_t primitive;
  Mode mode;
  std::size_t first_vertex;
  std::size_t vertices;
  // Accessors.
  std::size_t position;
  std::optional<std::size_t> normal;
  std::optional<std::size_t> tangent;
  std::optional<std::size_t> indices;
};

/// What a file's scene shows.
struct Scene {
  std::vector<Accessor> accessors;
  std::vector<Eigen::Affine3d> worlds;  ///< transform of each node, as far as the scene shows it
  std::vector<bool> is_shown;           ///< of each node
  std::vector<Part> parts;              ///< node after node, as those of the content
};

/// Reads the geometry of the scene that the file shows (its "scene", else the first, else all).
/// Primitives of one node that have all attributes in common share their vertices; each node that
/// shows a mesh gives vertices of its own.
/// @throws Error for nodes that are no tree, accessors that do not fit their use, and more vertices
///   than a file of that size can have without repeating meshes some thousand times
Scene read_scene(const File& file, Content& content);

/// Puts the file's materials and pictures into the content.
void read_materials(const File& file, Content& content);

}  // namespace hwffd::gltf
