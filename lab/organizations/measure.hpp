#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hwffd/model/configuration.hpp"
#include "hwffd/tb/schedule_recorder.hpp"

namespace hwffd::organizations {

/// How much of a row is simulated.
struct Effort {
  std::size_t vertices = 4001;      ///< random ones; 41 more than a multiple of 120
  std::size_t seam_values = 60000;  ///< components of vertices that cells share
  std::uint64_t seed = 1;
};

/// Clocks of one vertex, counted in the RTL.
struct VertexClocks {
  /// From the start of its first polynomial to its last sum: that of the tree where the next vertex
  /// starts before the accumulator has ended, else the accumulator's.
  std::uint64_t clocks = 0;
  /// Clocks of the accumulator that remain after that.
  std::uint64_t final_accumulation = 0;
};

/// What a run of a row showed.
struct Measurement {
  std::uint64_t checked = 0;  ///< results compared with the model
  std::uint64_t mismatches = 0;
  std::string first_mismatch;
  double max_error = 0;  ///< of a component, against eq. (1) in double; points in [-1, 1)
  double interval = 0;   ///< clocks between results
  VertexClocks vertex;   ///< of a vertex in a row of them
  std::size_t seam_values = 0;
  std::size_t seam_differences = 0;
  tb::ScheduleRecorder schedule;  ///< of the first vertices, from a core at rest
};

/// Clocks of vertex `index` of those recorded.
VertexClocks vertex_clocks(const tb::ScheduleRecorder& schedule, std::size_t index);

/// Runs the row's RTL. Throws std::invalid_argument where this build does not have it.
Measurement measure(const Configuration& row, const Effort& effort);

}  // namespace hwffd::organizations
