// hwffd-sim: mesh -> embed -> deform the lattice -> interleaved stream -> RTL -> every bit compared
// with the golden model, errors against the oracle, deformed mesh and report written.

#include <fmt/format.h>

#include <exception>
#include <filesystem>

#include "hwffd/atomic_file.hpp"
#include "hwffd/error.hpp"
#include "hwffd/stream/interleave.hpp"
#include "options.hpp"
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
    fmt::print("{}: corners move on chords, so the cells see {:.1f} of the {} degrees\n", text,
               twist_of_cells(deformation.amount(), dims[1]), deformation.amount());
  }
  fmt::print("errors are against eq. (1) in double, in units of 2^k > half the lattice's size\n\n");
}

std::filesystem::path save_mesh(const Options& options, Scene& scene, const RunResult& result) {
  const std::filesystem::path folder = options.output / "sim";
  std::filesystem::create_directories(folder);
  std::string deform = result.deform;
  for (char& c : deform) c = c == ':' ? '-' : c;
  const std::filesystem::path path =
      folder /
      fmt::format("{}-{}.obj", std::filesystem::path(scene.mesh.name()).stem().string(), deform);
  scene.mesh.set_positions(result.positions);
  scene.mesh.save(path);
  return path;
}

int simulate(const Options& options) {
  Scene scene = make_scene(options.model, options.lattice);
  print_scene(options, scene);
  fmt::print("{}\n", table_header());
  std::vector<RunResult> results;
  bool ok = true;
  for (const Configuration& row : options.rows) {
    for (const std::string& text : options.deformations) {
      results.push_back(run(options, row, scene, deform(scene, text)));
      fmt::print("{}\n", table_line(results.back(), options.stream));
      std::fflush(stdout);
      if (!results.back().ok()) {
        fmt::print(stderr, "{}\n", results.back().failure);
        ok = false;
      }
    }
  }
  if (!ok) return 1;

  std::filesystem::create_directories(options.output / "reports");
  const std::filesystem::path report = options.output / "reports" / "sim.json";
  write_files({{report, json_report(scene, options, results)}});
  const std::filesystem::path mesh = save_mesh(options, scene, results.front());
  fmt::print("\nwrote {} and {}\n", report.string(), mesh.string());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return simulate(parse_options(argc, argv));
  } catch (const Error& error) {
    fmt::print(stderr, "hwffd-sim: {}\n", error.what());
    return error.exit_status();
  } catch (const std::exception& error) {
    fmt::print(stderr, "hwffd-sim: {}\n", error.what());
    return 1;
  }
}
