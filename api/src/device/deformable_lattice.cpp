#include "hwffd/device/deformable_lattice.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/lattice/bending.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/few_points.hpp"
#include "hwffd/lattice/inverse.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "hwffd/on_threads.hpp"

namespace hwffd {
namespace {

constexpr Eigen::Index kPointsOfAPart = 8192;  // whose attachment stays in the caches

std::vector<Embedded> clamped(std::vector<Embedded> vertices) {
  for (Embedded& vertex : vertices) {
    // What is no number stays one, for the device to refuse.
    if (!vertex.local.hasNaN()) vertex.local = vertex.local.cwiseMax(0.0).cwiseMin(1.0);
  }
  return vertices;
}

/// What call(device) gives, of the device or of one of that kind.
template <typename Call>
Points on_device(Device& device, const std::string& kind, const Call& call) {
  return kind.empty() ? call(device) : call(*make_pull_back_device(kind));
}

}  // namespace

DeformableLattice::DeformableLattice(Lattice rest, const Family& family)
    : embedder_(std::move(rest), family),
      deformed_(embedder_.lattice()),
      outside_(Outside::parse("keep")),
      device_(make_device(choice_)) {}

DeformableLattice DeformableLattice::read(const std::filesystem::path& path,
                                          const std::optional<Family>& family) {
  const LatticeFile file = read_lattice_file(path, family);
  DeformableLattice lattice(whole(file.rest.value_or(file.lattice), *file.family), *file.family);
  if (file.rest) lattice.move(whole(file.lattice, *file.family).points());
  return lattice;
}

void DeformableLattice::move(const Points& points) { deformed_ = Lattice(rest().dims(), points); }

void DeformableLattice::deform(const std::string& deformation) {
  deformed_ = Deformation::parse(deformation).apply(deformed_, family());
}

void DeformableLattice::set_family(const Family& family) { embedder_ = Embedder(rest(), family); }

void DeformableLattice::set_device(const DeviceChoice& choice) {
  device_ = make_device(choice);
  choice_ = choice;
}

Points DeformableLattice::evaluate(std::vector<Embedded> vertices) {
  return device_->evaluate(deformed_, clamped(std::move(vertices)), family());
}

Points DeformableLattice::evaluate_grid(const Grid& grid) {
  return device_->evaluate_grid(deformed_, grid, family());
}

Points DeformableLattice::pull_back(std::vector<Embedded> vertices, const Points& gradient,
                                    const std::string& kind) {
  const std::vector<Embedded> places = clamped(std::move(vertices));
  return on_device(*device_, kind, [&](Device& device) {
    return device.pull_back(rest().dims(), places, gradient, family());
  });
}

Points DeformableLattice::pull_back_grid(const Grid& grid, const Points& gradient,
                                         const std::string& kind) {
  return on_device(*device_, kind, [&](Device& device) {
    return device.pull_back_grid(rest().dims(), grid, gradient, family());
  });
}

void DeformableLattice::check_own(const Attachment& attachment) const {
  const Lattice& other = attachment.rest();
  if (attachment.family().kind() == family().kind() && other.dims() == rest().dims() &&
      other.points() == rest().points()) {
    return;
  }
  throw Error("these points are attached to another lattice at rest; attach them to this one");
}

Points DeformableLattice::carry(const Attachment& attachment) {
  check_own(attachment);
  Points carried = attachment.follow(device_->evaluate(deformed_, attachment.places(), family()));
  summary_ = attachment.summary();
  return carried;
}

void DeformableLattice::carry_by_parts(Eigen::Index count, const ReadRows& read,
                                       const WriteRows& write, Attachment::Unsure unsure) {
  EmbeddingSummary summary;
  std::mutex joining;
  // No fewer than make up for the lattices that each part copies.
  const Eigen::Index size = std::max(kPointsOfAPart, 2 * rest().points().rows());
  on_ranges(static_cast<std::size_t>(count), static_cast<std::size_t>(size),
            [&](std::size_t first, std::size_t end) {
              const auto from = static_cast<Eigen::Index>(first);
              const Attachment part =
                  attach(read(from, static_cast<Eigen::Index>(end - first)), unsure);
              write(from, part.follow(device_->evaluate(deformed_, part.places(), family())));
              const std::lock_guard<std::mutex> lock(joining);
              summary = joined(summary, part.summary());
            });
  summary_ = summary;
}

void DeformableLattice::carry(Eigen::Index count, const ReadRows& read, const WriteRows& write,
                              Attachment::Unsure unsure) {
  // Points outside that follow need a search that takes longer to prepare than a part does.
  if (device_->concurrent() && outside_.kind() == Outside::Kind::kKeep) {
    try {
      return carry_by_parts(count, read, write, unsure);
    } catch (const Error&) {
      // As a whole it fails again, with a text that has its row.
    }
  }
  write(0, carry(attach(read(0, count), unsure)));
}

Points DeformableLattice::carry(const Eigen::Ref<const Points>& points, Attachment::Unsure unsure) {
  Points carried(points.rows(), 3);
  carry(
      points.rows(),
      [&](Eigen::Index first, Eigen::Index count) { return points.middleRows(first, count); },
      [&](Eigen::Index first, const Points& rows) {
        carried.middleRows(first, rows.rows()) = rows;
      },
      unsure);
  return carried;
}

Points DeformableLattice::displacements(const Eigen::Ref<const Points>& points,
                                        Attachment::Unsure unsure) {
  return carry(points, unsure) - points;
}

Points DeformableLattice::inverse(const Points& points) const {
  return inverse_of(embedder_, deformed_, outside_, points);
}

double DeformableLattice::bending_energy() const {
  return hwffd::bending_energy(rest(), deformed_, family());
}

std::vector<Eigen::Matrix3d> DeformableLattice::gradients(const Attachment& attachment) const {
  check_own(attachment);
  return attachment.gradients(deformed_);
}

}  // namespace hwffd
