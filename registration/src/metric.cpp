#include "hwffd/registration/metric.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "axis_weights.hpp"
#include "clones.hpp"
#include "hwffd/error.hpp"
#include "lane_sum.hpp"

namespace hwffd {
namespace {

constexpr int kFewestBins = 8;
constexpr int kMostBins = 256;

double real(float x) { return static_cast<double>(x); }
double real(std::uint8_t x) { return static_cast<double>(x); }

std::size_t count_inside(const MetricSamples& samples) {
  std::size_t result = 0;
  for (std::size_t i = 0; i < samples.n; ++i) result += samples.inside[i];
  return result;
}

HWFFD_CLONES double squares(const MetricSamples& samples) {
  const float* const f = samples.fixed;
  const float* const m = samples.moving;
  const std::uint8_t* const inside = samples.inside;
  return lane_sum(samples.n, [=](std::size_t i) {
    const double off = real(inside[i]) * (real(m[i]) - real(f[i]));
    return off * off;
  });
}

/// result = inside * (a*f + b*m + c)
HWFFD_CLONES void linear(const MetricSamples& samples, double a, double b, double c,
                         double* __restrict result) {
  const float* __restrict const f = samples.fixed;
  const float* __restrict const m = samples.moving;
  const std::uint8_t* __restrict const inside = samples.inside;
  for (std::size_t i = 0; i < samples.n; ++i) {
    result[i] = real(inside[i]) * ((a * real(f[i]) + b * real(m[i])) + c);
  }
}

class MeanSquares : public Metric {
 public:
  explicit MeanSquares(const Volume& fixed) : variance_(fixed.range().variance) {}

  MetricKind kind() const override { return MetricKind::kMeanSquares; }
  bool needs_sums_first() const override { return false; }
  std::size_t sum_count() const override { return 2; }

  void add(const MetricSamples& samples, double* sums) const override {
    sums[0] += static_cast<double>(count_inside(samples));
    sums[1] += squares(samples);
  }

  double finish(const double* sums) override {
    scale_ = 2 / (sums[0] * variance_);
    return sums[1] / (sums[0] * variance_);
  }

  void derivatives(const MetricSamples& samples, double* result) const override {
    linear(samples, -1, 1, 0, result);
  }
  double scale() const override { return scale_; }

 private:
  double variance_;
  double scale_ = 0.0;
};

/// Sums are of values less the middle of their range, so that little is lost in differences.
class Correlation : public Metric {
 public:
  Correlation(const Volume& fixed, const Volume& moving)
      : fixed_(middle(fixed)), moving_(middle(moving)) {}

  MetricKind kind() const override { return MetricKind::kCorrelation; }
  bool needs_sums_first() const override { return true; }
  std::size_t sum_count() const override { return 6; }

  void add(const MetricSamples& samples, double* sums) const override {
    sums[0] += static_cast<double>(count_inside(samples));
    const auto f = [&](std::size_t i) {
      return real(samples.inside[i]) * (real(samples.fixed[i]) - fixed_);
    };
    const auto m = [&](std::size_t i) {
      return real(samples.inside[i]) * (real(samples.moving[i]) - moving_);
    };
    sums[1] += lane_sum(samples.n, f);
    sums[2] += lane_sum(samples.n, m);
    sums[3] += lane_sum(samples.n, [&](std::size_t i) { return f(i) * f(i); });
    sums[4] += lane_sum(samples.n, [&](std::size_t i) { return m(i) * m(i); });
    sums[5] += lane_sum(samples.n, [&](std::size_t i) { return f(i) * m(i); });
  }

  double finish(const double* sums) override {
    const double n = sums[0];
    const double mean_f = sums[1] / n;
    const double mean_m = sums[2] / n;
    const double ff = sums[3] - n * mean_f * mean_f;
    const double mm = sums[4] - n * mean_m * mean_m;
    const double fm = sums[5] - n * mean_f * mean_m;
    const double norm = std::sqrt(ff) * std::sqrt(mm);
    if (!(ff > 0.0) || !(mm > 0.0) || !(norm > 0.0)) return std::numeric_limits<double>::infinity();
    const double r = fm / norm;
    a_ = -1 / norm;
    b_ = r / mm;
    c_ = -(a_ * (mean_f + fixed_) + b_ * (mean_m + moving_));
    return 1 - r;
  }

  void derivatives(const MetricSamples& samples, double* result) const override {
    linear(samples, a_, b_, c_, result);
  }
  double scale() const override { return 1.0; }

 private:
  static double middle(const Volume& volume) {
    const Volume::Range range = volume.range();
    return real(range.least) / 2 + real(range.most) / 2;
  }

  double fixed_, moving_;
  double a_ = 0.0, b_ = 0.0, c_ = 0.0;
};

/// Row f of the joint histogram has the voxels whose fixed value is in bin f. A moving value is in
/// the bins around 1 + (m - least)/(most - least) * (bins - 3), by a cubic B-spline.
class MutualInformation : public Metric {
 public:
  MutualInformation(const Volume& fixed, const Volume& moving, int bins)
      : bins_(static_cast<std::size_t>(bins)), logarithms_(bins_ * bins_) {
    const Volume::Range f = fixed.range();
    const Volume::Range m = moving.range();
    fixed_least_ = real(f.least);
    fixed_scale_ = bins / (real(f.most) - fixed_least_);
    moving_least_ = real(m.least);
    moving_scale_ = (bins - 3) / (real(m.most) - moving_least_);
  }

  MetricKind kind() const override { return MetricKind::kMutualInformation; }
  bool needs_sums_first() const override { return true; }
  std::size_t sum_count() const override { return 1 + bins_ * bins_; }

