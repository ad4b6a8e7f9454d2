#include "device/stream_device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "device/function_words.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/packets.hpp"

namespace hwffd {
namespace {

constexpr std::size_t kMostBeats = 4096;  // between two looks at who waits; a model likes many

class ModelStream final : public CommandStream {
 public:
  ModelStream(const Configuration& row, const PointStore& store, bool grids)
      : model_(row, features_of(store, grids), store.axis_points,
               store.pages > 0 ? store.pages : kPages),
        store_(store),
        grids_(grids) {}

  std::vector<Beat> run(const std::vector<Beat>& commands, std::size_t results,
                        const Progress& progress, std::size_t steps) override {
    std::vector<Beat> out;
    out.reserve(results);
    const std::size_t step = std::min(commands.size() / steps + 1, kMostBeats);
    for (std::size_t first = 0; first < commands.size(); first += step) {
      const std::size_t end = std::min(commands.size(), first + step);
      append(out, model_.run({commands.begin() + static_cast<std::ptrdiff_t>(first),
                              commands.begin() + static_cast<std::ptrdiff_t>(end)}));
      progress(static_cast<double>(end) / static_cast<double>(commands.size()));
    }
    return out;
  }

  void reset() override { model_.reset(); }
  PointStore store() const override { return store_; }
  bool has_grids() const override { return grids_; }

 private:
  static std::uint32_t features_of(const PointStore& store, bool grids) {
    return model::kAllFeatures | (grids ? model::kGridsFeature : 0U) |
           (store.pages > 0 ? model::kPagesFeature : 0U) |
           (store.axis_points > kSmallAxisPoints ? model::kLargeFeature : 0U);
  }

