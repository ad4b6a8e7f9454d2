#pragma once

#include <algorithm>
#include <vector>

#include "climb.hpp"

namespace hwffd::certified {

/// What some terms of a sum in binary32 come to, for some choice of their points.
struct PartialSum {
  float sum = 0;
  double error = 0;  ///< sum - eq. (1) of these terms
  std::array<float, 64> point{};
};

/// Chooses the 64 points of a component so that roundings of one sign add up: at each addition the
/// best few choices of both sides are kept. `F` says what is fused.
template <class F>
class FloatSums {
 public:
  /// @param weight  of each term, in the order of the sum; exact: of eq. (1)
  FloatSums(const std::array<float, 64>& weight, const std::array<double, 64>& exact,
            std::mt19937_64& engine)
      : weight_(weight), exact_(exact), engine_(engine) {}

  PartialSum one_after_the_other() {
    std::vector<PartialSum> best{PartialSum{}};
    for (int i = 0; i < 64; ++i) {
      std::vector<PartialSum> next;
      for (const PartialSum& before : best) {
        for (int choice = 0; choice < kLeaves; ++choice) {
          const float p = draw();
          PartialSum after = before;
          after.point[i] = p;
          after.sum = F::mac(before.sum, weight_[i], p);
          after.error = before.error + rounding(after.sum, before.sum, i, p);
          next.push_back(after);
        }
      }
      best = pruned(next);
    }
    return best.front();
  }

  PartialSum by_pairs() { return tree(0, 64).front(); }

 private:
  static constexpr int kBeamWidth = 12;
  static constexpr int kLeaves = 24;

  /// Near 1, so that sums are large and so are their roundings.
  float draw() { return 1.0F - static_cast<float>(engine_() % 0x40000) * 0x1p-24F; }

  /// What adding term i makes of the error.
  double rounding(float after, float before, int i, float p) const {
    return static_cast<double>(after) - static_cast<double>(before) - exact_[i] * p;
  }

  static std::vector<PartialSum> pruned(std::vector<PartialSum>& all) {
    const auto count = std::min<std::size_t>(all.size(), kBeamWidth);
    std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count), all.end(),
                      [](const auto& a, const auto& b) { return a.error > b.error; });
    all.resize(count);
    return all;
  }

  std::vector<PartialSum> tree(int first, int count) {
    std::vector<PartialSum> all;
    if (count == 2) {
      for (int choice = 0; choice < kLeaves * kBeamWidth; ++choice) {
        PartialSum pair;
        pair.point[first] = draw();
        pair.point[first + 1] = draw();
        const float left = F::term(weight_[first], pair.point[first]);
        pair.sum = F::mac(left, weight_[first + 1], pair.point[first + 1]);
        pair.error = static_cast<double>(pair.sum) - exact_[first] * pair.point[first] -
                     exact_[first + 1] * pair.point[first + 1];
        all.push_back(pair);
      }
      return pruned(all);
    }
    const auto low = tree(first, count / 2);
    const auto high = tree(first + count / 2, count / 2);
    for (const PartialSum& a : low) {
      for (const PartialSum& b : high) {
        PartialSum both = a;
        std::copy_n(b.point.begin() + first + count / 2, count / 2,
                    both.point.begin() + first + count / 2);
        both.sum = F::add(a.sum, b.sum);
        both.error = a.error + b.error +
                     (static_cast<double>(both.sum) - (static_cast<double>(a.sum) + b.sum));
        all.push_back(both);
      }
    }
    return pruned(all);
  }

  const std::array<float, 64>& weight_;
  const std::array<double, 64>& exact_;
  std::mt19937_64& engine_;
};

/// Points for a vertex of B-splines in product form, all three components alike.
template <class F>
PartialSum float_points(const model::CoefficientBank<F>& bank, const Horner<F>& horner,
                        model::VertexWords& vertex, bool tree, std::mt19937_64& engine) {
  std::array<Four, 3> weight{};
  std::array<Four, 3> exact{};
  for (int axis = 0; axis < 3; ++axis) {
    const float x = float_of_bits(vertex.local[axis]);
    for (int l = 0; l < 4; ++l) weight[axis][l] = model::polynomial<F>(bank, 0, l, x);
    exact[axis] = horner.exact(x);
  }
  std::array<float, 64> computed{};
  std::array<double, 64> wanted{};
  std::array<int, 64> local{};
  for (int index = 0; index < 64; ++index) {
    const int l = model::local_of_bank(index >> 4, vertex.cell[0]);
    const int m = model::local_of_bank(index >> 2, vertex.cell[1]);
    const int n = model::local_of_bank(index, vertex.cell[2]);
    local[index] = 16 * l + 4 * m + n;
    computed[index] =
        F::mul(F::mul(static_cast<float>(weight[0][l]), static_cast<float>(weight[1][m])),
               static_cast<float>(weight[2][n]));
    wanted[index] = exact[0][l] * exact[1][m] * exact[2][n];
  }
  FloatSums<F> sums(computed, wanted, engine);
  const PartialSum partial = tree ? sums.by_pairs() : sums.one_after_the_other();
  for (int index = 0; index < 64; ++index) {
    for (int c = 0; c < 3; ++c)
      vertex.points[3 * local[index] + c] = bits_of_float(partial.point[index]);
  }
  return partial;
}

}  // namespace hwffd::certified
