#include "device/model_pull_back.hpp"

#include <mutex>

#include "device/gradient_sums.hpp"
#include "hwffd/model/scatter.hpp"
#include "hwffd/on_threads.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd {

Points model_pull_back(const Configuration& row, const Index3& dims,
                       const std::vector<Embedded>& vertices, const Points& gradient,
                       const std::array<AxisWords, 3>& axes, std::uint64_t& saturated) {
  const std::unique_ptr<model::ScatterModel> scatter = model::make_scatter_model(row);
  for (int axis = 0; axis < 3; ++axis) {
    scatter->load(axis, axes[static_cast<std::size_t>(axis)]);
  }
  const int width = scatter->width();
  const WordCodec codec(row.format);
  GradientSums sums(row.format, width, dims, gradient);
  std::mutex joining;
  const auto vertices_of_a_page = static_cast<std::size_t>(model::scatter_exact_vertices(width));
  on_ranges(vertices.size(), vertices_of_a_page, [&](std::size_t first, std::size_t end) {
    model::ScatterPage page(width, dims);
    std::uint64_t saturated_here = 0;
    for (std::size_t v = first; v < end; ++v) {
      model::GradientWords words;
      words.cell = vertices[v].cell;
      words.gradient = sums.words(v);
      for (std::size_t c = 0; c < 3; ++c) {
        words.local[c] = codec.coordinate(vertices[v].local[static_cast<Eigen::Index>(c)]);
      }
      const model::VertexParts parts = scatter->parts(words);
      page.add(words.cell, parts);
      if (parts.saturated) ++saturated_here;
    }
    const std::vector<model::CollectedPoint> collected = page.collect(0);
    const std::lock_guard<std::mutex> lock(joining);
    for (std::size_t point = 0; point < collected.size(); ++point) {
      sums.add(point, collected[point].words);
    }
    saturated += saturated_here;
  });
  return sums.result();
}

}  // namespace hwffd
