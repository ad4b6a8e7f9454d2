#include "device/model_pull_back.hpp"

#include <cmath>
#include <mutex>

#include "hwffd/model/scatter.hpp"
#include "hwffd/on_threads.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd {
namespace {

/// The smallest e with which no gradient of at most that magnitude, times 2^-e, is rounded beyond
/// the largest of so many bits.
int gradient_exponent(double largest, int width) {
  int exponent = 0;
  const double fraction = std::frexp(largest, &exponent);
  return fraction > 1 - std::ldexp(1, 1 - width) ? exponent + 1 : exponent;
}

}  // namespace

Points model_pull_back(const Configuration& row, const Index3& dims,
                       const std::vector<Embedded>& vertices, const Points& gradient,
                       const std::array<AxisWords, 3>& axes, std::uint64_t& saturated) {
  const std::unique_ptr<model::ScatterModel> scatter = model::make_scatter_model(row);
  for (int axis = 0; axis < 3; ++axis) {
    scatter->load(axis, axes[static_cast<std::size_t>(axis)]);
  }
  const int width = scatter->width();
  const WordCodec codec(row.format);
  const int exponent =
      gradient_exponent(gradient.size() == 0 ? 0 : gradient.cwiseAbs().maxCoeff(), width);
  const std::size_t points = static_cast<std::size_t>(dims[0]) * static_cast<std::size_t>(dims[1]) *
                             static_cast<std::size_t>(dims[2]);
  std::vector<std::array<std::int64_t, 3>> sums(points);
  std::mutex joining;
  const auto vertices_of_a_page = static_cast<std::size_t>(model::scatter_exact_vertices(width));
  on_ranges(vertices.size(), vertices_of_a_page, [&](std::size_t first, std::size_t end) {
    model::ScatterPage page(width, dims);
    std::uint64_t saturated_here = 0;
    for (std::size_t v = first; v < end; ++v) {
      model::GradientWords words;
      words.cell = vertices[v].cell;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto column = static_cast<Eigen::Index>(c);
        words.local[c] = codec.coordinate(vertices[v].local[column]);
        words.gradient[c] =
            codec.point(std::ldexp(gradient(static_cast<Eigen::Index>(v), column), -exponent));
      }
      const model::VertexParts parts = scatter->parts(words);
      page.add(words.cell, parts);
      if (parts.saturated) ++saturated_here;
    }
    const std::vector<model::CollectedPoint> collected = page.collect(0);
    const std::lock_guard<std::mutex> lock(joining);
    for (std::size_t point = 0; point < points; ++point) {
      for (std::size_t c = 0; c < 3; ++c) {
        sums[point][c] += static_cast<std::int32_t>(collected[point].words[c]);
      }
    }
    saturated += saturated_here;
  });
  Points result(static_cast<Eigen::Index>(points), 3);
  for (std::size_t point = 0; point < points; ++point) {
    for (std::size_t c = 0; c < 3; ++c) {
      result(static_cast<Eigen::Index>(point), static_cast<Eigen::Index>(c)) =
          std::ldexp(static_cast<double>(sums[point][c]), exponent - (width - 1));
    }
  }
  return result;
}

}  // namespace hwffd
