// hwffd-upsets-TOP: bits of a core inverted while it works, one in each of many runs, and what
// became of it, a line each. The core is HWFFD_UPSET_CORE, a Verilated netlist of netlist.py.

#include <fmt/format.h>
#include <fmt/os.h>

#include <CLI/CLI.hpp>

#include "campaign.hpp"
#include "hwffd/error.hpp"
#include "program.hpp"
#include "scenario.hpp"
#include "upset_bench.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::upsets;

struct Options {
  std::string row, design, out;
  std::string kind = "registers";
  std::size_t flips = 9604;
  std::size_t vertices = 3;
  std::uint64_t seed = 1;
  std::size_t jobs = 1;
  std::vector<std::string> only;
};

/// Clocks of the traffic; every result of it is the model's.
std::uint64_t rehearse(Plan& plan) {
  Counter counter;
  Bench bench(plan, counter);
  bench.scenario->run(counter);
  const std::size_t wanted = plan.first.results.size() + plan.second.results.size();
  if (bench.scenario->judge().outcome != Outcome::kNoEffect || bench.scenario->compared() != wanted)
    throw Error("without a flip the results are not those of the model");
  return counter.clocks;
}

std::vector<Upset> chosen(const Options& options, const Design& design, std::uint64_t clocks) {
  if (options.only.empty()) {
    return design.draw(options.kind == "memories", options.flips, clocks, options.seed);
  }
  std::vector<Upset> upsets;
  for (const std::string& text : options.only) upsets.push_back(design.parse(text));
  return upsets;
}

void write(const Options& options, const Design& design, std::uint64_t clocks,
           const std::vector<Upset>& upsets, const std::vector<Verdict>& verdicts) {
  auto file = fmt::output_file(options.out);
  file.print("# clocks {} registers {} memory_bits {}\n", clocks, design.registers.size(),
             design.memory_bits());
  file.print("clock,module,name,word,bit,outcome,recovered,restarted,outside_read\n");
  for (std::size_t i = 0; i < upsets.size(); ++i) {
    const Upset& upset = upsets[i];
    const Verdict& verdict = verdicts[i];
    file.print("{},{},{},{},{},{},{},{},{}\n", upset.clock, design.module(upset),
               design.name(upset), upset.word, upset.bit, outcome_name(verdict.outcome),
               verdict.recovered ? 1 : 0, verdict.restarted ? 1 : 0, verdict.outside_read ? 1 : 0);
  }
}

void work(const Options& options) {
  const Design design = read_design(options.design);
  Plan plan(find_configuration(options.row), options.vertices, options.seed);
  const std::uint64_t clocks = rehearse(plan);
  plan.limit = 3 * clocks + 2000;
  Campaign campaign(chosen(options, design, clocks), options.jobs);
  Bench bench(plan, campaign);
  bench.scenario->run(campaign);
  if (campaign.struck()) campaign.report(bench.scenario->judge());
  write(options, design, clocks, campaign.upsets(), campaign.verdicts());
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  return run_program("hwffd-upsets", [&] {
    CLI::App app("Inverts bits of a core while it works.");
    app.add_option("--row", options.row, "of rtl/configurations.csv")->required();
    app.add_option("--design", options.design, "what netlist.py says of its bits")->required();
    app.add_option("--out", options.out, "the lines")->required();
    app.add_option("--kind", options.kind, "of bits")
        ->check(CLI::IsMember({"registers", "memories"}));
    app.add_option("--flips", options.flips, "runs with one flip each");
    app.add_option("--vertices", options.vertices, "of each kind")->check(CLI::Range(1, 100));
    app.add_option("--seed", options.seed, "of bits, clocks and traffic");
    app.add_option("--jobs", options.jobs, "runs side by side")->check(CLI::Range(1, 64));
    app.add_option("--only", options.only, "NAME@CLOCK or NAME:WORD:BIT@CLOCK in their place");
    parse_command_line(app, argc, argv);
    work(options);
    return 0;
  });
}
