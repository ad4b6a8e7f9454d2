#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/on_threads.hpp"
#include "level_evaluator.hpp"

namespace hwffd {

struct LevelEvaluator::Buffers {
  explicit Buffers(std::size_t n) : x(n), y(n), z(n), derivative(n), moving(n), inside(n) {}

  std::vector<double> x, y, z;  ///< places, then gradients
  std::vector<double> derivative;
  std::vector<float> moving;
  std::vector<std::uint8_t> inside;
};

class LevelEvaluator::Loan {
 public:
  explicit Loan(LevelEvaluator& from) : from_(from) {
    const std::lock_guard<std::mutex> lock(from.lending_);
    if (from.free_.empty()) {
      buffers_ = std::make_unique<Buffers>(from.map_->most_voxels());
    } else {
      buffers_ = std::move(from.free_.back());
      from.free_.pop_back();
    }
  }
  ~Loan() {
    const std::lock_guard<std::mutex> lock(from_.lending_);
    from_.free_.push_back(std::move(buffers_));
  }
  Loan(const Loan&) = delete;
  Loan& operator=(const Loan&) = delete;

  Buffers& operator*() const { return *buffers_; }

 private:
  LevelEvaluator& from_;
  std::unique_ptr<Buffers> buffers_;
};

LevelEvaluator::LevelEvaluator(const Volume& fixed, const Volume& moving, const VoxelGrid& grid,
                               MetricKind kind, int bins, const VoxelMapFactory& map)
    : fixed_(fixed),
      to_index_(moving.to_point().inverse()),
      sampler_(moving),
      metric_(make_metric(kind, fixed, moving, bins)),
      map_(map(grid)) {}

LevelEvaluator::~LevelEvaluator() = default;

void LevelEvaluator::for_slabs(const std::function<void(std::size_t)>& work) const {
  const std::size_t count = map_->slabs().size();
  if (map_->concurrent()) {
    on_threads(count, work);
    return;
  }
  for (std::size_t slab = 0; slab < count; ++slab) {
    work(slab);
    Watch::look();
  }
}

void LevelEvaluator::sample(const VoxelBlock& block, bool with_gradient, Buffers& buffers,
                            MetricSamples& samples) const {
  const VoxelGrid& grid = map_->grid();
  const std::size_t n = VoxelMap::voxels(grid, block);
  double* const x = buffers.x.data();
  double* const y = buffers.y.data();
  double* const z = buffers.z.data();
  map_->positions(block, x, y, z);
  if (with_gradient) {
    sampler_.gradients(n, x, y, z, buffers.moving.data(), buffers.inside.data(), x, y, z);
  } else {
    sampler_.values(n, x, y, z, buffers.moving.data(), buffers.inside.data());
  }
  const std::size_t first =
      (static_cast<std::size_t>(block.k) * static_cast<std::size_t>(grid.counts[1]) +
       static_cast<std::size_t>(block.j)) *
      static_cast<std::size_t>(grid.counts[0]);
  if (fixed_.mask() != nullptr) {
    for (std::size_t i = 0; i < n; ++i) {
      if (fixed_.mask()[first + i] == 0) buffers.inside[i] = 0;
    }
  }
  samples = {n, fixed_.values() + first, buffers.moving.data(), buffers.inside.data()};
}

std::vector<double> LevelEvaluator::total() const {
  std::vector<double> result(metric_->sum_count());
  for (const std::vector<double>& sums : sums_) {
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += sums[i];
  }
  return result;
}

MetricEvaluation LevelEvaluator::run(const Points& points, bool with_gradient) {
  Points indices(points.rows(), 3);
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    const auto index = to_index_({points(row, 0), points(row, 1), points(row, 2)});
    for (std::size_t c = 0; c < 3; ++c) indices(row, static_cast<int>(c)) = index[c];
  }
  map_->set_points(indices);
  const std::vector<VoxelSlab>& slabs = map_->slabs();
  const bool single_pass = with_gradient && !metric_->needs_sums_first();
  sums_.assign(slabs.size(), std::vector<double>(metric_->sum_count()));
  const auto finish = [&] {
    const std::vector<double> sums = total();
    MetricEvaluation result;
    result.voxels = static_cast<std::uint64_t>(sums[0]);
    if (result.voxels > 0) result.metric = metric_->finish(sums.data());
    return result;
  };
  MetricEvaluation result;
  if (!single_pass) {
    for_slabs([&](std::size_t slab) {
      const Loan buffers(*this);
      MetricSamples samples;
      for (std::size_t block = slabs[slab].block; block < slabs[slab].block_end; ++block) {
        sample(map_->blocks()[block], false, *buffers, samples);
        metric_->add(samples, sums_[slab].data());
      }
    });
    result = finish();
    if (!with_gradient || !std::isfinite(result.metric)) return result;
  }
  std::vector<std::unique_ptr<SlabSums>> gradients(slabs.size());
  for_slabs([&](std::size_t slab) {
    const Loan loan(*this);
    Buffers& buffers = *loan;
    MetricSamples samples;
    const auto transpose = map_->transpose(slabs[slab]);
    for (std::size_t b = slabs[slab].block; b < slabs[slab].block_end; ++b) {
      const VoxelBlock& block = map_->blocks()[b];
      sample(block, true, buffers, samples);
      if (single_pass) metric_->add(samples, sums_[slab].data());
      metric_->derivatives(samples, buffers.derivative.data());
      for (std::vector<double>* along : {&buffers.x, &buffers.y, &buffers.z}) {
        double* const g = along->data();
        for (std::size_t i = 0; i < samples.n; ++i) g[i] *= buffers.derivative[i];
      }
      transpose->add(block, buffers.x.data(), buffers.y.data(), buffers.z.data());
    }
    gradients[slab] = std::make_unique<SlabSums>(map_->grid().dims, slabs[slab]);
    transpose->finish(*gradients[slab]);
  });
  if (single_pass) result = finish();
  if (!std::isfinite(result.metric)) return result;
  Points sum = Points::Zero(points.rows(), 3);
  for (const auto& slab : gradients) slab->add_to(sum);
  // To points from indices, the transpose of to_index_.
  result.gradient.resize(points.rows(), 3);
  const double scale = metric_->scale();
  for (Eigen::Index row = 0; row < sum.rows(); ++row) {
    for (std::size_t c = 0; c < 3; ++c) {
      result.gradient(row, static_cast<int>(c)) =
          scale * (to_index_.linear[0][c] * sum(row, 0) + to_index_.linear[1][c] * sum(row, 1) +
                   to_index_.linear[2][c] * sum(row, 2));
    }
  }
  return result;
}

