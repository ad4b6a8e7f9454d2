#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hwffd/registration/volume.hpp"

namespace hwffd {

/// How much two images differ: a number that is less the better they are aligned.
///
/// - `mean-squares`: the mean of (f - m)^2, in parts of the variance of the fixed image
/// - `correlation`: 1 - r, where r is the coefficient of correlation (normalised correlation)
/// - `mutual-information`: minus the mutual information in nats, of a joint histogram with a cubic
///   B-spline as the Parzen window of the moving image (Mattes et al. 2003)
enum class MetricKind { kMeanSquares, kCorrelation, kMutualInformation };

/// @throws UsageError for a name that is none of metric_names(), which it lists
MetricKind parse_metric(std::string_view name);
const std::vector<std::string>& metric_names();
const std::string& metric_name(MetricKind kind);

/// Voxels of the fixed image and what the moving one has where they are taken to.
struct MetricSamples {
  std::size_t n = 0;
  const float* fixed = nullptr;
  const float* moving = nullptr;
  const std::uint8_t* inside = nullptr;  ///< 0: the voxel does not count
};

/// A metric of the images of one level. A pass over all voxels makes sums, in double and in a fixed
/// order: voxels of a block in theirs, blocks of a slab in theirs, and slabs (voxel_map.hpp) in
/// theirs. Of the sums come the value, and what the metric is to each voxel:
///
///     metric.begin();
///     for each slab: sums(slab) = vector(sum_count(), 0); for each block: metric.add(samples,
///     sums(slab)) value = metric.finish(sum of sums(slab)) for each block:
///     metric.derivatives(samples, d)   d[i] * scale() = dM/dm_i
///
/// add() and derivatives() are const: several threads call them at once.
class Metric {
 public:
  virtual ~Metric() = default;

  virtual MetricKind kind() const = 0;
  /// Whether derivatives() wants finish() before it. If not, one pass makes sums and derivatives.
  virtual bool needs_sums_first() const = 0;
  /// Numbers that a pass adds up; the first is the number of voxels that count.
  virtual std::size_t sum_count() const = 0;
  /// Adds what voxels have to sums.
  virtual void add(const MetricSamples& samples, double* sums) const = 0;
  /// The value of the metric, of the sums of all voxels, at least one of which counts.
  /// +infinity where there is none, as of a correlation where one image is constant.
  virtual double finish(const double* sums) = 0;
  /// What the value changes by with each moving value, but for scale(); 0 of a voxel that does not
  /// count. Changes of the number of voxels that count are no part of it.
  virtual void derivatives(const MetricSamples& samples, double* result) const = 0;
  /// After finish().
  virtual double scale() const = 0;
};

/// @param bins  of mutual information, an axis of the joint histogram, 8 to 256
/// @throws Error for a constant image, UsageError for bins out of range
std::unique_ptr<Metric> make_metric(MetricKind kind, const Volume& fixed, const Volume& moving,
                                    int bins = 32);

/// The natural logarithm of a positive normal number, by additions, multiplications and a division:
/// the same bits wherever IEEE-754 holds, off by less than 2 ulp, or 2^-53 around 1.
double portable_log(double x);

}  // namespace hwffd
