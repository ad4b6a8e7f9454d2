// hwffd-soc-scene: what the memory of the system in soc/ holds at the start: packets of functions
// and lattice, a mesh, and of each of its vertices the result that the bit-true model says.
//
// All are little-endian words of 32 bits, and firmware/scene.h has their order. Positions are in
// cells from the first face of the lattice on, Q4.28, so that the processor finds cell and local
// coordinates by shifts: embedding in a box is affine.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "dims.hpp"
#include "hwffd/atomic_file.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"
#include "program.hpp"

namespace {

using namespace hwffd;

constexpr std::uint32_t kMagic = 0x4E454353;  // "SCEN"
constexpr std::size_t kHeaderWords = 16;
constexpr int kFraction = 28;         // bits of a position in cells
constexpr int kMostPoints = 16;       // an axis, so that a cell has four bits
constexpr long kFewestVertices = 16;  // soc/firmware/resets.c: of a run after a reset

struct Options {
  std::string row;
  std::string model;
  std::string deform = "twist:90";
  std::string lattice = "6x8x6";
  long vertices = 0;  // 0: all
  std::filesystem::path output;
};

Options parse_options(int argc, char** argv) {
  Options options;
  CLI::App app{"Writes the memory of the system that make soc simulates."};
  app.add_option("--row", options.row, "of rtl/configurations.csv")->required();
  app.add_option("--model", options.model, "a mesh (glmark2's cat)");
  app.add_option("--deform", options.deform, "of its lattice (twist:90)");
  app.add_option("--lattice", options.lattice, "control points an axis (6x8x6)");
  app.add_option("--vertices", options.vertices, "the first so many of the mesh (all)")
      ->check(CLI::PositiveNumber);
  app.add_option("--output", options.output, "the file")->required();
  parse_command_line(app, argc, argv);
  return options;
}

using Position = std::array<std::uint32_t, 3>;

Position position_of(const Embedded& embedded, const Index3& dims) {
  Position position{};
  for (int a = 0; a < 3; ++a) {
    const auto cells = static_cast<double>(dims[a] - 3);
    const double at = std::clamp(embedded.cell[a] + embedded.local[a], 0.0, cells);
    position[a] = static_cast<std::uint32_t>(std::llround(std::ldexp(at, kFraction)));
  }
  return position;
}

/// What the firmware makes of a position; what lies on the last face is in the last cell, at 1.
VertexBeat vertex_of(const Position& position, const Index3& dims, std::size_t number) {
  VertexBeat beat;
  for (int a = 0; a < 3; ++a) {
    beat.cell[a] = std::min(static_cast<int>(position[a] >> kFraction), dims[a] - 4);
    const std::uint32_t cell = static_cast<std::uint32_t>(beat.cell[a]) << kFraction;
    beat.local[a] = (position[a] - cell) << (31 - kFraction);
  }
  beat.tag = static_cast<std::uint16_t>(number);
  return beat;
}

void append_words(std::vector<std::uint32_t>& words, const std::vector<Beat>& beats) {
  for (const Beat& beat : beats) words.insert(words.end(), beat.words.begin(), beat.words.end());
}

std::string bytes_of(const std::vector<std::uint32_t>& words) {
  std::string bytes;
  bytes.reserve(4 * words.size());
  for (const std::uint32_t word : words) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xFF);
  }
  return bytes;
}

std::vector<std::uint32_t> scene_of(const Options& options) {
  const Configuration& row = find_configuration(options.row);
  const WordCodec codec(row.format);
  const Index3 dims = parse_dims(options.lattice, "--lattice " + options.lattice, 4, kMostPoints);
  const Mesh mesh = load_model(options.model);
  const Box box = Box::around(mesh.positions());
  const Lattice lattice = Deformation::parse(options.deform).apply(box.lattice(dims));

  std::vector<Position> positions;
  std::vector<VertexBeat> vertices;
  const long all = mesh.positions().rows();
  const long count = options.vertices == 0 ? all : std::min(options.vertices, all);
  if (count < kFewestVertices) {
    throw Error(
        fmt::format("{}: {} vertices of a scene; give {} or more, as a run after a reset has",
                    mesh.name(), count, kFewestVertices));
  }
  for (const Embedded& embedded : box.embed(dims, Points(mesh.positions().topRows(count)))) {
    positions.push_back(position_of(embedded, dims));
    vertices.push_back(vertex_of(positions.back(), dims, vertices.size()));
  }
  const std::vector<Beat> functions = coefficients_packet(watertight_bspline(codec), codec);
  const std::vector<Beat> points =
      lattice_packet(lattice_words(lattice, codec, Normalization::of(lattice, codec)));
  std::vector<Beat> commands = functions;
  append(commands, points);
  append(commands, vertices_packets(vertices));
  model::StreamModel model(row);
  const std::vector<Beat> results = model.run(commands);
  if (results.size() != vertices.size() || model.error_status() != 0) {
    throw Error(fmt::format("{} results of {} vertices, errors {:#x}: no scene for this core",
                            results.size(), vertices.size(), model.error_status()));
  }

  std::vector<std::uint32_t> words(kHeaderWords);
  const auto begin = [&](int place) {  // of a section, at a multiple of 16 bytes
    while (words.size() % 4 != 0) words.push_back(0);
    words[place] = static_cast<std::uint32_t>(words.size());
  };
  words[0] = kMagic;
  words[2] = static_cast<std::uint32_t>(vertices.size());
  for (int a = 0; a < 3; ++a) words[3 + a] = static_cast<std::uint32_t>(dims[a]);
  begin(6);
  words[7] = static_cast<std::uint32_t>(functions.size());
  append_words(words, functions);
  begin(8);
  words[9] = static_cast<std::uint32_t>(points.size());
  append_words(words, points);
  begin(10);
  for (const Position& position : positions) {
    words.insert(words.end(), position.begin(), position.end());
  }
  begin(11);
  append_words(words, results);
  words[1] = static_cast<std::uint32_t>(words.size());
  fmt::print("{}: {} vertices, {}, {} control points\n", mesh.name(), vertices.size(),
             options.deform, lattice.points().rows());
  return words;
}

int run(const Options& options) {
  write_files({{options.output, bytes_of(scene_of(options))}});
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("hwffd-soc-scene", [&] { return run(parse_options(argc, argv)); });
}
