#include "options.hpp"

#include <CLI/CLI.hpp>

#include "hwffd/error.hpp"
#include "program.hpp"

namespace hwffd::organizations {

Options parse_options(int argc, char** argv) {
  Options options;
  CLI::App app{"Compares organizations at their read port: clocks, operators, errors, seams."};
  app.add_option("--vertices", options.effort.vertices,
                 "random vertices of every row (4001); slow rows: 1241 at most");
  app.add_option("--seam-values", options.effort.seam_values,
                 "components of shared vertices of every row (60000); slow rows: a tenth");
  app.add_option("--seed", options.effort.seed, "seed of vertices and registers (1)");
  app.add_option("--operators", options.operators, "what scripts/operators.py wrote");
  app.add_option("--areas", options.areas, "what make synth wrote (build/reports/synth.json)");
  app.add_option("--output", options.output, "folder for reports (build)");
  parse_command_line(app, argc, argv);
  const std::size_t vertices = options.effort.vertices;
  if (vertices < 161 || vertices > 1000000 || (vertices - 41) % 120 != 0) {
    throw UsageError("--vertices: expected 41 and a multiple of 120, 161 to 1000000");
  }
  if (options.effort.seam_values < 1 || options.effort.seam_values > 10000000) {
    throw UsageError("--seam-values: expected 1 to 10000000");
  }
  return options;
}

}  // namespace hwffd::organizations
