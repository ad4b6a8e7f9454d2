#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "event_run.hpp"
#include "page_stimulus.hpp"
#include "scatter_builds.hpp"

namespace hwffd::test {

/// A simulated `hwffd_adjoint`.
struct AdjointBuild : BuiltCore {
  const char* row;
  PageCore core;      ///< of its evaluator
  int scatter_pages;  ///< of sums
  bool rows;          ///< its parameter ROWS
};

/// All of them, which CMake makes of adjoint_cores.csv.
std::vector<AdjointBuild> adjoint_builds();

/// The models of both halves side by side: each takes what is its own, and results are in the order
/// of the packets. Coefficients go to both; their events are those of the scatter model, whose
/// functions must always sum to one, and which always has derivatives.
class AdjointModel {
 public:
  explicit AdjointModel(const AdjointBuild& build);

  /// Whole packets.
  std::vector<Beat> run(const std::vector<Beat>& packets);
  void reset();

  /// Of the evaluator's packets.
  const model::StreamEvents& evaluator_events() const { return evaluator_events_; }
  /// Of coefficients, gradients and collects.
  std::vector<model::ScatterEvent> scatter_events() const;
  /// Whether those of a packet, counted since reset, are in `scatter_events`.
  bool of_scatter(std::uint32_t packet) const { return of_scatter_.at(packet); }

 private:
  bool has_derivatives_;
  model::StreamModel evaluator_;
  model::ScatterStreamModel scatter_;
  model::StreamEvents evaluator_events_{};
  std::vector<bool> of_scatter_;  // of each packet
};

/// Such a core, its models and the bench between them.
class AdjointRun : public EventRun<AdjointModel> {
 public:
  AdjointRun(const AdjointBuild& build, std::uint64_t seed, const std::string& source = "always",
             const std::string& sink = "always")
      : EventRun(build, find_configuration(build.row).format, seed, source, sink, build),
        build_(build) {}

  bool has(std::uint32_t feature) const { return (build_.core.features & feature) != 0; }
  const Configuration& row() const { return find_configuration(build_.row); }

  /// The lattice of the page that `send_grid` evaluates, and vertices in it.
  std::vector<Beat> packet_of(const LatticeWords& lattice) const;
  std::vector<Beat> packet_of(const std::vector<VertexBeat>& vertices) const;
  void send_lattice(const LatticeWords& lattice);
  void send_grid(const Grid& grid);
  /// To the end: every bit of every result, and how often each event came. Places of those of
  /// coefficients, gradients and collects as in `ScatterRun`; of others the packet is one of the
  /// evaluator.
  ::testing::AssertionResult run();

 private:
  AdjointBuild build_;
};

}  // namespace hwffd::test
