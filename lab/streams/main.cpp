// hwffd-streams: how many words an arrangement of the control points moves, predicted from the
// order of the vertices and counted at the simulated core's input (paper, 3.3.2).

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "hwffd/error.hpp"
#include "program.hpp"
#include "report.hpp"
#include "study_program.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::streams;

/// The models, those that the user asked for or of the others those that are installed; a built-in
/// mesh if there are none.
std::vector<NamedMesh> meshes_of(const std::vector<std::string>& models, bool required) {
  std::vector<NamedMesh> meshes;
  for (const std::string& model : models) {
    try {
      meshes.push_back({model, Mesh::load(find_model(model))});
    } catch (const Error& error) {
      if (required) throw;
      fmt::print(stderr, "hwffd-streams: left out: {}\n", error.what());
    }
  }
  if (meshes.empty()) meshes.push_back({"built-in", Mesh::procedural()});
  return meshes;
}

int carry_out(StudyProgram& program) {
  std::vector<std::string> models{"cat.3ds", "horse.3ds", "bunny.obj"};
  std::vector<int> lattices{4, 6, 8, 12, 16};
  const CLI::Option* given =
      program.app().add_option("--models", models, "meshes (cat.3ds horse.3ds bunny.obj)");
  program.app()
      .add_option("--lattices", lattices, "control points an axis (4 6 8 12 16)")
      ->check(CLI::Range(Lattice::kMinPoints, kAxisPoints));
  return program.run([&] {
    std::sort(lattices.begin(), lattices.end());
    const Configuration& configuration = find_configuration("basic-fx18-overlapped");
    const std::vector<NamedMesh> meshes = meshes_of(models, !given->empty());
    const std::vector<Row> rows = study(meshes, lattices, configuration, show_rows_done);
    const std::vector<PagesRow> pages = pages_study(meshes, {24, 32, 48, 64}, configuration);
    return Findings{{{"streams", json_report(rows, pages)}}, faults(rows, pages)};
  });
}

}  // namespace

int main(int argc, char** argv) {
  return run_study("hwffd-streams",
                   "Counts the words that arrangements of the control points move.", argc, argv,
                   carry_out);
}
