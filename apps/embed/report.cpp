#include "report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace hwffd::embed {

std::string table(const std::vector<Row>& rows) {
  std::string text = fmt::format("{:<15} {:<9} {:>8} {:>7} {:>7} {:>7} {:>13} {:>12} {:>10}  {}\n",
                                 "mesh", "lattice", "dims", "points", "inside", "outside",
                                 "not converged", "max residual", "iterations", "folds");
  for (const Row& row : rows) {
    const EmbeddingSummary& s = row.summary;
    text += fmt::format("{:<15} {:<9} {:>8} {:>7} {:>7} {:>7} {:>13} {:>12.2e} {:>10.2f}  {}\n",
                        row.mesh, row.lattice,
                        fmt::format("{}x{}x{}", row.dims[0], row.dims[1], row.dims[2]), s.points,
                        s.inside, s.outside, s.not_converged, row.max_residual_relative(),
                        s.mean_iterations, row.folds.text());
  }
  return text;
}

std::string json_report(const std::vector<Row>& rows) {
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
  return nlohmann::ordered_json{{"rows", std::move(list)}}.dump(2) + "\n";
}

}  // namespace hwffd::embed
