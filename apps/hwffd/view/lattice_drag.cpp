#include "view/lattice_drag.hpp"

#include <utility>

#include "hwffd/lattice/deformation.hpp"

namespace hwffd::view {
namespace {

constexpr double kSamePlace = 0.5;  // pixels

Index3 place_of(const Lattice& lattice, Eigen::Index row) {
  const int index = static_cast<int>(row);
  const Index3& d = lattice.dims();
  return {index / (d[1] * d[2]), index / d[2] % d[1], index % d[2]};
}

}  // namespace

LatticeDrag::LatticeDrag(Lattice lattice) : first_(std::move(lattice)), lattice_(first_) {}

bool LatticeDrag::grab(const Screen& screen, const Pixels& mouse) {
  held_.reset();
  double nearest = 0;
  for (Eigen::Index row = 0; row < lattice_.points().rows(); ++row) {
    const std::optional<Screen::Seen> seen = screen.project(lattice_.points().row(row));
    if (!seen) continue;
    const Pixels offset = seen->place - mouse;
    const double distance = offset.norm();
    if (distance > kReach) continue;
    if (held_) {
      const bool in_front = distance < nearest + kSamePlace && seen->depth < held_->depth;
      if (distance > nearest - kSamePlace && !in_front) continue;
    }
    nearest = distance;
    held_.emplace(Held{place_of(lattice_, row), seen->depth, offset, lattice_});
  }
  return holds();
}

void LatticeDrag::drag(const Screen& screen, const Pixels& mouse) {
  if (!held_) return;
  const Index3& at = held_->place;
  const Point to = screen.unproject(mouse + held_->offset, held_->depth);
  const Point by = to - held_->lattice.point(at[0], at[1], at[2]);
  lattice_ = Deformation::move(at, by).apply(held_->lattice);
}

void LatticeDrag::reset() {
  held_.reset();
  lattice_ = first_;
}

}  // namespace hwffd::view
