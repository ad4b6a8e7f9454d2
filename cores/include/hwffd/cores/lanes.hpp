#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hwffd/model/configuration.hpp"

namespace hwffd::cores {

/// Units of one kind, and when they hold an operation.
struct Lane {
  struct Span {
    std::uint64_t begin;
    std::uint64_t end;
    std::size_t vertex;
  };
  std::string name;
  std::vector<Span> spans;  ///< in the order of their beginnings
};

/// When an operation enters a pipeline, and of which vertex it is.
struct Entry {
  std::uint64_t clock;
  std::size_t vertex;
};

/// What the probes of cores/rtl/ffd_bench.vlt showed from one clock to another; of several lanes
/// the first.
struct Schedule {
  std::vector<Entry> polynomials;                  ///< their starts
  std::optional<std::vector<Entry>> combinations;  ///< where there is a generator of these
  std::vector<Entry> steps;                        ///< ScheduleRecorder::steps
  std::vector<std::uint64_t> sums;
  std::vector<Entry> results;  ///< of vertices; of `walk` only they are looked at
  std::uint64_t begin = 0;
  std::uint64_t end = 0;  ///< the first clock that was not looked at
};

/// What of a core a row does not say.
struct Units {
  int evaluators;    ///< of polynomials, in all lanes
  int read_latency;  ///< of its points
};

/// The lanes of a row, from the polynomials to the accumulator. Throws std::logic_error where the
/// clocks between the probes are not what the row's latencies say.
std::vector<Lane> lanes_of(const Configuration& row, const Units& units, const Schedule& schedule);

}  // namespace hwffd::cores
