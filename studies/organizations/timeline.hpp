#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "comparison.hpp"

namespace hwffd::organizations {

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

/// The lanes of a row from its recorded schedule, from the polynomials to the accumulator. Throws
/// std::logic_error where the clocks between the probes are not what the row's latencies say.
std::vector<Lane> lanes_of(const Row& row);

/// SVG: which unit is busy in which clock of a vertex, at the paper's schedule and below it
/// overlapped; either may be null. A colour is a vertex.
std::string timeline(const Row* paper, const Row* overlapped);

}  // namespace hwffd::organizations
