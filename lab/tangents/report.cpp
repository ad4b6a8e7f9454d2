#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace hwffd::tangents {

std::string json_report(const std::vector<RowResult>& rows) {
  std::size_t vertices = 0;
  std::uint64_t mismatches = 0;
  std::size_t seam_values = 0;
  std::size_t seam_differences = 0;
  std::size_t wrong_flags = 0;
  double max_error = 0;
  bool finite_difference_ok = true;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const RowResult& r : rows) {
    vertices += r.vertices;
    mismatches += r.mismatches;
    seam_values += r.seam_values;
    seam_differences += r.seam_differences;
    wrong_flags += r.wrong_flags;
    max_error = std::max(max_error, r.max_error);
    finite_difference_ok = finite_difference_ok && r.finite_difference_ok();
    list.push_back({{"name", r.row.name},
                    {"org", r.row.org},
                    {"format", r.row.format},
                    {"vertices", r.vertices},
                    {"mismatches", r.mismatches},
                    {"clocks_per_vertex", r.clocks_per_vertex},
                    {"max_error", r.max_error},
                    {"bound", r.bound},
                    {"max_difference", r.max_difference},
                    {"finite_difference_ok", r.finite_difference_ok()},
                    {"max_determinant_error", r.max_determinant_error},
                    {"determinant_bound", r.determinant_bound},
                    {"upright", r.upright},
                    {"folded", r.folded},
                    {"wrong_flags", r.wrong_flags},
                    {"seam_values", r.seam_values},
                    {"seam_differences", r.seam_differences}});
  }
  const nlohmann::ordered_json report{{"vertices", vertices},
                                      {"max_error", max_error},
                                      {"finite_difference_ok", finite_difference_ok},
                                      {"seam_values", seam_values},
                                      {"seam_differences", seam_differences},
                                      {"wrong_flags", wrong_flags},
                                      {"mismatches", mismatches},
                                      {"rows", std::move(list)}};
  return report.dump(2) + "\n";
}

std::string faults(const RowResult& r) {
  std::string text;
  const auto require = [&](bool holds, const std::string& what) {
    if (!holds) text += fmt::format("{}: {}\n", r.row.name, what);
  };
  require(r.failure.empty(), r.failure);
  require(r.mismatches == 0, fmt::format("{} results differ from the model", r.mismatches));
  require(r.max_error <= r.bound,
          fmt::format("error of a derivative {:.2e}, bound {:.0e}", r.max_error, r.bound));
  require(r.finite_difference_ok(),
          fmt::format("{:.2e} from central differences", r.max_difference));
  require(r.max_determinant_error <= r.determinant_bound,
          fmt::format("error of det J {:.2e}, bound {:.0e}", r.max_determinant_error,
                      r.determinant_bound));
  require(r.wrong_flags == 0, fmt::format("{} wrong fold flags", r.wrong_flags));
  require(r.seam_differences == 0,
          fmt::format("{} of {} values differ on seams", r.seam_differences, r.seam_values));
  require(r.seam_values >= kSeamValues && r.upright > 0 && r.folded > 0,
          fmt::format("too little tried: {} vertices upright, {} folded, {} values on seams",
                      r.upright, r.folded, r.seam_values));
  return text;
}

}  // namespace hwffd::tangents
