#include "traffic.hpp"

#include <algorithm>

#include "hwffd/error.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/stream/packets.hpp"
#include "hwffd/tb/evaluator_stimulus.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::upsets {
namespace {

// Values stay clear of what saturates: a point so near to 1, a derivative beyond it.
constexpr double kLargest = 0.4;

double small(tb::Random& random) { return kLargest * (2 * random.unit() - 1); }

LatticeWords lattice(const WordCodec& codec, tb::Random& random) {
  LatticeWords words;
  words.dims = {kAxis, kAxis, kAxis};
  words.points.resize(std::size_t{kAxis} * kAxis * kAxis);
  for (auto& point : words.points) {
    for (std::uint32_t& word : point) word = codec.point(small(random));
  }
  return words;
}

std::vector<VertexBeat> vertices(const WordCodec& codec, tb::Random& random, std::size_t count) {
  std::vector<VertexBeat> beats(count);
  std::uint16_t tag = 0;
  for (VertexBeat& beat : beats) {
    for (int a = 0; a < 3; ++a) {
      beat.local[a] = codec.coordinate(random.unit());
      beat.cell[a] = static_cast<int>(random.below(kAxis - 3));
    }
    beat.tag = tag++;
  }
  return beats;
}

std::vector<InterleavedVertex> own_points(const WordCodec& codec, tb::Random& random,
                                          std::size_t count) {
  auto vertices = tb::interleaved(tb::random_stimulus(codec, count, random.bits()));
  for (InterleavedVertex& vertex : vertices) {
    for (std::uint32_t& word : vertex.points) word = codec.point(small(random));
    for (std::uint32_t& word : vertex.local) word = codec.coordinate(random.unit());
  }
  return vertices;
}

}  // namespace

Traffic make_traffic(const Configuration& row, std::size_t count, std::uint64_t seed) {
  const WordCodec codec(row.format);
  tb::Random random(seed);
  Traffic traffic;
  append(traffic.beats,
         coefficients_packet(watertight_bspline(codec), codec, Functions::kDerivativesToo));
  append(traffic.beats, lattice_packet(lattice(codec, random)));
  for (const Results results : {Results::kPosition, Results::kDerivatives, Results::kDeterminant}) {
    append(traffic.beats,
           vertices_packet(vertices(codec, random, count), OutsideMode::kClamp, results));
  }
  append(traffic.beats, interleaved_packet(own_points(codec, random, count)));
  model::StreamModel model(row, model::kAllFeatures, kAxis);
  traffic.results = model.run(traffic.beats);
  const model::StreamEvents& events = model.events();
  if (traffic.results.empty() ||
      std::any_of(events.begin(), events.end(), [](auto n) { return n; }))
    throw Error("the traffic has no results, or an event");
  return traffic;
}

}  // namespace hwffd::upsets
