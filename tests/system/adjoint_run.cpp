#include "adjoint_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "hwffd/stream/blending.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint32_t kCoefficients = 1;
constexpr std::uint32_t kGradients = 10;
constexpr std::uint32_t kCollect = 11;
constexpr std::uint32_t kDerivativesToo = 1U << 31;  // of word 2 of coefficients
constexpr std::ptrdiff_t kFunctionBeats = 12;

/// A packet of coefficients as one without derivatives, of which it is complete where that was; or
/// none.
std::vector<Beat> without_derivatives(const std::vector<Beat>& packet) {
  if ((packet[0].words[2] & kDerivativesToo) == 0) return packet;
  if (packet.size() < 1 + 2 * kFunctionBeats) return {};
  std::vector<Beat> rest(packet.begin(), packet.begin() + 1 + kFunctionBeats);
  rest.front().words[2] &= ~kDerivativesToo;
  rest.back().last = true;
  return rest;
}

}  // namespace

AdjointModel::AdjointModel(const AdjointBuild& build)
    : has_derivatives_((build.core.features & model::kDerivativesFeature) != 0),
      evaluator_(find_configuration(build.row), build.core.features, build.core.axis,
                 build.core.pages),
      scatter_(
          [&] {
            Configuration row = find_configuration("affine-fx17-overlapped");
            row.format = find_configuration(build.row).format;
            row.evaluator = find_configuration(build.row).evaluator;
            return row;
          }(),
          build.core.axis, build.scatter_pages) {}

std::vector<Beat> AdjointModel::run(const std::vector<Beat>& packets) {
  std::vector<Beat> results;
  for (auto next = packets.begin(); next != packets.end();) {
    auto end = std::find_if(next, packets.end(), [](const Beat& beat) { return beat.last; });
    if (end == packets.end()) throw std::invalid_argument("a packet that does not end");
    ++end;
    const std::vector<Beat> packet(next, end);
    next = end;
    const std::uint32_t opcode = packet[0].words[0] & 0xFF;
    const bool of_scatter = opcode == kGradients || opcode == kCollect;
    of_scatter_.push_back(of_scatter || opcode == kCoefficients);
    // The scatter model counts all packets, and refuses those of the evaluator.
    const auto sums = scatter_.run(packet);
    results.insert(results.end(), sums.begin(), sums.end());
    if (of_scatter) continue;
    const model::StreamEvents before = evaluator_.events();
    const bool plain = opcode == kCoefficients && !has_derivatives_;
    const auto some = evaluator_.run(plain ? without_derivatives(packet) : packet);
    results.insert(results.end(), some.begin(), some.end());
    if (opcode == kCoefficients) continue;
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

AdjointRun::AdjointRun(const AdjointBuild& build, std::uint64_t seed, const std::string& source,
                       const std::string& sink)
    : build_(build),
      codec_(find_configuration(build.row).format),
      core_(build.make(seed)),
      model_(build) {
  tb::StreamBenchOptions options;
  options.test = {build.name, seed, "SEED=" + std::to_string(seed)};
  options.source_throttle = source;
  options.sink_throttle = sink;
  options.probe_edges = true;
  bench_ = std::make_unique<tb::StreamBench>(core_, options);
  bench_->reset(3);
}

void AdjointRun::send(const std::vector<Beat>& packets) {
  bench_->send(packets);
  bench_->expect(model_.run(packets));
  sent_ += packets.size();
}

void AdjointRun::send_functions(const std::string& family) {
  send(coefficients_packet(hwffd::family(family, codec_), codec_, Functions::kDerivativesToo));
}

void AdjointRun::send_lattice(const LatticeWords& lattice) {
  send(has(model::kPagesFeature) ? page_packet(0, lattice) : lattice_packet(lattice));
}

void AdjointRun::send_grid(const Grid& grid) { send(grid_packet(grid, 0, {})); }

::testing::AssertionResult AdjointRun::run() {
  bench_->run();
  if (!bench_->finish()) return ::testing::AssertionFailure() << bench_->report();
  const std::vector<model::ScatterEvent> expected = model_.scatter_events();
  std::vector<model::ScatterEvent> got_placed, expected_placed;
  std::array<std::uint64_t, kStreamEvents> got{}, of_scatter{};
  for (const model::ScatterEvent& event : core_.log()) {
    if (!has_place(event)) {
      ++got.at(event.event);
    } else if (model_.of_scatter(event.packet)) {
      got_placed.push_back(event);
    } else {
      ++got.at(event.event);
    }
  }
  for (const model::ScatterEvent& event : expected) {
    if (has_place(event)) {
      expected_placed.push_back(event);
    } else {
      ++of_scatter.at(event.event);
    }
  }
  if (sorted_text(got_placed) != sorted_text(expected_placed)) {
    return ::testing::AssertionFailure() << "events of the core:\n"
                                         << sorted_text(got_placed) << "those of the model:\n"
                                         << sorted_text(expected_placed);
  }
  for (std::size_t code = 0; code < kStreamEvents; ++code) {
    const std::uint64_t most = model_.evaluator_events()[code] + of_scatter[code];
    // Two in one clock of what tells of a vertex that has added and of a word are one pulse.
    const bool shared = code == event::kSaturated && of_scatter[code] != 0;
    const std::uint64_t least = shared ? model_.evaluator_events()[code] + 1 : most;
    if (got[code] >= least && got[code] <= most) continue;
    return ::testing::AssertionFailure()
           << got[code] << " pulses of event " << code << ", " << most << " expected";
  }
  return ::testing::AssertionSuccess();
}

void AdjointRun::reset(std::uint64_t cycles) {
  bench_->reset(cycles);
  model_.reset();
  sent_ = 0;
}

}  // namespace hwffd::test
