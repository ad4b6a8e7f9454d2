#include "compare/core.hpp"

#include <fmt/format.h>

#include "compare/software.hpp"
#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/stream_bench.hpp"

namespace hwffd::compare {
namespace {

constexpr double kBeatBytes = 16;

/// Clocks and results of some vertices; what is wrong goes into the row.
struct Run {
  std::uint64_t first_latency = 0;  ///< from the last beat to the first result
  double clocks_per_vertex = 0;
  std::size_t beats = 0;  ///< of vertices and of results
  std::vector<Beat> results;
};

Run run(CoreRow& row, const Scene& scene, const Normalization& normalization, std::uint64_t seed) {
  const WordCodec codec(row.row.format);
  const auto core = cores::make_stream_core(row.row, seed);
  tb::StreamBenchOptions options;
  options.test = {fmt::format("compare {}", row.row.name), seed,
                  fmt::format("build/lab/compare/hwffd-compare --row {}", row.row.name)};
  tb::StreamBench bench(*core, options);
  const std::vector<Beat> vertices = vertices_packets(vertex_beats(scene.vertices, codec));
  std::vector<Beat> beats = coefficients_packet(watertight_bspline(codec), codec);
  append(beats, lattice_packet(lattice_words(scene.lattice, codec, normalization)));
  append(beats, vertices);
  bench.reset(4);
  bench.expect(model::StreamModel(row.row).run(beats));
  bench.send(beats);
  bench.run();
  if (!bench.finish() && row.failure.empty()) row.failure = bench.report();
  row.mismatches += bench.scoreboard().mismatches() + bench.scoreboard().extra();
  Run result;
  result.results = bench.results();
  result.beats = vertices.size() + result.results.size();
  if (!result.results.empty()) {
    result.first_latency = bench.result_clocks().front() - bench.accept_clocks().back();
  }
  if (result.results.size() > 1) result.clocks_per_vertex = bench.clocks_per_result();
  return result;
}

}  // namespace

CoreRow count(const Configuration& configuration, const Scene& scene, bool sorted,
              std::uint64_t seed) {
  CoreRow row;
  row.row = configuration;
  row.sorted = sorted;
  row.vertices = scene.vertices.size();
  row.bound = error_bound(configuration.format);
  const WordCodec codec(configuration.format);
  const Normalization normalization = Normalization::of(scene.lattice, codec);
  row.latency_clocks = run(row, first_of(scene, 1), normalization, seed).first_latency;
  const Run all = run(row, scene, normalization, seed);
  row.clocks_per_vertex = all.clocks_per_vertex;
  row.bytes_per_vertex =
      kBeatBytes * static_cast<double>(all.beats) / static_cast<double>(row.vertices);
  if (all.results.size() == row.vertices) {
    row.error = largest_error(scene, positions_of(all.results, codec, normalization));
  }
  return row;
}

}  // namespace hwffd::compare