VoxelGrid voxel_grid(const Index3& counts, const std::array<int, 3>& halvings,
                     const Index3& halved_counts, const Index3& dims) {
  VoxelGrid grid;
  grid.counts = halved_counts;
  grid.dims = dims;
  for (std::size_t a = 0; a < 3; ++a) {
    const double cells = dims[a] - 3;
    grid.first[a] = 0.5 * cells / counts[a];
    grid.step[a] = std::ldexp(cells, halvings[a]) / counts[a];
  }
  return grid;
}

class MetricEvaluator::Implementation {
 public:
  template <class... Arguments>
  explicit Implementation(Arguments&&... arguments) : level(arguments...) {}
  LevelEvaluator level;
};

MetricEvaluator::MetricEvaluator(const Volume& fixed, const Volume& moving, const Index3& dims,
                                 MetricKind kind, int bins, const VoxelMapFactory& map)
    : implementation_(std::make_unique<Implementation>(
          fixed, moving, voxel_grid(fixed.counts(), {0, 0, 0}, fixed.counts(), dims), kind, bins,
          map)) {}

MetricEvaluator::~MetricEvaluator() = default;

MetricEvaluation MetricEvaluator::operator()(const Points& points, bool with_gradient) {
  const Index3& dims = map().grid().dims;
  const auto wanted = static_cast<Eigen::Index>(dims[0]) * dims[1] * dims[2];
  if (points.rows() != wanted) {
    throw Error(fmt::format("metric: {} control points; give {} x {} x {}", points.rows(), dims[0],
                            dims[1], dims[2]));
  }
  return implementation_->level.run(points, with_gradient);
}

const VoxelMap& MetricEvaluator::map() const { return implementation_->level.map(); }

}  // namespace hwffd
