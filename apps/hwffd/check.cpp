#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/few_points.hpp"
#include "hwffd/lattice/fold.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "outputs.hpp"
#include "report.hpp"
#include "stages.hpp"

namespace hwffd::command {
namespace {

constexpr const char* kCheckExamples = R"(Examples:
  hwffd check rest.json
  hwffd check rest.json moved.json      (before and after a deformation)
A lattice folds where det J changes its sign. "proved" holds of every point of its cells. Exit status:
0 if all are proved, 1 if one is folded or undecided.)";

struct CheckOptions {
  std::vector<std::string> files;
  std::string family;  ///< of all; empty: what each file says
  int depth = kFoldDepth;
  std::string report;
};

int run(const CheckOptions& options) {
  check_outputs({{"--json", options.report}}, options.files);
  const std::optional<Family> named = family_named(options.family);
  Json lattices = Json::array();
  std::string text;
  bool proved = true;
  double first_volume = 0;
  for (const std::string& file : options.files) {
    const LatticeFile read = read_lattice_file(file, named);
    const Lattice& lattice = read.lattice;
    const FoldCheck check = check_folds(whole(lattice, *read.family), options.depth, *read.family);
    proved = proved && check.verdict == FoldCheck::Verdict::kProved;
    text += fmt::format("{} {}: {}, volume {:.6g}", file, dims_text(lattice.dims()), check.text(),
                        check.volume);
    if (lattices.empty()) {
      first_volume = check.volume;
    } else if (first_volume != 0) {
      text += fmt::format(" ({:+.2f} %)", 100 * (check.volume / first_volume - 1));
    }
    text += "\n";
    Json entry{{"file", file}, {"dims", lattice.dims()}};
    entry.update(json_of(check));
    lattices.push_back(std::move(entry));
  }
  if (!options.report.empty()) write_report(options.report, {{"lattices", std::move(lattices)}});
  if (options.report != "-") fmt::print("{}", text);
  return proved ? 0 : 1;
}

}  // namespace

Action add_check(CLI::App& app) {
  const auto options = std::make_shared<CheckOptions>();
  app.add_option("lattices", options->files, "lattice files; volumes are compared with the first")
      ->required();
  app.add_option("--family", options->family,
                 fmt::format("blending functions of all: {} (default: what a file says, else {})",
                             fmt::join(Family::names(), ", "), Family().name()));
  app.add_option("--depth", options->depth, "times a cell is halved at most (6)")
      ->check(CLI::Range(0, 12));
  app.add_option("--json", options->report, "report to write; - for standard output");
  app.footer(kCheckExamples);
  return [=] { return run(*options); };
}

}  // namespace hwffd::command
