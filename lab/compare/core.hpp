#pragma once

#include <cstdint>
#include <string>

#include "compare/scene.hpp"
#include "hwffd/model/configuration.hpp"

namespace hwffd::compare {

/// What the RTL of a whole core took for vertices of a resident lattice, at streams that never
/// wait.
struct CoreRow {
  Configuration row;
  bool sorted = false;
  std::size_t vertices = 0;
  double clocks_per_vertex = 0;
  std::uint64_t latency_clocks = 0;  ///< of one alone, from being accepted to its result
  double bytes_per_vertex = 0;       ///< of vertices' packets and results, without the lattice
  double error = 0;                  ///< the largest of a component, against the oracle
  double bound = 0;                  ///< that it is held to
  std::uint64_t mismatches = 0;      ///< results that are not the model's
  std::string failure;               ///< the bench's report of a run that failed
};

/// Runs hwffd_stream of a row: one vertex by itself, then all of a scene.
/// @param seed  of the registers
CoreRow count(const Configuration& row, const Scene& scene, bool sorted, std::uint64_t seed);

}  // namespace hwffd::compare
