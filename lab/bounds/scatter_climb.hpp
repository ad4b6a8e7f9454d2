#pragma once

#include <random>
#include <vector>

#include "climb.hpp"
#include "coordinates.hpp"
#include "hwffd/bounds/axis_error.hpp"
#include "hwffd/model/scatter.hpp"

namespace hwffd::certified {

/// Hill climbing over a vertex and its gradient: the sum of the errors of its 64 parts against the
/// gradient times equation (1), or half its derivative along an axis, as the model rounds them.
/// What saturates does not count.
/// @tparam Parts  how parts are rounded
template <class F, class Parts = model::RoundedParts<F>>
class ScatterClimb {
 public:
  /// @param powers      the weights are those of the evaluator `powers`, else polynomials
  /// @param derivative  the axis along which it is the gradient of the derivative, or -1
  ScatterClimb(bool powers, int derivative) : powers_(powers), derivative_(derivative) {}

  /// From three coordinates with their cells and the largest gradient on, so many steps, and in
  /// between each axis in turn over all candidates.
  Witness run(const Triple& start, const Choices& choices, std::int64_t steps,
              std::mt19937_64& engine) {
    Witness best;
    for (int axis = 0; axis < 3; ++axis) {
      best.vertex.local[axis] = start[axis].point.word;
      best.vertex.cell[axis] = start[axis].cell;
    }
    best.result = FixedPoints::top(1, F::kWeightFraction + 2);
    best.error = error(best);
    for (std::int64_t step = 0; step < steps; ++step) {
      if (step % (steps / kRounds + 1) == 0) {
        for (std::size_t axis = 0; axis < 3; ++axis) over_axis(best, axis, *choices[axis]);
      }
      Witness probe = best;
      const auto axis = static_cast<std::size_t>(engine() % 3);
      switch (engine() % 4) {
        case 0: {
          const Candidate& other = (*choices[axis])[engine() % choices[axis]->size()];
          probe.vertex.local[axis] = other.point.word;
          probe.vertex.cell[axis] = other.cell;
          break;
        }
        case 1:
          probe.vertex.local[axis] = std::min<std::uint32_t>(
              0x80000000U, FixedPoints::moved(probe.vertex.local[axis] >> 1, engine) << 1);
          break;
        case 2:
          probe.vertex.cell[axis] = static_cast<int>(engine() % 4);
          break;
        default:
          probe.result = FixedPoints::moved(probe.result, engine);
      }
      probe.error = error(probe);
      if (probe.error >= best.error) best = probe;
    }
    return best;
  }

  /// The sum of the 64 errors, 0 where something saturates. The gradient is the word `result`.
  double error(const Witness& witness) const {
    using model::LocalVertex;
    LocalVertex<F> vertex;
    vertex.cell = witness.vertex.cell;
    vertex.derivative = derivative_;
    std::array<Four, 3> exact;
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t word = witness.vertex.local[axis];
      vertex.local[axis] = F::coordinate(word);
      const double x = Coordinates<F>::value(word);
      exact[axis] = axis == derivative_ ? half_slopes(x) : bounds::bspline(x);
    }
    const double gradient = std::ldexp(static_cast<std::int32_t>(witness.result), -31);
    const auto cumulative = model::cumulative_of<F>(vertex, bank_, powers_);
    const auto parts = model::scattered<Parts>(cumulative, F::point(witness.result), derivative_);
    double sum = 0;
    for (int index = 0; index < 64; ++index) {
      if (parts[index].saturated) return 0;
      const int l = model::local_of_bank(index >> 4, vertex.cell[0]);
      const int m = model::local_of_bank(index >> 2, vertex.cell[1]);
      const int n = model::local_of_bank(index, vertex.cell[2]);
      const double part =
          std::ldexp(static_cast<double>(parts[index].value), -(F::kWeightFraction + 1));
      sum += std::abs(part - gradient * exact[0][l] * exact[1][m] * exact[2][n]);
    }
    return sum;
  }

 private:
  static constexpr std::int64_t kRounds = 4;

  void over_axis(Witness& best, std::size_t axis, const std::vector<Candidate>& candidates) const {
    Witness probe = best;
    for (const Candidate& candidate : candidates) {
      probe.vertex.local[axis] = candidate.point.word;
      probe.vertex.cell[axis] = candidate.cell;
      probe.error = error(probe);
      if (probe.error > best.error) best = probe;
    }
  }

  model::CoefficientBank<F> bank_ =
      bounds::bspline_bank<F>(bounds::fixed_name(F::kWeightFraction + 2).c_str());
  bool powers_;
  int derivative_;
};

}  // namespace hwffd::certified
