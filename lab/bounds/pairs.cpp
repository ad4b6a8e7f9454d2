#include "pairs.hpp"

#include <algorithm>

#include "hwffd/on_threads.hpp"

namespace hwffd::certified {
namespace {

/// Products of weights are exact in double below 2^53.
class Pairs {
 public:
  Pairs(const std::vector<Candidate>& points, int fraction)
      : unit_(std::ldexp(1, -fraction)), count_(points.size()) {
    for (int l = 0; l < 4; ++l) {
      for (const Candidate& candidate : points) {
        weight_[l].push_back(static_cast<double>(candidate.units[l]));
        exact_[l].push_back(candidate.point.exact[l] / unit_);
      }
    }
  }

  double largest() const {
    constexpr std::size_t kParts = 64;
    std::array<double, kParts> of_part{};
    on_threads(kParts, [&](std::size_t part) {
      for (std::size_t i = part; i < count_; i += kParts) {
        for (std::size_t first = 0; first <= i; first += kBlock) {
          of_part[part] = std::max(of_part[part], block(i, first));
        }
      }
    });
    return *std::max_element(of_part.begin(), of_part.end()) * unit_;
  }

 private:
  static constexpr std::size_t kBlock = 256;

  /// Of point i and those of a block. Loops that compilers make vectors of.
  double block(std::size_t i, std::size_t first) const {
    const std::size_t length = std::min(kBlock, count_ - first);
    std::array<double, kBlock> sum{};
    for (int l = 0; l < 4; ++l) {
      const double w = weight_[l][i] * unit_;
      const double b = exact_[l][i] * unit_;
      for (int m = 0; m < 4; ++m) {
        const double* weight = &weight_[m][first];
        const double* exact = &exact_[m][first];
        for (std::size_t j = 0; j < length; ++j) {
          sum[j] += std::abs(floor_of(w * weight[j] + 0.5) - b * exact[j]);
        }
      }
    }
    return *std::max_element(sum.begin(), sum.end());
  }

  /// std::floor below 2^51, in two additions and a comparison.
  static double floor_of(double value) {
    constexpr double kShift = 0x1.8p52;
    const double nearest = (value + kShift) - kShift;
    return nearest - (nearest > value ? 1.0 : 0.0);
  }

  double unit_;
  std::size_t count_;
  std::array<std::vector<double>, 4> weight_;  // in units
  std::array<std::vector<double>, 4> exact_;
};

}  // namespace

double largest_pair(const std::vector<Candidate>& points, int fraction) {
  return Pairs(points, fraction).largest();
}

}  // namespace hwffd::certified
