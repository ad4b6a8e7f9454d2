#pragma once

#include <optional>
#include <string>
#include <vector>

#include "synthesis.hpp"

namespace hwffd::organizations {

/// One organization on one target: its area, and how many vertices come out.
struct Throughput {
  std::string name;  ///< of the row
  std::string org;   ///< as a picture calls it
  std::string format;
  Area area;
  double interval;  ///< clocks from a vertex to the next

  /// Nothing where the clock is not known.
  std::optional<double> per_second() const;
  double per_clock() const { return 1 / interval; }
  /// Vertices per second, or per clock where the clock is not known.
  double rate() const { return per_second().value_or(per_clock()); }
  double per_size() const { return rate() / area.size; }
  /// Nothing on a target without multipliers, or where none is used.
  std::optional<double> per_multiplier() const;
};

/// Those of one target that no other beats: none is as fast and smaller, or as small and faster; by
/// size. Rates with and without a clock are not compared.
std::vector<const Throughput*> front(const std::vector<Throughput>& rows);

/// Targets, in the order in which they come.
std::vector<std::string> targets(const std::vector<Throughput>& rows);

/// One line a row; says which command makes the report if there are none.
std::string area_table(const std::vector<Throughput>& rows);

}  // namespace hwffd::organizations
