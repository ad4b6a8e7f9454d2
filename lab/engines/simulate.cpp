// hwffd-engine-ENGINE-ROW: recorded commands through the core that it is linked with, under random
// pauses on both sides, and what comes out.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "answers.hpp"
#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/tb/stream_bench.hpp"
#include "program.hpp"
#include "recording.hpp"

namespace {

using namespace hwffd;

void simulate(const std::string& row, std::uint64_t seed, const std::filesystem::path& folder,
              const std::filesystem::path& output) {
  const auto core = cores::make_stream_core(find_configuration(row), seed);
  tb::StreamBenchOptions options;
  options.test = {row, seed, ""};
  options.source_throttle = "bernoulli";
  options.sink_throttle = "bernoulli";
  tb::StreamBench bench(*core, options);
  bench.reset(1);
  bench.send(test::read_stream(folder / "beats.hex"));
  bench.expect(test::read_stream(folder / "model" / "results.txt"));
  bench.run();
  if (!bench.finish()) fmt::print("{}\n", bench.report());
  engines::write_answers(output, {bench.results(), bench.events()});
  fmt::print("clocks {} beats {} results {}\n", bench.cycle(), bench.accept_clocks().size(),
             bench.results().size());
}

}  // namespace

int main(int argc, char** argv) {
  std::string row;
  std::string folder;
  std::string output;
  std::uint64_t seed = 1;
  return run_program("hwffd-engine", [&] {
    CLI::App app("Recorded commands through one core, for `make -C lab engines`.");
    app.add_option("--row", row, "of rtl/configurations.csv, that of the core")->required();
    app.add_option("--folder", folder, "with what hwffd-engines-words wrote")->required();
    app.add_option("--output", output, "folder for the answers")->required();
    app.add_option("--seed", seed, "of pauses and start values")->capture_default_str();
    parse_command_line(app, argc, argv);
    simulate(row, seed, folder, output);
    return 0;
  });
}
