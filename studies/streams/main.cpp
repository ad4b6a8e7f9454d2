// hwffd-streams: how many words an arrangement of the control points moves, predicted from the
// order of the vertices and counted at the simulated core's input (paper, 3.3.2).

#include <fmt/format.h>

#include <filesystem>

#include "hwffd/atomic_file.hpp"
#include "hwffd/error.hpp"
#include "options.hpp"
#include "program.hpp"
#include "report.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::streams;

/// The models, those that the user asked for or of the others those that are installed; a built-in
/// mesh if there are none.
std::vector<NamedMesh> meshes_of(const Options& options) {
  std::vector<NamedMesh> meshes;
  for (const std::string& model : options.models) {
    try {
      meshes.push_back({model, Mesh::load(find_model(model))});
    } catch (const Error& error) {
      if (options.models_given) throw;
      fmt::print(stderr, "hwffd-streams: left out: {}\n", error.what());
    }
  }
  if (meshes.empty()) meshes.push_back({"built-in", Mesh::procedural()});
  return meshes;
}

int run(const Options& options) {
  const std::vector<Row> rows = study(meshes_of(options), options.lattices,
                                      find_configuration("basic-fx18-overlapped"), show_rows_done);
  fmt::print("words moved to the core, a vertex\n\n{}", table(rows));
  const std::filesystem::path folder = options.output / "reports";
  std::filesystem::create_directories(folder);
  write_files({{folder / "streams.svg", plot(rows)}, {folder / "streams.json", json_report(rows)}});
  fmt::print("\nwrote {0}/streams.json and {0}/streams.svg\n", folder.string());
  return conclude(faults(rows));
}

}  // namespace

int main(int argc, char** argv) {
  return hwffd::run_program("hwffd-streams", [&] { return run(parse_options(argc, argv)); });
}
