#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/LU>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.hpp"
#include "device_options.hpp"
#include "geometry.hpp"
#include "hwffd/device/deformer.hpp"
#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"
#include "hwffd/lattice/fold.hpp"
#include "hwffd/lattice/lattice.hpp"
#include "mask.hpp"
#include "outputs.hpp"
#include "points_file.hpp"
#include "program.hpp"
#include "report.hpp"
#include "stages.hpp"

namespace hwffd::command {
namespace {

constexpr const char* kDeformExamples = R"(Examples:
  hwffd deform horse.3ds --lattice sphere --deform twist:90 -o out.ply
  hwffd deform cat.3ds --dims 4x8x4 --deform helix:90 --deform bend:30:yz -o cat.ply
  hwffd deform cat.3ds --dims 6x6x6 --deform bend:60 --deform taper:0.5 -o cat.obj
  hwffd deform cat.3ds --deform twist:90 --device rtl --org factored --format fx18 -o cat.glb
  hwffd deform chair.obj --lattice box --region 0,0,0,1,2,1 --deform twist:40 --outside fade:0.2
        --lattice box --deform bend:30 -o chair.obj        (local first, then global)
  hwffd deform chair.obj --deform bend:30 --group seat --group back -o chair.obj
  hwffd deform cat.3ds --deform twist:90 --keyframes 24 -o frame.ply   (frame-0000.ply ...)
  echo "0.5 0.5 0.5" | hwffd deform - --lattice lattice.json --deform to:moved.json)";

struct DeformOptions {
  std::string input;
  std::string output;
  std::string outside = "keep";
  std::string report;
  DeviceChoice device;
  int keyframes = 0;
  std::vector<std::string> groups;
  std::string mask;
  bool check_folds = false;
};

/// frame.ply -> frame-0007.ply
std::filesystem::path frame_path(const std::filesystem::path& path, int frame) {
  return path.parent_path() /
         fmt::format("{}-{:04}{}", path.stem().string(), frame, path.extension().string());
}

void warn(const std::string& text) { fmt::print(stderr, "hwffd: warning: {}\n", one_line(text)); }

/// One line that names what became of features of a file; none for no features.
void warn_of_features(const std::string& file, const char* fate,
                      const std::vector<std::string>& features) {
  constexpr std::size_t kLongest = 120;
  std::string list;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const std::string next = (i == 0 ? "" : ", ") + features[i];
    if (list.size() + next.size() > kLongest) {
      list += fmt::format(" and {} more", features.size() - i);
      break;
    }
    list += next;
  }
  if (!list.empty()) warn(fmt::format("{}: {}: {}", file, fate, list));
}

/// What of a mesh is lost on its way into a file, or does not follow it there.
void warn_of_losses(const Geometry& geometry, const std::string& output,
                    const std::vector<std::string>& losses) {
  if (geometry.is_mesh()) {
    const Mesh& mesh = geometry.mesh();
    if (mesh.edits(output)) {
      warn_of_features(output,
                       "kept as they were, and so move the deformed shape as if it were at rest",
                       mesh.unfollowed());
    } else {
      warn_of_features(geometry.name(), "dropped", mesh.dropped());
    }
  }
  warn_of_features(output, "dropped", losses);
}

void warn_of(const DeformReport& report) {
  for (std::size_t i = 0; i < report.folds.size(); ++i) {
    const auto& [rest, deformed] = report.folds[i];
    const std::string& name = report.stages[i].name;
    if (rest.verdict != FoldCheck::Verdict::kProved) {
      warn(fmt::format("lattice '{}', at rest, is {}: neighbours may part", name, rest.text()));
    }
    if (deformed.verdict != FoldCheck::Verdict::kProved) {
      warn(fmt::format("lattice '{}', deformed, is {}: the mesh may pass through itself", name,
                       deformed.text()));
    }
  }
  for (std::size_t i = 0; i < report.stages.size(); ++i) {
    const std::size_t lost = report.result.summaries[i].not_converged;
    if (lost == 0) continue;
    warn(
        fmt::format("lattice '{}': {} vertices could neither be embedded nor proved outside, and "
                    "count as outside; see --check-folds",
                    report.stages[i].name, lost));
  }
  if (report.result.torn_edges > 0) {
    warn(
        fmt::format("{} edges join a vertex outside the lattice, which stays, and one that moves: "
                    "the mesh tears there; see --outside clamp or fade",
                    report.result.torn_edges));
  }
  if (report.device.counts().saturated > 0) {
    warn(fmt::format("{} results saturated in fixed point: {}", report.device.counts().saturated,
                     "the deformed lattice is too large for its scale"));
  }
}

/// The files to write, one a frame, checked before there is any work to lose.
std::vector<std::string> outputs_of(const DeformOptions& options) {
  const bool points = names_points(options.input);
  const std::string output = options.output.empty() && points ? "-" : options.output;
  if (output.empty()) throw UsageError("--output: name the mesh to write, such as -o out.ply");
  if (options.keyframes > 0 && output == "-") {
    throw UsageError("--keyframes: frames are files; name them by --output");
  }
  check_format(options.input, output);
  std::vector<std::string> names;
  for (int frame = 0; options.keyframes > 0 && frame <= options.keyframes; ++frame) {
    names.push_back(frame_path(output, frame).string());
  }
  if (names.empty()) names.push_back(output);
  std::vector<Output> all;
  for (const std::string& name : names) all.push_back({"--output", name});
  all.push_back({"--json", options.report});
  check_outputs(all);
  return names;
}

