#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <utility>

#include "commands.hpp"
#include "device_options.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "outputs.hpp"
#include "stages.hpp"
#include "view/show.hpp"

namespace hwffd::command {
namespace {

constexpr const char* kViewExamples = R"(Examples:
  hwffd view cat.3ds
  hwffd view horse.3ds --lattice cylinder --deform twist:90 --device model --org parallel
  hwffd view cat.3ds --lattice rest.json --deform to:moved.json -o moved.json
The left button drags a control point in the plane of the screen, another button turns the view, the
wheel zooms. S saves the lattice, R makes it what it was at the beginning, Esc closes the window.)";

constexpr const char* kOutput = "lattice.json";

struct ViewOptions {
  std::string input;
  std::string output;  ///< empty: kOutput, which must not be a lattice that was read
  std::string outside = "keep";
  DeviceChoice device;
};

int run(const ViewOptions& options, const StageOptions& stage_options) {
  const std::vector<StageText> texts = stage_options.texts();
  if (texts.size() != 1) throw UsageError("--lattice: view takes one lattice");
  const std::string output = options.output.empty() ? kOutput : options.output;
  check_not_read({"--output", output}, {options.input});
  if (options.output.empty()) check_not_read({"--output", output}, files_of(texts));
  Mesh mesh = load_model(options.input);
  Stage stage = std::move(make_stages(texts, mesh.positions()).front());
  const std::unique_ptr<Device> device = make_device(options.device);
  LatticeFile file = stage.file();
  // A file that cannot be written is no reason to lose what was dragged: the window stays.
  const auto save = [&](const Lattice& lattice) {
    try {
      file.lattice = lattice;
      write_lattice(output, file);
      fmt::print("wrote {}\n", output);
      std::fflush(stdout);
    } catch (const Error& error) {
      fmt::print(stderr, "hwffd: {}\n", error.what());
    }
  };
  view::show({std::move(mesh), stage.family, std::move(stage.rest), std::move(stage.deformed),
              Outside::parse(options.outside)},
             *device, save);
  return 0;
}

}  // namespace

Action add_view(CLI::App& app) {
  const auto options = std::make_shared<ViewOptions>();
  const auto stages = std::make_shared<StageOptions>(app);
  app.add_option("input", options->input, "mesh file, or a name in glmark2's models")->required();
  app.add_option("-o,--output", options->output, "file that S writes (lattice.json)");
  app.add_option("--outside", options->outside,
                 "vertices outside the lattice: keep (default), clamp, fade:WIDTH");
  add_device_options(app, options->device);
  app.footer(kViewExamples);
  return [=] { return run(*options, *stages); };
}

}  // namespace hwffd::command
