// hwffd-sim: mesh -> embed -> deform the lattice -> command stream -> RTL -> every bit compared
// with the golden model, errors against the oracle, deformed mesh, picture and report written.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "hwffd/atomic_file.hpp"
#include "hwffd/cores/waveform.hpp"
#include "options.hpp"
#include "output.hpp"
#include "picture/before_after.hpp"
#include "picture/png.hpp"
#include "program.hpp"
#include "report.hpp"
#include "run.hpp"
#include "scene.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::sim;

void print_scene(const Options& options, const Scene& scene) {
  const Index3 dims = scene.lattice.dims();
  fmt::print("{}: {} vertices ({} before welding), lattice {}x{}x{}, seed {}\n", scene.mesh.name(),
             scene.mesh.vertex_count(), scene.mesh.vertex_count_read(), dims[0], dims[1], dims[2],
             options.seed);
  for (const std::string& text : options.deformations) {
    const Deformation deformation = Deformation::parse(text);
    if (deformation.kind() != Deformation::Kind::kTwist) continue;
    const int layers = dims[static_cast<std::size_t>(deformation.arguments().axis)];
    fmt::print("{}: corners move on chords, so the cells see {:.1f} of the {} degrees\n", text,
               twist_of_cells(deformation.amount(), layers), deformation.amount());
  }
  fmt::print("errors are against eq. (1) in double, in units of 2^k > half the lattice's size\n\n");
}

/// The mesh and the picture are those of the first run, from the positions out of the hardware.
void write_results(const Options& options, const Output& output, Scene& scene,
                   const std::vector<RunResult>& results) {
  const RunResult& shown = results.front();
  const Lattice deformed = Deformation::parse(shown.deform).apply(scene.lattice);
  picture::BeforeAfter halves(scene.lattice, deformed);
  halves.draw(scene.mesh, scene.lattice);
  scene.mesh.set_positions(shown.positions);
  halves.draw(scene.mesh, deformed);

  const std::filesystem::path mesh = output.mesh(shown.deform);
  scene.mesh.save(mesh);
  std::vector<FileContent> files{{output.report(), json_report(scene, options, results)}};
  if (halves.missing().empty()) {
    files.push_back({output.picture(shown.deform), picture::png_bytes(halves.image())});
  }
  write_files(files);
  fmt::print("\nwrote {}", mesh.string());
  for (const FileContent& file : files) fmt::print(", {}", file.path.string());
  fmt::print("\n");
  if (!halves.missing().empty()) fmt::print("no picture: {}\n", halves.missing());
}

int simulate(const Options& options) {
  Scene scene = make_scene(options.model, options.lattice);
  const Output output(options, scene);
  print_scene(options, scene);
  fmt::print("{}\n", table_header());
  std::vector<RunResult> results;
  int status = 0;
  for (const Configuration& row : options.rows) {
    for (const std::string& text : options.deformations) {
      const std::string waveform = options.trace ? output.waveform(text, row.name).string() : "";
      results.push_back(run(options, row, scene, deform(scene, text), waveform));
      fmt::print("{}\n", table_line(results.back(), options.stream));
      if (results.back().bus) fmt::print("{}\n", bus_line(*results.back().bus));
      if (options.trace) fmt::print("  first {} clocks in {}\n", cores::kTracedClocks, waveform);
      status = std::max(status, conclude(faults(results.back())));
    }
  }
  if (status != 0) return status;
  write_results(options, output, scene, results);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return hwffd::run_program("hwffd-sim", [&] { return simulate(parse_options(argc, argv)); });
}
