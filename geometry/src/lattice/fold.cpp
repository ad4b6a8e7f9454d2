#include "hwffd/lattice/fold.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "hwffd/lattice/bezier_volume.hpp"
#include "hwffd/on_threads.hpp"

namespace hwffd {
namespace {

constexpr double kSame = 1e-12;          // of the lattice's size
constexpr double kRounding = 1e-12;      // of the product of the largest derivatives
constexpr std::size_t kMaxParts = 4000;  // of all cells together, left undecided at a level

/// A part of a cell, and det J over it without the factors that vanish on collapsed faces.
struct Part {
  Index3 cell;
  Eigen::Vector3d low;  ///< its corner, in local coordinates
  double width;
  BezierVolume determinant;
  double rounding;  ///< that every coefficient may be wrong by
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

class Check {
 public:
  Check(const Lattice& lattice, const Family& family) {
    const Points& points = lattice.points();
    const Point low = points.colwise().minCoeff();
    const Point high = points.colwise().maxCoeff();
    const Point centre = (low + high) / 2;
    size_ = (high - low).maxCoeff();
    const Index3 count = family.cells(lattice.dims());
    for (const Index3& cell : places(count)) {
      Watch::look();
      Support support = family.support(lattice, cell);
      support.rowwise() -= centre.transpose();
      add_cell(count, cell, BezierVolume::of_cell(support));
    }
    sign_ = result_.volume < 0 ? -1.0 : 1.0;
  }

  FoldCheck run(int max_depth) {
    for (;; ++result_.depth) {
      std::vector<Part> unclear;
      Watch::look();
      for (Part& part : parts_) {
        if (is_folded(part)) return result_;
        if (!is_proved(part)) unclear.push_back(std::move(part));
      }
      if (unclear.empty()) return result_;
      if (result_.depth >= max_depth || unclear.size() > kMaxParts / 8) {
        return report(FoldCheck::Verdict::kUndecided, unclear.front(),
                      Eigen::Vector3d::Constant(0.5));
      }
      parts_.clear();
      for (const Part& part : unclear) halve(part);
    }
  }

 private:
  void add_cell(const Index3& count, const Index3& cell, const BezierVolume& map) {
    BezierVolume determinant = jacobian_determinant(map);
    result_.volume += determinant.integral()[0];
    // The slopes have the rounding of the points (a hundred times smaller than kRounding).
    double rounding = kRounding;
    for (int axis = 0; axis < 3; ++axis) rounding *= largest(map.derivative(axis)) + size_ / 100;
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      for (int end = 0; end < 2; ++end) {
        if (cell[a] != end * (count[a] - 1)) continue;
        const int power = collapsed_axes(map, axis, end, kSame * size_);
        if (power == 0) continue;
        result_.collapsed = true;
        determinant = determinant.without_factor(axis, end, power);
        rounding *= power == 1 ? 8 : 28;  // the coefficients grow by at most this
      }
    }
    parts_.push_back({cell, Eigen::Vector3d::Zero(), 1.0, std::move(determinant), rounding});
  }

  bool is_proved(const Part& part) const {
    return (sign_ * part.determinant.coefficients()).minCoeff() > part.rounding;
  }

  /// Corner coefficients are values: one of the other sign is a fold.
  bool is_folded(const Part& part) {
    const Index3& degree = part.determinant.degree();
    for (int c = 0; c < 8; ++c) {
      const Index3 corner{c >> 2 & 1, c >> 1 & 1, c & 1};
      const Eigen::Index row = part.determinant.index(
          {corner[0] * degree[0], corner[1] * degree[1], corner[2] * degree[2]});
      if (sign_ * part.determinant.coefficients()(row, 0) >= -part.rounding) continue;
      report(FoldCheck::Verdict::kFolded, part, Eigen::Vector3d(corner[0], corner[1], corner[2]));
      return true;
    }
    return false;
  }

  FoldCheck report(FoldCheck::Verdict verdict, const Part& part, const Eigen::Vector3d& at) {
    result_.verdict = verdict;
    result_.cell = part.cell;
    result_.local = part.low + part.width * at;
    return result_;
  }

  void halve(const Part& part) {
    const auto octants = part.determinant.octants();
    for (int o = 0; o < 8; ++o) {
      const Eigen::Vector3d corner(o >> 2 & 1, o >> 1 & 1, o & 1);
      parts_.push_back({part.cell, part.low + corner * part.width / 2, part.width / 2,
                        octants[static_cast<std::size_t>(o)], part.rounding});
    }
  }

  FoldCheck result_;
  double size_ = 0.0;
  double sign_ = 1.0;
  std::vector<Part> parts_;
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
