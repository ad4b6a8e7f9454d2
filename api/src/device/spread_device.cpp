#include "device/spread_device.hpp"

#include <algorithm>
#include <utility>

#include "device/function_words.hpp"
#include "device/model_grid.hpp"
#include "device/model_pull_back.hpp"
#include "hwffd/error.hpp"
#include "hwffd/model/scatter.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/on_threads.hpp"

namespace hwffd {
namespace {

// At once: a model loads the lattice for each, and goes on to the end of them when it is to stop.
constexpr std::size_t kVerticesOfAThread = 8192;

}  // namespace

SpreadDevice::SpreadDevice(const Configuration& row, Make make, bool rows)
    : row_(row), make_(std::move(make)), rows_(rows) {
  idle_.push_back(make_());
  name_ = idle_.front()->name();
}

std::unique_ptr<StreamDevice> SpreadDevice::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (idle_.empty()) return make_();
  std::unique_ptr<StreamDevice> model = std::move(idle_.back());
  idle_.pop_back();
  return model;
}

void SpreadDevice::give_back(std::unique_ptr<StreamDevice> model) {
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_.saturated += model->take_saturated();
  idle_.push_back(std::move(model));
}

void SpreadDevice::spread(const std::vector<Embedded>& vertices, const Part& part) {
  if (vertices.size() <= kVerticesOfAThread) {
    std::unique_ptr<StreamDevice> model = take();
    if (shows()) model->on_progress([this](double done) { show(done); });
    part(*model, vertices, 0);
    model->on_progress({});
    give_back(std::move(model));
    return;
  }
  const auto count = static_cast<double>(vertices.size());
  const std::size_t ranges = (vertices.size() + kVerticesOfAThread - 1) / kVerticesOfAThread;
  on_threads(
      ranges,
      [&](std::size_t range) {
        const std::size_t first = range * kVerticesOfAThread;
        const std::size_t end = std::min(vertices.size(), first + kVerticesOfAThread);
        std::unique_ptr<StreamDevice> model = take();
        part(*model,
             {vertices.begin() + static_cast<std::ptrdiff_t>(first),
              vertices.begin() + static_cast<std::ptrdiff_t>(end)},
             first);
        give_back(std::move(model));
      },
      [&](std::size_t done) {
        show(std::min(count, static_cast<double>(done * kVerticesOfAThread)) / count);
      });
}

Points SpreadDevice::run(const Lattice& lattice, const std::vector<Embedded>& vertices,
                         const Blending& blending) {
  Points positions(static_cast<Eigen::Index>(vertices.size()), 3);
  spread(vertices, [&](StreamDevice& model, const std::vector<Embedded>& some, std::size_t first) {
    positions.middleRows(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(some.size())) =
        model.run(lattice, some, blending);
  });
  return positions;
}

Points SpreadDevice::run_grid(const Lattice& lattice, const Grid& grid, const Blending& blending) {
  if (!contracts(row_)) return Device::run_grid(lattice, grid, blending);
  ModelGrid result =
      evaluate_on_model(row_, name_, lattice, grid, blending, [this](double done) { show(done); });
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_.saturated += result.saturated;
  return std::move(result.positions);
}

Points SpreadDevice::run(const std::vector<SupportedVertex>& vertices, const Blending& blending) {
  // Their control points are scaled together.
  std::unique_ptr<StreamDevice> model = take();
  Points positions = model->run(vertices, blending);
  give_back(std::move(model));
  return positions;
}

std::array<AxisWords, 3> SpreadDevice::pull_back_functions(const Blending& blending) const {
  if (!model::has_scatter(row_)) {
    throw Error(name_ +
                ": has no transpose; take organization affine and format fx17, or device "
                "reference");
  }
  return function_words(blending, WordCodec(row_.format), row_, name_);
}

void SpreadDevice::count_saturated(std::uint64_t vertices) {
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_.saturated += vertices;
}

Points SpreadDevice::run_pull_back(const Index3& dims, const std::vector<Embedded>& vertices,
                                   const Points& gradient, const Blending& blending) {
  std::uint64_t saturated = 0;
  Points pulled =
      model_pull_back(row_, dims, vertices, gradient, pull_back_functions(blending), saturated);
  count_saturated(saturated);
  return pulled;
}

Points SpreadDevice::run_pull_back_grid(const Index3& dims, const Grid& grid,
                                        const Points& gradient, const Blending& blending) {
  if (!rows_) return Device::run_pull_back_grid(dims, grid, gradient, blending);
  std::uint64_t saturated = 0;
  Points pulled =
      model_pull_back_rows(row_, dims, grid, gradient, pull_back_functions(blending), saturated);
  count_saturated(saturated);
  return pulled;
}

Device::Tangents SpreadDevice::run_tangents(const Lattice& lattice,
                                            const std::vector<Embedded>& vertices,
                                            const Blending& blending) {
  Tangents tangents{Points(static_cast<Eigen::Index>(vertices.size()), 3), {}};
  tangents.jacobians.resize(vertices.size());
  spread(vertices, [&](StreamDevice& model, const std::vector<Embedded>& some, std::size_t first) {
    const Tangents part = model.run_tangents(lattice, some, blending);
    tangents.positions.middleRows(static_cast<Eigen::Index>(first),
                                  static_cast<Eigen::Index>(some.size())) = part.positions;
    std::copy(part.jacobians.begin(), part.jacobians.end(),
              tangents.jacobians.begin() + static_cast<std::ptrdiff_t>(first));
  });
  return tangents;
}

}  // namespace hwffd
