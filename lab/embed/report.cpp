#include "report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace hwffd::embed {
namespace {

constexpr double kLargestResidual = 1e-9;  // in parts of the lattice's size

}  // namespace

std::string json_report(const std::vector<Row>& rows, double fold_us) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    list.push_back({{"mesh", row.mesh},
                    {"lattice", row.lattice},
                    {"points", row.summary.points},
                    {"inside", row.summary.inside},
                    {"not_converged", row.summary.not_converged},
                    {"max_residual_relative", row.max_residual_relative()},
                    {"newton_mean_iterations", row.summary.mean_iterations},
                    {"folds", row.folds.text()}});
  }
  return nlohmann::ordered_json{{"fold_check_us_per_cell", fold_us}, {"rows", std::move(list)}}
             .dump(2) +
         "\n";
}

std::string faults(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) {
    const EmbeddingSummary& s = row.summary;
    const std::string name = fmt::format("{} in {}", row.mesh, row.lattice);
    if (s.points == 0) text += fmt::format("{}: no points\n", name);
    if (s.not_converged > 0) {
      text += fmt::format("{}: {} of {} points not converged\n", name, s.not_converged, s.points);
    }
    if (row.holds_all && s.outside > 0) {
      text += fmt::format("{}: {} of {} points outside a lattice that holds them all\n", name,
                          s.outside, s.points);
    }
    if (!(row.max_residual_relative() <= kLargestResidual)) {
      text += fmt::format("{}: points come back with a residual of {:.2e}, at most {:.0e} wanted\n",
                          name, row.max_residual_relative(), kLargestResidual);
    }
  }
  return text;
}

}  // namespace hwffd::embed
