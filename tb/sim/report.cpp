#include "report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace hwffd::sim {

std::string table_header() {
  return fmt::format("{:<10} {:<6} {:<11} {:<12} {:<10} {:>8} {:>10} {:>13} {:>10} {:>10}", "org",
                     "format", "schedule", "stream", "deform", "checked", "mismatches",
                     "clocks/vertex", "max error", "rms error");
}

std::string table_line(const RunResult& r, const std::string& stream) {
  return fmt::format("{:<10} {:<6} {:<11} {:<12} {:<10} {:>8} {:>10} {:>13.2f} {:>10.2e} {:>10.2e}",
                     r.row.org, r.row.format, r.row.schedule, stream, r.deform, r.checked,
                     r.mismatches, r.clocks_per_vertex, r.max_error, r.rms_error);
}

std::string bus_line(const tb::BusUtilisation& bus) {
  return fmt::format(
      "  bus: {:.1f} % used: {} beats read ({:.1f} %), {} written ({:.1f} %) in {} clocks",
      100 * bus.both(), bus.read_beats, 100 * bus.read(), bus.write_beats, 100 * bus.write(),
      bus.clocks());
}

std::string faults(const RunResult& r) {
  if (!r.failure.empty()) return r.failure + "\n";
  const std::string name = fmt::format("{} {}", r.row.name, r.deform);
  if (r.checked == 0 || r.mismatches > 0) {
    return fmt::format("{}: {} of {} results differ from the model\n", name, r.mismatches,
                       r.checked);
  }
  if (!std::isfinite(r.max_error)) return fmt::format("{}: positions are no numbers\n", name);
  return "";
}

std::string json_report(const Scene& scene, const Options& options,
                        const std::vector<RunResult>& results) {
  nlohmann::ordered_json runs = nlohmann::ordered_json::array();
  for (const RunResult& r : results) {
    runs.push_back({{"org", r.row.org},
                    {"format", r.row.format},
                    {"schedule", r.row.schedule},
                    {"stream", options.stream},
                    {"deform", r.deform},
                    {"checked", r.checked},
                    {"mismatches", r.mismatches},
                    {"clocks_per_vertex", r.clocks_per_vertex},
                    {"max_error", r.max_error},
                    {"rms_error", r.rms_error}});
    if (r.bus) runs.back()["bus_utilisation"] = r.bus->both();
  }
  const nlohmann::ordered_json report = {{"model", scene.mesh.name()},
                                         {"vertices", scene.mesh.vertex_count()},
                                         {"runs", std::move(runs)}};
  return report.dump(2) + "\n";
}

}  // namespace hwffd::sim
