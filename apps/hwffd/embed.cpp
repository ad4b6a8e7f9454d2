#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.hpp"
#include "geometry.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/embedder.hpp"
#include "outputs.hpp"
#include "report.hpp"
#include "stages.hpp"

namespace hwffd::command {
namespace {

constexpr const char* kEmbedExamples = R"(Examples:
  hwffd embed horse.3ds --lattice sphere
  hwffd embed horse.3ds --lattice cage.json -o horse.txt
One line a vertex is written: cell i j k, local s t u, the residual (distance of the point found from
the vertex), and inside, outside or not-converged. Vertices are welded: equal positions count once.)";

struct EmbedOptions {
  std::string input;
  std::string output;
  std::string report;
  bool check_folds = false;
};

const char* word(EmbeddingStatus status) {
  switch (status) {
    case EmbeddingStatus::kInside:
      return "inside";
    case EmbeddingStatus::kOutside:
      return "outside";
    case EmbeddingStatus::kNotConverged:
      break;
  }
  return "not-converged";
}

std::string lines(const std::vector<Embedding>& embeddings) {
  std::string text = "# i j k s t u residual status\n";
  for (const Embedding& e : embeddings) {
    text += fmt::format("{} {} {} {} {} {} {:.3g} {}\n", e.at.cell[0], e.at.cell[1], e.at.cell[2],
                        e.at.local[0], e.at.local[1], e.at.local[2], e.residual, word(e.status));
  }
  return text;
}

int run(const EmbedOptions& options, const StageOptions& stage_options) {
  const std::vector<StageText> texts = stage_options.texts();
  if (texts.size() != 1) throw UsageError("--lattice: embed takes one lattice");
  if (!texts.front().deformations.empty()) {
    throw UsageError("--deform: vertices are embedded at rest; use hwffd deform to move them");
  }
  check_outputs({{"--output", options.output}, {"--json", options.report}},
                {options.input, texts.front().lattice});
  const Geometry geometry = Geometry::read(options.input);
  const std::vector<Stage> stages = make_stages(texts, geometry.positions());
  std::optional<FoldCheck> folds;
  if (options.check_folds) folds = check_rest(stages.front());
  const Embedder embedder(stages.front().rest, stages.front().family);
  const std::vector<Embedding> embeddings = embedder.embed(geometry.positions());
  const EmbeddingSummary summary = summarize(embeddings);
  if (!options.output.empty()) write_output(options.output, lines(embeddings));
  if (!options.report.empty()) {
    Json report{{"input", geometry.name()},
                {"lattice", stages.front().name},
                {"dims", stages.front().rest.dims()},
                {"family", stages.front().family.name()},
                {"size", embedder.size()}};
    report.update(json_of(summary));
    if (folds) report["rest"] = json_of(*folds);
    write_report(options.report, report);
  }
  if (options.report != "-" && options.output != "-") {
    fmt::print("{} {}: {}\n", stages.front().name, dims_text(stages.front().rest.dims()),
               text_of(summary));
    if (folds) fmt::print("at rest {}\n", folds->text());
  }
  if (summary.not_converged > 0) {
    throw Error(
        fmt::format("{}: {} vertices could neither be embedded nor proved outside; use a "
                    "lattice with less distorted cells",
                    geometry.name(), summary.not_converged));
  }
  return 0;
}

}  // namespace

Action add_embed(CLI::App& app) {
  const auto options = std::make_shared<EmbedOptions>();
  const auto stages = std::make_shared<StageOptions>(app);
  app.add_option("input", options->input, "mesh, points as text (.xyz), - for standard input")
      ->required();
  app.add_option("-o,--output", options->output,
                 "text file for the places, one a line; - for standard output");
  app.add_option("--json", options->report, "report to write; - for standard output");
  add_check_folds(app, options->check_folds);
  app.footer(kEmbedExamples);
  return [=] { return run(*options, *stages); };
}

}  // namespace hwffd::command
