// hwffd-record: makes the recordings anew, from the models. Run it only where an answer of the core
// changes on purpose, and name the reason with the hashes that change.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/evaluator_stimulus.hpp"
#include "program.hpp"
#include "recording.hpp"
#include "replay.hpp"
#include "stimulus.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kSeed = 2000;
constexpr std::size_t kReadPortVertices = 48;

/// Each kind of packet and vertex in every mode, then any packets in any order, some of them bad.
std::vector<Beat> command_stream(const WordCodec& codec) {
  tb::Random random(kSeed);
  std::vector<Beat> beats = vertices_packet(random_vertices(codec, random, {4, 4, 4}, 2));
  append(beats, coefficients_packet(watertight_bspline(codec), codec, Functions::kDerivativesToo));
  for (const std::string& name : stimulus_names()) {
    append(beats, interleaved_packet(make_stimulus(name, codec, 4, kSeed)));
  }
  append(beats, vertices_packet(random_vertices(codec, random, {4, 4, 4}, 2)));
  const LatticeWords lattice = random_lattice(codec, random, {9, 5, 7});
  append(beats, lattice_packet(lattice));
  for (const auto mode : {OutsideMode::kClamp, OutsideMode::kPass, OutsideMode::kBlank}) {
    for (const auto results : {Results::kPosition, Results::kDerivatives, Results::kDeterminant}) {
      append(beats,
             vertices_packet(random_vertices(codec, random, lattice.dims, 8, true), mode, results));
    }
  }
  append(beats, random_packets(codec, random, 60));
  append(beats, coefficients_packet(watertight_bspline(codec), codec, Functions::kDerivativesToo));
  append(beats, interleaved_packet(make_stimulus("random", codec, 4, kSeed)));
  return beats;
}

/// Two banks with another family on each axis, and vertices in all cells.
std::vector<Beat> read_port_stream(const WordCodec& codec) {
  std::vector<Beat> beats;
  for (const auto& names : {std::array{"bspline", "bernstein", "catmull-rom"},
                            std::array{"hermite", "bspline", "linear"}}) {
    std::array<Blending, 3> axes;
    for (int axis = 0; axis < 3; ++axis) axes[axis] = family(names[axis], codec);
    append(beats, coefficients_packet(axes, codec, Functions::kDerivativesToo));
  }
  const tb::EvaluatorStimulus stimulus = tb::random_stimulus(codec, kReadPortVertices, kSeed);
  int exponent = 0;
  for (const auto& support : stimulus.supports) exponent = std::max(exponent, support.exponent);
  std::vector<InterleavedVertex> vertices = tb::interleaved(stimulus);
  for (InterleavedVertex& vertex : vertices) vertex.exponent = exponent;
  append(beats, interleaved_packet(vertices));
  return beats;
}

}  // namespace

void record_all() {
  std::set<std::string> formats;
  for (const Configuration& row : recorded_rows()) formats.insert(row.format);
  for (const std::string& format : formats) {
    const WordCodec codec(format);
    write_recorded_stream("commands", format, command_stream(codec));
    write_recorded_stream("read_port", format, read_port_stream(codec));
  }
  std::vector<Recording> commands;
  std::vector<Recording> read_port;
  for (const Configuration& row : recorded_rows()) {
    commands.push_back(model_answers(row, read_recorded_stream("commands", row.format)));
    read_port.push_back(
        model_answers_at_read_port(row, read_recorded_stream("read_port", row.format)));
  }
  write_table(table_path("commands"), commands);
  write_table(table_path("read_port"), read_port);
  fmt::print("{} rows of {} formats recorded\n", commands.size(), formats.size());
}

}  // namespace hwffd::test

int main() {
  return hwffd::run_program("hwffd-record", [] {
    hwffd::test::record_all();
    return 0;
  });
}
