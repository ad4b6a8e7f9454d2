#pragma once

#include <assimp/scene.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hwffd {

/// The vertices of an obj file as it numbers them. Assimp's reader gives each corner of a face a
/// vertex of its own and forgets the numbers, and the vertices that no face uses. So it is given
/// the file with numbers where coordinates were, and the coordinates are put back afterwards.
class ObjVertices {
 public:
  /// @throws Error (without the file's name) for a vertex that is not three numbers
  explicit ObjVertices(const std::string& bytes);

  /// The file for Assimp.
  const std::string& numbered() const { return numbered_; }

  /// Gives the scene that was read from numbered() its coordinates. The vertices of each part come
  /// in the order of the file, and those that no face uses are in the first part.
  /// @return the number in the file of each vertex of the scene
  std::vector<std::uint32_t> restore(aiScene& scene) const;

 private:
  /// The line of a vertex, without its end: takes the coordinates, returns what Assimp gets.
  std::string take(std::string_view line, std::size_t number_of_line);
  void add_unused(aiScene& scene) const;

  std::string numbered_;
  std::vector<aiVector3D> positions_;
};

}  // namespace hwffd
