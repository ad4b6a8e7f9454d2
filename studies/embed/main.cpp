// hwffd-embed: meshes, and points inside by construction, embedded in lattices of every kind: how
// many are inside, how exactly they come back, and what it takes.

#include <fmt/format.h>

#include <filesystem>

#include "hwffd/atomic_file.hpp"
#include "hwffd/error.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "options.hpp"
#include "program.hpp"
#include "report.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::embed;

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

int run(const Options& options) {
  std::vector<Row> rows = by_construction(static_cast<std::size_t>(options.points), options.seed);
  for (const std::string& model : options.models) {
    for (Row& row : rows_of(model, options.models_given)) rows.push_back(std::move(row));
  }
  fmt::print("{}", table(rows));
  const std::filesystem::path folder = options.output / "reports";
  std::filesystem::create_directories(folder);
  write_files({{folder / "embed.json", json_report(rows)}});
  fmt::print("\nwrote {}/embed.json\n", folder.string());
  return conclude(faults(rows));
}

}  // namespace

int main(int argc, char** argv) {
  return hwffd::run_program("hwffd-embed", [&] { return run(parse_options(argc, argv)); });
}
