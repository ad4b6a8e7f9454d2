#include "hwffd/device/fit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <unordered_set>

#include "commands.hpp"
#include "device_options.hpp"
#include "geometry.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "outputs.hpp"
#include "program.hpp"
#include "report.hpp"
#include "stages.hpp"

namespace hwffd::command {
namespace {

constexpr const char* kFitExamples = R"(Examples:
  hwffd fit rest.ply moved.ply --dims 6x6x6 -o fitted.json
  hwffd fit scan.xyz target.xyz --loss huber --scale 0.01 --penalty 1e-4 -o fitted.json
Vertex n of the first goes to vertex n of the second, as near as the control points can bring it:
--deform says where these start. What is outside the lattice stays and does not count.
The file has the lattice at rest and deformed; Python's Lattice.read() takes both.)";

struct FitCommand {
  std::string source;
  std::string target;
  std::string output;
  std::string report;
  std::string loss = loss_names().front();
  DeviceChoice device;
  FitOptions fit;
};

/// The row of the positions that each vertex of a file has.
std::vector<std::uint32_t> rows_of(const Geometry& geometry) {
  const auto count = static_cast<std::size_t>(geometry.positions().rows());
  std::vector<std::uint32_t> rows(count);
  std::iota(rows.begin(), rows.end(), 0U);
  if (!geometry.is_mesh() || geometry.mesh().vertex_count_read() == count) return rows;
  const std::vector<std::uint32_t>& numbers = geometry.mesh().numbers();
  rows.resize(std::size_t{*std::max_element(numbers.begin(), numbers.end())} + 1);
  for (std::size_t v = 0; v < numbers.size(); ++v) rows[numbers[v]] = geometry.mesh().welded()[v];
  return rows;
}

/// Points, and where they shall be.
struct Pairs {
  Points points, targets;
};

/// Vertex n of one file and vertex n of the other. Of meshes a pair counts once, as equal positions
/// do, which may be others in each.
Pairs pairs_of(const Geometry& source, const Geometry& target) {
  const std::vector<std::uint32_t> from = rows_of(source);
  const std::vector<std::uint32_t> to = rows_of(target);
  if ((!source.is_mesh() && !target.is_mesh()) || from.size() != to.size()) {
    return {source.positions(), target.positions()};
  }
  std::unordered_set<std::uint64_t> seen;
  std::vector<std::uint32_t> rows;
  std::vector<std::uint32_t> target_rows;
  for (std::size_t v = 0; v < from.size(); ++v) {
    if (!seen.insert(std::uint64_t{from[v]} << 32 | to[v]).second) continue;
    rows.push_back(from[v]);
    target_rows.push_back(to[v]);
  }
  return {source.positions()(rows, Eigen::all), target.positions()(target_rows, Eigen::all)};
}

int run(const FitCommand& options, const StageOptions& stage_options) {
  const std::vector<StageText> texts = stage_options.texts();
  if (texts.size() != 1) throw UsageError("--lattice: fit takes one lattice");
  std::vector<std::string> inputs = files_of(texts);
  inputs.insert(inputs.end(), {options.source, options.target});
  check_outputs({{"--output", options.output}, {"--json", options.report}}, inputs);
  FitOptions how = options.fit;
  how.loss = parse_loss(options.loss);

  const Geometry source = Geometry::read(options.source);
  const auto [points, targets] = pairs_of(source, Geometry::read(options.target));
  const std::vector<Stage> stages = make_stages(texts, points);
  DeformableLattice lattice(stages.front().rest, stages.front().family);
  lattice.move(stages.front().deformed.points());
  lattice.set_device(options.device);
  const FitResult result =
      fit(lattice, points, targets, how, [&](int iteration, double /*objective*/) {
        show_progress("fit", static_cast<double>(iteration) / how.iterations);
        return true;
      });
  show_progress("fit", 1.0);

  if (!options.output.empty()) {
    write_output(options.output,
                 lattice_text({lattice.deformed(), lattice.rest(), lattice.family()}));
  }
  if (!options.report.empty()) {
    write_report(options.report, {{"points", points.rows()},
                                  {"outside", result.outside},
                                  {"dims", lattice.rest().dims()},
                                  {"loss", options.loss},
                                  {"rms_start", result.rms_start},
                                  {"rms_end", result.rms_end},
                                  {"largest", result.largest},
                                  {"iterations", result.iterations},
                                  {"evaluations", result.evaluations},
                                  {"deformed", json_of(result.folds)}});
  }
  if (options.report != "-" && options.output != "-") {
    fmt::print(
        "{} {}: {} points, {} outside; rms {:.4g} -> {:.4g}, largest {:.4g}, {} iterations\n{}\n",
        stages.front().name, dims_text(lattice.rest().dims()), points.rows(), result.outside,
        result.rms_start, result.rms_end, result.largest, result.iterations, result.folds.text());
    if (options.output.empty()) fmt::print("wrote nothing: name a file, such as -o FILE\n");
  }
  return 0;
}

}  // namespace

Action add_fit(CLI::App& app) {
  const auto options = std::make_shared<FitCommand>();
  const auto stages = std::make_shared<StageOptions>(app);
  app.add_option("source", options->source, "mesh, or points as text (.xyz), at rest")->required();
  app.add_option("target", options->target, "the same where its vertices shall be, in their order")
      ->required();
  app.add_option("-o,--output", options->output,
                 "lattice file to write, at rest and deformed; - for standard output");
  app.add_option("--loss", options->loss,
                 fmt::format("what a distance costs: {}", fmt::join(loss_names(), ", ")));
  app.add_option("--scale", options->fit.scale,
                 "of huber and geman-mcclure: distance from which on a vertex is an outlier");
  app.add_option("--penalty", options->fit.bending_weight, "weight of the bending energy (0)");
  app.add_option("--iterations", options->fit.iterations, "most (500)")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--json", options->report, "report to write; - for standard output");
  add_device_options(app, options->device);
  app.footer(kFitExamples);
  return [=] { return run(*options, *stages); };
}

}  // namespace hwffd::command
