// hwffd-words: how long a word must be. The bit-true model of every word length against the oracle,
// and beside each measured error the bound that is proved of it.

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "hwffd/atomic_file.hpp"
#include "options.hpp"
#include "plot.hpp"
#include "program.hpp"
#include "report.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::words;

void show_progress(double done) {
  if (isatty(fileno(stderr)) == 0) return;
  fmt::print(stderr, "\rmeasured {:3.0f} %", 100 * done);
  if (done >= 1) fmt::print(stderr, "\r{:16}\r", "");
}

int run(const Options& options) {
  const std::vector<Result> results =
      study(all_rows(), options.vertices, options.seed, show_progress);
  fmt::print("{}\n{}", table(results), answer(results));
  const std::filesystem::path folder = options.output / "reports";
  std::filesystem::create_directories(folder);
  write_files(
      {{folder / "words.svg", plot(results)}, {folder / "words.json", json_report(results)}});
  fmt::print("\nwrote {0}/words.json and {0}/words.svg\n", folder.string());
  return conclude(faults(results));
}

}  // namespace

int main(int argc, char** argv) {
  return hwffd::run_program("hwffd-words", [&] { return run(parse_options(argc, argv)); });
}
