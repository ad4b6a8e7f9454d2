#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hwffd/device/device.hpp"
#include "picture/image.hpp"
#include "picture/renderer.hpp"
#include "plates/subjects.hpp"

namespace hwffd::plates {

/// A picture of a subject whose vertices a device computed.
struct Plate {
  std::string what;  ///< "cat.3ds, twist:90"
  picture::Image image;
  std::size_t vertices = 0;    ///< that the device computed
  std::size_t mismatches = 0;  ///< of them, those that the model has elsewhere
};

/// All plates of a subject: its lattice at rest, once a view, then deformed, once a view. Both are
/// seen by the same cameras, which have both lattices and the model in their pictures.
/// @param device  evaluates the vertices that are shown
/// @param model   evaluates them again, to be compared: any double that differs is a mismatch
/// @throws Error as Device and Renderer do
std::vector<Plate> plates_of(Subject subject, Device& device, Device& model,
                             const picture::Renderer& renderer);

}  // namespace hwffd::plates
