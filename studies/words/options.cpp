#include "options.hpp"

#include <CLI/CLI.hpp>
#include <string>

#include "hwffd/error.hpp"
#include "program.hpp"

namespace hwffd::words {

Options parse_options(int argc, char** argv) {
  Options options;
  CLI::App app{"Measures and bounds the error of every word length against eq. (1) in double."};
  app.add_option("--vertices", options.vertices, "vertices of every row (1000000)");
  app.add_option("--seed", options.seed, "seed of the vertices (1)");
  app.add_option("--output", options.output, "folder for reports (build)");
  parse_command_line(app, argc, argv);
  if (options.vertices < 2 || options.vertices > 1000000000) {
    throw UsageError("--vertices: expected 2 to 1000000000");
  }
  return options;
}

}  // namespace hwffd::words
