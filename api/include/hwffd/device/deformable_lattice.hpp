#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hwffd/device/device.hpp"
#include "hwffd/lattice/embedder.hpp"
#include "hwffd/lattice/outside.hpp"

namespace hwffd {

/// A lattice at rest and deformed, with the device that evaluates it: all that a program needs to
/// deform points. What C (hwffd.h) and Python call.
class DeformableLattice {
 public:
  /// Not deformed yet, on the model, points outside stay.
  /// @throws Error if the lattice spans no volume (Embedder)
  explicit DeformableLattice(Lattice rest);

  const Lattice& rest() const { return embedder_.lattice(); }
  const Lattice& deformed() const { return deformed_; }

  /// Moves the control points to new places, n x 3.
  /// @throws Error for another number of points or one that is not finite
  void move(const Points& points);
  /// Moves them further, as Deformation::parse() reads it.
  void deform(const std::string& deformation);

  void set_device(const DeviceChoice& choice) { device_ = make_device(choice); }
  const Device& device() const { return *device_; }
  void set_outside(const std::string& text) { outside_ = Outside::parse(text); }
  const Outside& outside() const { return outside_; }

  /// Where points lie in the lattice at rest (paper, eq. (2)).
  std::vector<Embedding> embed(const Points& points) const { return embedder_.embed(points); }
  /// Eq. (1) in the deformed lattice, n x 3; coordinates beyond [0, 1] are clamped.
  Points evaluate(std::vector<Embedded> vertices);
  /// Where the deformation takes points of the space at rest, n x 3 (Attachment).
  Points carry(const Points& points);
  /// Of the points that carry() took last; before, of none.
  const EmbeddingSummary& summary() const { return summary_; }

 private:
  Embedder embedder_;
  Lattice deformed_;
  Outside outside_;
  EmbeddingSummary summary_;
  std::unique_ptr<Device> device_;
};

}  // namespace hwffd
