#include "hwffd/lattice/inverse.hpp"

#include <Eigen/LU>
#include <limits>
#include <utility>
#include <vector>

#include "hwffd/lattice/attachment.hpp"
#include "hwffd/lattice/lattice_evaluator.hpp"

namespace hwffd {
namespace {

constexpr int kInverseSteps = 60;
constexpr double kLeastPart = 1e-6;            // of a step
constexpr double kInverseTolerance = 1e-12;    // of the lattice's size
constexpr double kCoordinateRounding = 1e-15;  // of the largest coordinate
constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

/// Eq. (1) in double at places of a family.
Points evaluate_places(const Lattice& lattice, const std::vector<Embedded>& places,
                       const Family& family) {
  if (places.empty()) return Points(0, 3);
  const Family::Evaluable evaluable = family.evaluable(lattice);
  std::vector<Embedded> at;
  at.reserve(places.size());
  for (const Embedded& place : places) at.push_back(evaluable.at(place));
  return evaluate_in(evaluable.lattice, at, evaluable.blending);
}

/// Newton's method for points outside the cells, all at once, each with a part of its step that is
/// smaller while that brings it no nearer. Where the nearest place turns a corner, a derivative is
/// that of one side only: there as large a part of what the point is off by comes in between.
class InverseSearch {
 public:
  InverseSearch(const Embedder& rest, const Lattice& deformed, const Outside& outside,
                Points targets)
      : rest_(rest),
        deformed_(deformed),
        outside_(outside),
        targets_(std::move(targets)),
        at_(targets_),
        part_(static_cast<std::size_t>(targets_.rows()), 1.0),
        plain_(static_cast<std::size_t>(targets_.rows()), 0) {
    const double largest = targets_.size() == 0 ? 0.0 : targets_.cwiseAbs().maxCoeff();
    tolerance_ = kInverseTolerance * rest.size() + kCoordinateRounding * largest;
  }

  Points places() {
    Reached now = reached(at_);
    for (int step = 0; step < kInverseSteps && !done(now); ++step) {
      const Points next = stepped(now);
      Reached then = reached(next);
      for (Eigen::Index i = 0; i < at_.rows(); ++i) {
        double& part = part_[static_cast<std::size_t>(i)];
        char& plain = plain_[static_cast<std::size_t>(i)];
        if (then.difference.row(i).norm() < now.difference.row(i).norm()) {
          at_.row(i) = next.row(i);
          now.difference.row(i) = then.difference.row(i);
          now.gradients[static_cast<std::size_t>(i)] = then.gradients[static_cast<std::size_t>(i)];
          part = std::min(1.0, 2 * part);
          plain = 0;
        } else {
          if (plain != 0) part /= 4;
          plain = plain == 0 ? 1 : 0;
        }
      }
    }
    for (Eigen::Index i = 0; i < at_.rows(); ++i) {
      if (!near(now, i)) at_.row(i).setConstant(kNowhere);
    }
    return at_;
  }

 private:
  struct Reached {
    Points difference;  ///< targets less where the points go
    std::vector<Eigen::Matrix3d> gradients;
  };

  Reached reached(const Points& at) const {
    const Attachment attachment(rest_, at, outside_, Attachment::Unsure::kStay);
    const Points moved =
        attachment.follow(evaluate_places(deformed_, attachment.places(), rest_.family()));
    return {targets_ - moved, attachment.gradients(deformed_)};
  }

  bool near(const Reached& now, Eigen::Index i) const {
    return now.difference.row(i).norm() <= tolerance_;
  }

  bool done(const Reached& now) const {
    for (Eigen::Index i = 0; i < at_.rows(); ++i) {
      if (!near(now, i) && part_[static_cast<std::size_t>(i)] >= kLeastPart) return false;
    }
    return true;
  }

  Points stepped(const Reached& now) const {
    Points next = at_;
    for (Eigen::Index i = 0; i < at_.rows(); ++i) {
      if (near(now, i)) continue;
      const Eigen::Vector3d difference = now.difference.row(i);
      const Eigen::Vector3d step =
          now.gradients[static_cast<std::size_t>(i)].partialPivLu().solve(difference);
      // Also where the derivative is not known, by as much as the point is off.
      const bool plain = plain_[static_cast<std::size_t>(i)] != 0 || !step.allFinite();
      next.row(i) += part_[static_cast<std::size_t>(i)] * (plain ? difference : step).transpose();
    }
    return next;
  }

  const Embedder& rest_;
  const Lattice& deformed_;
  const Outside& outside_;
  Points targets_;
  Points at_;
  std::vector<double> part_;
  std::vector<char> plain_;  ///< whether the next step is what the point is off by
  double tolerance_ = 0.0;
};

/// Points outside that stay, but for those of the cells at rest, which have moved away.
Points stayers(const Embedder& rest, Points points) {
  const std::vector<Embedding> at_rest = rest.embed(points);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const bool outside = at_rest[static_cast<std::size_t>(i)].status == EmbeddingStatus::kOutside;
    if (!outside) points.row(i).setConstant(kNowhere);
  }
  return points;
}

}  // namespace

Points inverse_of(const Embedder& rest, const Lattice& deformed, const Outside& outside,
                  const Points& points) {
  const Attachment there(Embedder(deformed, rest.family()), points, Outside::parse("keep"),
                         Attachment::Unsure::kStay);
  Points result = there.follow(evaluate_places(rest.lattice(), there.places(), rest.family()));
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const EmbeddingStatus status = there.embedding(i).status;
    if (status == EmbeddingStatus::kNotConverged) result.row(i).setConstant(kNowhere);
    if (status == EmbeddingStatus::kOutside) rows.push_back(i);
  }
  if (rows.empty()) return result;
  const Points others = points(rows, Eigen::all);
  result(rows, Eigen::all) = outside.kind() == Outside::Kind::kKeep
                                 ? stayers(rest, others)
                                 : InverseSearch(rest, deformed, outside, others).places();
  return result;
}

}  // namespace hwffd
