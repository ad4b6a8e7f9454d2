#include "run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "dma_run.hpp"
#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/tb/arrangement.hpp"
#include "hwffd/tb/stream_bench.hpp"
#include "program.hpp"

namespace hwffd::sim {
namespace {

/// By the core's streams. Fills the result and returns what came.
std::vector<Beat> run_streams(RunResult& result, const std::vector<Beat>& beats,
                              const tb::TestIdentity& test, const std::string& waveform) {
  const auto core = cores::make_stream_core(result.row, test.seed, waveform);
  tb::StreamBenchOptions bench_options;
  bench_options.test = test;
  tb::StreamBench bench(*core, bench_options);
  bench.on_progress([&](double done) { show_progress(test.name, done); });
  bench.reset(4);
  bench.expect(model::StreamModel(result.row).run(beats));
  bench.send(beats);
  bench.run();

  if (!bench.finish()) result.failure = bench.report();
  result.checked = bench.scoreboard().checked();
  result.mismatches = bench.scoreboard().mismatches() + bench.scoreboard().extra();
  if (bench.results().size() > 1) result.clocks_per_vertex = bench.clocks_per_result();
  return bench.results();
}

/// From memory to memory.
std::vector<Beat> run_memory(RunResult& result, const std::vector<Beat>& beats,
                             const tb::TestIdentity& test, const std::string& waveform) {
  DmaRun dma = run_dma(result.row, beats, test, waveform,
                       [&](double done) { show_progress(test.name, done); });
  result.failure = dma.failure;
  result.checked = dma.checked;
  result.mismatches = dma.mismatches;
  result.clocks_per_vertex = dma.clocks_per_result;
  result.bus = dma.bus;
  return std::move(dma.results);
}

}  // namespace

RunResult run(const Options& options, const Configuration& row, const Scene& scene,
              const Deformed& deformed, const std::string& waveform) {
  const WordCodec codec(row.format);
  const Normalization normalization = Normalization::of(deformed.lattice, codec);
  const bool dma = options.stream == kDmaStream;
  const std::vector<Beat> beats =
      tb::packets(tb::find_arrangement(dma ? "resident" : options.stream), deformed.lattice,
                  scene.vertices, row.format);
  const tb::TestIdentity test{
      fmt::format("sim {} {}", row.name, deformed.name), options.seed,
      fmt::format("make sim ORG={} FORMAT={} SCHEDULE={} STREAM={} DEFORM={} SEED={}", row.org,
                  row.format, row.schedule, options.stream, deformed.name, options.seed)};

  RunResult result{row, deformed.name, 0, 0, 0, 0, 0, {}, {}, {}};
  const std::vector<Beat> results = (dma ? run_memory : run_streams)(result, beats, test, waveform);
  result.positions = positions_of(results, codec, normalization);
  if (result.positions.rows() == deformed.exact.rows()) {
    const Points error = (result.positions - deformed.exact) / lattice_scale(deformed.lattice);
    result.max_error = error.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
    result.rms_error = std::sqrt(error.squaredNorm() / static_cast<double>(error.size()));
  }
  return result;
}

}  // namespace hwffd::sim
