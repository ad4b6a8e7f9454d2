#include "synthesis.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "hwffd/error.hpp"

namespace hwffd::organizations {
namespace {

using Json = nlohmann::json;

/// A number of a row; nothing where it is null or missing.
std::optional<double> figure(const Json& row, const char* field) {
  const auto found = row.find(field);
  if (found == row.end() || found->is_null()) return std::nullopt;
  return found->get<double>();
}

/// The first size that the target counts; nothing if it counts none.
std::optional<Area> area_of(const Json& row) {
  constexpr std::pair<const char*, const char*> kSizes[] = {
      {"lut", "LUTs"}, {"area_um2", "um2"}, {"cells", "cells"}};
  for (const auto& [field, unit] : kSizes) {
    const std::optional<double> size = figure(row, field);
    if (!size || *size <= 0) continue;
    return Area{row.at("target"), unit, *size, figure(row, "dsp"), figure(row, "fmax_mhz")};
  }
  return std::nullopt;
}

}  // namespace

Areas read_areas(const std::filesystem::path& path) {
  Areas areas;
  std::ifstream in(path);
  if (!in) return areas;
  try {
    const Json report = Json::parse(in);
    for (const Json& row : report.at("rows")) {
      if (row.at("top") != "ffd_org_select") continue;
      if (const auto area = area_of(row)) areas[row.at("name")].push_back(*area);
    }
  } catch (const Json::exception&) {
    throw Error(fmt::format("{}: no report of areas: run make synth again", path.string()));
  }
  return areas;
}

}  // namespace hwffd::organizations