/// A mesh may be written over itself, but over nothing else that is read.
void check_inputs_stay(const DeformOptions& options, const std::vector<std::string>& outputs,
                       const std::vector<StageText>& stages) {
  std::vector<std::string> inputs = files_of(stages);
  inputs.push_back(options.mask);
  for (const std::string& output : outputs) check_not_read({"--output", output}, inputs);
  inputs.push_back(options.input);
  check_not_read({"--json", options.report}, inputs);
}

/// Points spread over all.
Points some_of(const Points& points) {
  constexpr Eigen::Index kSome = 64;
  return points(Eigen::seq(0, Eigen::last, std::max<Eigen::Index>(1, points.rows() / kSome)),
                Eigen::all);
}

/// Whether a deformation may be a mirror, which turns faces round: no more than where each of some
/// points is turned inside out or does not tell.
bool may_mirror(const Deformer& some, const std::vector<Lattice>& deformed) {
  const Deformer::Result result = some.deform(deformed, *make_device({"reference", "", ""}));
  return std::none_of(result.gradients.begin(), result.gradients.end(),
                      [](const Eigen::Matrix3d& gradient) { return gradient.determinant() > 0.0; });
}

int run(const DeformOptions& options, const StageOptions& stage_options) {
  const std::vector<std::string> outputs = outputs_of(options);
  const std::vector<StageText> texts = stage_options.texts();
  check_inputs_stay(options, outputs, texts);
  const Outside outside = Outside::parse(options.outside);
  const std::unique_ptr<Device> device = make_device(options.device);
  Geometry geometry = Geometry::read(options.input);
  const std::vector<Stage> stages = make_stages(texts, geometry.positions());
  std::vector<Deformer::Rest> rest;
  std::vector<StageFolds> folds;
  for (const Stage& stage : stages) {
    rest.push_back({stage.rest, stage.family});
    if (!options.check_folds) continue;
    const FoldCheck at_rest = check_rest(stage);
    folds.push_back({at_rest, check_folds(stage.deformed, kFoldDepth, stage.family)});
  }
  const Mask mask(geometry, options.groups, options.mask);
  const auto triangles = [&geometry]() -> const Deformer::Triangles& {
    return geometry.triangles();
  };
  auto deformer = std::make_optional<Deformer>(geometry.positions(), triangles, rest, outside);
  std::optional<Deformer> some;  // of a mesh without normals, whose faces alone may turn
  if (geometry.is_mesh() && !geometry.mesh().has_normals()) {
    some.emplace(some_of(geometry.positions()), nullptr, rest, outside);
  }

  const int frames = options.keyframes;
  std::vector<std::string> losses;
  Deformer::Result result;
  for (int frame = 0; frame <= frames; ++frame) {
    const std::string title = frames > 0 ? fmt::format("frame {}/{}", frame, frames) : "deform";
    device->on_progress(
        RatedProgress(title, static_cast<double>(geometry.positions().rows()), "vertices"));
    const double fraction = frames > 0 ? static_cast<double>(frame) / frames : 1.0;
    std::vector<Lattice> deformed;
    for (const Stage& stage : stages) {
      deformed.push_back(between(stage.rest, stage.deformed, fraction));
    }
    const bool turns = geometry.is_mesh() && (!some || may_mirror(*some, deformed));
    result = deformer->deform(deformed, *device,
                              turns ? Deformer::Gradients::kAll : Deformer::Gradients::kNone);
    if (frame == frames) deformer.reset();  // a large part of the memory
    mask.apply(result.positions, result.gradients);
    geometry.move(result.positions, result.gradients);
    result.positions.resize(0, 3);
    losses = geometry.write(outputs[static_cast<std::size_t>(frame)]);
  }
  const DeformReport report{geometry, *device, stages, folds, result, outputs};
  warn_of_losses(geometry, outputs.front(), losses);
  warn_of(report);
  if (!options.report.empty()) write_report(options.report, json_of(report));
  if (outputs.front() != "-" && options.report != "-") fmt::print("{}", text_of(report));
  return 0;
}

}  // namespace

Action add_deform(CLI::App& app) {
  const auto options = std::make_shared<DeformOptions>();
  const auto stages = std::make_shared<StageOptions>(app);
  app.add_option("input", options->input,
                 "mesh file, name in glmark2's models, points as text (.xyz), - for points from "
                 "standard input")
      ->required();
  app.add_option(
      "-o,--output", options->output,
      "mesh to write (obj, ply, off, stl, glb, gltf, dae), or points (text, or ply), which go to "
      "standard output if left out");
  app.add_option("--outside", options->outside,
                 "vertices outside a lattice: keep (default), clamp, fade:WIDTH");
  add_device_options(app, options->device);
  app.add_option("--group", options->groups,
                 "only vertices of parts of this name move; again for more")
      ->type_name("NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_option("--mask", options->mask,
                 "text with a number for each vertex of the input: how much of the displacement it "
                 "takes, 0 to 1")
      ->type_name("FILE");
  add_check_folds(app, options->check_folds);
  app.add_option("--keyframes", options->keyframes,
                 "write frames 0 (at rest) to N (deformed), numbered")
      ->type_name("N")
      ->check(CLI::Range(1, 9999));
  app.add_option("--json", options->report, "report to write; - for standard output");
  app.footer(kDeformExamples);
  return [=] { return run(*options, *stages); };
}

}  // namespace hwffd::command
