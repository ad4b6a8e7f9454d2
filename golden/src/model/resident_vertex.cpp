#include "hwffd/model/resident_vertex.hpp"

#include "hwffd/model/evaluator.hpp"

namespace hwffd::model {

VertexWords with_support(const ResidentPoints& points, const ResidentVertex& vertex, bool fourth) {
  VertexWords words;
  words.local = vertex.local;
  words.cell = vertex.cell;
  words.exponent = points.exponent;
  const std::uint32_t* corner = points.at(vertex.cell);
  for (int p = 0; p < 64; ++p) {
    const std::uint32_t* point = corner + points.offset({p / 16, p / 4 % 4, p % 4});
    for (int c = 0; c < 3; ++c) words.points[3 * p + c] = point[fourth ? 3 : c];
  }
  return words;
}

}  // namespace hwffd::model
