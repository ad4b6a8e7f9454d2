#pragma once

#include <assimp/material.h>
#include <assimp/texture.h>

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "hwffd/points.hpp"
#include "mesh/space.hpp"

namespace hwffd {

/// A corner has no such value.
inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Values of one kind (normals, texture coordinates, colours) and the corners that refer to them.
template <int N>
struct Values {
  Eigen::Matrix<float, Eigen::Dynamic, N, Eigen::RowMajor> rows;  ///< a row of NaN: no value
  /// Corner -> row, or kNone; empty: the row of a corner is its vertex.
  std::vector<std::uint32_t> of_corner;

  bool empty() const { return rows.rows() == 0; }
  std::uint32_t row_of(std::size_t corner, std::uint32_t vertex) const {
    return of_corner.empty() ? vertex : of_corner[corner];
  }
};

/// Faces of one material, one after the other.
struct ContentPart {
  std::string name;
  std::uint32_t material = 0;
  std::size_t first_face = 0;
  std::size_t faces = 0;
};

/// A named group of parts; the first of all is the root, and parents come before their children.
struct ContentNode {
  std::string name;
  std::uint32_t parent = 0;
  std::vector<std::uint32_t> parts;
};

/// A mesh as its file has it: every vertex once, in the order of the file, in the mesh's own space
/// (node transforms applied). Faces are polygons of three corners or more, lines of two, points of
/// one; strips and polylines are cut.
struct Content {
  Points positions;  ///< a row a vertex of the file
  /// Whether the file's coordinates are binary32: by their type, or in text because binary32 keeps
  /// every digit of each of them. Positions are then exactly such numbers.
  bool is_single = true;
  /// Whether the file numbers its vertices; if not, positions are those of corners that differ.
  bool is_numbered = true;
  std::vector<std::uint32_t> corners;  ///< vertices of all faces, face after face
  std::vector<std::size_t> face_ends;  ///< where the corners of a face end; empty: all have three
  Values<3> normals;
  std::vector<Values<3>> textures;      ///< sets of texture coordinates, v upwards
  std::vector<unsigned> texture_sizes;  ///< numbers in use in each set, 1 to 3
  std::vector<Values<4>> colours;       ///< sets, red, green, blue, alpha, 0 to 1
  Eigen::Matrix<float, Eigen::Dynamic, 4, Eigen::RowMajor> tangents;  ///< of vertices, or none
  std::vector<ContentPart> parts;  ///< of all faces, in order; at least one
  /// Vertex -> part that holds it where no face uses it; empty: the first.
  std::vector<std::uint32_t> homes;
  std::vector<ContentNode> nodes;
  std::vector<std::unique_ptr<aiMaterial>> materials;  ///< at least one
  std::vector<std::unique_ptr<aiTexture>> pictures;    ///< named *0, *1 by materials
  Space space;                                         ///< of positions
  /// What the file has and the fields above do not: "property quality of vertex".
  std::vector<std::string> extras;
  /// What acts on vertices and does not follow them, and stays where the file is edited: "1 skin".
  std::vector<std::string> unfollowed;

  std::size_t vertex_count() const { return static_cast<std::size_t>(positions.rows()); }
  std::size_t face_count() const {
    return face_ends.empty() ? corners.size() / 3 : face_ends.size();
  }
  std::size_t face_begin(std::size_t face) const {
    if (face_ends.empty()) return 3 * face;
    return face == 0 ? 0 : face_ends[face - 1];
  }
  /// Ends a face whose corners, from this one on, have been added.
  void end_face(std::size_t begin) {
    constexpr std::size_t kTriangle = 3;
    if (face_ends.empty() && corners.size() == begin + kTriangle) return;
    if (face_ends.empty()) {
      for (std::size_t end = kTriangle; end <= begin; end += kTriangle) face_ends.push_back(end);
    }
    face_ends.push_back(corners.size());
  }
  std::size_t face_end(std::size_t face) const { return face_begin(face + 1); }
};

}  // namespace hwffd
