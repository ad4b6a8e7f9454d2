#include "options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <functional>
#include <iterator>
#include <set>
#include <system_error>

#include "dims.hpp"
#include "hwffd/cores/axi_core_factory.hpp"
#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/error.hpp"
#include "hwffd/stream/packets.hpp"
#include "program.hpp"

namespace hwffd::sim {
namespace {

struct Text {
  std::string deform;
  std::string lattice = "4x4x4";
  std::string org;
  std::string format;
  std::string schedule;
  std::string seed = "1";
};

std::string joined(const std::set<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// Keeps the rows whose column has the wanted word; an empty word keeps all.
void keep(std::vector<Configuration>& rows, const char* option, const std::string& wanted,
          const std::function<std::string(const Configuration&)>& column) {
  if (wanted.empty()) return;
  std::set<std::string> known;
  for (const Configuration& row : rows) known.insert(column(row));
  if (known.count(wanted) == 0) {
    const std::string gone = gone_text(wanted);
    if (!gone.empty()) throw UsageError(gone);
    throw UsageError(fmt::format("{}={}: unknown; known here: {}", option, wanted, joined(known)));
  }
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [&](const Configuration& row) { return column(row) != wanted; }),
             rows.end());
}

bool in_tier_sim(const Configuration& row) { return std::string(row.tier) == "sim"; }

/// Whether the rows of tier sim do not have what is asked for.
bool asks_for_more(const Text& text) {
  if (!text.org.empty()) return true;
  const std::vector<Configuration>& all = configurations();
  return !text.format.empty() && std::none_of(all.begin(), all.end(), [&](const auto& row) {
    return in_tier_sim(row) && row.format == text.format;
  });
}

std::vector<Configuration> rows_of(const Text& text) {
  std::vector<Configuration> rows;
  const bool more = asks_for_more(text);
  for (const Configuration& row : configurations()) {
    // Without a wish beyond them, the rows of tier sim; with one, whatever this build has of it.
    const bool wanted = more || in_tier_sim(row);
    if (wanted && cores::has_stream_core(row)) rows.push_back(row);
  }
  keep(rows, "ORG", text.org, [](const Configuration& row) { return row.org; });
  keep(rows, "FORMAT", text.format, [](const Configuration& row) { return row.format; });
  keep(rows, "SCHEDULE", text.schedule, [](const Configuration& row) { return row.schedule; });
  return rows;
}

/// Those that this build has with their buses.
std::vector<Configuration> dma_rows_of(const std::vector<Configuration>& rows) {
  std::vector<Configuration> available;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(available), cores::has_axi_core);
  if (!available.empty()) return available;
  std::set<std::string> built;
  for (const Configuration& row : configurations()) {
    if (cores::has_axi_core(row)) built.insert(row.name);
  }
  throw UsageError(
      fmt::format("STREAM={}: not built for what ORG, FORMAT and SCHEDULE name; "
                  "built for: {}",
                  kDmaStream, joined(built)));
}

std::uint64_t seed_of(const std::string& text) {
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, seed);
  if (error != std::errc() || read != end) {
    throw UsageError(fmt::format("SEED={}: expected a whole number from 0 to 2^64 - 1", text));
  }
  return seed;
}

}  // namespace

Options parse_options(int argc, char** argv) {
  Options options;
  Text text;
  CLI::App app{"Deforms a mesh on the simulated hardware and compares every bit with the model."};
  app.add_option("--model", options.model, "mesh file, or a name in glmark2's models");
  app.add_option("--deform", text.deform,
                 "twist:90 | bend:90 | shear:0.5 | random:SEED | none (default: twist:90, random)");
  app.add_option("--lattice", text.lattice, "control points an axis, 4 to 16 (4x4x4)");
  app.add_option("--org", text.org, "organization (default: all of the table's tier sim)");
  app.add_option("--format", text.format, "fp32 | bfp32 | fx18 | fx32 (default: all)");
  app.add_option("--schedule", text.schedule, "paper | overlapped (default: both)");
  app.add_option("--stream", options.stream, "interleaved | resident | dma (interleaved)");
  app.add_option("--seed", text.seed, "seed of the bench (1)");
  app.add_flag("--trace", options.trace, "write waveforms (FST); needs a build with HWFFD_TRACE");
  app.add_option("--output", options.output, "folder for meshes and reports (build)");
  parse_command_line(app, argc, argv);
  const std::vector<std::string> streams{"interleaved", "resident", kDmaStream};
  if (std::find(streams.begin(), streams.end(), options.stream) == streams.end()) {
    throw UsageError(fmt::format("STREAM={}: unknown; known here: {}", options.stream,
                                 joined({streams.begin(), streams.end()})));
  }
  if (options.trace && !cores::stream_cores_can_trace()) {
    throw UsageError(
        "--trace: this build writes no waveforms; use make sim TRACE=1, or configure with "
        "-DHWFFD_TRACE=ON");
  }
  options.seed = seed_of(text.seed);
  options.lattice =
      parse_dims(text.lattice, "LATTICE=" + text.lattice, Lattice::kMinPoints, kAxisPoints);
  options.rows = rows_of(text);
  if (options.stream == kDmaStream) options.rows = dma_rows_of(options.rows);
  options.deformations = {text.deform};
  if (text.deform.empty()) {
    options.deformations = {"twist:90", fmt::format("random:{}", options.seed)};
  }
  for (const std::string& deformation : options.deformations) Deformation::parse(deformation);
  return options;
}

}  // namespace hwffd::sim
