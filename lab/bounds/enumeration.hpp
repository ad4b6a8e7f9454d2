#pragma once

#include <vector>

#include "axis.hpp"
#include "hwffd/on_threads.hpp"

namespace hwffd::certified {

/// Every coordinate of a format, or one number of `stride`, in so many parts side by side: calls
/// visit(part, AxisPoint) with both ends of what is rounded to the same number.
template <class F, class Weights, class Visit>
void visit_all(const Weights& weights, std::int64_t stride, std::size_t part_count,
               const Visit& visit) {
  using C = Coordinates<F>;
  on_threads(part_count, [&](std::size_t part) {
    const std::int64_t length = (C::kLast - C::kFirst) / stride + 1;
    const auto count = static_cast<std::int64_t>(part_count);
    const std::int64_t from = length * static_cast<std::int64_t>(part) / count;
    const std::int64_t to = length * static_cast<std::int64_t>(part + 1) / count;
    AxisPoint point;
    for (std::int64_t i = from; i < to; ++i) {
      const std::int64_t k = C::kFirst + i * stride;
      point.weight = weights(F::coordinate(C::word(k, 0)));
      for (int end = 0; end < C::kEnds; ++end) {
        point.word = C::word(k, end);
        point.x = C::value(point.word);
        point.exact = weights.exact(point.x);
        visit(part, point);
      }
    }
  });
}

/// What is true of all coordinates that were looked at.
struct AxisFacts {
  double error = 0;                ///< the largest sum_l |w_l - B_l|
  double weight = 0;               ///< the largest |w_l - B_l|
  std::int64_t coordinates = 0;    ///< that were looked at
  std::uint32_t word = 0;          ///< of the largest weight's error
  std::vector<AxisPoint> extreme;  ///< of large errors of either sign, from all of [0, 1]
};

/// Coordinates worth trying: of each piece of [0, 1] the one with the largest sum of magnitudes,
/// the largest and the smallest sum.
class Extremes {
 public:
  void visit(const AxisPoint& point) {
    const auto piece = std::min(static_cast<std::size_t>(point.x * kPieces), kPieces - 1);
    const Four e = point.error();
    const double sum = e[0] + e[1] + e[2] + e[3];
    const double size = norm(e);
    const std::array<double, kKinds> keys{size, size + sum, size - sum, 3 * sum + size,
                                          size - 3 * sum};
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
      Best& best = best_[piece * kKinds + kind];
      if (keys[kind] > best.key) best = {keys[kind], point};
    }
  }
  void take(std::vector<AxisPoint>& points) const {
    for (const Best& best : best_) {
      if (best.key > -1) points.push_back(best.point);
    }
  }

 private:
  static constexpr std::size_t kPieces = 256;
  static constexpr std::size_t kKinds = 5;
  struct Best {
    double key = -1;
    AxisPoint point;
  };
  std::vector<Best> best_ = std::vector<Best>(kPieces * kKinds);
};

/// Which function's weight is what the others leave of the sum; kNone: it is computed as theirs
/// are.
constexpr int kNone = -1;

inline AxisPoint variant(AxisPoint point, int left, double sum) {
  if (left != kNone) point.weight = completed(point.weight, left, sum);
  return point;
}

/// @param lefts  what is looked at of each coordinate, one after the other
/// @param also   gets every point as well, on several threads: also(AxisPoint)
template <class F, class Weights, class Also>
AxisFacts axis_facts(const Weights& weights, std::int64_t stride, const std::vector<int>& lefts,
                     const Also& also) {
  constexpr std::size_t kPartials = 16;
  struct Partial {
    AxisFacts facts;
    Extremes extremes;
  };
  std::vector<Partial> partials(kPartials);
  visit_all<F>(weights, stride, kPartials, [&](std::size_t number, const AxisPoint& plain) {
    Partial& partial = partials[number];
    for (const int left : lefts) {
      const AxisPoint point = variant(plain, left, Weights::kSum);
      const Four e = point.error();
      partial.facts.error = std::max(partial.facts.error, norm(e));
      for (const double of_one : e) {
        if (std::abs(of_one) > partial.facts.weight) {
          partial.facts.weight = std::abs(of_one);
          partial.facts.word = point.word;
        }
      }
      ++partial.facts.coordinates;
      partial.extremes.visit(point);
      also(point);
    }
  });
  AxisFacts all;
  for (const Partial& partial : partials) {
    if (partial.facts.weight > all.weight) {
      all.weight = partial.facts.weight;
      all.word = partial.facts.word;
    }
    all.error = std::max(all.error, partial.facts.error);
    all.coordinates += partial.facts.coordinates;
    partial.extremes.take(all.extreme);
  }
  return all;
}

}  // namespace hwffd::certified
