#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "hwffd/model/stream_model.hpp"
#include "page_stimulus.hpp"
#include "scatter_run.hpp"

namespace hwffd::test {

/// A simulated `hwffd_adjoint`.
struct AdjointBuild {
  std::string name;  ///< adjoint_<first cell of its row in CMakeLists.txt>
  const char* row;
  PageCore core;      ///< of its evaluator
  int scatter_pages;  ///< of sums
  std::unique_ptr<cores::StreamCore> (*make)(std::uint64_t seed);
};

inline void PrintTo(const AdjointBuild& build, std::ostream* out) { *out << build.name; }

/// All of them, which CMake makes of its table.
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
  /// Whether events of that packet, since reset, are in `scatter_events`.
  bool of_scatter(std::uint32_t packet) const { return of_scatter_.at(packet); }

 private:
  bool has_derivatives_;
  model::StreamModel evaluator_;
  model::ScatterStreamModel scatter_;
  model::StreamEvents evaluator_events_{};
  std::vector<bool> of_scatter_;  // of each packet
};

/// Such a core, its models and the bench between them.
class AdjointRun {
 public:
  AdjointRun(const AdjointBuild& build, std::uint64_t seed, const std::string& source = "always",
             const std::string& sink = "always");

  bool has(std::uint32_t feature) const { return (build_.core.features & feature) != 0; }
  const Configuration& row() const { return find_configuration(build_.row); }
  const WordCodec& codec() const { return codec_; }
  tb::StreamBench& bench() { return *bench_; }
  bool idle() const { return core_.idle(); }
  /// Beats sent since reset.
  std::size_t sent() const { return sent_; }

  /// Appends whole packets to the command stream, and what the models make of them.
  void send(const std::vector<Beat>& packets);
  /// Functions of a family, with derivatives, on all axes.
  void send_functions(const std::string& family = "bspline");
  /// The lattice of the page that `send_grid` evaluates.
  void send_lattice(const LatticeWords& lattice);
  void send_grid(const Grid& grid);
  /// To the end: every bit of every result, and how often each event came. Places of those of
  /// coefficients, gradients and collects as in `ScatterRun`; of others the packet is one of the
  /// evaluator.
  ::testing::AssertionResult run();
  void reset(std::uint64_t cycles = 1);

  /// All pulses of the core.
  const std::vector<model::ScatterEvent>& events() const { return core_.log(); }

 private:
  AdjointBuild build_;
  WordCodec codec_;
  EventLog core_;
  AdjointModel model_;
  std::unique_ptr<tb::StreamBench> bench_;
  std::size_t sent_ = 0;
};

}  // namespace hwffd::test
