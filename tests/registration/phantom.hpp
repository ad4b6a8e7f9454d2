#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "hwffd/lattice/lattice.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "hwffd/registration/volume.hpp"

namespace hwffd {

/// Two images of n voxels an axis, or of one along k: the moving one is a smooth pattern, the fixed
/// one that pattern at T(x), without noise.
class Phantom {
 public:
  using Place = std::array<double, 3>;

  /// @param voxels  that T moves points by at most, along each axis
  Phantom(const Index3& counts, double voxels, const AffineMap& to_point = {})
      : counts_(counts), voxels_(voxels), to_point_(to_point) {}

  /// Indices of the moving image from those of the fixed one.
  Place map(const Place& x) const {
    const auto wave = [&](std::size_t a, std::size_t b, double phase) {
      const double at_a = (x[a] + 0.5) / counts_[a];
      const double at_b = (x[b] + 0.5) / counts_[b];
      return voxels_ * std::sin(3.5 * at_a + phase) * std::cos(1.5 * at_b);
    };
    Place result = x;
    result[0] += wave(1, 2, 0.5);
    result[1] += wave(0, 2, 1.0);
    if (counts_[2] > 1) result[2] += wave(0, 1, 0.0);
    return result;
  }

  Volume moving() const {
    return volume("moving image", [](const Place& x) { return pattern(x); });
  }
  Volume fixed() const {
    return volume("fixed image", [&](const Place& x) { return pattern(map(x)); });
  }
  /// The fixed image with other values for the same content.
  Volume fixed_of_another_kind() const {
    return volume("fixed image", [&](const Place& x) {
      const double v = pattern(map(x));
      return 500 - 3 * v + 40 * std::sin(v / 30);
    });
  }

  /// The mean distance in voxels between where a lattice and where T takes voxels, of those at
  /// least `margin` voxels inside.
  double error(const Lattice& deformed, int margin) const {
    const AffineMap to_index = to_point_.inverse();
    const Oracle oracle;
    double sum = 0.0;
    int count = 0;
    const auto at_least = [&](std::size_t a) { return counts_[a] > 1 ? margin : 0; };
    for (int k = at_least(2); k < counts_[2] - at_least(2); ++k) {
      for (int j = at_least(1); j < counts_[1] - at_least(1); ++j) {
        for (int i = at_least(0); i < counts_[0] - at_least(0); ++i) {
          const Place voxel{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
          Index3 cell{};
          Eigen::Vector3d local;
          for (std::size_t a = 0; a < 3; ++a) {
            const int cells = deformed.dims()[a] - 3;
            const double x = (voxel[a] + 0.5) * cells / counts_[a];
            cell[a] = std::min(static_cast<int>(x), cells - 1);
            local[static_cast<int>(a)] = x - cell[a];
          }
          const Eigen::Vector3d at =
              oracle.evaluate(deformed.support(cell), local[0], local[1], local[2]);
          const Place got = to_index({at[0], at[1], at[2]});
          const Place wanted = map(voxel);
          double square = 0.0;
          for (std::size_t a = 0; a < 3; ++a) square += (got[a] - wanted[a]) * (got[a] - wanted[a]);
          sum += std::sqrt(square);
          ++count;
        }
      }
    }
    return sum / count;
  }

 private:
  static double pattern(const Place& x) {
    return 100 + 40 * std::sin(0.45 * x[0] + 0.2 * x[1]) * std::cos(0.3 * x[2]) +
           35 * std::sin(0.4 * x[1] - 0.25 * x[2] + 1) + 25 * std::cos(0.37 * x[2] + 0.31 * x[0]) +
           30 * std::sin(0.23 * x[0] - 0.34 * x[1] + 2);
  }

  template <class Value>
  Volume volume(const char* name, const Value& value) const {
    std::vector<float> values;
    for (int k = 0; k < counts_[2]; ++k) {
      for (int j = 0; j < counts_[1]; ++j) {
        for (int i = 0; i < counts_[0]; ++i) {
          values.push_back(static_cast<float>(
              value({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)})));
        }
      }
    }
    return {name, counts_, std::move(values), to_point_};
  }

  Index3 counts_;
  double voxels_;
  AffineMap to_point_;
};

}  // namespace hwffd
