// hwffd-energy-words: vertices as the words that ffd_bench_energy.v reads, and the words that must
// come back, by the bit-true model.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "compare/scene.hpp"
#include "hwffd/atomic_file.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/model/evaluator.hpp"
#include "hwffd/stream/blending.hpp"
#include "program.hpp"

namespace {

using namespace hwffd;

constexpr std::int64_t kMostVertices = 256;  // of which each has a support of its own

/// What the bench does next, as ffd_bench_energy.v numbers it.
enum class Step : unsigned { kEnd = 0, kLoad = 1, kWrite = 2, kVertex = 3 };

std::string line(Step step, std::uint32_t place, const std::array<std::uint32_t, 4>& words) {
  return fmt::format("{:x}{:08x}{:08x}{:08x}{:08x}{:08x}\n", static_cast<unsigned>(step), place,
                     words[3], words[2], words[1], words[0]);
}

/// The same functions for all axes, in core and model.
std::string loads(const AxisWords& axis, model::EvaluatorModel& evaluator) {
  std::string text;
  for (unsigned a = 0; a < 3; ++a) {
    for (unsigned f = 0; f < 4; ++f) {
      const auto shift = static_cast<unsigned>(axis.shift);
      text += line(Step::kLoad, a << 6U | f << 2U | shift, axis.word[f]);
      evaluator.load(0, static_cast<int>(a), static_cast<int>(f), 3, axis.shift, axis.word[f]);
    }
  }
  return text;
}

std::string writes(const std::vector<InterleavedVertex>& vertices) {
  std::string text;
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const auto& points = vertices[v].points;
    for (std::uint32_t p = 0; p < 64; ++p) {
      text +=
          line(Step::kWrite, v << 6U | p, {points[3 * p], points[3 * p + 1], points[3 * p + 2], 0});
    }
  }
  return text;
}

std::string offers(const std::vector<InterleavedVertex>& vertices) {
  std::string text;
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const InterleavedVertex& vertex = vertices[v];
    std::uint32_t cell = 0;
    for (unsigned a = 0; a < 3; ++a) cell |= static_cast<unsigned>(vertex.cell[a]) << (4 * a);
    text += line(Step::kVertex, (v == 0 ? 1U : 0U) << 20U | v << 12U | cell,
                 {vertex.local[0], vertex.local[1], vertex.local[2], 0});
  }
  return text;
}

std::string results(const std::vector<InterleavedVertex>& vertices,
                    const model::EvaluatorModel& evaluator) {
  std::string text;
  for (const InterleavedVertex& vertex : vertices) {
    model::VertexWords words{vertex.local, vertex.cell, vertex.points};
    words.exponent = vertex.exponent;
    const model::ResultWords expected = evaluator.evaluate(0, words);
    text += fmt::format("{:08x}{:08x}{:08x}\n", expected.words[2], expected.words[1],
                        expected.words[0]);
  }
  return text;
}

void write(const std::string& name, std::size_t count, std::uint64_t seed,
           const std::filesystem::path& folder) {
  const Configuration& row = find_configuration(name);
  const WordCodec codec(row.format);
  const compare::Scene scene = compare::random_scene(count, seed);
  const Normalization normalization = Normalization::of(scene.lattice, codec);
  const std::vector<InterleavedVertex> vertices =
      interleave(scene.lattice, scene.vertices, codec, normalization);
  const auto evaluator = model::make_evaluator_model(row);
  std::string steps = writes(vertices);
  steps += loads(encode(watertight_bspline(codec), codec), *evaluator);
  steps += offers(vertices) + line(Step::kEnd, 0, {});
  std::filesystem::create_directories(folder);
  write_files(
      {{folder / "steps.hex", steps}, {folder / "results.hex", results(vertices, *evaluator)}});
}

}  // namespace

int main(int argc, char** argv) {
  std::string row;
  std::string folder;
  std::int64_t vertices = 32;
  std::uint64_t seed = 1;
  return run_program("hwffd-energy-words", [&] {
    CLI::App app("Writes vertices as words for the bench of `make -C lab energy`.");
    app.add_option("--row", row, "of rtl/configurations.csv")->required();
    app.add_option("--folder", folder, "for steps.hex and results.hex")->required();
    app.add_option("--vertices", vertices, "each with points of its own")
        ->check(CLI::Range(std::int64_t{1}, kMostVertices))
        ->capture_default_str();
    app.add_option("--seed", seed, "seed of points and vertices")->capture_default_str();
    parse_command_line(app, argc, argv);
    write(row, static_cast<std::size_t>(vertices), seed, folder);
    return 0;
  });
}
