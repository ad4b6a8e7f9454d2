#include "hwffd/lattice/interleave.hpp"

#include <algorithm>
#include <cmath>

#include "bounds.hpp"

namespace hwffd {
namespace {

/// The power of two that just exceeds the distances of points from a centre along x, y and z.
double scale_of(const Points& points, const Point& centre) {
  const double largest = (points.rowwise() - centre.transpose()).cwiseAbs().maxCoeff();
  int exponent = 0;
  std::frexp(largest, &exponent);  // largest < 2^exponent
  return largest > 0 ? std::ldexp(1.0, exponent) : 1.0;
}

void encode_local(VertexBeat& beat, const Eigen::Vector3d& local, std::size_t index,
                  const WordCodec& codec) {
  beat.tag = static_cast<std::uint16_t>(index);
  for (int axis = 0; axis < 3; ++axis) beat.local[axis] = codec.coordinate(local[axis]);
}

void encode_support(InterleavedVertex& vertex, const Support& support, const WordCodec& codec,
                    const Normalization& normalization) {
  vertex.exponent = normalization.exponent();
  for (int p = 0; p < 64; ++p) {
    const Point point = normalization.to_stream(support.row(p));
    for (int c = 0; c < 3; ++c) vertex.points[3 * p + c] = codec.point(point[c]);
  }
}

}  // namespace

int block_exponent(const Points& points) {
  float largest = 0;
  for (const double value : points.reshaped()) {
    const auto magnitude = std::abs(static_cast<float>(value));
    if (std::isfinite(magnitude)) largest = std::max(largest, magnitude);
  }
  int exponent = 0;
  std::frexp(largest, &exponent);  // largest < 2^exponent
  return exponent;
}

double lattice_scale(const Lattice& lattice) {
  return scale_of(lattice.points(), middle_of(lattice.points()));
}

Normalization Normalization::of(const Lattice& lattice, const WordCodec& codec, Origin origin) {
  return of(lattice.points(), codec, origin);
}

Normalization Normalization::of(const Points& points, const WordCodec& codec, Origin origin) {
  Normalization normalization;
  if (codec.is_block()) {
    normalization.exponent_ = block_exponent(points);
    return normalization;
  }
  if (origin == Origin::kCentre) normalization.centre_ = middle_of(points);
  if (!codec.is_float()) normalization.scale_ = scale_of(points, normalization.centre_);
  return normalization;
}

LatticeWords lattice_words(const Lattice& lattice, const WordCodec& codec,
                           const Normalization& normalization) {
  LatticeWords words{lattice.dims(), {}, normalization.exponent()};
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
    encode_local(beat, vertex.local, beats.size() - 1, codec);
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
    encode_support(out, lattice.support(vertices[v].cell), codec, normalization);
  }
  return stream;
}

std::vector<InterleavedVertex> interleave(const std::vector<SupportedVertex>& vertices,
                                          const WordCodec& codec,
                                          const Normalization& normalization) {
  std::vector<InterleavedVertex> stream;
  stream.reserve(vertices.size());
  for (const SupportedVertex& vertex : vertices) {
    InterleavedVertex& out = stream.emplace_back();
    encode_local(out, vertex.local, stream.size() - 1, codec);
    encode_support(out, vertex.support, codec, normalization);
  }
  return stream;
}

Point point_of(const Beat& result, const WordCodec& codec) {
  return {codec.decode_point(result.words[0]), codec.decode_point(result.words[1]),
          codec.decode_point(result.words[2])};
}

Points positions_of(const std::vector<Beat>& results, const WordCodec& codec,
                    const Normalization& normalization, std::size_t each) {
  Points positions(static_cast<Eigen::Index>(results.size() / each), 3);
  for (Eigen::Index v = 0; v < positions.rows(); ++v) {
    const Beat& result = results[static_cast<std::size_t>(v) * each];
    positions.row(v) = normalization.to_world(point_of(result, codec));
  }
  return positions;
}

}  // namespace hwffd
