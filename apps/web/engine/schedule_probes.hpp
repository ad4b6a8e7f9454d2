#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "hwffd/cores/lanes.hpp"
#include "hwffd/cores/signal.hpp"
#include "hwffd/model/configuration.hpp"
#include "signal_table.hpp"

namespace hwffd::web {

/// The schedule of a running core, from the probes of cores/rtl/ffd_bench.vlt: of several lanes the
/// first, of all clocks the last ones. Vertices are numbered as they enter, from 0.
class ScheduleProbes {
 public:
  /// Clocks that are kept: those shown, and those in which what is shown then has begun.
  static constexpr std::uint64_t kWindow = 1024;

  /// Throws Error where the core lacks a probe.
  ScheduleProbes(const SignalTable& signals, const Configuration& row);

  /// Looks at the probes; once a clock, when the core has settled.
  void sample(std::uint64_t clock);

  cores::Schedule schedule() const;

 private:
  using Entries = std::deque<cores::Entry>;

  /// A counter of steps, which takes in vertices.
  struct Sequencer {
    cores::Signal valid;
    cores::Signal first;
    std::uint64_t contexts = 1;        ///< vertices in turn, a clock each
    std::vector<std::size_t> turns{};  ///< the vertex of each
    std::size_t entered = 0;
    Entries starts{};
  };

  /// Of `walk`: which vertices want planes of points, and when each is taken out of its queue. Its
  /// sum comes so many clocks later as that of the first one did.
  struct Walk {
    cores::Signal goes;    ///< a vertex, into the queue
    cores::Signal planes;  ///< that it wants, 0 to 4
    cores::Signal takes;   ///< one, out of it
    cores::Signal result;
    std::size_t entered = 0;
    std::size_t taken = 0;
    std::deque<std::size_t> wanted{};  ///< for each plane that is to come, its vertex
    Entries takings{};
    std::optional<std::uint64_t> latency{};
  };

  void look(Sequencer& sequencer, std::uint64_t clock);
  void look_at_walk(std::uint64_t clock);

  std::vector<Sequencer> sequencers_;  ///< polynomials, and behind them combinations if there are
  std::optional<Walk> walk_;
  cores::Signal step_;
  cores::Signal sum_;
  std::deque<std::size_t> on_the_way_;  ///< vertices of steps that have begun
  Entries steps_;
  std::deque<std::uint64_t> sums_;
  std::uint64_t begin_ = 0;
  std::uint64_t end_ = 0;
};

}  // namespace hwffd::web
