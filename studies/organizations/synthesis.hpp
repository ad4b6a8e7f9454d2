#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hwffd::organizations {

/// What an organization costs on a target.
struct Area {
  std::string target;
  std::string unit;  ///< of the size: "LUTs", "um2" or "cells"
  double size;
  std::optional<double> multipliers;
  std::optional<double> clock_mhz;
};

/// The areas of a row of the table of configurations, by its name.
using Areas = std::map<std::string, std::vector<Area>>;

/// What `make synth` says of organizations; nothing if it has not been run.
/// @throws Error  for a file that is no such report
Areas read_areas(const std::filesystem::path& path);

}  // namespace hwffd::organizations
