#include "adjoint_run.hpp"

#include <algorithm>
#include <iterator>

#include "scatter_stimulus.hpp"

namespace hwffd::test {
namespace {

/// A packet of coefficients as one without derivatives, of which it is complete where that was; or
/// none.
std::vector<Beat> without_derivatives(const std::vector<Beat>& packet) {
  if ((packet[0].words[2] & kDerivativesFollow) == 0) return packet;
  if (packet.size() < 1 + 2 * kCoefficientBeats) return {};
  std::vector<Beat> rest(packet.begin(), packet.begin() + 1 + kCoefficientBeats);
  rest.front().words[2] &= ~kDerivativesFollow;
  rest.back().last = true;
  return rest;
}

}  // namespace

AdjointModel::AdjointModel(const AdjointBuild& build)
    : has_derivatives_((build.core.features & model::kDerivativesFeature) != 0),
      evaluator_(find_configuration(build.row), build.core.features, build.core.axis,
                 build.core.pages),
      scatter_(transposed_row(find_configuration(build.row).format,
                              find_configuration(build.row).evaluator),
               build.core.axis, build.scatter_pages, build.rows) {}

std::vector<Beat> AdjointModel::run(const std::vector<Beat>& packets) {
  std::vector<Beat> results;
  for (auto next = packets.begin(); next != packets.end();) {
    auto end = std::find_if(next, packets.end(), [](const Beat& beat) { return beat.last; });
    if (end == packets.end()) throw std::invalid_argument("a packet that does not end");
    ++end;
    const std::vector<Beat> packet(next, end);
    next = end;
    const bool coefficients = opcode_of(packet) == Opcode::kCoefficients;
    const bool of_scatter = is_of_scatter(packet);
    of_scatter_.push_back(of_scatter || coefficients);
    // The scatter model counts all packets, and refuses those of the evaluator.
    const auto sums = scatter_.run(packet);
    results.insert(results.end(), sums.begin(), sums.end());
    if (of_scatter) continue;
    const model::StreamEvents before = evaluator_.events();
    const bool plain = coefficients && !has_derivatives_;
    const auto some = evaluator_.run(plain ? without_derivatives(packet) : packet);
    results.insert(results.end(), some.begin(), some.end());
    if (coefficients) continue;
    for (std::size_t code = 0; code < before.size(); ++code) {
      evaluator_events_[code] += evaluator_.events()[code] - before[code];
    }
  }
  return results;
}

void AdjointModel::reset() {
  evaluator_.reset();
  scatter_.reset();
  evaluator_events_ = {};
  of_scatter_.clear();
}

std::vector<model::ScatterEvent> AdjointModel::scatter_events() const {
  std::vector<model::ScatterEvent> events;
  std::copy_if(scatter_.events().begin(), scatter_.events().end(), std::back_inserter(events),
               [&](const model::ScatterEvent& event) { return of_scatter(event.packet); });
  return events;
}

std::vector<Beat> AdjointRun::packet_of(const LatticeWords& lattice) const {
  return has(model::kPagesFeature) ? page_packet(0, lattice) : lattice_packet(lattice);
}

std::vector<Beat> AdjointRun::packet_of(const std::vector<VertexBeat>& vertices) const {
  return has(model::kPagesFeature) ? page_vertices_packet(0, vertices) : vertices_packet(vertices);
}

void AdjointRun::send_lattice(const LatticeWords& lattice) { send(packet_of(lattice)); }

void AdjointRun::send_grid(const Grid& grid) { send(grid_packet(grid, 0, {})); }

::testing::AssertionResult AdjointRun::run() {
  if (const auto finished = finish(); !finished) return finished;
  const EventTally got = tally(events(), [&](const model::ScatterEvent& event) {
    return has_place(event) && model().of_scatter(event.packet);
  });
  EventTally expected = tally(model().scatter_events(), has_place);
  if (const auto same = same_events(got.placed, expected.placed); !same) return same;
  const std::uint64_t shared = expected.others[event::kSaturated];
  for (std::size_t code = 0; code < kStreamEvents; ++code) {
    expected.others[code] += model().evaluator_events()[code];
  }
  return as_often(got.others, expected.others, shared);
}

}  // namespace hwffd::test