  void add(const MetricSamples& samples, double* sums) const override {
    double* const histogram = sums + 1;
    for (std::size_t i = 0; i < samples.n; ++i) {
      if (samples.inside[i] == 0) continue;
      sums[0] += 1;
      const Place at = place(samples, i);
      const std::array<double, 4> w = AxisWeights::bspline(at.local);
      for (std::size_t q = 0; q < 4; ++q) histogram[at.bin + q] += w[q];
    }
  }

  double finish(const double* sums) override {
    const double n = sums[0];
    const double* const histogram = sums + 1;
    std::vector<double> of_fixed(bins_);
    std::vector<double> of_moving(bins_);
    for (std::size_t f = 0; f < bins_; ++f) {
      for (std::size_t m = 0; m < bins_; ++m) {
        of_fixed[f] += histogram[f * bins_ + m];
        of_moving[m] += histogram[f * bins_ + m];
      }
    }
    double information = 0.0;
    for (std::size_t f = 0; f < bins_; ++f) {
      for (std::size_t m = 0; m < bins_; ++m) {
        const double joint = histogram[f * bins_ + m];
        double& logarithm = logarithms_[f * bins_ + m];
        logarithm = 0.0;
        // What is smaller is the rounding of sums.
        if (!(joint > kLeast) || !(of_moving[m] > kLeast)) continue;
        logarithm = portable_log(joint / of_moving[m]);
        information += joint * (logarithm - portable_log(of_fixed[f] / n));
      }
    }
    scale_ = moving_scale_ / n;
    return -information / n;
  }

  void derivatives(const MetricSamples& samples, double* result) const override {
    for (std::size_t i = 0; i < samples.n; ++i) {
      result[i] = 0.0;
      if (samples.inside[i] == 0) continue;
      const Place at = place(samples, i);
      const double* const row = logarithms_.data() + at.bin;
      const double x = at.local;
      const double y = 1 - x;
      const double outer = y * y / 2;
      const double last = x * x / 2;
      const double second = x * (1.5 * x - 2);
      const double third = (x - 1.5 * x * x) + 0.5;
      result[i] = (outer * row[0] - second * row[1]) - (third * row[2] + last * row[3]);
    }
  }
  double scale() const override { return scale_; }

 private:
  static constexpr double kLeast = 1e-300;

  struct Place {
    std::size_t bin;  ///< of the histogram, the first of four
    double local;
  };

  Place place(const MetricSamples& samples, std::size_t i) const {
    const double f = (real(samples.fixed[i]) - fixed_least_) * fixed_scale_;
    const double m = (real(samples.moving[i]) - moving_least_) * moving_scale_;
    const auto row = static_cast<std::size_t>(std::clamp(f, 0.0, static_cast<double>(bins_ - 1)));
    const double at = std::clamp(m, 0.0, static_cast<double>(bins_ - 3));
    const std::size_t cell = std::min(static_cast<std::size_t>(at), bins_ - 4);
    return {row * bins_ + cell, at - static_cast<double>(cell)};
  }

  std::size_t bins_;
  double fixed_least_, fixed_scale_, moving_least_, moving_scale_;
  std::vector<double> logarithms_;  ///< of p(f, m) / p(m)
  double scale_ = 0.0;
};

}  // namespace

const std::vector<std::string>& metric_names() {
  static const std::vector<std::string> names{"mean-squares", "correlation", "mutual-information"};
  return names;
}

const std::string& metric_name(MetricKind kind) {
  return metric_names()[static_cast<std::size_t>(kind)];
}

MetricKind parse_metric(std::string_view name) {
  const auto& names = metric_names();
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) {
    throw UsageError(
        fmt::format("metric '{}': unknown; give {}", name, fmt::join(metric_names(), ", ")));
  }
  return static_cast<MetricKind>(at - names.begin());
}

std::unique_ptr<Metric> make_metric(MetricKind kind, const Volume& fixed, const Volume& moving,
                                    int bins) {
  check_not_constant(fixed);
  check_not_constant(moving);
  switch (kind) {
    case MetricKind::kMeanSquares:
      return std::make_unique<MeanSquares>(fixed);
    case MetricKind::kCorrelation:
      return std::make_unique<Correlation>(fixed, moving);
    case MetricKind::kMutualInformation:
      break;
  }
  if (bins < kFewestBins || bins > kMostBins) {
    throw UsageError(fmt::format("bins {}: give {} to {}", bins, kFewestBins, kMostBins));
  }
  return std::make_unique<MutualInformation>(fixed, moving, bins);
}

double portable_log(double x) {
  // x = m * 2^e with m in [sqrt(1/2), sqrt(2)).
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  int exponent = static_cast<int>(bits >> 52) - 1023;
  bits = (bits & 0x000FFFFFFFFFFFFFULL) | 0x3FF0000000000000ULL;
  double m = 0.0;
  std::memcpy(&m, &bits, sizeof m);
  if (m > 1.4142135623730951) {
    m *= 0.5;
    ++exponent;
  }
  // log(1 + f) = f - f^2/2 + s*(f^2/2 + R) with s = f/(2 + f), R = sum of 2 s^2n/(2n + 1), n >= 1.
  const double f = m - 1;
  const double s = f / (2 + f);
  const double z = s * s;
  double r = 0.0;
  for (int n = 11; n > 0; --n) r = z * (2.0 / (2 * n + 1) + r);
  const double half = 0.5 * f * f;
  // log(2) in two, the first of so few bits that its product with an exponent is exact.
  constexpr double kHigh = 0x1.62e42fee00000p-1;
  constexpr double kLow = 0x1.a39ef35793c76p-33;
  const double e = exponent;
  return e * kHigh - ((half - (s * (half + r) + e * kLow)) - f);
}

}  // namespace hwffd
