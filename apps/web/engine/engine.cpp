#include "engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/lattice/coordinates.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/stream/packets.hpp"

namespace hwffd::web {
namespace {

/// Counts the words of the core that differ from the model's.
void compare(Deformed& deformed, const std::vector<Beat>& rtl, const std::vector<Beat>& model) {
  deformed.words = 4 * model.size();
  for (std::size_t v = 0; v < model.size(); ++v) {
    for (int word = 0; word < 4; ++word) {
      const std::uint32_t got = rtl[v].words[word];
      const std::uint32_t expected = model[v].words[word];
      if (got == expected) continue;
      if (deformed.mismatches++ == 0) deformed.first = Mismatch{v, word, got, expected};
    }
  }
}

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
    if (points >= 4 && points <= kAxisPoints) continue;
    throw Error(fmt::format("lattice: {} points along an axis; take 4 to {}", points, kAxisPoints));
  }
  dims_ = dims;
  if (has_mesh()) rest();
}

void Engine::rest() {
  lattice_ = box_->lattice(dims_);
  embedded_ = box_->embed(dims_, positions_);
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

std::vector<std::size_t> Engine::order() const {
  std::vector<std::size_t> order(embedded_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (!keeps_cell(*row_)) return order;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return embedded_[a].cell < embedded_[b].cell;
  });
  return order;
}

Deformed Engine::deform() {
  check_mesh();
  if (core_ == nullptr) throw Error("mesh: there is no core to deform it; open one first");
  const WordCodec codec(row_->format);
  const Normalization normalization = Normalization::of(*lattice_, codec);
  if (inside_->begun()) core_->reset();
  std::vector<Beat> commands = coefficients_packet(watertight_bspline(codec), codec);
  append(commands, lattice_packet(lattice_words(*lattice_, codec, normalization)));
  std::vector<std::size_t> sent = order();
  std::vector<Embedded> embedded;
  embedded.reserve(sent.size());
  for (const std::size_t vertex : sent) embedded.push_back(embedded_[vertex]);
  std::vector<Beat> vertices = vertices_packets(vertex_beats(embedded, codec));
  append(commands, vertices);
  std::vector<Beat> expected = model_->run(commands);
  const Answers answers = core_->run(commands, expected.size());

  Deformed deformed;
  compare(deformed, answers.beats, expected);
  if (deformed.first) deformed.first->vertex = sent[deformed.first->vertex];
  const Points positions = positions_of(answers.beats, codec, normalization);
  deformed.positions.resizeLike(positions);
  for (std::size_t v = 0; v < sent.size(); ++v) {
    deformed.positions.row(static_cast<Eigen::Index>(sent[v])) =
        positions.row(static_cast<Eigen::Index>(v));
  }
  deformed.clocks = answers.clocks;
  const std::size_t gaps = std::max<std::size_t>(expected.size(), 2) - 1;
  deformed.clocks_per_vertex =
      static_cast<double>(answers.clocks - answers.first) / static_cast<double>(gaps);
  deformed.saturated = static_cast<std::uint64_t>(
      std::count_if(answers.beats.begin(), answers.beats.end(),
                    [](const Beat& beat) { return (beat.words[3] & kStatusSaturated) != 0; }));
  inside_->begin({std::move(vertices), std::move(expected), std::move(sent)});
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
