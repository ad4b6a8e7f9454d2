#include "options.hpp"

#include <CLI/CLI.hpp>

#include "hwffd/error.hpp"
#include "program.hpp"

namespace hwffd::bfp {

Options parse_options(int argc, char** argv) {
  Options options;
  CLI::App app{"Measures block floating point against eq. (1), and its organizations' bits."};
  app.add_option("--vertices", options.vertices,
                 "vertices of every distribution of control points (10000000)");
  app.add_option("--rtl-vertices", options.rtl_vertices, "vertices of every row in RTL (2000)");
  app.add_option("--seed", options.seed, "seed of lattices, vertices and registers (1)");
  app.add_option("--output", options.output, "folder for reports (build)");
  parse_command_line(app, argc, argv);
  if (options.vertices < 1 || options.vertices > 1000000000) {
    throw UsageError("--vertices: expected 1 to 1000000000");
  }
  if (options.rtl_vertices < 1 || options.rtl_vertices > 1000000) {
    throw UsageError("--rtl-vertices: expected 1 to 1000000");
  }
  return options;
}

}  // namespace hwffd::bfp
