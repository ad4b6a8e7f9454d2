#include "hwffd/lattice/weights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "hwffd/error.hpp"
#include "hwffd/on_threads.hpp"

namespace hwffd {
namespace {

constexpr std::size_t kWeights = 64;         // weights of a place
constexpr std::size_t kPlacesAtOnce = 1024;  // places that a thread takes at once
constexpr std::size_t kPartialSums = 16;     // sums of pull_back(), however many threads there are

/// The weights of a place and the rows of their control points, in the order of a support.
struct PlaceWeights {
  std::array<std::int32_t, kWeights> columns;
  std::array<double, kWeights> values;
};

PlaceWeights weights_at(const Attachment& attachment, std::size_t place) {
  const Lattice& lattice = attachment.rest();
  const Family& family = attachment.family();
  const Embedded& at = attachment.places()[place];
  std::array<Eigen::Vector4d, 3> axis;
  Index3 corner{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double x = at.local[static_cast<Eigen::Index>(a)];
    axis[a] =
        family.functions(lattice.dims()[a], at.cell[a]) * Eigen::Vector4d(1, x, x * x, x * x * x);
    corner[a] = family.first(at.cell[a]);
  }
  const double whole = attachment.follower(place).weight;
  PlaceWeights result{};
  std::size_t next = 0;
  for (int l = 0; l < 4; ++l) {
    for (int m = 0; m < 4; ++m) {
      const double row = whole * axis[0][l] * axis[1][m];
      for (int n = 0; n < 4; ++n, ++next) {
        result.columns[next] =
            static_cast<std::int32_t>(lattice.index(corner[0] + l, corner[1] + m, corner[2] + n));
        result.values[next] = row * axis[2][n];
      }
    }
  }
  return result;
}

}  // namespace

std::size_t weight_count(const Attachment& attachment) {
  return kWeights * attachment.places().size();
}

SparseRows weights_of(const Attachment& attachment) {
  const std::size_t places = attachment.places().size();
  SparseRows rows;
  rows.starts.reserve(static_cast<std::size_t>(attachment.size()) + 1);
  rows.starts.push_back(0);
  std::size_t place = 0;
  for (Eigen::Index row = 0; row < attachment.size(); ++row) {
    if (place < places && attachment.follower(place).row == row) ++place;
    rows.starts.push_back(static_cast<std::int64_t>(kWeights * place));
  }
  rows.columns.resize(kWeights * places);
  rows.values.resize(kWeights * places);
  on_ranges(places, kPlacesAtOnce, [&](std::size_t first, std::size_t end) {
    for (std::size_t p = first; p < end; ++p) {
      const PlaceWeights weights = weights_at(attachment, p);
      const auto to = static_cast<std::ptrdiff_t>(kWeights * p);
      std::copy(weights.columns.begin(), weights.columns.end(), rows.columns.begin() + to);
      std::copy(weights.values.begin(), weights.values.end(), rows.values.begin() + to);
    }
  });
  return rows;
}

Points unmoved_part(const Attachment& attachment) {
  Points result = attachment.points();
  for (std::size_t place = 0; place < attachment.places().size(); ++place) {
    const Attachment::Follower follower = attachment.follower(place);
    if (attachment.is_inside(follower.row)) {
      result.row(follower.row).setZero();
    } else {
      result.row(follower.row) -= follower.weight * follower.anchor.transpose();
    }
  }
  return result;
}

Points pull_back(const Attachment& attachment, const Points& gradient) {
  if (gradient.rows() != attachment.size()) {
    throw Error(fmt::format("gradient of {} points for {} that are attached; give a row for each",
                            gradient.rows(), attachment.size()));
  }
  const std::size_t places = attachment.places().size();
  const std::size_t size = (places + kPartialSums - 1) / kPartialSums;
  Points result = Points::Zero(attachment.rest().points().rows(), 3);
  if (size == 0) return result;
  std::vector<Points> partial_sums((places + size - 1) / size, result);
  on_ranges(places, size, [&](std::size_t first, std::size_t end) {
    Points& sum = partial_sums[first / size];
    for (std::size_t p = first; p < end; ++p) {
      const PlaceWeights weights = weights_at(attachment, p);
      const Eigen::RowVector3d of_point = gradient.row(attachment.follower(p).row);
      for (std::size_t w = 0; w < kWeights; ++w) {
        sum.row(weights.columns[w]) += weights.values[w] * of_point;
      }
    }
  });
  for (const Points& sum : partial_sums) result += sum;
  return result;
}

}  // namespace hwffd
