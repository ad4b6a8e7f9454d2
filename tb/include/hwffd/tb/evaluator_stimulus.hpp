#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hwffd/stream/packets.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd::tb {

/// The 64 control points of a support as stream words, three a point, in local order, n fastest,
/// and their exponent where they share one (bfp32).
struct SupportWords {
  std::array<std::uint32_t, 192> points{};
  int exponent = 0;
};

/// A vertex as an evaluator takes it at its read port.
struct EvaluatorVertex {
  std::array<std::uint32_t, 3> local{};  ///< s, t, u as stream words
  std::array<int, 3> cell{};
  std::uint8_t support = 0;  ///< which of the supports it reads
  int bank = 0;              ///< of the coefficients, 0 or 1
  int derivative = -1;       ///< the axis along which it is differentiated; -1: the position
  bool jacobian = false;     ///< the position and all three in one pass
  std::optional<std::uint32_t> second = {};  ///< s of a second vertex with it
};

/// Supports (at most 256) and vertices that read them.
struct EvaluatorStimulus {
  std::vector<SupportWords> supports;
  std::vector<EvaluatorVertex> vertices;
};

/// Supports with points uniform in [-1, 1) times 2^exponent (0 but in bfp32), vertices in any cell
/// with uniform coordinates, one in ten of them 0 or 1. `together` of them, one after the other,
/// share cell and support.
EvaluatorStimulus random_stimulus(const WordCodec& codec, std::size_t vertices, std::uint64_t seed,
                                  std::size_t together = 1);

/// Vertices on faces, edges and corners that the cells of one random lattice share.
struct SeamStimulus : EvaluatorStimulus {
  std::vector<std::size_t> group;  ///< of each vertex; those of a group are one point

  struct Differences {
    std::size_t values = 0, count = 0;  ///< components compared, and those that differ
  };
  /// How components differ from those of the group's first vertex: `words(v, r)` are the words of
  /// result r of vertex v, which has `each` of them.
  template <class Words>
  Differences differences(std::size_t each, Words words) const {
    Differences result;
    for (std::size_t v = 0, first = 0; v < vertices.size(); ++v) {
      if (group[v] != group[first]) first = v;
      for (std::size_t r = 0; r < each; ++r) {
        for (int c = 0; c < 3; ++c, ++result.values) {
          result.count += words(v, r)[c] != words(first, r)[c] ? 1 : 0;
        }
      }
    }
    return result;
  }
};

/// The vertices, each with the support that it reads and its exponent.
std::vector<InterleavedVertex> interleaved(const EvaluatorStimulus& stimulus);

/// At least `values` components of shared vertices in a lattice of 6 x 6 x 6 cells: coordinate 1 in
/// the lower cell of a shared axis, 0 in the upper one.
SeamStimulus seam_stimulus(const WordCodec& codec, std::size_t values, std::uint64_t seed);

}  // namespace hwffd::tb
