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

LatticeWords lattice_words(const Lattice& lattice, const WordCodec& codec,
                           const Normalization& normalization) {
  LatticeWords words{lattice.dims(), {}};
  words.points.reserve(lattice.points().rows());
  for (Eigen::Index row = 0; row < lattice.points().rows(); ++row) {
    const Point point = normalization.to_stream(lattice.points().row(row));
    words.points.push_back({codec.point(point[0]), codec.point(point[1]), codec.point(point[2])});
  }
  return words;
}

std::vector<VertexBeat> vertex_beats(const std::vector<Embedded>& vertices,
                                     const WordCodec& codec) {
  std::vector<VertexBeat> beats;
  beats.reserve(vertices.size());
  for (const Embedded& vertex : vertices) {
    VertexBeat& beat = beats.emplace_back();
    beat.cell = vertex.cell;
    beat.tag = static_cast<std::uint16_t>(beats.size() - 1);
    for (int axis = 0; axis < 3; ++axis) beat.local[axis] = codec.coordinate(vertex.local[axis]);
  }
  return beats;
}

std::vector<InterleavedVertex> interleave(const Lattice& lattice,
                                          const std::vector<Embedded>& vertices,
                                          const WordCodec& codec,
                                          const Normalization& normalization) {
  std::vector<InterleavedVertex> stream;
  stream.reserve(vertices.size());
  const std::vector<VertexBeat> beats = vertex_beats(vertices, codec);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    InterleavedVertex& out = stream.emplace_back();
    static_cast<VertexBeat&>(out) = beats[v];
    const Support support = lattice.support(vertices[v].cell);
    for (int p = 0; p < 64; ++p) {
      const Point point = normalization.to_stream(support.row(p));
      for (int c = 0; c < 3; ++c) out.points[3 * p + c] = codec.point(point[c]);
    }
  }
  return stream;
}

}  // namespace hwffd
