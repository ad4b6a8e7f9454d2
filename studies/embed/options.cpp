#include "options.hpp"

#include <CLI/CLI.hpp>

#include "hwffd/error.hpp"
#include "program.hpp"

namespace hwffd::embed {

Options parse_options(int argc, char** argv) {
  Options options;
  CLI::App app{"Embeds meshes, and points inside by construction, in lattices of every kind."};
  const CLI::Option* model = app.add_option("--model", options.models,
                                            "meshes (cat.3ds horse.3ds bunny.obj, where present)");
  app.add_option("--points", options.points, "points by construction in each lattice (10000)");
  app.add_option("--seed", options.seed, "seed of these points (1)");
  app.add_option("--output", options.output, "folder for reports (build)");
  parse_command_line(app, argc, argv);
  if (options.points < 1 || options.points > 10000000) {
    throw UsageError("--points: expected 1 to 10000000");
  }
  options.models_given = !model->empty();
  return options;
}

}  // namespace hwffd::embed
