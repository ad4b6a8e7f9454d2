#include "hwffd/device/deformable_lattice.hpp"

#include <utility>

#include "hwffd/lattice/attachment.hpp"
#include "hwffd/lattice/deformation.hpp"

namespace hwffd {

DeformableLattice::DeformableLattice(Lattice rest)
    : embedder_(std::move(rest)),
      deformed_(embedder_.lattice()),
      outside_(Outside::parse("keep")),
      device_(make_device({})) {}

void DeformableLattice::move(const Points& points) { deformed_ = Lattice(rest().dims(), points); }

void DeformableLattice::deform(const std::string& deformation) {
  deformed_ = Deformation::parse(deformation).apply(deformed_);
}

Points DeformableLattice::evaluate(std::vector<Embedded> vertices) {
  for (Embedded& vertex : vertices) {
    // What is no number stays one, for the device to refuse.
    if (!vertex.local.hasNaN()) vertex.local = vertex.local.cwiseMax(0.0).cwiseMin(1.0);
  }
  return device_->evaluate(deformed_, vertices);
}

Points DeformableLattice::carry(const Points& points) {
  const Attachment attachment(rest(), points, outside_);
  Points carried = attachment.follow(device_->evaluate(deformed_, attachment.places()));
  summary_ = attachment.summary();
  return carried;
}

}  // namespace hwffd
