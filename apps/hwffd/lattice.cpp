#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "geometry.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "outputs.hpp"
#include "report.hpp"
#include "stages.hpp"

namespace hwffd::command {
namespace {

constexpr const char* kLatticeExamples = R"(Examples:
  hwffd lattice --lattice cylinder --around horse.3ds -o rest.json
  hwffd lattice --lattice rest.json --deform twist:90 --deform taper:0.5 -o moved.json
  hwffd lattice --lattice box --region 0,0,0,1,2,1 --dims 4x6x4 -o box.json
The file is described in docs/lattice.md section 3: n_s*n_t*n_u points, u running fastest.)";

struct LatticeOptions {
  std::string around;
  std::string output = "-";
};

int run(const LatticeOptions& options, const StageOptions& stage_options) {
  const std::vector<StageText> texts = stage_options.texts();
  if (texts.size() != 1) throw UsageError("--lattice: a file holds one lattice; give one");
  check_outputs({{"--output", options.output}}, {options.around});
  Points points(0, 3);
  if (!options.around.empty()) points = Geometry::read(options.around).positions();
  if (points.rows() == 0 && texts.front().region.empty()) {
    points = (Points(2, 3) << -1, -1, -1, 1, 1, 1).finished();
  }
  const LatticeFile file = deformed_lattice(texts.front(), given_lattice(texts.front(), points));
  write_output(options.output, lattice_text(file));
  if (options.output != "-") {
    fmt::print("wrote {}: {} points\n", options.output, dims_text(file.lattice.dims()));
  }
  return 0;
}

}  // namespace

Action add_lattice(CLI::App& app) {
  const auto options = std::make_shared<LatticeOptions>();
  const auto stages = std::make_shared<StageOptions>(app);
  app.add_option("--around", options->around,
                 "mesh or points that the shape holds (default: a cube from -1 to 1)");
  app.add_option("-o,--output", options->output, "lattice file to write (standard output)");
  app.footer(kLatticeExamples);
  return [=] { return run(*options, *stages); };
}

}  // namespace hwffd::command
