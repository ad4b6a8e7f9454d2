#include "hwffd/registration/volume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hwffd/error.hpp"

namespace hwffd {
namespace {

/// The determinant of the 2 x 2 matrix that is left without a row and a column, with its sign.
double cofactor(const std::array<std::array<double, 3>, 3>& m, std::size_t row,
                std::size_t column) {
  const std::size_t r = (row + 1) % 3;
  const std::size_t s = (row + 2) % 3;
  const std::size_t c = (column + 1) % 3;
  const std::size_t d = (column + 2) % 3;
  return m[r][c] * m[s][d] - m[r][d] * m[s][c];
}

template <class Number>
std::shared_ptr<const Number[]> shared(std::vector<Number> numbers) {
  if (numbers.empty()) return nullptr;
  const auto owner = std::make_shared<std::vector<Number>>(std::move(numbers));
  return {owner, owner->data()};
}

void check_length(const std::string& what, std::size_t length, std::size_t wanted) {
  if (length == wanted) return;
  throw Error(
      fmt::format("{}: {} numbers; give one for each of its {} voxels", what, length, wanted));
}

std::size_t product(const Index3& counts) {
  std::size_t size = 1;
  for (const int n : counts) size *= static_cast<std::size_t>(std::max(n, 0));
  return size;
}

}  // namespace

AffineMap AffineMap::of(const Eigen::Matrix4d& matrix) {
  for (int i = 0; i < 16; ++i) {
    if (!std::isfinite(matrix(i / 4, i % 4))) {
      throw Error("affine map: a number that is not finite; give a matrix of 4 x 4 numbers");
    }
  }
  if (matrix(3, 0) != 0.0 || matrix(3, 1) != 0.0 || matrix(3, 2) != 0.0 || matrix(3, 3) != 1.0) {
    throw Error("affine map: the last row of the matrix is not 0 0 0 1; give one that is affine");
  }
  AffineMap result;
  for (std::size_t row = 0; row < 3; ++row) {
    const auto r = static_cast<int>(row);
    result.linear[row] = {matrix(r, 0), matrix(r, 1), matrix(r, 2)};
    result.offset[row] = matrix(r, 3);
  }
  return result;
}

std::array<double, 3> AffineMap::operator()(const std::array<double, 3>& x) const {
  std::array<double, 3> result{};
  for (std::size_t row = 0; row < 3; ++row) {
    result[row] =
        linear[row][0] * x[0] + linear[row][1] * x[1] + linear[row][2] * x[2] + offset[row];
  }
  return result;
}

double AffineMap::determinant() const {
  return linear[0][0] * cofactor(linear, 0, 0) + linear[0][1] * cofactor(linear, 0, 1) +
         linear[0][2] * cofactor(linear, 0, 2);
}

AffineMap AffineMap::inverse() const {
  const double det = determinant();
  if (det == 0.0 || !std::isfinite(det) || !std::isfinite(1 / det)) {
    throw Error("affine map: it is not invertible; give one whose columns span a volume");
  }
  AffineMap result;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      result.linear[row][column] = cofactor(linear, column, row) / det;
    }
  }
  result.offset = {0, 0, 0};
  result.offset = result({-offset[0], -offset[1], -offset[2]});
  return result;
}

AffineMap composed(const AffineMap& then, const AffineMap& first) {
  AffineMap result;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      result.linear[row][column] = then.linear[row][0] * first.linear[0][column] +
                                   then.linear[row][1] * first.linear[1][column] +
                                   then.linear[row][2] * first.linear[2][column];
    }
  }
  result.offset = then(first.offset);
  return result;
}

Volume::Volume(std::string name, const Index3& counts, Values values, const AffineMap& to_point,
               Mask mask)
    : name_(std::move(name)),
      counts_(counts),
      values_(std::move(values)),
      to_point_(to_point),
      mask_(std::move(mask)) {
  check();
}

Volume::Volume(std::string name, const Index3& counts, std::vector<float> values,
               const AffineMap& to_point, std::vector<std::uint8_t> mask)
    : name_(std::move(name)), counts_(counts), to_point_(to_point) {
  check_length(name_, values.size(), product(counts));
  if (!mask.empty()) check_length("mask of the " + name_, mask.size(), product(counts));
  values_ = shared(std::move(values));
  mask_ = shared(std::move(mask));
  check();
}

std::size_t Volume::size() const { return product(counts_); }

void Volume::check() const {
  if (counts_[0] < 1 || counts_[1] < 1 || counts_[2] < 1) {
    throw Error(fmt::format("{}: {} x {} x {} voxels; give at least one along each axis", name_,
                            counts_[0], counts_[1], counts_[2]));
  }
  if (static_cast<double>(counts_[0]) * counts_[1] * counts_[2] >
      std::numeric_limits<std::int32_t>::max()) {
    throw Error(fmt::format("{}: {} x {} x {} voxels; give fewer than 2^31", name_, counts_[0],
                            counts_[1], counts_[2]));
  }
  const double det = to_point_.determinant();
  if (det == 0.0 || !std::isfinite(det) || !std::isfinite(1 / det)) {
    throw Error(name_ + ": its axes span no volume; give it a spacing and a direction that do");
  }
  const std::size_t n = size();
  std::size_t bad = 0;
  std::size_t first = 0;
  for (std::size_t i = n; i-- > 0;) {
    if (std::isfinite(values_[i])) continue;
    ++bad;
    first = i;
  }
  if (bad > 0) {
    const auto along_i = static_cast<std::size_t>(counts_[0]);
    const auto along_j = static_cast<std::size_t>(counts_[1]);
    throw Error(fmt::format(
        "{}: {} of {} voxels NaN or infinite, the first ({}, {}, {}); replace them by numbers, and "
        "mask them out if they are to count for nothing",
        name_, bad, n, first % along_i, first / along_i % along_j, first / along_i / along_j));
  }
  if (mask_ != nullptr &&
      std::all_of(mask_.get(), mask_.get() + n, [](std::uint8_t voxel) { return voxel == 0; })) {
    throw Error("mask of the " + name_ + ": it is 0 everywhere; give one with voxels that count");
  }
}

Volume::Range Volume::range() const {
  Range result{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(), 0.0,
               0};
  double sum = 0.0;
  const std::size_t n = size();
  for (std::size_t i = 0; i < n; ++i) {
    if (mask_ != nullptr && mask_[i] == 0) continue;
    result.least = std::min(result.least, values_[i]);
    result.most = std::max(result.most, values_[i]);
    sum += static_cast<double>(values_[i]);
    ++result.voxels;
  }
  const double mean = sum / static_cast<double>(result.voxels);
  double squares = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    if (mask_ != nullptr && mask_[i] == 0) continue;
    const double off = static_cast<double>(values_[i]) - mean;
    squares += off * off;
  }
  result.variance = squares / static_cast<double>(result.voxels);
  return result;
}

void check_not_constant(const Volume& volume) {
  const Volume::Range range = volume.range();
  if (range.least < range.most) return;
  throw Error(fmt::format("{}: all voxels{} are {}; give one with contrast", volume.name(),
                          volume.mask() != nullptr ? " of its mask" : "", range.least));
}

}  // namespace hwffd
