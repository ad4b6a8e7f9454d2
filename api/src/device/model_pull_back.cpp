#include "device/model_pull_back.hpp"

#include <algorithm>
#include <mutex>

#include "device/gradient_sums.hpp"
#include "hwffd/model/scatter.hpp"
#include "hwffd/on_threads.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd {
namespace {

std::unique_ptr<model::ScatterModel> loaded_scatter(const Configuration& row,
                                                    const std::array<AxisWords, 3>& axes) {
  std::unique_ptr<model::ScatterModel> scatter = model::make_scatter_model(row);
  for (int axis = 0; axis < 3; ++axis) {
    scatter->load(axis, axes[static_cast<std::size_t>(axis)]);
  }
  return scatter;
}

}  // namespace

Points model_pull_back(const Configuration& row, const Index3& dims,
                       const std::vector<Embedded>& vertices, const Points& gradient,
                       const std::array<AxisWords, 3>& axes, std::uint64_t& saturated) {
  const std::unique_ptr<model::ScatterModel> scatter = loaded_scatter(row, axes);
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

Points model_pull_back_rows(const Configuration& row, const Index3& dims, const Grid& grid,
                            const Points& gradient, const std::array<AxisWords, 3>& axes,
                            std::uint64_t& saturated) {
  const std::unique_ptr<model::ScatterModel> scatter = loaded_scatter(row, axes);
  const int width = scatter->width();
  const auto places = axis_places(grid, dims, WordCodec(row.format));
  const std::unique_ptr<model::RowPlaces> along_s = scatter->row_places(places[0], -1);
  GradientSums sums(row.format, width, dims, gradient);
  std::mutex joining;
  const std::size_t of_row = grid.count[0];
  const auto most = static_cast<std::size_t>(model::scatter_most_vertices(width));
  // Few enough that no sum overflows; and not all, so that threads have something to share.
  const std::size_t rows_of_a_page = std::max<std::size_t>(1, most / 8 / of_row);
  const std::size_t rows = std::size_t{grid.count[1]} * grid.count[2];
  on_ranges(rows, rows_of_a_page, [&](std::size_t first, std::size_t end) {
    model::ScatterPage page(width, dims);
    model::ScatterRow sums_of_row(*scatter);
    std::uint64_t saturated_here = 0;
    for (std::size_t r = first; r < end; ++r) {
      const AxisPlace& t = places[1][r % grid.count[1]];
      const AxisPlace& u = places[2][r / grid.count[1]];
      model::GradientWords vertex;
      vertex.local = {0, t.local, u.local};
      vertex.cell = {0, t.cell, u.cell};
      for (std::size_t a = 0; a < of_row; ++a) {
        vertex.cell[0] = places[0][a].cell;
        const model::VertexLayers layers = along_s->layers(a, sums.words(r * of_row + a));
        if (sums_of_row.add(vertex, layers)) ++saturated_here;
      }
      for (const bool layer : sums_of_row.end(page)) saturated_here += layer ? 1 : 0;
    }
    const std::lock_guard<std::mutex> lock(joining);
    for (std::size_t point = 0; point < sums.points(); ++point) {
      sums.add_sum(point, {page.sum(point, 0), page.sum(point, 1), page.sum(point, 2)});
    }
    saturated += saturated_here;
  });
  return sums.result();
}

}  // namespace hwffd
