// hwffd-compare: what this project itself brings to the comparison of `make compare`: its programs,
// timed on the core on which it runs, and clocks of its cores, counted in their RTL. The scene goes
// into files, for the other programs.

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "compare/report.hpp"
#include "hwffd/cores/stream_core_factory.hpp"
#include "program.hpp"
#include "study_program.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::compare;

struct Options {
  std::int64_t vertices = 1'000'000;
  std::int64_t model_vertices = 20'000;
  std::int64_t core_vertices = 4'096;
  std::int64_t milliseconds = 1'500;
  std::uint64_t seed = 1;
  std::vector<std::string> models;
  std::vector<std::string> walkers;
  std::vector<std::string> rows;
  std::string scene;
};

/// Of the bit-true models those that are asked for, else one of each kind of organization and
/// number.
std::vector<std::string> models_of(const Options& options) {
  if (!options.models.empty()) return options.models;
  return {"factored-fx18-overlapped", "affine3-fx17-overlapped", "basic-fp32-overlapped"};
}

/// Of those that walk along rows of grids the ones that are asked for, else one of each format.
std::vector<std::string> walkers_of(const Options& options) {
  if (!options.walkers.empty()) return options.walkers;
  return {"walk-fx17-overlapped", "factored-fx18-overlapped", "affine-fx32-overlapped",
          "factored-fp32-overlapped", "factored-bfp32-overlapped"};
}

/// What a core is counted for: rows that this build has.
std::vector<Configuration> cores_of(const Options& options) {
  std::vector<Configuration> rows;
  for (const std::string& name : options.rows) {
    const Configuration& row = find_configuration(name);
    if (cores::has_stream_core(row)) {
      rows.push_back(row);
    } else {
      fmt::print("not counted: {} is not in this build; TIER=all may have it\n", name);
    }
  }
  return rows;
}

Measured measure(const Options& options) {
  const Scene random = random_scene(static_cast<std::size_t>(options.vertices), options.seed);
  if (!options.scene.empty()) write_scene(random, options.scene);
  const Scene sorted = sorted_by_cell(random);
  const std::vector<Configuration> counted = cores_of(options);
  const std::vector<std::string> models = models_of(options);
  Measured measured;
  measured.vertices = random.vertices.size();
  const std::vector<std::string> walkers = walkers_of(options);
  const double steps =
      2.0 * static_cast<double>(3 + models.size() + counted.size() + walkers.size()) + 1;
  const auto show = [&](const std::string& what) {
    const std::size_t done = measured.software.size() + measured.cores.size();
    show_progress(what, static_cast<double>(done) / steps);
  };
  const auto add = [&](SoftwareRow row) {
    measured.software.push_back(std::move(row));
    show(measured.software.back().what);
  };
  const double seconds = static_cast<double>(options.milliseconds) / 1000;
  for (const Scene* scene : {&random, &sorted}) {
    const bool is_sorted = scene == &sorted;
    add(evaluator<float>(*scene, is_sorted, seconds));
    add(evaluator<double>(*scene, is_sorted, seconds));
    add(device("", *scene, is_sorted, seconds));
    const Scene few = first_of(*scene, static_cast<std::size_t>(options.model_vertices));
    for (const std::string& model : models) add(device(model, few, is_sorted, seconds));
    const Scene fewer = first_of(*scene, static_cast<std::size_t>(options.core_vertices));
    for (const Configuration& row : counted) {
      measured.cores.push_back(count(row, fewer, is_sorted, options.seed));
      show(row.name);
    }
  }
  const GridScene grid = grid_scene(random.lattice, static_cast<std::size_t>(options.vertices));
  add(grid_device("", grid, seconds));
  for (const std::string& row : walkers) {
    add(walker(row, grid, seconds));
    add(grid_device(row, grid, seconds));
  }
  return measured;
}

int carry_out(StudyProgram& program) {
  Options options;
  program.number("--vertices", options.vertices, "of LatticeEvaluator and device reference", 1,
                 100'000'000);
  program.number("--model-vertices", options.model_vertices, "of them, of each bit-true model", 1,
                 10'000'000);
  program.number("--core-vertices", options.core_vertices, "of them, of each core's RTL", 2,
                 1'000'000);
  program.number("--milliseconds", options.milliseconds, "for which each program runs", 1, 100'000);
  program.app().add_option("--model", options.models, "rows whose bit-true models are timed");
  program.app().add_option("--walker", options.walkers,
                           "rows whose bit-true models are timed along a grid");
  program.app().add_option("--row", options.rows, "rows whose cores are counted");
  program.app().add_option("--scene", options.scene, "folder for what is evaluated");
  program.seed(options.seed, "points and vertices");
  return program.run([&] {
    const Measured measured = measure(options);
    return Findings{{{"compare-own", json_report(measured)}}, faults(measured)};
  });
}

}  // namespace

int main(int argc, char** argv) {
  return run_study("hwffd-compare", "Times the project's programs and counts clocks of its cores.",
                   argc, argv, carry_out);
}
