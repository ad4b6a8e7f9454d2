#include "report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "hwffd/excerpt.hpp"
#include "outputs.hpp"

namespace hwffd::command {

void write_report(const std::string& path, const Json& report) {
  write_output(path, report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string dims_text(const Index3& dims) {
  return fmt::format("{}x{}x{}", dims[0], dims[1], dims[2]);
}

Json json_of(const EmbeddingSummary& s) {
  return {{"points", s.points},
          {"inside", s.inside},
          {"outside", s.outside},
          {"not_converged", s.not_converged},
          {"worst_residual", s.worst_residual},
          {"newton_mean_iterations", s.mean_iterations}};
}

std::string text_of(const EmbeddingSummary& s) {
  return fmt::format("{} vertices: {} inside, {} outside, {} not converged; worst residual {:.1e}",
                     s.points, s.inside, s.outside, s.not_converged, s.worst_residual);
}

Json json_of(const FoldCheck& check) {
  const char* verdict = check.verdict == FoldCheck::Verdict::kProved   ? "proved"
                        : check.verdict == FoldCheck::Verdict::kFolded ? "folded"
                                                                       : "undecided";
  return {{"verdict", verdict}, {"text", check.text()}, {"volume", check.volume}};
}

Json json_of(const DeformReport& report) {
  Json stages = Json::array();
  for (std::size_t i = 0; i < report.stages.size(); ++i) {
    const Stage& stage = report.stages[i];
    Json entry{{"lattice", stage.name},
               {"dims", stage.rest.dims()},
               {"family", stage.family.name()},
               {"embedding", json_of(report.result.summaries[i])}};
    if (!report.folds.empty()) {
      entry["rest"] = json_of(report.folds[i].rest);
      entry["deformed"] = json_of(report.folds[i].deformed);
    }
    stages.push_back(std::move(entry));
  }
  return {
      {"input", report.geometry.name()},         {"vertices", report.geometry.positions().rows()},
      {"device", report.device.name()},          {"saturated", report.device.counts().saturated},
      {"clocks", report.device.counts().clocks}, {"stages", std::move(stages)},
      {"torn_edges", report.result.torn_edges},  {"written", report.written}};
}

std::string text_of(const DeformReport& report) {
  std::string text;
  for (std::size_t i = 0; i < report.stages.size(); ++i) {
    const Stage& stage = report.stages[i];
    text += fmt::format("{} {}: {}\n", stage.name, dims_text(stage.rest.dims()),
                        text_of(report.result.summaries[i]));
    if (report.folds.empty()) continue;
    text +=
        fmt::format("{} {}: at rest {}, deformed {}\n", stage.name, dims_text(stage.rest.dims()),
                    report.folds[i].rest.text(), report.folds[i].deformed.text());
  }
  text += report.device.name();
  if (report.device.counts().clocks > 0) {
    text += fmt::format(": {} vertices in {} clocks", report.device.counts().vertices,
                        report.device.counts().clocks);
  }
  text += fmt::format("\nwrote {}", one_line(report.written.front()));
  if (report.written.size() > 1) text += " to " + one_line(report.written.back());
  return text + "\n";
}

}  // namespace hwffd::command
