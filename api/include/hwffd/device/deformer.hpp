#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "hwffd/device/device.hpp"
#include "hwffd/lattice/attachment.hpp"
#include "hwffd/lattice/outside.hpp"

namespace hwffd {

/// Points carried through lattices, one stage after the other (paper, section 2: hierarchical
/// deformation). Each stage embeds the points as the stage before left them in its lattice at rest
/// and evaluates them in its deformed lattice on a device.
class Deformer {
 public:
  /// What all stages made of the points.
  struct Result {
    Points positions;                         ///< n x 3
    std::vector<Eigen::Matrix3d> gradients;   ///< of the whole map at each point; NaN: unknown;
                                              ///< empty if not asked for
    std::vector<EmbeddingSummary> summaries;  ///< one a stage
    std::size_t torn_edges = 0;               ///< Attachment::torn_edges, over all stages
  };

  /// Whether the derivatives of the map are wanted, for normals: a device evaluates four times
  /// then.
  enum class Gradients { kNone, kAll };

  /// The lattice of a stage at rest.
  struct Rest {
    Lattice lattice;
    Family family = {};
  };

  /// Indices of points, three a triangle.
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;

  /// @param points     n x 3
  /// @param triangles  whose edges may tear (torn_edges), called in deform() where one can; or none
  /// @param rest       one a stage
  /// @throws Error if there is no stage, or what Attachment throws
  Deformer(const Points& points, std::function<const Triangles&()> triangles,
           std::vector<Rest> rest, Outside outside);

  /// @param deformed  the lattices of the stages, deformed, of the same dimensions
  /// @throws Error for another number of lattices or other dimensions, and what Attachment and
  ///   Device throw
  Result deform(const std::vector<Lattice>& deformed, Device& device,
                Gradients gradients = Gradients::kAll) const;

 private:
  std::function<const Triangles&()> triangles_;
  std::vector<Rest> rest_;
  Outside outside_;
  Attachment first_;  ///< of the first stage, whose points never change
};

}  // namespace hwffd
