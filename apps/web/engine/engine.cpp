#include "engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/lattice/coordinates.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/stream/grid.hpp"
#include "hwffd/stream/packets.hpp"

namespace hwffd::web {
namespace {

constexpr std::size_t kBatch = 65'536;  // vertices at once: a multiple of kPacketVertices

/// Counts the words of the core that differ from the model's, of these vertices.
void compare(Deformed& deformed, std::size_t first, const std::vector<Beat>& rtl,
             const std::vector<Beat>& model) {
  deformed.words += 4 * model.size();
  for (std::size_t v = 0; v < model.size(); ++v) {
    for (int word = 0; word < 4; ++word) {
      const std::uint32_t got = rtl[v].words[word];
      const std::uint32_t expected = model[v].words[word];
      if (got == expected) continue;
      if (deformed.mismatches++ == 0) deformed.first = Mismatch{first + v, word, got, expected};
    }
  }
}

/// Rows of a grid of a lattice from face to face, with as many vertices in a cell as the planes of
/// control points take clocks that a row wants.
Grid rows_of(const Index3& dims) {
  constexpr int kPlane = 4, kFirst = 3;  // clocks; planes of a row beside one a cell
  const std::array<int, 3> cells = {dims[0] - kFirst, dims[1] - kFirst, dims[2] - kFirst};
  const int in_cell = (kPlane * (cells[0] + kFirst) + cells[0] - 1) / cells[0];
  return grid_between(
      {0, 0, 0},
      {static_cast<double>(cells[0]), static_cast<double>(cells[1]), static_cast<double>(cells[2])},
      {in_cell * cells[0], 4, 4});
}

bool is_saturated(const Beat& result) { return (result.words[3] & kStatusSaturated) != 0; }

}  // namespace

void Engine::open(const std::string& name) {
  const Configuration& row = find_configuration(name);
  const bool stuck = core_ != nullptr && core_->fault();
  inside_.reset();
  core_ = std::make_unique<RunningCore>(row);
  core_->set_fault(stuck);
  inside_ = std::make_unique<Inside>(*core_, row);
  inside_->watch(watched_);
  model_ = std::make_unique<model::StreamModel>(row);
  row_ = &row;
}

void Engine::set_mesh(const Points& positions) {
  const auto count = static_cast<std::size_t>(positions.rows());
  if (count == 0) throw Error("mesh: it has no vertices; take one that has some");
  if (count > kMostVertices) {
    throw Error(
        fmt::format("mesh: it has {} vertices; take one with {} at most", count, kMostVertices));
  }
  check_coordinates("vertex", positions);
  box_ = Box::around(positions);
  positions_ = positions;
  rest();
}

void Engine::set_dims(const Index3& dims) {
  for (const int points : dims) {
    if (points >= Lattice::kMinPoints && points <= kAxisPoints) continue;
    throw Error(fmt::format("lattice: {} points along an axis; take {} to {}", points,
                            Lattice::kMinPoints, kAxisPoints));
  }
  dims_ = dims;
  if (has_mesh()) rest();
}

void Engine::rest() {
  lattice_ = box_->lattice(dims_);
  embedded_ = box_->embed(dims_, positions_);
}

const Lattice& Engine::lattice() const {
  check_mesh();
  return *lattice_;
}

void Engine::set_points(const Points& points) {
  check_mesh();
  lattice_ = Lattice(dims_, points);
}

void Engine::set_shape(const std::string& deformation) {
  check_mesh();
  const Lattice rest = box_->lattice(dims_);
  lattice_ = deformation.empty() ? rest : Deformation::parse(deformation).apply(rest);
}

void Engine::set_fault(bool on) {
  if (core_ == nullptr) throw Error("fault: there is no core; open one first");
  core_->set_fault(on);
}

void Engine::check_mesh() const {
  if (!has_mesh()) throw Error("lattice: there is no mesh that it is around; give one first");
}

Traffic Engine::deform(std::size_t first, std::size_t end, const StreamWords& words,
                       std::vector<Beat> commands, Deformed& deformed) {
  const std::vector<Embedded> embedded(embedded_.begin() + static_cast<std::ptrdiff_t>(first),
                                       embedded_.begin() + static_cast<std::ptrdiff_t>(end));
  std::vector<Beat> packets = vertices_packets(vertex_beats(embedded, words.codec));
  append(commands, packets);
  std::vector<Beat> expected = model_->run(commands);
  const Answers answers = core_->run(commands, expected.size());
  compare(deformed, first, answers.beats, expected);
  deformed.positions.middleRows(static_cast<Eigen::Index>(first),
                                static_cast<Eigen::Index>(end - first)) =
      positions_of(answers.beats, words.codec, words.normalization);
  if (deformed.clocks == 0) deformed.first_result = answers.first;
  deformed.clocks += answers.clocks;
  deformed.saturated += static_cast<std::uint64_t>(
      std::count_if(answers.beats.begin(), answers.beats.end(), is_saturated));
  return {std::move(packets), std::move(expected)};
}

Traffic Engine::rows(const WordCodec& codec) {
  Traffic traffic{vertices_packets(grid_vertices(rows_of(dims_), dims_, codec)), {}};
  traffic.results = model_->run(traffic.commands);
  return traffic;
}

Deformed Engine::deform() {
  check_mesh();
  if (core_ == nullptr) throw Error("mesh: there is no core to deform it; open one first");
  const WordCodec codec(row_->format);
  const StreamWords words{codec, Normalization::of(*lattice_, codec)};
  if (inside_->begun()) core_->reset();
  std::vector<Beat> commands = coefficients_packet(watertight_bspline(codec), codec);
  append(commands, lattice_packet(lattice_words(*lattice_, codec, words.normalization)));
  const std::size_t all = embedded_.size();
  Deformed deformed;
  deformed.positions.resizeLike(positions_);
  std::optional<Traffic> first;
  for (std::size_t next = 0; next < all; next += kBatch) {
    const std::size_t end = std::min<std::size_t>(next + kBatch, all);
    Traffic traffic = deform(next, end, words, std::move(commands), deformed);
    commands.clear();
    if (!first) first = std::move(traffic);
  }
  const std::size_t gaps = std::max<std::size_t>(all, 2) - 1;
  deformed.clocks_per_vertex =
      static_cast<double>(deformed.clocks - deformed.first_result) / static_cast<double>(gaps);
  inside_->begin(walks(*row_) ? rows(codec) : std::move(*first));
  return deformed;
}

Inside& Engine::inside() {
  if (inside_ == nullptr) throw Error("core: there is none; open one first");
  return *inside_;
}

void Engine::watch(const std::vector<std::string>& names) {
  inside().watch(names);
  watched_ = names;
}

}  // namespace hwffd::web
