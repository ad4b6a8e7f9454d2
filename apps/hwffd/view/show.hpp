#pragma once

#include <functional>

#include "hwffd/device/device.hpp"
#include "hwffd/lattice/outside.hpp"
#include "hwffd/mesh/mesh.hpp"

namespace hwffd::view {

/// A mesh in a lattice.
struct Scene {
  Mesh mesh;
  Family family;     ///< of blending functions
  Lattice rest;      ///< in which the mesh is embedded, once
  Lattice deformed;  ///< as it is at the beginning, and after a reset
  Outside outside;
};

/// Opens a window in which the user drags the lattice's points and sees the mesh follow (Controls),
/// and returns when it is closed. Its title says the device and the frames a second.
/// @param device  evaluates the mesh anew for each frame in which the lattice has moved
/// @param save    what the key S does with the lattice
/// @throws Error where there is no display (Window), and what Deformer and `save` throw
void show(Scene scene, Device& device, const std::function<void(const Lattice&)>& save);

}  // namespace hwffd::view
