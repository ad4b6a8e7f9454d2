#include "hwffd/lattice/fold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <numeric>
#include <vector>

#include "far_rounding.hpp"
#include "hwffd/lattice/bezier_volume.hpp"
#include "hwffd/on_threads.hpp"

namespace hwffd {
namespace {

constexpr double kSame = 1e-12;            // of the lattice's size
constexpr double kRounding = 1e-12;        // of the product of the largest derivatives
constexpr std::size_t kMaxRegions = 4000;  // of all cells together, left undecided at a level
constexpr std::size_t kCellsAtOnce = 16;   // that a thread looks at
constexpr std::size_t kRegionsAtOnce = 8;

/// What the coefficients of det J say of its sign over a region.
struct Bounds {
  double least, most;                ///< of all coefficients
  double corner_least, corner_most;  ///< of those at corners, which are values
  double rounding;                   ///< that every coefficient may be wrong by

  bool is_proved(double sign) const { return (sign > 0 ? least : -most) > rounding; }
  bool is_folded(double sign) const { return (sign > 0 ? corner_least : -corner_most) < -rounding; }
};

/// A region of a cell, and det J over it without the factors that vanish on collapsed faces.
struct Region {
  Index3 cell;
  Eigen::Vector3d low;  ///< its corner, in local coordinates
  double width;
  BezierVolume determinant;
  double rounding;  ///< that every coefficient may be wrong by

  /// The coefficient at a corner, 0 or 1 an axis.
  double at(const Index3& corner) const {
    const Index3& degree = determinant.degree();
    const Eigen::Index row =
        determinant.index({corner[0] * degree[0], corner[1] * degree[1], corner[2] * degree[2]});
    return determinant.coefficients()(row, 0);
  }

  Bounds bounds() const {
    Bounds result{determinant.coefficients().minCoeff(), determinant.coefficients().maxCoeff(),
                  at({0, 0, 0}), at({0, 0, 0}), rounding};
    for (const Index3& corner : places({2, 2, 2})) {
      result.corner_least = std::min(result.corner_least, at(corner));
      result.corner_most = std::max(result.corner_most, at(corner));
    }
    return result;
  }
};

/// Along how many of its two axes a face of the cell is collapsed.
int collapsed_axes(const BezierVolume& map, int axis, int end, double tolerance) {
  const auto a = static_cast<std::size_t>(axis);
  const auto& c = map.coefficients();
  int result = 0;
  for (int other = 1; other < 3; ++other) {
    const std::size_t along = static_cast<std::size_t>(axis + other) % 3;
    bool same = true;
    for (Eigen::Index row = 0; row < c.rows(); ++row) {
      Index3 at = map.place(row);
      if (at[a] != end * map.degree()[a]) continue;
      at[along] = 0;
      same = same && (c.row(row) - c.row(map.index(at))).norm() <= tolerance;
    }
    if (same) ++result;
  }
  return result;
}

double largest(const BezierVolume& volume) {
  return volume.coefficients().rowwise().norm().maxCoeff();
}

/// Level by level: the regions of a level are looked at on all threads and judged in their order,
/// so that the answer is the same for any number of threads. Of whole cells only bounds are kept.
class Check {
 public:
  Check(const Lattice& lattice, const Family& family)
      : lattice_(lattice), family_(family), count_(family.cells(lattice.dims())) {
    const Points& points = lattice.points();
    const Point low = points.colwise().minCoeff();
    const Point high = points.colwise().maxCoeff();
    centre_ = (low + high) / 2;
    size_ = (high - low).maxCoeff();
    far_ = far_rounding(points, size_);
  }

  FoldCheck run(int max_depth) {
    std::vector<Region> regions = unclear_cells();
    while (result_.verdict == FoldCheck::Verdict::kProved && !regions.empty()) {
      if (result_.depth >= max_depth || regions.size() > kMaxRegions / 8) {
        report(FoldCheck::Verdict::kUndecided, regions.front(), Eigen::Vector3d::Constant(0.5));
        break;
      }
      ++result_.depth;
      regions = unclear(halved(regions));
    }
    return result_;
  }

 private:
  struct Cell {
    Region region;
    double volume;
    bool collapsed;
  };

  Cell cell_at(const Index3& index) const {
    Support support = family_.support(lattice_, index);
    support.rowwise() -= centre_.transpose();
    const BezierVolume map = BezierVolume::of_cell(support);
    BezierVolume determinant = jacobian_determinant(map);
    const double volume = determinant.integral()[0];
    // The slopes have the rounding of the points (a hundred times smaller than kRounding).
    std::array<double, 3> slopes{};
    for (int axis = 0; axis < 3; ++axis) {
      slopes[static_cast<std::size_t>(axis)] = largest(map.derivative(axis)) + size_ / 100;
    }
    double rounding = kRounding * slopes[0] * slopes[1] * slopes[2];
    rounding += far_ * (slopes[0] * slopes[1] + slopes[1] * slopes[2] + slopes[2] * slopes[0]);
    bool collapsed = false;
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      for (int end = 0; end < 2; ++end) {
        if (index[a] != end * (count_[a] - 1)) continue;
        const int power = collapsed_axes(map, axis, end, kSame * size_ + far_);
        if (power == 0) continue;
        collapsed = true;
        determinant = determinant.without_factor(axis, end, power);
        rounding *= power == 1 ? 8 : 28;  // the coefficients grow by at most this
      }
    }
    return {
        {index, Eigen::Vector3d::Zero(), 1.0, std::move(determinant), rounding}, volume, collapsed};
  }

