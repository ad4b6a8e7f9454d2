#include "options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>

#include "hwffd/error.hpp"
#include "hwffd/lattice/lattice.hpp"
#include "program.hpp"

namespace hwffd::streams {

Options parse_options(int argc, char** argv) {
  Options options;
  CLI::App app{"Counts the words that arrangements of the control points move."};
  const CLI::Option* models =
      app.add_option("--models", options.models, "meshes (cat.3ds horse.3ds bunny.obj)");
  app.add_option("--lattices", options.lattices, "control points an axis (4 6 8 12 16)");
  app.add_option("--output", options.output, "folder for reports (build)");
  parse_command_line(app, argc, argv);
  const bool good = std::all_of(options.lattices.begin(), options.lattices.end(), [](int points) {
    return points >= Lattice::kMinPoints && points <= Lattice::kMaxPoints;
  });
  if (!good || options.lattices.empty()) throw UsageError("--lattices: expected 4 to 16 each");
  options.models_given = !models->empty();
  std::sort(options.lattices.begin(), options.lattices.end());
  return options;
}

}  // namespace hwffd::streams
