#include "device/model_grid.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <vector>

#include "device/function_words.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/model/evaluator.hpp"
#include "hwffd/on_threads.hpp"

namespace hwffd {
namespace {

constexpr std::size_t kVerticesAtOnce = 4096;  // whose results stay in the caches

std::unique_ptr<model::EvaluatorModel> model_of(const Configuration& row,
                                                const std::array<AxisWords, 3>& axes) {
  std::unique_ptr<model::EvaluatorModel> model = model::make_evaluator_model(row);
  for (int axis = 0; axis < 3; ++axis) {
    const AxisWords& words = axes[axis];
    for (int function = 0; function < 4; ++function) {
      model->load(0, axis, function, words.degree, words.shift, words.word[function]);
    }
  }
  return model;
}

model::ResidentPoints resident(const LatticeWords& lattice) {
  model::ResidentPoints points;
  points.dims = lattice.dims;
  points.exponent = lattice.exponent;
  points.points.reserve(lattice.points.size());
  for (const auto& point : lattice.points) {
    points.points.push_back({point[0], point[1], point[2], 0});
  }
  return points;
}

}  // namespace

ModelGrid evaluate_on_model(const Configuration& row, const std::string& device,
                            const Lattice& lattice, const Grid& grid,
                            const Device::Blending& blending, const Progress& progress) {
  const WordCodec codec(row.format);
  const Normalization normalization = Normalization::of(lattice, codec, origin_for(blending));
  const auto model = model_of(row, function_words(blending, codec, row, device));
  const model::ResidentPoints points = resident(lattice_words(lattice, codec, normalization));
  const auto walker = model->walker(0, points, axis_places(grid, lattice.dims(), codec));

  const std::size_t of_row = grid.count[0];
  const std::size_t rows = std::size_t{grid.count[1]} * grid.count[2];
  const std::size_t at_once = std::max<std::size_t>(1, kVerticesAtOnce / of_row);
  const std::size_t parts = (rows + at_once - 1) / at_once;
  ModelGrid result{Points(static_cast<Eigen::Index>(vertex_count(grid)), 3), 0};
  std::atomic<std::uint64_t> saturated{0};
  on_threads(
      parts,
      [&](std::size_t part) {
        const std::size_t first = part * at_once;
        std::vector<model::ResultWords> words;
        walker->evaluate(first, std::min(rows, first + at_once), words);
        std::uint64_t beyond = 0;
        auto position = static_cast<Eigen::Index>(first * of_row);
        for (const model::ResultWords& of : words) {
          const Point stream{codec.decode_point(of.words[0]), codec.decode_point(of.words[1]),
                             codec.decode_point(of.words[2])};
          result.positions.row(position++) = normalization.to_world(stream);
          beyond += of.saturated ? 1 : 0;
        }
        saturated += beyond;
      },
      [&](std::size_t done) { progress(static_cast<double>(done) / static_cast<double>(parts)); });
  result.saturated = saturated;
  return result;
}

}  // namespace hwffd
