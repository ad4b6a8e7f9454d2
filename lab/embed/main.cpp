// hwffd-embed: meshes, and points inside by construction, embedded in lattices of every kind: how
// many are inside, how exactly they come back, and what it takes.

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "hwffd/error.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "report.hpp"
#include "study_program.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::embed;

constexpr int kFoldPoints = 16;  // an axis, of the lattice whose check is timed

/// The rows of a mesh; of one that is not installed none, unless the user asked for it.
std::vector<Row> rows_of(const std::string& model, bool required) {
  if (!required) {
    try {
      find_model(model);
    } catch (const Error& error) {
      fmt::print("left out: {}\n", error.what());
      return {};
    }
  }
  return of_mesh(model);
}

int carry_out(StudyProgram& program) {
  std::vector<std::string> models{"cat.3ds", "horse.3ds", "bunny.obj"};
  std::int64_t points = 10'000;
  std::uint64_t seed = 1;
  const CLI::Option* given = program.app().add_option(
      "--model", models, "meshes (cat.3ds horse.3ds bunny.obj, where present)");
  program.number("--points", points, "points by construction in each lattice", 1, 10'000'000);
  program.seed(seed, "these points");
  return program.run([&] {
    std::vector<Row> rows = by_construction(static_cast<std::size_t>(points), seed);
    for (const std::string& model : models) {
      for (Row& row : rows_of(model, !given->empty())) rows.push_back(std::move(row));
    }
    const double fold_us = fold_check_us_per_cell(kFoldPoints);
    return Findings{{{"embed", json_report(rows, fold_us)}}, faults(rows)};
  });
}

}  // namespace

int main(int argc, char** argv) {
  return run_study("hwffd-embed",
                   "Embeds meshes, and points inside by construction, in lattices of every kind.",
                   argc, argv, carry_out);
}
