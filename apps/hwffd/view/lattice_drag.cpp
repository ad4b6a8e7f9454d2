#include "view/lattice_drag.hpp"

#include <utility>

#include "hwffd/lattice/deformation.hpp"

namespace hwffd::view {
namespace {

constexpr double kSamePlace = 0.5;  // pixels

}  // namespace

LatticeDrag::LatticeDrag(Lattice lattice, const Family& family)
    : first_(std::move(lattice)), lattice_(first_), family_(family) {}

bool LatticeDrag::grab(const Screen& screen, const Pixels& mouse) {
  held_.reset();
  double nearest = 0;
  for (const Index3& place : places(lattice_.dims())) {
    const std::optional<Screen::Seen> seen = screen.project(lattice_.point(place));
    if (!seen) continue;
    const Pixels offset = seen->place - mouse;
    const double distance = offset.norm();
    if (distance > kReach) continue;
    if (held_) {
      const bool in_front = distance < nearest + kSamePlace && seen->depth < held_->depth;
      if (distance > nearest - kSamePlace && !in_front) continue;
    }
    nearest = distance;
    held_.emplace(Held{place, seen->depth, offset, lattice_});
  }
  return holds();
}

void LatticeDrag::drag(const Screen& screen, const Pixels& mouse) {
  if (!held_) return;
  const Point to = screen.unproject(mouse + held_->offset, held_->depth);
  const Point by = to - held_->lattice.point(held_->place);
  lattice_ = Deformation::move(held_->place, by).apply(held_->lattice, family_);
}

void LatticeDrag::reset() {
  held_.reset();
  lattice_ = first_;
}

}  // namespace hwffd::view
