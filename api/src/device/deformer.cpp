#include "hwffd/device/deformer.hpp"

#include <fmt/format.h>

#include <utility>

#include "hwffd/error.hpp"

namespace hwffd {
namespace {

const Deformer::Rest& first_of(const std::vector<Deformer::Rest>& lattices) {
  if (lattices.empty()) throw Error("no lattice to deform with; give at least one");
  return lattices.front();
}

void check_dims(const Lattice& rest, const Lattice& deformed) {
  const Index3& a = rest.dims();
  const Index3& b = deformed.dims();
  if (a == b) return;
  throw Error(
      fmt::format("deformed lattice has {} x {} x {} points, the lattice at rest {} x {} x "
                  "{}; give both the same",
                  b[0], b[1], b[2], a[0], a[1], a[2]));
}

}  // namespace

Deformer::Deformer(const Points& points, std::function<const Triangles&()> triangles,
                   std::vector<Rest> rest, Outside outside)
    : triangles_(std::move(triangles)),
      rest_(std::move(rest)),
      outside_(outside),
      first_(first_of(rest_).lattice, points, outside_, rest_.front().family) {}

Deformer::Result Deformer::deform(const std::vector<Lattice>& deformed, Device& device,
                                  Gradients gradients) const {
  if (deformed.size() != rest_.size()) {
    throw Error(fmt::format("{} deformed lattices for {} stages; give one a stage", deformed.size(),
                            rest_.size()));
  }
  Result result;
  if (gradients == Gradients::kAll) {
    result.gradients.assign(static_cast<std::size_t>(first_.size()), Eigen::Matrix3d::Identity());
  }
  for (std::size_t stage = 0; stage < rest_.size(); ++stage) {
    const auto& [lattice, family] = rest_[stage];
    check_dims(lattice, deformed[stage]);
    std::optional<Attachment> later;
    if (stage > 0) later.emplace(lattice, result.positions, outside_, family);
    const Attachment& attachment = later ? *later : first_;
    if (gradients == Gradients::kNone) {
      result.positions =
          attachment.follow(device.evaluate(deformed[stage], attachment.places(), family));
    } else {
      const Device::Tangents tangents =
          device.tangents(deformed[stage], attachment.places(), family);
      result.positions = attachment.follow(tangents.positions);
      const std::vector<Eigen::Matrix3d> own =
          attachment.gradients(tangents.jacobians, tangents.positions);
      for (std::size_t i = 0; i < own.size(); ++i) {
        result.gradients[i] = own[i] * result.gradients[i];
      }
    }
    result.summaries.push_back(attachment.summary());
    if (triangles_ && attachment.may_tear()) {
      result.torn_edges += attachment.torn_edges(triangles_());
    }
  }
  return result;
}

}  // namespace hwffd
