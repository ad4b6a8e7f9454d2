// hwffd-tangents: vertices with their derivatives and with det J out of the RTL, every bit against
// the model, values against the oracle and central differences, and where cells meet.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "hwffd/atomic_file.hpp"
#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/error.hpp"
#include "program.hpp"
#include "report.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::tangents;

struct Options {
  std::filesystem::path output = "build";
  int vertices = 5000;
  std::uint64_t seed = 1;
};

Options parse_options(int argc, char** argv) {
  Options options;
  CLI::App app{"Checks derivatives and det J that the RTL evaluates, in each number format."};
  app.add_option("--vertices", options.vertices, "in each of two lattices (5000)");
  app.add_option("--seed", options.seed, "seed of vertices and points (1)");
  app.add_option("--output", options.output, "folder for reports (build)");
  parse_command_line(app, argc, argv);
  if (options.vertices < 1 || options.vertices > 1000000) {
    throw UsageError("--vertices: expected 1 to 1000000");
  }
  return options;
}

/// `basic`, overlapped, in every format that it has in this build: the smallest core that has
/// streams.
std::vector<Configuration> rows() {
  std::vector<Configuration> found;
  for (const Configuration& row : configurations()) {
    if (row.name != fmt::format("basic-{}-overlapped", row.format)) continue;
    if (cores::has_stream_core(row)) {
      found.push_back(row);
    } else {
      fmt::print("left out: {} is not in this build; TIER=test has it\n", row.name);
    }
  }
  return found;
}

int run_all(const Options& options) {
  std::vector<RowResult> results;
  int status = 0;
  for (const Configuration& row : rows()) {
    results.push_back(run(row, static_cast<std::size_t>(options.vertices), options.seed,
                          [&](double done) { show_progress(row.name, done); }));
    status = std::max(status, conclude(faults(results.back())));
  }
  fmt::print("{}\nerrors are in units of 2^k > half the lattice's size, of det J in its cube\n",
             table(results));
  const std::filesystem::path folder = options.output / "reports";
  std::filesystem::create_directories(folder);
  write_files({{folder / "tangents.json", json_report(results)}});
  fmt::print("wrote {}/tangents.json\n", folder.string());
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("hwffd-tangents", [&] { return run_all(parse_options(argc, argv)); });
}
