#include "compare/report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace hwffd::compare {
namespace {

using Json = nlohmann::ordered_json;

template <class Row>
std::string error_fault(const std::string& name, const Row& row) {
  if (row.error <= row.bound) return "";
  return fmt::format("{}: error {:.2e}, bound {:.2e}\n", name, row.error, row.bound);
}

}  // namespace

std::string json_report(const Measured& measured) {
  Json software = Json::array();
  for (const SoftwareRow& row : measured.software) {
    software.push_back({{"what", row.what},
                        {"sorted", row.sorted},
                        {"vertices_per_s", row.vertices_per_s},
                        {"error", row.error},
                        {"latency_ns", row.latency_ns > 0 ? Json(row.latency_ns) : Json()},
                        {"bytes_per_vertex", row.bytes_per_vertex}});
  }
  Json cores = Json::array();
  for (const CoreRow& row : measured.cores) {
    cores.push_back({{"name", row.row.name},
                     {"sorted", row.sorted},
                     {"vertices", row.vertices},
                     {"clocks_per_vertex", row.clocks_per_vertex},
                     {"latency_clocks", row.latency_clocks},
                     {"bytes_per_vertex", row.bytes_per_vertex},
                     {"error", row.error},
                     {"mismatches", row.mismatches}});
  }
  const Json report{{"vertices", measured.vertices},
                    {"vector_units", vector_units()},
                    {"software", std::move(software)},
                    {"cores", std::move(cores)}};
  return report.dump(2) + "\n";
}

std::string faults(const Measured& measured) {
  std::string text;
  if (measured.software.empty()) text += "no program was measured\n";
  for (const SoftwareRow& row : measured.software) {
    if (!(row.vertices_per_s > 0)) text += row.what + ": no vertex was evaluated\n";
    text += error_fault(row.what, row);
  }
  for (const CoreRow& row : measured.cores) {
    if (!row.failure.empty()) text += fmt::format("{}: {}\n", row.row.name, row.failure);
    if (row.mismatches != 0) {
      text += fmt::format("{}: {} results differ from the model\n", row.row.name, row.mismatches);
    }
    if (!(row.clocks_per_vertex > 0) || row.latency_clocks == 0) {
      text += fmt::format("{}: no clock was counted\n", row.row.name);
    }
    text += error_fault(row.row.name, row);
  }
  return text;
}

}  // namespace hwffd::compare
