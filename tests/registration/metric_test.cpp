#include "hwffd/registration/metric.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "errors.hpp"
#include "random_numbers.hpp"

namespace hwffd {
namespace {

constexpr MetricKind kKinds[] = {MetricKind::kMeanSquares, MetricKind::kCorrelation,
                                 MetricKind::kMutualInformation};

Volume line_of(const char* name, std::vector<float> values) {
  const int n = static_cast<int>(values.size());
  return {name, {n, 1, 1}, std::move(values), {}};
}

struct Images {
  std::vector<float> fixed, moving;
  std::vector<std::uint8_t> inside;

  explicit Images(std::size_t n, std::uint64_t seed) {
    RandomNumbers random(seed);
    for (std::size_t i = 0; i < n; ++i) {
      fixed.push_back(static_cast<float>(random(100, 200)));
      moving.push_back(static_cast<float>(0.5 * static_cast<double>(fixed.back()) + random(0, 30)));
      inside.push_back(random(0, 1) < 0.8 ? 1 : 0);
    }
    // The ends of the range, so that samples can change without changing it.
    fixed[0] = moving[0] = 0;
    fixed[1] = moving[1] = 300;
  }
  MetricSamples samples() const {
    return {fixed.size(), fixed.data(), moving.data(), inside.data()};
  }
  std::unique_ptr<Metric> metric(MetricKind kind, int bins = 32) const {
    return make_metric(kind, line_of("fixed image", fixed), line_of("moving image", moving), bins);
  }
};

double value_of(Metric& metric, const MetricSamples& samples) {
  std::vector<double> sums(metric.sum_count());
  metric.add(samples, sums.data());
  return metric.finish(sums.data());
}

TEST(Metric, MeanSquaresAndCorrelationAreTheirFormulas) {
  const Images images(1003, 1);
  double n = 0, squares = 0, f = 0, m = 0, all = 0, all_squares = 0;
  for (std::size_t i = 0; i < 1003; ++i) {
    const double x = static_cast<double>(images.fixed[i]);
    all += x / 1003;
    if (images.inside[i] == 0) continue;
    const double y = static_cast<double>(images.moving[i]);
    ++n;
    squares += (x - y) * (x - y);
    f += x;
    m += y;
  }
  double ff = 0, mm = 0, fm = 0;
  for (std::size_t i = 0; i < 1003; ++i) {
    const double x = static_cast<double>(images.fixed[i]);
    all_squares += (x - all) * (x - all) / 1003;
    if (images.inside[i] == 0) continue;
    const double y = static_cast<double>(images.moving[i]);
    ff += (x - f / n) * (x - f / n);
    mm += (y - m / n) * (y - m / n);
    fm += (x - f / n) * (y - m / n);
  }
  const double mean_squares = squares / n / all_squares;
  const double correlation = 1 - fm / std::sqrt(ff * mm);
  EXPECT_NEAR(value_of(*images.metric(MetricKind::kMeanSquares), images.samples()), mean_squares,
              1e-12 * mean_squares);
  EXPECT_NEAR(value_of(*images.metric(MetricKind::kCorrelation), images.samples()), correlation,
              1e-12);
}

/// Of values in the middle of their bins with the moving image's wide apart, the B-spline window
/// spreads each over the same three bins: with two values of each image, information is that of a
/// table of two by two.
TEST(Metric, MutualInformationOfATable) {
  constexpr int kBins = 35;
  std::vector<float> fixed;
  std::vector<float> moving;
  const int table[2][2] = {{30, 10}, {5, 55}};
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 2; ++b) {
      for (int n = 0; n < table[a][b]; ++n) {
        fixed.push_back(static_cast<float>(a));
        moving.push_back(static_cast<float>(b));
      }
    }
  }
  const std::vector<std::uint8_t> inside(100, 1);
  const auto metric = make_metric(MetricKind::kMutualInformation, line_of("fixed image", fixed),
                                  line_of("moving image", moving), kBins);
  double information = 0.0;
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 2; ++b) {
      const double p = table[a][b] / 100.0;
      const double of_row = (table[a][0] + table[a][1]) / 100.0;
      const double of_column = (table[0][b] + table[1][b]) / 100.0;
      information += p * std::log(p / of_row / of_column);
    }
  }
  EXPECT_NEAR(value_of(*metric, {100, fixed.data(), moving.data(), inside.data()}), -information,
              1e-14);
}

