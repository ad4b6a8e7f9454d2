#pragma once

#include <array>
#include <vector>

#include "hwffd/registration/volume.hpp"

namespace hwffd {

/// Fewest voxels that an axis keeps when it is halved.
constexpr int kFewestHalved = 8;

/// A volume of an image pyramid.
struct PyramidLevel {
  Volume volume;
  std::array<int, 3>
      halvings;  ///< times that each axis was halved: voxel n is voxel n * 2^halvings
};

/// A volume halved along axes where `axes` says so: smoothed there by (1 4 6 4 1)/16, the outermost
/// voxels repeated beyond the volume, then every second voxel, from the first on. So n voxels
/// become (n + 1)/2, rounded down, and voxel m of these is voxel 2m of those, where the mask is
/// that of that voxel too. With a mask only voxels that count are smoothed, by weights that sum to
/// one (normalized convolution). Sums are made in float, in a fixed order. It takes 3/4 of the
/// volume's memory, and with a mask 3/4 more.
/// @throws Error where no voxel of the mask is left
Volume halved(const Volume& volume, const std::array<bool, 3>& axes);

/// A volume smoothed by (1 2 1)/4 along each axis, the outermost voxels repeated beyond it; with a
/// mask only voxels that count, as halved() does.
Volume smoothed(const Volume& volume);

/// A volume whose voxels that do not count have what smoothed() gives them of neighbours that do,
/// and the others what they had: between voxels nothing is seen of what does not count.
Volume filled(const Volume& volume);

/// The image pyramid of a volume: `levels` volumes, the coarsest first, the last the volume itself.
/// Each is halved() from the next along the axes that have at least kFewestHalved voxels after it;
/// others stay, such as the one slice of an image of two dimensions.
/// @throws Error for levels below 1, and where a level has no axis that can be halved: it says how
///   many levels there can be
std::vector<PyramidLevel> pyramid(const Volume& volume, int levels);

/// Levels that a pyramid of so many voxels an axis can have.
int most_levels(const Index3& counts);

}  // namespace hwffd
