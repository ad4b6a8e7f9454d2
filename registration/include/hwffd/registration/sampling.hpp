#pragma once

#include <cstddef>
#include <cstdint>

#include "hwffd/registration/volume.hpp"

namespace hwffd {

/// Values of a volume between its voxels, with their gradients.
///
/// A place is in the volume if its index is in [-0.5, n - 0.5) along each axis of n voxels and,
/// with a mask, the mask of the nearest voxel is not 0; half a voxel between two belongs to the
/// upper one. Between the centres of voxels values are trilinear; from the outermost centres to the
/// outer faces they are constant, and their gradient along that axis is 0. So along an axis of one
/// voxel values are constant.
///
/// Each place gives the same bits wherever it stands among others, on any processor.
class LinearSampler {
 public:
  /// @param volume  stays alive as long as the sampler
  explicit LinearSampler(const Volume& volume);

  /// Values at n places, in voxels of the volume.
  /// @param inside  1 where the place is in the volume; elsewhere 0, as the value
  /// @return how many are
  std::size_t values(std::size_t n, const double* x, const double* y, const double* z,
                     float* values, std::uint8_t* inside) const;

  /// The same, and the gradient of the value with respect to the place, per voxel of the volume;
  /// 0 outside. It may replace the places: gx == x and so on.
  std::size_t gradients(std::size_t n, const double* x, const double* y, const double* z,
                        float* values, std::uint8_t* inside, double* gx, double* gy,
                        double* gz) const;

 private:
  template <bool kGradients>
  std::size_t run(std::size_t n, const double* x, const double* y, const double* z, float* values,
                  std::uint8_t* inside, double* gx, double* gy, double* gz) const;

  const Volume& volume_;
};

}  // namespace hwffd
