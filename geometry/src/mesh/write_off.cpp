#include <fmt/format.h>

#include "mesh/format/text.hpp"
#include "mesh/mesh_writers.hpp"
#include "mesh/scene.hpp"

namespace hwffd {

Files write_off(const Output& output) {
  const Points positions = numbered_positions(output);
  std::string faces;
  std::size_t count = 0;
  each_part(output.scene, [&](const aiMesh& part, std::size_t first) {
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      if (face.mNumIndices < 2) continue;
      ++count;
      faces += std::to_string(face.mNumIndices);
      for (unsigned c = 0; c < face.mNumIndices; ++c) {
        faces += fmt::format(" {}", output.numbers[first + face.mIndices[c]]);
      }
      faces += '\n';
    }
  });
  std::string text = fmt::format("OFF\n{} {} 0\n", positions.rows(), count);
  for (Eigen::Index n = 0; n < positions.rows(); ++n) {
    for (int axis = 0; axis < 3; ++axis) {
      append_number(text, positions(n, axis), output.is_single);
      text += axis < 2 ? ' ' : '\n';
    }
  }
  return {{output.path.filename().string(), text + faces}};
}

}  // namespace hwffd