  /// The cells that are not proved, up to the first that folds, which is reported.
  std::vector<Region> unclear_cells() {
    const std::vector<Index3> cells = places(count_);
    std::vector<Bounds> bounds(cells.size());
    std::vector<double> volumes(cells.size());
    std::atomic<bool> collapsed{false};
    on_ranges(cells.size(), kCellsAtOnce, [&](std::size_t first, std::size_t end) {
      for (std::size_t c = first; c < end; ++c) {
        const Cell cell = cell_at(cells[c]);
        bounds[c] = cell.region.bounds();
        volumes[c] = cell.volume;
        if (cell.collapsed) collapsed = true;
      }
    });
    result_.collapsed = collapsed;
    result_.volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
    sign_ = result_.volume < 0 ? -1.0 : 1.0;
    return unclear(bounds, [&](std::size_t c) { return cell_at(cells[c]).region; });
  }

  std::vector<Region> unclear(std::vector<Region> regions) {
    std::vector<Bounds> bounds(regions.size());
    on_ranges(regions.size(), kRegionsAtOnce, [&](std::size_t first, std::size_t end) {
      for (std::size_t p = first; p < end; ++p) bounds[p] = regions[p].bounds();
    });
    return unclear(bounds, [&](std::size_t p) { return std::move(regions[p]); });
  }

  /// The regions that are not proved, as many as undecided() needs, up to one that folds, which is
  /// reported.
  template <typename RegionAt>
  std::vector<Region> unclear(const std::vector<Bounds>& bounds, const RegionAt& region_at) {
    std::vector<Region> result;
    for (std::size_t p = 0; p < bounds.size(); ++p) {
      if (bounds[p].is_folded(sign_)) {
        report_fold(region_at(p));
        return {};
      }
      if (!bounds[p].is_proved(sign_) && result.size() <= kMaxRegions / 8) {
        result.push_back(region_at(p));
      }
    }
    return result;
  }

  /// Corner coefficients are values: one of the other sign is a fold.
  void report_fold(const Region& region) {
    for (const Index3& corner : places({2, 2, 2})) {
      if (sign_ * region.at(corner) >= -region.rounding) continue;
      report(FoldCheck::Verdict::kFolded, region, Eigen::Vector3d(corner[0], corner[1], corner[2]));
      return;
    }
  }

  void report(FoldCheck::Verdict verdict, const Region& region, const Eigen::Vector3d& at) {
    result_.verdict = verdict;
    result_.cell = region.cell;
    result_.local = region.low + region.width * at;
  }

  static std::vector<Region> halved(const std::vector<Region>& regions) {
    std::vector<std::vector<Region>> octants(regions.size());
    on_ranges(regions.size(), kRegionsAtOnce, [&](std::size_t first, std::size_t end) {
      for (std::size_t p = first; p < end; ++p) octants[p] = halved(regions[p]);
    });
    std::vector<Region> result;
    for (std::vector<Region>& some : octants) {
      std::move(some.begin(), some.end(), std::back_inserter(result));
    }
    return result;
  }

  static std::vector<Region> halved(const Region& region) {
    auto octants = region.determinant.octants();
    std::vector<Region> result;
    for (std::size_t o = 0; o < octants.size(); ++o) {
      const Eigen::Vector3d corner(o >> 2 & 1, o >> 1 & 1, o & 1);
      result.push_back({region.cell, region.low + corner * region.width / 2, region.width / 2,
                        std::move(octants[o]), region.rounding});
    }
    return result;
  }

  const Lattice& lattice_;
  const Family& family_;
  const Index3 count_;
  Point centre_;
  FoldCheck result_;
  double size_ = 0.0;
  double far_ = 0.0;  ///< rounding of slopes where the lattice lies far from the origin
  double sign_ = 1.0;
};

}  // namespace

std::string FoldCheck::text() const {
  const std::string where = fmt::format("(cell {} {} {}; {:.6g}, {:.6g}, {:.6g})", cell[0], cell[1],
                                        cell[2], local[0], local[1], local[2]);
  switch (verdict) {
    case Verdict::kFolded:
      return "folded at " + where;
    case Verdict::kUndecided:
      return fmt::format("undecided at depth {} {}", depth, where);
    case Verdict::kProved:
      break;
  }
  return collapsed ? "proved but on collapsed faces" : "proved";
}

FoldCheck check_folds(const Lattice& lattice, int max_depth, const Family& family) {
  family.check_dims(lattice.dims());
  return Check(lattice, family).run(max_depth);
}

}  // namespace hwffd
