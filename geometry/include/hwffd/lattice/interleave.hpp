#pragma once

#include <vector>

#include "hwffd/lattice/lattice.hpp"
#include "hwffd/stream/packets.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd {

/// World coordinates to those of the stream and back: stream = (world - centre) / scale.
///
/// The centre is that of the control points' bounding box, so that what is far from the world's
/// origin loses no digits in binary32. Fixed point wants every control point inside [-1, 1) as
/// well: its scale is a power of two. Block floating point takes world coordinates as they are,
/// with the exponent of the largest: it rounds them no more than the results are.
class Normalization {
 public:
  /// Where the stream's origin lies. What was taken away from the points is added to their weighted
  /// sum, so functions that do not sum to 1 want kWorld.
  enum class Origin { kCentre, kWorld };

  /// For control points of a lattice in the format of the codec.
  static Normalization of(const Lattice& lattice, const WordCodec& codec,
                          Origin origin = Origin::kCentre);
  /// For any control points, n x 3.
  static Normalization of(const Points& points, const WordCodec& codec,
                          Origin origin = Origin::kCentre);

  Point to_stream(const Point& world) const { return (world - centre_) / scale_; }
  Point to_world(const Point& stream) const { return stream * scale_ + centre_; }
  /// Of a difference of points, or a derivative.
  Point vector_to_world(const Point& stream) const { return stream * scale_; }
  /// Of the points in the stream, where the format has one for all; else 0.
  int exponent() const { return exponent_; }

 private:
  Point centre_{0, 0, 0};
  double scale_ = 1;
  int exponent_ = 0;
};

/// The exponent of a block: the smallest e such that every finite coordinate, as a binary32 word,
/// is below 2^e in magnitude; 0 where all are 0.
int block_exponent(const Points& points);

/// The power of two that just exceeds the half extent of a lattice: the unit in which errors are
/// reported, the same for every format.
double lattice_scale(const Lattice& lattice);

/// The control points of a lattice as stream words.
LatticeWords lattice_words(const Lattice& lattice, const WordCodec& codec,
                           const Normalization& normalization);

/// Each vertex as stream words; the tag is the index modulo 65536.
std::vector<VertexBeat> vertex_beats(const std::vector<Embedded>& vertices, const WordCodec& codec);

/// A vertex that brings its own control points (paper, fig. 3).
struct SupportedVertex {
  Eigen::Vector3d local{0, 0, 0};  ///< s, t, u
  Support support;
};

/// Each as stream words; the tag is the index modulo 65536.
std::vector<InterleavedVertex> interleave(const std::vector<SupportedVertex>& vertices,
                                          const WordCodec& codec,
                                          const Normalization& normalization);

/// Each vertex with the 64 control points of its cell, as stream words (paper, fig. 3). The tag is
/// the index modulo 65536.
std::vector<InterleavedVertex> interleave(const Lattice& lattice,
                                          const std::vector<Embedded>& vertices,
                                          const WordCodec& codec,
                                          const Normalization& normalization);

/// The three words of a result as the stream's coordinates.
Point point_of(const Beat& result, const WordCodec& codec);

/// The first of each vertex's `each` results as positions in world coordinates, n x 3.
Points positions_of(const std::vector<Beat>& results, const WordCodec& codec,
                    const Normalization& normalization, std::size_t each = 1);

}  // namespace hwffd
