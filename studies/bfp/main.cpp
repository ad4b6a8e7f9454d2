// hwffd-bfp: block floating point. The error of both forms of eq. (1) in the bit-true model, beside
// the bound that is proved of it, and the bits of every organization that this build has in RTL.

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "agreement.hpp"
#include "hwffd/atomic_file.hpp"
#include "hwffd/cores/evaluator_core_factory.hpp"
#include "hwffd/error.hpp"
#include "options.hpp"
#include "program.hpp"
#include "report.hpp"
#include "study.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::bfp;

std::vector<const Configuration*> built_rows() {
  std::vector<const Configuration*> rows;
  for (const Configuration& row : configurations()) {
    if (std::string(row.format) == "bfp32" && cores::has_evaluator_core(row)) rows.push_back(&row);
  }
  if (rows.empty()) throw Error("no row of bfp32 in this build: configure it by make bfp");
  return rows;
}

int run(const Options& options) {
  const std::vector<Agreement> agreements =
      compare(built_rows(), options.rtl_vertices, options.seed, show_rows_done);
  const std::vector<Result> results =
      study(options.vertices, options.seed, [](double done) { show_progress("measured", done); });
  fmt::print("{}", table(results, agreements));
  const std::filesystem::path folder = options.output / "reports";
  std::filesystem::create_directories(folder);
  write_files({{folder / "bfp.json", json_report(results, agreements)}});
  fmt::print("\nwrote {}/bfp.json\n", folder.string());
  return conclude(faults(results, agreements));
}

}  // namespace

int main(int argc, char** argv) {
  return hwffd::run_program("hwffd-bfp", [&] { return run(parse_options(argc, argv)); });
}
