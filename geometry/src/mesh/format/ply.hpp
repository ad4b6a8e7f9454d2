#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh/format/document.hpp"
#include "mesh/format/ply_header.hpp"

namespace hwffd {

/// What each property of the element vertex is.
class PlyVertex {
 public:
  /// Numbers of a vertex, in the order in which row() has them.
  enum Place : std::size_t { kPosition = 0, kNormal = 3, kTexture = 6, kColour = 8, kPlaces = 12 };
  static constexpr std::size_t kUnknown = kPlaces;

  explicit PlyVertex(const PlyElement& element);

  /// The place of each property, or kUnknown.
  const std::vector<std::size_t>& places() const { return places_; }
  /// The type of what stands in a place; its size is 0 if nothing does.
  const PlyType& type(std::size_t place) const { return types_[place]; }
  /// Whether all of so many places are there.
  bool has(std::size_t first, std::size_t count) const;

 private:
  std::vector<std::size_t> places_;
  std::array<PlyType, kPlaces> types_;
};

/// Of a face or a strip: the numbers of its vertices.
bool is_ply_corners(const PlyProperty& property);

/// Of a face: texture coordinates, two a corner.
bool is_ply_textures(const PlyProperty& property);

/// What the file holds.
/// @throws Error, without the file's name, for what is no such file
void read_ply_content(const std::string& bytes, const PlyHeader& header, Content& content);

/// The file with what changed.
std::string edit_ply(const std::string& bytes, const PlyHeader& header, const Edit& edit);

}  // namespace hwffd
