// Command packets and the results that the model wants for them, for the run with cocotb: a line a
// packet, `packet` and its beats, or `result` and a beat; beats as 32 hexadecimal digits, word 3
// first. Called with the file to write.
#include <fmt/format.h>

#include <exception>

#include "hwffd/atomic_file.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"

namespace {

using namespace hwffd;

std::vector<std::vector<Beat>> packets_of(const WordCodec& codec) {
  const Index3 dims{5, 4, 6};
  const Mesh mesh = Mesh::procedural();
  const Box box = Box::around(mesh.positions());
  const Lattice lattice = Deformation::parse("random:3").apply(box.lattice(dims));
  const Normalization normalization = Normalization::of(lattice, codec);
  const auto embedded = box.embed(dims, Points(mesh.positions().topRows(40)));
  const auto interleaved = interleave(lattice, embedded, codec, normalization);
  std::vector<Beat> unknown = vertices_packet(vertex_beats(embedded, codec));
  unknown.front().words[0] = 99;
  return {coefficients_packet(watertight_bspline(codec), codec),
          lattice_packet(lattice_words(lattice, codec, normalization)),
          vertices_packet(vertex_beats(embedded, codec)), unknown,
          interleaved_packet({interleaved.begin(), interleaved.begin() + 5})};
}

std::string line(const std::string& kind, const std::vector<Beat>& beats) {
  std::string text = kind;
  for (const Beat& beat : beats) {
    text += ' ';
    for (int word = 3; word >= 0; --word) text += fmt::format("{:08x}", beat.words[word]);
  }
  return text + "\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    const Configuration& row = find_configuration("basic-fx18-overlapped");
    model::StreamModel model(row);
    std::string text;
    for (const std::vector<Beat>& packet : packets_of(WordCodec(row.format))) {
      text += line("packet", packet);
      for (const Beat& result : model.run(packet)) text += line("result", {result});
    }
    write_files({{argv[1], text}});
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "vectors: {}\n", error.what());
    return 1;
  }
}
