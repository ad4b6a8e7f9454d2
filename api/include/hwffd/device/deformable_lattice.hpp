#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hwffd/device/device.hpp"
#include "hwffd/lattice/attachment.hpp"
#include "hwffd/lattice/embedder.hpp"
#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/outside.hpp"

namespace hwffd {

/// A lattice at rest and deformed, with the device that evaluates it: all that a program needs to
/// deform points. What C (hwffd.h) and Python call.
class DeformableLattice {
 public:
  /// Not deformed yet, on the reference, points outside stay.
  /// @throws Error if the lattice spans no volume (Embedder), or has points an axis that the family
  ///   cannot have
  explicit DeformableLattice(Lattice rest, const Family& family = {});
  /// That of a lattice file, deformed where the file gives the lattice at rest apart. One of few
  /// points an axis is made whole().
  /// @param family  in place of what the file names
  /// @throws as read_lattice_file() and the constructor
  static DeformableLattice read(const std::filesystem::path& path,
                                const std::optional<Family>& family = {});

  const Lattice& rest() const { return embedder_.lattice(); }
  const Lattice& deformed() const { return deformed_; }
  const Family& family() const { return embedder_.family(); }

  /// Moves the control points to new places, n x 3.
  /// @throws Error for another number of points or one that is not finite
  void move(const Points& points);
  /// Moves them further, as Deformation::parse() reads it.
  void deform(const std::string& deformation);
  /// The same control points with other blending functions.
  /// @throws as the constructor
  void set_family(const Family& family);

  /// @throws as make_device()
  void set_device(const DeviceChoice& choice);
  const Device& device() const { return *device_; }
  /// What device() was made of.
  const DeviceChoice& choice() const { return choice_; }
  void set_outside(const std::string& text) { outside_ = Outside::parse(text); }
  const Outside& outside() const { return outside_; }

  /// Where points lie in the lattice at rest (paper, eq. (2)).
  std::vector<Embedding> embed(const Points& points) const { return embedder_.embed(points); }
  /// Points of the space at rest, n x 3, embedded to be carried again and again.
  /// @throws as Attachment
  Attachment attach(const Points& points,
                    Attachment::Unsure unsure = Attachment::Unsure::kRefuse) const {
    return {embedder_, points, outside_, unsure};
  }

  /// Eq. (1) in the deformed lattice, n x 3; coordinates beyond [0, 1] are clamped.
  Points evaluate(std::vector<Embedded> vertices);
  /// The same at the places of a regular grid, s fastest, then t, then u.
  /// @throws as Device::evaluate()
  Points evaluate_grid(const Grid& grid);
  /// The transpose of evaluate(): of the gradient of a number with respect to the points at these
  /// places, n x 3, that with respect to the control points, m x 3. It does not depend on where the
  /// control points are. Coordinates beyond [0, 1] are clamped.
  /// @param kind  what adds up (make_pull_back_device()); empty: device()
  /// @throws as Device::pull_back() and make_pull_back_device()
  Points pull_back(std::vector<Embedded> vertices, const Points& gradient,
                   const std::string& kind = "");
  /// The same at the places of a regular grid, s fastest, then t, then u.
  Points pull_back_grid(const Grid& grid, const Points& gradient, const std::string& kind = "");
  /// Where the deformation takes attached points, n x 3.
  /// @throws Error if they were attached to another lattice; as Device::evaluate()
  Points carry(const Attachment& attachment);
  /// Where the deformation takes points of the space at rest, n x 3: attach() and carry(), bit for
  /// bit, but part by part where the device can, without the room that an attachment takes.
  Points carry(const Eigen::Ref<const Points>& points,
               Attachment::Unsure unsure = Attachment::Unsure::kRefuse);

  /// Rows `first` to `first + count - 1` of points, in double, wherever they are kept.
  using ReadRows = std::function<Points(Eigen::Index first, Eigen::Index count)>;
  /// Keeps rows from `first` on.
  using WriteRows = std::function<void(Eigen::Index first, const Points& rows)>;
  /// The same of `count` points that are read and written part by part, so that no more than a few
  /// parts are in memory in double. Both functions are called on several threads at once, and may
  /// be called again for the same rows; what they throw ends the call, as does Error.
  void carry(Eigen::Index count, const ReadRows& read, const WriteRows& write,
             Attachment::Unsure unsure = Attachment::Unsure::kRefuse);
  /// How far points of the space at rest move, n x 3: carry() less the points.
  Points displacements(const Eigen::Ref<const Points>& points,
                       Attachment::Unsure unsure = Attachment::Unsure::kRefuse);
  /// The points of the space at rest that the deformation takes to these, n x 3, in double. NaN
  /// where there is none, or none was found. Where there are several, in a lattice that folds
  /// space, one of them; inside the cells rather than outside.
  /// @throws Error that names the row of a point that is not finite, and if the deformed lattice
  ///   spans no volume
  Points inverse(const Points& points) const;
  /// bending_energy() of the deformation.
  double bending_energy() const;
  /// The gradient of the deformation at attached points, in double (Attachment::gradients).
  /// @throws Error if they were attached to another lattice
  std::vector<Eigen::Matrix3d> gradients(const Attachment& attachment) const;

  /// Of the points that carry() took last; before, of none.
  const EmbeddingSummary& summary() const { return summary_; }

 private:
  void check_own(const Attachment& attachment) const;
  void carry_by_parts(Eigen::Index count, const ReadRows& read, const WriteRows& write,
                      Attachment::Unsure unsure);

  Embedder embedder_;
  Lattice deformed_;
  Outside outside_;
  EmbeddingSummary summary_;
  DeviceChoice choice_;
  std::unique_ptr<Device> device_;
};

}  // namespace hwffd
