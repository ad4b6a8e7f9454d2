// Registrations of two small volumes by each metric, and the bits of their lattices, for builds to
// be compared. It calls no libm, whose functions have other bits elsewhere.

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

#include "hwffd/registration/registration.hpp"

namespace {

using namespace hwffd;

constexpr int kSize = 24;

/// Bumps (1 - r^2)^2 at places drawn at random, moved by a smooth shift.
Volume bumps(const char* name, double shift) {
  std::vector<float> values;
  for (int k = 0; k < kSize; ++k) {
    for (int j = 0; j < kSize; ++j) {
      for (int i = 0; i < kSize; ++i) {
        std::uint32_t state = 12345;
        const auto draw = [&state] {
          state = state * 1664525U + 1013904223U;
          return (state >> 8) / 16777216.0;
        };
        double value = 0.0;
        for (int bump = 0; bump < 12; ++bump) {
          const double x = i + shift * (j - 12) / 12.0 - kSize * draw();
          const double y = j + shift * (k - 12) / 12.0 - kSize * draw();
          const double z = k - shift * (i - 12) / 12.0 - kSize * draw();
          const double radius = 5.0 + 4.0 * draw();
          const double rest = 1.0 - (x * x + y * y + z * z) / (radius * radius);
          if (rest > 0.0) value += rest * rest;
        }
        values.push_back(static_cast<float>(value));
      }
    }
  }
  return Volume(name, {kSize, kSize, kSize}, std::move(values), AffineMap{});
}

}  // namespace

int main() {
  const Volume fixed = bumps("fixed", 0.0);
  const Volume moving = bumps("moving", 1.0);
  for (const std::string& metric : metric_names()) {
    RegistrationOptions options;
    options.spacing = {8, 8, 8};
    options.levels = 2;
    options.metric = parse_metric(metric);
    options.bending_weight = 0.01;
    options.no_folds = true;
    options.iterations = 12;
    const RegistrationResult result = register_volumes(fixed, moving, options);
    std::printf("%s %d %a %a\n", metric.c_str(), static_cast<int>(result.evaluations),
                result.metric_start, result.metric_end);
    const Points& points = result.deformed.points();
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
      for (Eigen::Index c = 0; c < 3; ++c) {
        std::uint64_t bits = 0;
        const double number = points(row, c);
        std::memcpy(&bits, &number, sizeof bits);
        std::printf("%016llx\n", static_cast<unsigned long long>(bits));
      }
    }
  }
  return 0;
}