  model::StreamModel model_;
  PointStore store_;
  bool grids_;
};

}  // namespace

std::unique_ptr<CommandStream> model_stream(const Configuration& row, const PointStore& store,
                                            bool grids) {
  return std::make_unique<ModelStream>(row, store, grids);
}

StreamDevice::StreamDevice(const std::string& kind, const Configuration& row,
                           std::unique_ptr<CommandStream> stream)
    : name_(kind + " " + row.name),
      row_(row),
      stream_(std::move(stream)),
      store_(stream_->store()) {
  if (store_.pages > 0) pages_.emplace(store_);
}

int StreamDevice::axis_points() const {
  return pages_ ? store_.axis_points : std::min(store_.axis_points, kSmallAxisPoints);
}

bool StreamDevice::takes_whole(const Index3& dims) const {
  return !pages_ && *std::max_element(dims.begin(), dims.end()) <= axis_points();
}

StreamDevice::Questions StreamDevice::asked_in_order(std::size_t vertices, std::uint32_t tag,
                                                     std::size_t packet) {
  Questions asked;
  asked.reserve(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    const bool ends = (v + 1) % packet == 0 || v + 1 == vertices;
    asked.push_back({(tag + static_cast<std::uint32_t>(v)) & kTagMask, ends});
  }
  return asked;
}

StreamDevice::Questions StreamDevice::asked_by_page(const PagedVertices& paged,
                                                    const std::vector<LatticePage>& pages) {
  Questions asked;
  asked.reserve(paged.from.size());
  for (const std::size_t p : paged.sent) {
    const std::size_t count = paged.of_page[p].size();
    for (std::size_t v = 0; v < count; ++v) {
      const auto tag = static_cast<std::uint32_t>(paged.from[asked.size()]);
      const bool ends = (v + 1) % kPacketVertices == 0 || v + 1 == count;
      asked.push_back({tag & (is_large(pages[p].lattice) ? kLargeTagMask : kTagMask), ends});
    }
  }
  return asked;
}

std::vector<Beat> StreamDevice::answer(const std::vector<Beat>& commands, const Questions& asked,
                                       std::size_t each) {
  std::vector<Beat> beats;
  try {
    beats = stream_->run(
        commands, asked.size() * each, [&](double done) { show(done); },
        shows() ? CommandStream::kStepsSeen : 1);
    check(beats, asked, each);
  } catch (...) {
    if (pages_) pages_->forget();  // a reset that fails may have been one
    stream_->reset();
    throw;
  }
  for (const Beat& beat : beats) {
    if ((beat.words[3] & kStatusSaturated) != 0) ++counts_.saturated;
  }
  counts_.clocks = stream_->clocks();
  return beats;
}

void StreamDevice::check(const std::vector<Beat>& beats, const Questions& asked,
                         std::size_t each) const {
  const std::size_t vertices = asked.size();
  const auto expected = [&](std::size_t b) {
    const Asked& vertex = asked[b / each];
    return (beats[b].words[3] & kTagMask) == vertex.tag &&
           beats[b].last == (vertex.ends && b % each == each - 1);
  };
  std::size_t good = 0;
  while (good < std::min(beats.size(), vertices * each) && expected(good)) ++good;
  if (good == vertices * each && good == beats.size()) return;
  throw Error(
      fmt::format("{}: {} results for {} vertices, {} of them asked for before the first that was "
                  "not; this is a fault of the hardware: please report it",
                  name_, beats.size(), vertices, good));
}

std::vector<Beat> StreamDevice::answer(const std::array<AxisWords, 3>& axes,
                                       const LatticeWords& lattice,
                                       const std::vector<VertexBeat>& vertices, Results results) {
  const bool derivatives = results != Results::kPosition;
  std::vector<Beat> commands =
      coefficients_packet(axes, derivatives ? Functions::kDerivativesToo : Functions::kBlending);
  if (takes_whole(lattice.dims)) {
    append(commands, lattice_packet(lattice));
    append(commands, vertices_packets(vertices, results));
    return answer(commands, asked_in_order(vertices.size()), results_of(results));
  }
  const std::vector<LatticePage> pages = pages_of(lattice, axis_points());
  PagedVertices paged = by_page(vertices, lattice.dims, axis_points());
  append(commands, pages_ ? pages_->packets(pages, paged, OutsideMode::kClamp, results)
                          : page_packets(pages, paged, OutsideMode::kClamp, results));
  return in_order(answer(commands, asked_by_page(paged, pages), results_of(results)), paged,
                  results);
}

Points StreamDevice::run(const Lattice& lattice, const std::vector<Embedded>& vertices,
                         const Device::Blending& blending) {
  const WordCodec codec(row_.format);
  const Normalization normalization = Normalization::of(lattice, codec, origin_for(blending));
  return positions_of(answer(function_words(blending, codec, row_, name_),
                             lattice_words(lattice, codec, normalization),
                             vertex_beats(vertices, codec), Results::kPosition),
                      codec, normalization);
}

Points StreamDevice::run_grid(const Lattice& lattice, const Grid& grid, const Blending& blending) {
  if (!stream_->has_grids() || !takes_whole(lattice.dims())) {
    return Device::run_grid(lattice, grid, blending);
  }
  const WordCodec codec(row_.format);
  const Normalization normalization = Normalization::of(lattice, codec, origin_for(blending));
  std::vector<Beat> commands = coefficients_packet(function_words(blending, codec, row_, name_));
  append(commands, lattice_packet(lattice_words(lattice, codec, normalization)));
  append(commands, grid_packet(grid));
  const std::size_t count = vertex_count(grid);
  return positions_of(answer(commands, asked_in_order(count, grid.tag, count), 1), codec,
                      normalization);
}

Device::Tangents StreamDevice::run_tangents(const Lattice& lattice,
                                            const std::vector<Embedded>& vertices,
                                            const Device::Blending& blending) {
  const WordCodec codec(row_.format);
  const Normalization normalization = Normalization::of(lattice, codec, origin_for(blending));
  const std::array<AxisWords, 3> axes = function_words(blending, codec, row_, name_);
  const std::vector<Beat> beats = answer(axes, lattice_words(lattice, codec, normalization),
                                         vertex_beats(vertices, codec), Results::kDerivatives);
  constexpr std::size_t kEach = results_of(Results::kDerivatives);
  Tangents tangents{positions_of(beats, codec, normalization, kEach), {}};
  tangents.jacobians.resize(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Point derivative = point_of(beats[kEach * v + 1 + axis], codec);
      tangents.jacobians[v].col(static_cast<Eigen::Index>(axis)) =
          std::ldexp(1.0, axes[axis].derivative.exponent) *
          normalization.vector_to_world(derivative);
    }
  }
  return tangents;
}

Points StreamDevice::run(const std::vector<SupportedVertex>& vertices,
                         const Device::Blending& blending) {
  const WordCodec codec(row_.format);
  Points points(64 * static_cast<Eigen::Index>(vertices.size()), 3);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    points.middleRows<64>(64 * static_cast<Eigen::Index>(v)) = vertices[v].support;
  }
  const Normalization normalization = Normalization::of(points, codec, origin_for(blending));
  std::vector<Beat> commands = coefficients_packet(function_words(blending, codec, row_, name_));
  append(commands, interleaved_packets(interleave(vertices, codec, normalization)));
  return positions_of(answer(commands, asked_in_order(vertices.size()), 1), codec, normalization);
}

}  // namespace hwffd
