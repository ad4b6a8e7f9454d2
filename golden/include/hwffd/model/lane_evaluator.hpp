#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hwffd/model/configuration.hpp"
#include "hwffd/model/organization.hpp"
#include "hwffd/model/resident_vertex.hpp"
#include "hwffd/numerics/fixed.hpp"

// A function compiled for several kinds of processor, of which the best is taken when the program
// starts; whatever it calls is compiled into it. Sanitizers begin later than that choice.
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define HWFFD_FOR_EACH_PROCESSOR \
  __attribute__((flatten, target_clones("avx512f", "avx2", "default")))
#else
#define HWFFD_FOR_EACH_PROCESSOR
#endif

namespace hwffd::model {

/// The format of `F` in lanes, where there is one. With HWFFD_NO_LANES there is none: results are
/// the same, a vertex at a time.
template <class F>
struct InLanes {
  static constexpr bool kThere = false;
};
#ifndef HWFFD_NO_LANES
template <int W>
struct InLanes<Fixed<W>> {
  static constexpr bool kThere = Fixed<W>::kShort;
  using Format = Fixed<W, Lanes>;
};
#endif

/// A number format and an organization that evaluate eight vertices at once, with the bits of one:
/// it is the same source, with `Lanes` for a number.
///
/// An organization's order depends on a vertex's cell modulo 4, so vertices are taken together
/// whose cells are equal in that.
template <class F, template <class> class Organization>
class LaneEvaluator {
 public:
  using Format = typename InLanes<F>::Format;

  explicit LaneEvaluator(const Configuration& configuration) : organization_(configuration) {}

  CoefficientBank<Format>& bank() { return bank_; }

  /// Positions of vertices of one lattice, or derivatives along an axis, in their order.
  void evaluate(const ResidentPoints& points, const std::vector<ResidentVertex>& vertices,
                int derivative, std::vector<ResultWords>& results) const {
    results.resize(vertices.size());
    std::array<std::vector<std::uint32_t>, 64> of_residue;
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
      const std::array<int, 3>& cell = vertices[v].cell;
      of_residue[(cell[0] & 3) * 16 + (cell[1] & 3) * 4 + (cell[2] & 3)].push_back(v);
    }
    for (const std::vector<std::uint32_t>& some : of_residue) {
      for (std::size_t first = 0; first < some.size(); first += kLanes) {
        const std::size_t count = std::min<std::size_t>(kLanes, some.size() - first);
        eight(points, vertices, &some[first], count, derivative, results);
      }
    }
  }

 private:
  using Words = std::array<Lanes, 3>;

  /// Up to eight vertices, whose numbers are given; the other lanes repeat the first.
  void eight(const ResidentPoints& points, const std::vector<ResidentVertex>& vertices,
             const std::uint32_t* number, std::size_t count, int derivative,
             std::vector<ResultWords>& results) const {
    LocalVertex<Format> local;
    local.cell = vertices[number[0]].cell;
    local.derivative = derivative;
    std::array<const std::uint32_t*, kLanes> corner;
    for (int lane = 0; lane < kLanes; ++lane) {
      const ResidentVertex& vertex =
          vertices[number[static_cast<std::size_t>(lane) < count ? lane : 0]];
      corner[lane] = points.at(vertex.cell);
      for (int axis = 0; axis < 3; ++axis) {
        const typename F::Weight x = F::coordinate(vertex.local[axis]);
        local.local[axis].value[lane] = x.value;
        local.local[axis].saturated[lane] = x.saturated ? -1 : 0;
      }
    }
    alignas(sizeof(Lanes)) Words words;
    alignas(sizeof(Lanes)) Lanes saturated;
    run(points, corner, local, words, saturated);
    for (std::size_t lane = 0; lane < count; ++lane) {
      ResultWords& result = results[number[lane]];
      for (int c = 0; c < 3; ++c) result.words[c] = static_cast<std::uint32_t>(words[c][lane]);
      result.saturated = saturated[lane] != 0;
      result.nan = false;
    }
  }

  HWFFD_FOR_EACH_PROCESSOR void run(const ResidentPoints& points,
                                    const std::array<const std::uint32_t*, kLanes>& corner,
                                    const LocalVertex<Format>& local, Words& words,
                                    Lanes& saturated) const {
    Support<Format> support;
    for (int p = 0; p < 64; ++p) {
      const std::size_t offset = points.offset({p / 16, p / 4 % 4, p % 4});
      for (int c = 0; c < 3; ++c) {
        const auto of = [&](int lane) {
          return std::int64_t{static_cast<std::int32_t>(corner[lane][offset + c])};
        };
        support[p][c] =
            Format::point_of_units(Lanes{of(0), of(1), of(2), of(3), of(4), of(5), of(6), of(7)});
      }
    }
    const VectorSum<Format> sum = organization_.evaluate(local, support, bank_);
    saturated = Lanes{};
    for (int c = 0; c < 3; ++c) {
      const typename Format::Number number = Format::out_units(sum[c]);
      words[c] = number.value;
      saturated |= number.saturated;
    }
  }

  Organization<Format> organization_;
  CoefficientBank<Format> bank_{};
};

}  // namespace hwffd::model
