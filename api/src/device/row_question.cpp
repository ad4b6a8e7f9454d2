#include "device/row_question.hpp"

#include "hwffd/stream/blending.hpp"
#include "hwffd/stream/packets.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd {
namespace {

constexpr int kPoints = 4;  // an axis: the smallest core keeps as many
constexpr int kVertices = 32;

/// Numbers in [0, 1) without a pattern, the same in every run.
class Numbers {
 public:
  double next() {
    state_ = state_ * 1664525U + 1013904223U;
    return (state_ >> 8) * 0x1p-24;
  }

 private:
  std::uint32_t state_ = 1;
};

std::vector<Beat> scene(const WordCodec& codec, Numbers& numbers) {
  LatticeWords lattice{{kPoints, kPoints, kPoints}, {}};
  for (int point = 0; point < kPoints * kPoints * kPoints; ++point) {
    std::array<std::uint32_t, 3> words{};
    for (std::uint32_t& word : words) word = codec.point(2 * numbers.next() - 1);
    lattice.points.push_back(words);
  }
  std::vector<Beat> packets =
      coefficients_packet(watertight_bspline(codec), codec, Functions::kDerivativesToo);
  append(packets, lattice_packet(lattice));
  return packets;
}

std::vector<VertexBeat> vertices_in(const WordCodec& codec, Numbers& numbers) {
  std::vector<VertexBeat> vertices(kVertices);
  for (int v = 0; v < kVertices; ++v) {
    VertexBeat& vertex = vertices[static_cast<std::size_t>(v)];
    for (std::uint32_t& word : vertex.local) word = codec.coordinate(numbers.next());
    vertex.tag = static_cast<std::uint16_t>(v);
  }
  return vertices;
}

}  // namespace

bool answers_as(CommandStream& stream, const Configuration& row) {
  const WordCodec codec(row.format);
  const auto nothing = [](double) {};
  const std::unique_ptr<CommandStream> model = model_stream(row);
  const auto same = [&](const std::vector<Beat>& packets, std::size_t results) {
    return stream.run(packets, results, nothing, 1) == model->run(packets, results, nothing, 1);
  };
  Numbers numbers;
  std::vector<Beat> packets = scene(codec, numbers);
  const std::vector<VertexBeat> vertices = vertices_in(codec, numbers);
  append(packets, vertices_packet(vertices));
  if (!same(packets, kVertices)) return false;
  return same(vertices_packet(vertices, OutsideMode::kClamp, Results::kDerivatives),
              kVertices * results_of(Results::kDerivatives));
}

}  // namespace hwffd
