// hwffd-plates: the plates of the paper. Models in lattices of 64 points, at rest and deformed;
// their vertices come out of the simulated RTL and are compared with the bit-true model.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hwffd/error.hpp"
#include "plates/plate.hpp"
#include "plates/report.hpp"
#include "program.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::plates;

struct Options {
  std::string device = "rtl";
  int width = 1600;
  std::filesystem::path output = "build";
};

Options parse_options(int argc, char** argv) {
  Options options;
  CLI::App app{"Draws the ten plates of the paper from vertices that the simulated RTL computes."};
  app.add_option("--device", options.device, "rtl (default), model, reference");
  app.add_option("--width", options.width, "of a plate in pixels (1600)");
  app.add_option("--output", options.output, "folder for plates and reports (build)");
  parse_command_line(app, argc, argv);
  if (options.width < 160 || options.width > 3200 || options.width % 32 != 0) {
    throw UsageError("--width: expected a multiple of 32 from 160 to 3200");
  }
  return options;
}

int run(const Options& options) {
  const std::unique_ptr<Device> device = make_device({options.device});
  const std::unique_ptr<Device> model = make_device({"model"});
  const picture::Renderer renderer(options.width, options.width * 3 / 4);
  device->on_progress([&](double done) { show_progress(device->name(), done); });
  fmt::print("{}, compared with {}\n\n{}\n", device->name(), model->name(), table_header());
  std::vector<Plate> plates;
  for (Subject& subject : subjects()) {
    for (Plate& plate : plates_of(std::move(subject), *device, *model, renderer)) {
      plates.push_back(std::move(plate));
      fmt::print("{}\n", table_line(plates.size(), plates.back()));
    }
    std::fflush(stdout);
  }
  write_plates(options.output, plates);
  const std::string folder = options.output.string();
  fmt::print(
      "\nwrote {0}/plates/plate01.png to {1}, {0}/plates/plates.png (all), {0}/reports/{2}\n",
      folder, file_name(plates.size()), "plates.json");
  const std::string wrong = faults(plates);
  if (wrong.empty()) return 0;
  throw Error(fmt::format("{}; see {}/reports/plates.json", wrong, folder));
}

}  // namespace

int main(int argc, char** argv) {
  return hwffd::run_program("hwffd-plates", [&] { return run(parse_options(argc, argv)); });
}
