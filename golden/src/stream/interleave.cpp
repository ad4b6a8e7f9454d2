#include "hwffd/stream/interleave.hpp"

#include <cmath>

namespace hwffd {
namespace {

Point centre_of(const Lattice& lattice) {
  const Point low = lattice.points().colwise().minCoeff();
  const Point high = lattice.points().colwise().maxCoeff();
  return (low + high) / 2;
}

}  // namespace

double lattice_scale(const Lattice& lattice) {
  const Points offset = lattice.points().rowwise() - centre_of(lattice).transpose();
  const double largest = offset.cwiseAbs().maxCoeff();
  int exponent = 0;
  std::frexp(largest, &exponent);  // largest < 2^exponent
  return largest > 0 ? std::ldexp(1.0, exponent) : 1.0;
}

Normalization Normalization::of(const Lattice& lattice, const WordCodec& codec) {
  Normalization normalization;
  if (codec.is_float()) return normalization;
  normalization.centre_ = centre_of(lattice);
  normalization.scale_ = lattice_scale(lattice);
  return normalization;
}

std::vector<InterleavedVertex> interleave(const Lattice& lattice,
                                          const std::vector<Embedded>& vertices,
                                          const WordCodec& codec,
                                          const Normalization& normalization) {
  std::vector<InterleavedVertex> stream;
  stream.reserve(vertices.size());
  for (const Embedded& vertex : vertices) {
    InterleavedVertex& out = stream.emplace_back();
    out.cell = vertex.cell;
    out.tag = static_cast<std::uint16_t>(stream.size() - 1);
    for (int axis = 0; axis < 3; ++axis) out.local[axis] = codec.coordinate(vertex.local[axis]);
    const Support support = lattice.support(vertex.cell);
    for (int p = 0; p < 64; ++p) {
      const Point point = normalization.to_stream(support.row(p));
      for (int c = 0; c < 3; ++c) out.points[3 * p + c] = codec.point(point[c]);
    }
  }
  return stream;
}

}  // namespace hwffd
