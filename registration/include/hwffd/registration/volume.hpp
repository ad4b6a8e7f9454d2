#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "hwffd/points.hpp"

namespace hwffd {

/// An affine map of three coordinates, x -> linear * x + offset. Its inverse and products are
/// written out, in an order that no vector unit changes: their bits are the same on any processor.
struct AffineMap {
  std::array<std::array<double, 3>, 3> linear{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< rows
  std::array<double, 3> offset{0, 0, 0};

  /// Of a 4 x 4 matrix, whose last row is 0 0 0 1.
  /// @throws Error for another last row, and for a number that is not finite
  static AffineMap of(const Eigen::Matrix4d& matrix);

  std::array<double, 3> operator()(const std::array<double, 3>& x) const;
  double determinant() const;
  /// @throws Error where the determinant is 0 or not finite
  AffineMap inverse() const;
};

/// The map that does `first`, and `then` to what that gives.
AffineMap composed(const AffineMap& then, const AffineMap& first);

/// A volume: numbers of binary32 in voxels along i, j and k, i fastest, and where these lie. An
/// image of two dimensions has one voxel along one axis.
///
/// Values and mask are shared, never copied or changed: a volume may show memory of somebody else,
/// such as an array of Python that the pointer holds.
class Volume {
 public:
  using Values = std::shared_ptr<const float[]>;
  using Mask = std::shared_ptr<const std::uint8_t[]>;

  /// @param name  that errors give it: "fixed image"
  /// @param counts  voxels along i, j, k, at least 1 each
  /// @param values  counts[0]*counts[1]*counts[2], i fastest
  /// @param to_point  from the index of a voxel's centre to its point, in units of length
  /// @param mask  as many bytes; only voxels where it is not 0 count. None: all do
  /// @throws Error, one line that names the volume and the cure: a count below 1; more than 2^31
  ///   voxels; voxels that are NaN or infinite (how many, and the first); a mask that is 0
  ///   everywhere; a map to points that is not invertible
  Volume(std::string name, const Index3& counts, Values values, const AffineMap& to_point,
         Mask mask = nullptr);
  /// The same of vectors, which are moved from.
  /// @throws Error as well for another number of values or bytes than counts say
  Volume(std::string name, const Index3& counts, std::vector<float> values,
         const AffineMap& to_point, std::vector<std::uint8_t> mask = {});

  const std::string& name() const { return name_; }
  const Index3& counts() const { return counts_; }
  std::size_t size() const;
  const float* values() const { return values_.get(); }
  /// Null where all voxels count.
  const std::uint8_t* mask() const { return mask_.get(); }
  const AffineMap& to_point() const { return to_point_; }

  /// The least and the largest value of voxels that count, and their variance.
  struct Range {
    float least, most;
    double variance;
    std::size_t voxels;  ///< that count
  };
  Range range() const;

 private:
  void check() const;

  std::string name_;
  Index3 counts_;
  Values values_;
  AffineMap to_point_;
  Mask mask_;
};

/// @throws Error for a volume all of whose voxels that count have one value: nothing can be
///   registered by it
void check_not_constant(const Volume& volume);

}  // namespace hwffd
