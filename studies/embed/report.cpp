#include "report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace hwffd::embed {
namespace {

constexpr double kLargestResidual = 1e-9;  // in parts of the lattice's size

}  // namespace

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