TEST(Metric, DerivativesAreThoseOfDifferences) {
  const Images images(200, 2);
  for (const MetricKind kind : kKinds) {
    const auto metric = images.metric(kind, 16);
    value_of(*metric, images.samples());
    std::vector<double> derivatives(200);
    metric->derivatives(images.samples(), derivatives.data());
    const double scale = metric->scale();
    double largest = 0.0;
    for (std::size_t i = 2; i < 200; ++i) {
      const float step = 0x1p-6F;
      Images more = images;
      Images less = images;
      more.moving[i] += step;
      less.moving[i] -= step;
      const double width =
          static_cast<double>(more.moving[i]) - static_cast<double>(less.moving[i]);
      const double difference =
          (value_of(*metric, more.samples()) - value_of(*metric, less.samples())) / width;
      EXPECT_NEAR(derivatives[i] * scale, difference, 2e-8 + 1e-4 * std::abs(difference))
          << metric_name(kind) << ' ' << i;
      largest = std::max(largest, std::abs(difference));
      if (images.inside[i] == 0) {
        EXPECT_EQ(derivatives[i], 0.0);
      }
    }
    EXPECT_GT(largest, 1e-4) << metric_name(kind);
  }
}

TEST(Metric, IsLeastOfTheSame) {
  Images images(500, 3);
  const Images other(500, 4);
  for (const MetricKind kind : kKinds) {
    const MetricSamples same{500, images.fixed.data(), images.fixed.data(), images.inside.data()};
    const auto metric = make_metric(kind, line_of("fixed image", images.fixed),
                                    line_of("moving image", images.fixed));
    const MetricSamples differ{500, images.fixed.data(), other.fixed.data(), images.inside.data()};
    EXPECT_LT(value_of(*metric, same), value_of(*metric, differ)) << metric_name(kind);
    if (kind != MetricKind::kMutualInformation) {
      EXPECT_NEAR(value_of(*metric, same), 0.0, 1e-12);
    }
  }
}

TEST(Metric, CorrelationOfWhatIsConstantWhereItCountsIsNone) {
  Images images(64, 5);
  const auto metric = images.metric(MetricKind::kCorrelation);
  std::fill(images.moving.begin(), images.moving.end(), 7.0F);
  EXPECT_EQ(value_of(*metric, images.samples()), std::numeric_limits<double>::infinity());
}

TEST(Metric, NamesAndRefusals) {
  for (const MetricKind kind : kKinds) EXPECT_EQ(parse_metric(metric_name(kind)), kind);
  EXPECT_EQ(message_of<UsageError>([] { parse_metric("ssd"); }),
            "metric 'ssd': unknown; give mean-squares, correlation, mutual-information");
  const Images images(64, 6);
  EXPECT_EQ(message_of<UsageError>([&] { images.metric(MetricKind::kMutualInformation, 7); }),
            "bins 7: give 8 to 256");
  EXPECT_EQ(message_of<UsageError>([&] { images.metric(MetricKind::kMutualInformation, 257); }),
            "bins 257: give 8 to 256");
  const Volume flat = line_of("moving image", {3, 3, 3});
  EXPECT_ERROR(make_metric(MetricKind::kMeanSquares, line_of("fixed image", images.fixed), flat),
               "moving image: all voxels are 3; give one with contrast");
}

double ulp(double x) { return std::nextafter(std::abs(x), 1e300) - std::abs(x); }

TEST(PortableLog, IsTheLogarithm) {
  RandomNumbers random(7);
  double worst = 0.0;
  int compared = 0;
  const auto compare = [&](double x) {
    const long double wanted = std::log(static_cast<long double>(x));
    const auto off =
        static_cast<double>(std::abs(static_cast<long double>(portable_log(x)) - wanted));
    worst = std::max(worst, off / ulp(static_cast<double>(wanted)));
    ++compared;
  };
  for (int i = 0; i < 20000; ++i) {
    compare(std::ldexp(random(1, 2), static_cast<int>(random(-1000, 1000))));
    compare(random(0.5, 2));
    compare(1 + std::ldexp(random(-1, 1), -static_cast<int>(random(1, 50))));
  }
  for (const double x : {0x1p-1022, 1.7976931348623157e308, 2.0, 0.5, std::sqrt(0.5)}) compare(x);
  EXPECT_EQ(portable_log(1.0), 0.0);
  EXPECT_EQ(compared, 60005);
  EXPECT_LT(worst, 1.0);
}

}  // namespace
}  // namespace hwffd
