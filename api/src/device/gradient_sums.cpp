#include "device/gradient_sums.hpp"

#include <cmath>

namespace hwffd {
namespace {

/// The smallest e with which no gradient of at most that magnitude, times 2^-e, is rounded beyond
/// the largest of so many bits.
int gradient_exponent(double largest, int width) {
  int exponent = 0;
  const double fraction = std::frexp(largest, &exponent);
  return fraction > 1 - std::ldexp(1, 1 - width) ? exponent + 1 : exponent;
}

}  // namespace

GradientSums::GradientSums(const std::string& format, int width, const Index3& dims,
                           const Points& gradients)
    : codec_(format),
      width_(width),
      gradients_(gradients),
      exponent_(
          gradient_exponent(gradients.size() == 0 ? 0 : gradients.cwiseAbs().maxCoeff(), width)),
      sums_(static_cast<std::size_t>(dims[0]) * static_cast<std::size_t>(dims[1]) *
            static_cast<std::size_t>(dims[2])) {}

std::array<std::uint32_t, 3> GradientSums::words(std::size_t v) const {
  std::array<std::uint32_t, 3> words;
  for (std::size_t c = 0; c < 3; ++c) {
    const double value = gradients_(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(c));
    words[c] = codec_.point(std::ldexp(value, -exponent_));
  }
  return words;
}

Points GradientSums::result() const {
  Points result(static_cast<Eigen::Index>(sums_.size()), 3);
  for (std::size_t point = 0; point < sums_.size(); ++point) {
    for (std::size_t c = 0; c < 3; ++c) {
      result(static_cast<Eigen::Index>(point), static_cast<Eigen::Index>(c)) =
          std::ldexp(static_cast<double>(sums_[point][c]), exponent_ - (width_ - 1));
    }
  }
  return result;
}

}  // namespace hwffd
